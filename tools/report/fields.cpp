#include "tools/report/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "formats/gzip.hpp"
#include "tools/plot/source.hpp"
#include "tools/report/html.hpp"

namespace asperity::report {
namespace {

constexpr Index most_blocks = 512, least_blocks = 64;         // along a side
constexpr double most_bytes = 420'000;                        // of all fields in the page
constexpr Index most_cells = 1 << 19;                         // of a volume
constexpr double largest_code = 65534, missing_code = 65535;  // of 16 bits
constexpr double deepest_code = 254, missing_below = 255;     // of 8 bits, of a volume

// States and counts have no means.
bool whole(const Variable& v) {
  const bool real = v.values.index() == 0 || std::holds_alternative<std::vector<float>>(v.values) ||
                    std::holds_alternative<std::vector<double>>(v.values);
  return !real && !v.attributes.find("scale_factor") && !v.attributes.find("add_offset");
}

// ---- data for the script ----

std::string data_of(std::string_view css_class, const plot::Quantity& quantity, const plot::Unit& unit,
                    plot::Range values, double low, double step, const std::string& more,
                    std::string_view bytes) {
  const plot::Colours colours = plot::colours_of(values, quantity);
  const plot::Range shown = plot::drawable(colours.range / unit.factor);
  return fmt::format(
      "<script type=\"application/octet-stream\" class=\"{}\" data-label=\"{}\" data-unit=\"{}\" "
      "data-low=\"{}\" "
      "data-step=\"{}\" data-range=\"{} {}\" data-colours=\"{}\"{}>{}</script>\n",
      css_class, escaped(quantity.name), escaped(unit.name), low, step, shown.low, shown.high,
      fmt::join(plot::control_colours(colours.palette), " "), more, base64(deflated(bytes)));
}

// Differences along y: first the high bytes of all, then the low ones.
std::string bytes_of(const Field& values, double low, double step) {
  const auto n = static_cast<std::size_t>(values.size());
  std::string out(2 * n, '\0');
  for (Index i = 0, k = 0; i < values.rows(); ++i)
    for (unsigned before = 0; const double v : values.row(i)) {
      const auto code = static_cast<unsigned>(std::isfinite(v) ? std::round((v - low) / step) : missing_code);
      const unsigned difference = (code - before) & 0xFFFFU;
      out[static_cast<std::size_t>(k)] = static_cast<char>(difference >> 8);
      out[n + static_cast<std::size_t>(k++)] = static_cast<char>(difference & 0xFFU);
      before = code;
    }
  return out;
}

// " data-words=…": the names of the states 0, 1, 2, …
std::string states_of(const Variable& v) {
  const std::string words = v.attributes.text("flag_meanings");
  const Values* values = v.attributes.find("flag_values");
  if (words.empty() || !values) return "";
  double next = 0;
  for (const double value : numbers(*values))
    if (value != next++) return "";
  return fmt::format(" data-words=\"{}\"", escaped(words));
}

std::string field_data(const Dataset& blocks, const Variable& original) {
  const std::string& name = original.name;
  const Field values = field_of(blocks, name, Missing::not_a_number);
  const plot::Range range = plot::range_of(values);
  const plot::Quantity quantity = plot::quantity_of(blocks.at(name));
  const plot::Unit unit = plot::unit_for(range.magnitude(), quantity.unit);
  const plot::Range own = range / unit.factor;
  const bool exact = whole(original) && own.width() <= largest_code && unit.factor == 1;
  const double step = exact ? 1 : own.width() > 0 ? own.width() / largest_code : 1;
  return data_of("field", quantity, unit, range, own.low, step, states_of(original),
                 bytes_of(values / unit.factor, own.low, step));
}

// A row a depth: the cells in the middle of as many blocks as fit.
struct Volume {
  Shape shape;
  Field values;
};
Volume volume_of(const Dataset& data) {
  const Index nz = data.length("z"), nx = data.length("x"), ny = data.length("y");
  Index every = 1;
  while (nz * (nx / every) * (ny / every) > most_cells && every < std::min(nx, ny)) ++every;
  Volume out{{nx / every, ny / every}, Field(nz, (nx / every) * (ny / every))};
  const Variable& v = data.at("von_mises");
  const std::vector<double> all = present_numbers(v);
  for (Index k = 0; k < nz; ++k)
    out.values.row(k) =
        plot::in_blocks(Eigen::Map<const Field>(&all[static_cast<std::size_t>(k * nx * ny)], nx, ny),
                        out.shape, plot::Block::middle)
            .reshaped<Eigen::RowMajor>();
  out.values *= factor_to("Pa", v);
  return out;
}

// Differences from depth to depth.
std::string volume_data(const Dataset& data, const plot::Unit& length) {
  const auto [shape, values] = volume_of(data);
  const plot::Range range = plot::range_of(values);
  const plot::Unit unit = plot::unit_for(range.magnitude(), "Pa");
  const double low = range.low / unit.factor,
               step = range.width() > 0 ? range.width() / unit.factor / deepest_code : 1;
  const Field codes = values.isFinite().select(((values / unit.factor - low) / step).round(), missing_below);
  std::string bytes;
  for (Index k = 0; k < codes.rows(); ++k)
    for (Index c = 0; c < codes.cols(); ++c)
      bytes += static_cast<char>(static_cast<int>(codes(k, c) - (k == 0 ? 0 : codes(k - 1, c))));
  std::vector<double> z = depths_of(data);
  for (double& depth : z) depth /= length.factor;
  const std::string more =
      fmt::format(" data-nx=\"{}\" data-ny=\"{}\" data-z=\"{}\"", shape.nx, shape.ny, fmt::join(z, " "));
  return data_of("volume", {"von Mises stress", "Pa", plot::Zero::least}, unit, range, low, step, more,
                 bytes);
}

// ---- the element ----

constexpr const char* controls =
    R"(<div class="bar"><label>Field <select class="which"></select></label>
<label>Section <select class="along"><option value="x">along x</option><option value="y">along y</option></select></label>
<label>x <input type="range" class="x" min="0" value="0"></label>
<label>y <input type="range" class="y" min="0" value="0"></label>
<label><input type="checkbox" class="robust"> colours from 1 to 99 %</label></div>
<output class="readout"></output>
<canvas class="map" role="img" aria-label="Map"></canvas>
<canvas class="profile" role="img" aria-label="Profile"></canvas>
)";

// Broken fields of the user's own are no reason to refuse the others.
bool can_be_shown(const Dataset& data, const std::string& name) try {
  return field_of(data, name, Missing::not_a_number).isFinite().any();
} catch (const DataError&) {
  return false;
}

// The place of the largest stress, or the middle.
Index start_at(const Dataset& data, const char* attribute, double size, Index points) {
  const double share = data.attributes.number(attribute, 0) / size + 0.5;
  return std::clamp<Index>(static_cast<Index>(share * static_cast<double>(points)), 0, points - 1);
}

std::string words_about(const Grid& grid, const Grid& shown, bool volume) {
  std::string out =
      "Point at the map to read values. Click it, drag, or move the sliders to move the section.";
  if (shown.shape != grid.shape)
    out += fmt::format(
        " {} × {} points are shown as {} × {} means over blocks, states by the point in the middle; "
        "single points are higher and lower.",
        grid.shape.nx, grid.shape.ny, shown.shape.nx, shown.shape.ny);
  if (volume) out += " The stress below is shown in 254 steps.";
  return element("p", out, "soft");
}

}  // namespace

