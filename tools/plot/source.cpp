#include "tools/plot/source.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/section.hpp"

namespace asperity::plot {
namespace {

constexpr double least_spread = 1e-3;             // of the level
constexpr double tail = 0.5, squeezed = 1.0 / 8;  // [%] of the outliers at either end; of the range of all

// The cells with centres in a range, and the outer edges of their area.
struct Span {
  Index first, count;
  Range edges;
};
template <class Position>
Span cells_within(Range range, Index n, double spacing, Position position, const char* option) {
  Index first = 0, last = n - 1;
  while (first < n && position(first) < range.low) ++first;
  while (last >= 0 && position(last) > range.high) --last;
  if (first > last)
    throw ParameterError(option, fmt::format("contains no point: give a part of {} to {}",
                                             cli::format_quantity(position(0), "m"),
                                             cli::format_quantity(position(n - 1), "m")));
  return {first, last - first + 1, {position(first) - 0.5 * spacing, position(last) + 0.5 * spacing}};
}

// "1%:99%"; {0, 0} of other texts. Throws ParameterError for shares that are none.
Range shares_in(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == text.npos) return {0, 0};
  auto share = [](std::string_view word) {
    if (!word.ends_with('%')) return unlimited;
    return to_number<double>(word.substr(0, word.size() - 1)).value_or(unlimited);
  };
  const Range out{share(std::string_view(text).substr(0, colon)), share(text.substr(colon + 1))};
  if (!(0 <= out.low && out.low < out.high && out.high <= 100))
    cli::refuse("range", text, "is no pair of rising shares from 0 to 100 %, such as 1%:99%");
  return out;
}

// The values between which these shares lie [%].
Range between_shares(const std::vector<Patch>& patches, Range part) {
  std::vector<double> all;
  for (const Patch& p : patches)
    std::ranges::copy_if(p.values.reshaped(), std::back_inserter(all),
                         [](double v) { return std::isfinite(v); });
  auto value_at = [&](double percent) {
    const auto rank = std::lround(0.01 * percent * static_cast<double>(all.size() - 1));
    std::ranges::nth_element(all, all.begin() + rank);
    return all[static_cast<std::size_t>(rank)];
  };
  const double low = value_at(part.low);
  return {low, value_at(part.high)};
}

// To three digits, as it can be typed.
std::string in_words(double value, const std::string& unit) {
  return cli::format_quantity(std::stod(fmt::format("{:.3g}", value)), unit.empty() ? "1" : unit);
}

}  // namespace

Quantity quantity_of(const Variable& variable) {
  const std::string& name = variable.name;
  const bool strain = name == "plastic_strain" || name == "plastic_strain_counter",
             dent = name == "displacement_plastic";  // short, for they stand along an axis
  const std::string unit = si_unit_of(variable), words = strain ? "plastic strain"
                                                         : dent ? "plastic displacement"
                                                                : variable.attributes.text("long_name");
  if (name == "heights") return {"height", unit, Zero::chosen};
  if (name == "noise") return {"noise", unit, Zero::between};
  if (name == "pressure" || name == "gap" || name == "displacement") return {name, unit, Zero::least};
  if (name == "von_mises") return {"von Mises", unit, Zero::least};
  if (name.starts_with("stress_")) return {"stress σ" + name.substr(7), unit, Zero::between};
  const auto negative = [](double v) { return v < 0 && std::isfinite(v); };
  const bool below = std::ranges::any_of(present_numbers(variable), negative);
  return {words.empty() ? name : words, unit,
          name == "heights_residual" ? Zero::chosen
          : below                    ? Zero::between
                                     : Zero::least};
}

Quantity shared(const std::vector<Quantity>& all, const Cases& cases, const std::string& variable) {
  Quantity out = all[0];
  for (std::size_t c = 1; c < all.size(); ++c) {
    if (all[c].unit != out.unit)
      throw DataError(variable, fmt::format("is in {} in {}, and in {} in {}: draw them apart", all[c].unit,
                                            cases[c].label, out.unit, cases[0].label));
    if (all[c].name != out.name) out.name = variable;
    if (all[c].zero == Zero::between) out.zero = Zero::between;
  }
  return out;
}

Quantity quantity_of(const Cases& cases, const std::string& variable) {
  std::vector<Quantity> all;
  for (const Case& c : cases) all.push_back(quantity_of(c.data.at(variable)));
  return shared(all, cases, variable);
}

Patch patch_of(const Dataset& data, const std::string& variable, const Request& request) {
  const Grid grid = grid_of(data);
  const Field all = field_of(data, variable, Missing::not_a_number);
  const Span i = cells_within(
      request.x, grid.shape.nx, grid.dx, [&](Index k) { return grid.x(k); }, "x-range");
  const Span j = cells_within(
      request.y, grid.shape.ny, grid.dy, [&](Index k) { return grid.y(k); }, "y-range");
  Patch patch{all.block(i.first, j.first, i.count, j.count), i.edges, j.edges};
  if (!patch.values.isFinite().any()) throw DataError(variable, "all points to be drawn are missing");
  return patch;
}

std::vector<Patch> patches_of(const Cases& cases, const std::string& variable, const Request& request) {
  std::vector<Patch> out;
  for (const Case& c : cases) out.push_back(patch_of(c.data, variable, request));
  return out;
}

Range range_of(const std::vector<Patch>& patches) {
  Range out{unlimited, -unlimited};
  for (const Patch& p : patches) out = united(out, range_of(p.values));
  return out;
}

Field in_blocks(const Field& points, Shape number, Block shown) {
  const Index nx = points.rows(), ny = points.cols();
  if (number == Shape{nx, ny}) return points;
  return Field::NullaryExpr(number.nx, number.ny, [&](Index i, Index j) {
    const Index x = i * nx / number.nx, y = j * ny / number.ny;
    const auto block = points.block(x, y, (i + 1) * nx / number.nx - x, (j + 1) * ny / number.ny - y);
    if (shown == Block::middle) return block(block.rows() / 2, block.cols() / 2);
    const auto there = block.isFinite();
    if (!there.any()) return std::numeric_limits<double>::quiet_NaN();
    if (shown == Block::largest) return there.select(block, -unlimited).maxCoeff();
    return there.select(block, 0).sum() / static_cast<double>(there.count());
  });
}

Shape blocks_in(const Field& points, Shape size) {
  return {(points.rows() + size.nx - 1) / size.nx, (points.cols() + size.ny - 1) / size.ny};
}

std::string Level::words() const {
  return number.empty() ? "" : fmt::format(" above {}{}", value < 0 ? "−" : "", number);
}

std::string Level::difference() const {
  return number.empty() ? "" : fmt::format(" {} {}", value < 0 ? "+" : "−", number);
}

Level level_of(const std::vector<Patch>& patches, Range asked, const Quantity& quantity) {
  const Range shown = united(asked, range_of(patches));
  const bool one_value = !(drawable(shown) == shown);
  if (one_value || !(shown.width() < least_spread * shown.magnitude())) return {};
  double sum = 0, count = 0;
  for (const Patch& p : patches) {
    const auto there = p.values.isFinite();
    sum += there.select(p.values - shown.low, 0).sum();  // of small numbers, without loss
    count += static_cast<double>(there.count());
  }
  const double mean = shown.low + sum / count;
  const Unit unit = unit_for(std::abs(mean), quantity.unit);
  const int digits =
      std::min(15, 1 + static_cast<int>(std::ceil(std::log10(std::abs(mean) / shown.width()))));
  const std::string number = fmt::format("{:.{}g}", std::abs(mean) / unit.factor, digits);
  return {std::copysign(std::stod(number) * unit.factor, mean),
          number + (unit.name.empty() ? "" : " " + unit.name)};
}

Lattice lattice_of(const Patch& patch, const Unit& x, const Unit& y, bool in_space) {
  return {patch.x_at(0) / x.factor, patch.y_at(0) / y.factor, patch.dx() / x.factor, patch.dy() / y.factor,
          in_space};
}

double reach(const Patch& patch) { return std::max(patch.x.magnitude(), patch.y.magnitude()); }

std::string Section::label() const {
  const Unit unit = unit_for(std::abs(place), "m");
  return fmt::format("{} = {}", along_x ? "y" : "x",
                     place == 0 ? "0" : brief(place / unit.factor) + " " + unit.name);
}