std::vector<std::string> fields_of(const Dataset& data, const std::string& first) {
  std::vector<std::string> out;
  if (data.length("x") < 2 || data.length("y") < 2 || !data.has("x") || !data.has("y")) return out;
  for (const Variable& v : data.variables)
    if (v.dimensions == std::vector<std::string>{"x", "y"} && v.name != "mask" && v.values.index() != 0 &&
        can_be_shown(data, v.name))
      out.insert(v.name == first ? out.begin() : out.end(), v.name);
  return out;
}

bool has_volume(const Dataset& data) {
  const Variable* v = data.find("von_mises");
  if (!v || v->dimensions != std::vector<std::string>{"z", "x", "y"} || data.length("z") < 2) return false;
  const std::vector<double> depths = depths_of(data);
  return std::ranges::is_sorted(depths, std::less_equal<>()) &&
         std::ranges::any_of(present_numbers(*v), [](double stress) { return std::isfinite(stress); });
}

Dataset in_blocks(const Dataset& data, const std::vector<std::string>& names, Index most) {
  Grid grid = grid_of(data);
  const Shape from = grid.shape;
  grid.shape = {std::min(from.nx, most), std::min(from.ny, most)};
  grid.dx *= static_cast<double>(from.nx) / static_cast<double>(grid.shape.nx);
  grid.dy *= static_cast<double>(from.ny) / static_cast<double>(grid.shape.ny);
  Dataset out;
  set_grid(out, grid);
  for (const std::string& name : names) {
    const Variable& v = data.at(name);
    const Field values = plot::in_blocks(field_of(data, name, Missing::not_a_number), grid.shape,
                                         whole(v) ? plot::Block::middle : plot::Block::mean);
    Variable reduced{
        name, v.dimensions, std::vector<double>(values.data(), values.data() + values.size()), {}};
    reduced.attributes.set("units", si_unit_of(v));
    reduced.attributes.set("long_name", v.attributes.text("long_name"));
    out.put(std::move(reduced));
  }
  return out;
}

std::string viewer(const Dataset& data, const std::vector<std::string>& names) {
  if (names.empty()) return "";
  std::string fields;
  Dataset blocks;
  for (double most = most_blocks;;
       most *= 0.97 * std::sqrt(most_bytes / static_cast<double>(fields.size()))) {
    blocks = in_blocks(data, names, std::max(least_blocks, static_cast<Index>(most)));
    fields.clear();
    for (const std::string& name : names) fields += field_data(blocks, data.at(name));
    if (static_cast<double>(fields.size()) <= most_bytes || most <= least_blocks) break;
  }
  const Grid grid = grid_of(data), shown = grid_of(blocks);
  const double x = 0.5 * grid.size_x(), y = 0.5 * grid.size_y();
  const plot::Unit length = plot::unit_for(std::max(x, y), "m");
  const bool volume = has_volume(data);
  std::string out = controls;
  if (volume)
    out += "<canvas class=\"below\" role=\"img\" aria-label=\"Stress below\"></canvas>\n" +
           volume_data(data, length);
  return fmt::format(
      "<div class=\"viewer\" data-nx=\"{}\" data-ny=\"{}\" data-x=\"{} {}\" data-y=\"{} {}\" "
      "data-unit=\"{}\" "
      "data-at=\"{} {}\">\n{}{}{}</div>\n",
      shown.shape.nx, shown.shape.ny, -x / length.factor, x / length.factor, -y / length.factor,
      y / length.factor, length.name, start_at(data, "stress_max_x", 2 * x, shown.shape.nx),
      start_at(data, "stress_max_y", 2 * y, shown.shape.ny), out, fields, words_about(grid, shown, volume));
}

}  // namespace asperity::report