Section section_of(const Dataset& data, const std::string& text) {
  const Grid grid = grid_of(data);
  const auto [along_x, index] = cli::section_row(grid, text, [&](bool at_y) {
    const char* attribute = at_y ? "stress_max_y" : "stress_max_x";
    const double place = data.attributes.number(attribute, NAN);
    if (std::isnan(place)) throw DataError(attribute, "is missing: asperity-stress --maximum adds it");
    return place;
  });
  const double place = along_x ? grid.y(index) : grid.x(index), spacing = along_x ? grid.dy : grid.dx;
  return {along_x, std::abs(place) < 1e-6 * spacing ? 0 : place, index};  // round-off of the middle
}

std::string section_of_all(const Cases& cases, const std::string& section) {
  const std::string_view of_all = "=max-of-all";
  if (!section.ends_with(of_all)) return section;
  const std::string axis = section.substr(0, section.size() - of_all.size());
  double largest = -unlimited;
  std::string out;
  for (const Case& c : cases) {
    const double value = c.data.attributes.number("stress_max_von_mises", NAN),
                 place = c.data.attributes.number("stress_max_" + axis, NAN);
    if (!std::isfinite(value + place))
      throw DataError("stress_max_" + axis,
                      "is missing in " + c.label + ": asperity-stress --maximum adds it");
    if (value > largest) largest = value, out = fmt::format("{}={}m", axis, place);
  }
  return out;
}

double hertz_pressure(const Dataset& data) {
  const double p0 = data.attributes.number("contact_hertz_pressure", -1);
  if (!(p0 > 0))
    throw DataError("contact_hertz_pressure", "the dataset has no such attribute: omit --scale-by p0");
  return p0;
}

Range value_range(const Request& request, const std::string& unit, Range present, Range otherwise) {
  if (request.range.empty()) return otherwise;
  if (shares_in(request.range).width() > 0)
    cli::refuse("range", request.range, "is of colours, which this kind has not: give LOW,HIGH with unit");
  const auto [low, high] = cli::parse_quantities("range", request.range, unit);
  if (!(low < high)) cli::refuse("range", request.range, "must have its lower bound first");
  if (!(drawable({low, high}) == Range{low, high}))
    cli::refuse("range", request.range, "is too narrow for double precision: widen it");
  if (high < present.low || present.high < low)
    cli::refuse("range", request.range,
                "contains no value: give a part of " + in_words(present.low, unit) + " to " +
                    in_words(present.high, unit));
  return {low, high};
}

Axis value_axis(const Request& request, Range present, Range otherwise, const Quantity& quantity,
                std::string_view name) {
  const Range range = value_range(request, quantity.unit, present, otherwise);
  return axis_of(range, unit_for(range.magnitude(), quantity.unit), name);
}

Range part_of(Range present, Range asked, const char* option) {
  const Range out{std::max(asked.low, present.low), std::min(asked.high, present.high)};
  if (!(out.width() > 0))
    throw ParameterError(
        option, fmt::format("contains nothing to draw: give a part of {} to {}",
                            cli::format_quantity(present.low, "m"), cli::format_quantity(present.high, "m")));
  return out;
}

Colours colours_of(Range values, const Quantity& quantity) {
  switch (quantity.zero) {
    case Zero::chosen:
      return sequential(values);
    case Zero::least:
      return one_sided(values);
    case Zero::between:
      return about_zero(values);
  }
  return {};
}

void limit(Colours& colours, const std::vector<Patch>& patches, const Quantity& quantity,
           const Request& request) {
  const Range present = range_of(patches), asked = shares_in(request.range);
  const bool by_value = asked.width() == 0 && (!request.range.empty() || quantity.zero != Zero::chosen);
  if (by_value) {
    colours.range = value_range(request, quantity.unit, present, colours.range);
    return;
  }
  const Range shares_shown = asked.width() > 0 ? asked : Range{tail, 100 - tail},
              most = between_shares(patches, shares_shown);
  const bool squeezes = most.width() > 0 && most.width() < squeezed * present.width();
  if (!squeezes && asked.width() == 0) return;
  colours.range = drawable(most);
  colours.words = fmt::format(", {:.6g} to {:.6g} %", shares_shown.low, shares_shown.high);
}

Colours field_colours(const std::vector<Patch>& patches, const Quantity& quantity, const Request& request) {
  Colours out = colours_of(range_of(patches), quantity);
  limit(out, patches, quantity, request);
  return out;
}

}  // namespace asperity::plot
