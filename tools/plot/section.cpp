#include <algorithm>
#include <cmath>
#include <memory>

#include <gsl/gsl_interp2d.h>

#include "core/error.hpp"
#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/plot/layout.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

constexpr Index fine_columns = 480, fine_rows = 320;

// In SI; missing values are NaN.
std::vector<double> present_values(const Variable& variable) {
  std::vector<double> values = present_numbers(variable);
  const double factor = factor_to(si_unit_of(variable), variable);
  for (double& v : values) v *= factor;
  return values;
}

// Whether the dataset holds a single section instead of a volume.
bool is_section(const Variable& variable) {
  return variable.dimensions == std::vector<std::string>{"z", "x"} ||
         variable.dimensions == std::vector<std::string>{"z", "y"};
}

// Whether it lies in the layers that may flow (tools/contact/plasticity.hpp).
bool is_in_layers(const Variable& variable) {
  return variable.dimensions == std::vector<std::string>{"layer", "x", "y"};
}

Section section_on(const Dataset& data, const Variable& variable, const std::string& asked) {
  const std::string widest = data.length("x") < 2 ? "x=0" : "y=0";
  if (!is_section(variable)) return section_of(data, asked.empty() ? widest : asked);
  if (!asked.empty()) throw ParameterError("section", "the dataset holds a single section: omit it");
  const bool along_x = variable.dimensions[1] == "x";
  return {along_x, present_values(data.at(along_x ? "section_y" : "section_x")).at(0), 0};
}

// The section's values, row k the k-th depth.
Field section_values(const Dataset& data, const Variable& variable, const Section& section) {
  const std::vector<double> values = present_values(variable);
  const Index nz = data.length(variable.dimensions.front()), nx = data.length("x"), ny = data.length("y");
  const Index columns = section.along_x ? nx : ny;
  if (is_section(variable)) return Eigen::Map<const Field>(values.data(), nz, columns);
  if (variable.dimensions != std::vector<std::string>{"z", "x", "y"} && !is_in_layers(variable))
    throw DataError(variable.name, "is not a volume on (z, x, y)");
  return Field::NullaryExpr(nz, columns, [&](Index k, Index c) {
    const Index i = section.along_x ? c : section.index, j = section.along_x ? section.index : c;
    return values[static_cast<std::size_t>((k * nx + i) * ny + j)];
  });
}

// Linear between depths and between cells, on an even lattice: depths may be spaced unevenly.
Field resampled(const Field& values, const std::vector<double>& along, const std::vector<double>& depths,
                const Patch& shown) {
  const std::unique_ptr<gsl_interp2d, void (*)(gsl_interp2d*)> linear(
      gsl_interp2d_alloc(gsl_interp2d_bilinear, along.size(), depths.size()), gsl_interp2d_free);
  gsl_interp2d_init(linear.get(), along.data(), depths.data(), values.data(), along.size(), depths.size());
  return Field::NullaryExpr(fine_columns, fine_rows, [&](Index c, Index r) {
    return gsl_interp2d_eval_extrap(linear.get(), along.data(), depths.data(), values.data(), shown.x_at(c),
                                    shown.y_at(r), nullptr, nullptr);
  });
}

// The largest magnitude among the values at cells and depths within a range, and where it is.
struct Mark {
  double along, depth, value;
};
Mark largest_of(const Field& values, const std::vector<double>& along, const std::vector<double>& depths,
                const Patch& shown) {
  Mark out{0, 0, 0};
  for (Index k = 0; k < values.rows(); ++k)
    for (Index i = 0; i < values.cols(); ++i) {
      const double s = along[static_cast<std::size_t>(i)], z = depths[static_cast<std::size_t>(k)];
      if (std::abs(values(k, i)) > std::abs(out.value) && shown.x.contains(s) && shown.y.contains(z))
        out = {s, z, values(k, i)};
    }
  return out;
}

// The section as drawn: evenly spaced, x along the section, y downwards.
struct Cut {
  Patch patch;
  Mark mark;
};
Cut cut_of(const Dataset& data, const std::string& variable, const Grid& grid, const Section& section,
           const Request& request) {
  const std::vector<double> depths =
      is_in_layers(data.at(variable)) ? present_values(data.at("layer")) : depths_of(data);
  if (depths.size() < 2 || !std::ranges::is_sorted(depths, std::less_equal<>()))
    throw DataError("z", "a section needs at least two depths in ascending order");
  std::vector<double> along;
  for (Index i = 0; i < (section.along_x ? grid.shape.nx : grid.shape.ny); ++i)
    along.push_back(section.along_x ? grid.x(i) : grid.y(i));
  if (along.size() < 2)
    throw DataError(section.along(), "a section in this direction needs at least two points, found 1");
  const Range position = part_of({along.front(), along.back()}, section.along_x ? request.x : request.y,
                                 section.along_x ? "x-range" : "y-range"),
              depth = part_of({depths.front(), depths.back()}, request.depth, "depth-range");
  const Field values = section_values(data, data.at(variable), section);
  Patch patch{Field(fine_columns, fine_rows), position, depth};
  patch.values = resampled(values, along, depths, patch);
  return {patch, largest_of(values, along, depths, patch)};
}

// The sections of all cases, with values in one unit, and their colours.
struct Cuts {
  std::vector<Patch> patches;  ///< one per case: along the surface and down
  std::vector<Mark> marks;     ///< where they are largest
  std::vector<Section> sections;
  Quantity quantity;
  Range range;  ///< of the values
  Colours colours;
  std::string above;  ///< below it values are hidden; empty: none are

  bool at_one_place() const {
    return std::ranges::all_of(sections, [&](const Section& s) { return s.label() == sections[0].label(); });
  }
};

void scale_by_hertz(Cuts& cuts, const Cases& cases) {
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const double p0 = hertz_pressure(cases[c].data);
    cuts.patches[c].values /= p0;
    cuts.marks[c].value /= p0;
  }
  cuts.quantity.name += " / p₀";
  cuts.quantity.unit.clear();
}

// Of each case, what lies below its own bound.
void hide_below(Cuts& cuts, const Cases& cases, const Request& request) {
  const Variable& variable = cases[0].data.at(request.variable_or("von_mises"));
  if (si_unit_of(variable) != "Pa")
    throw ParameterError("above", "is a stress, and " + variable.name + " is not");
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Dataset& data = cases[c].data;
    const double scale = request.scale_by_hertz ? data.attributes.number("contact_hertz_pressure", 1) : 1;
    const double bound =
        request.above.in(data, [&] { return field_of(data, "pressure", "Pa").maxCoeff(); }) / scale;
    Field& values = cuts.patches[c].values;
    values = (values >= bound).select(values, std::numeric_limits<double>::quiet_NaN());
    least = std::min(least, bound);
  }
  const double highest = std::ranges::max(cuts.marks, {}, &Mark::value).value;  // at a cell
  if (!(least < highest))
    throw ParameterError(
        "above",
        fmt::format("no value of the section reaches {}; the largest is {}", request.above.label(),
                    request.scale_by_hertz ? brief(highest) + " p₀" : cli::format_quantity(highest, "Pa")));
  cuts.above = request.above.label();
  cuts.colours = {{least, highest}, Palette::sequential};
}

Cuts cuts_of(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("von_mises");
  Cuts cuts;
  for (const auto& [data, label, sample] : cases) {
    const Grid grid = grid_of(data);
    cuts.sections.push_back(section_on(data, data.at(variable), request.section));
    const Cut cut = cut_of(data, variable, grid, cuts.sections.back(), request);
    cuts.patches.push_back(cut.patch);
    cuts.marks.push_back(cut.mark);
  }
  cuts.quantity = quantity_of(cases, variable);
  if (request.scale_by_hertz) scale_by_hertz(cuts, cases);
  cuts.range = range_of(cuts.patches);
  cuts.colours = colours_of(cuts.range, cuts.quantity);
  if (request.above.given()) hide_below(cuts, cases, request);
  limit(cuts.colours, cuts.patches, cuts.quantity, request);
  return cuts;
}

// Short where much is to be said.
std::string default_title(const Cuts& cuts, const Unit& value) {
  std::string out = cuts.at_one_place() ? "section " + cuts.sections[0].label() : "";
  const double largest = cuts.marks[0].value;
  const bool marked = cuts.marks.size() == 1 && largest != 0;
  if (!cuts.above.empty())
    out = (marked ? cuts.sections[0].label() : out) + (out.empty() ? "above " : ", above ") + cuts.above;
  if (!marked) return out;
  return out + fmt::format(", {}{}{}{} at +", cuts.above.empty() ? "largest " : "",
                           brief(largest / value.factor), value.name.empty() ? "" : " ", value.name);
}

// A black cross with a white rim, on any colour; before a disc, for lines of symbols are thin in SVG.
void add_mark(Panel& panel, const Mark& mark, const Unit& along, const Unit& depth) {
  if (mark.value == 0) return;
  const Field at{{mark.along / along.factor, mark.depth / depth.factor}};
  for (const char* style : {"pointtype 7 pointsize 0.5*dot linecolor rgb 'white'",
                            "pointtype 1 pointsize 0.95*dot linewidth 3.8 linecolor rgb 'white'",
                            "pointtype 1 pointsize 0.8*dot linewidth 1.5 linecolor rgb 'black'"})
    panel.layers.push_back(points(at, std::string("with points ") + style));
}

// By gnuplot's contours of the same cells, with straight lines between their centres, at the multiples of a
// step that lie within the range of the values: found before the panel is drawn.
void add_isolines(Panel& panel, const Field& cells, const Lattice& at, double step) {
  const Range values = range_of(cells);
  if (!(drawable(values) == values)) return;  // round-off of a constant
  std::string levels;
  for (const double v : multiples(values, step))
    if (values.low < v && v < values.high) levels += fmt::format("{}{}", levels.empty() ? "" : ",", v);
  if (levels.empty()) return;
  panel.commands.line("set contour base\nunset surface\nset cntrparam levels discrete {}\nset table $lines",
                      levels);
  Lattice in_space = at;
  in_space.in_space = true;
  panel.commands.draw("splot", {raster(cells, in_space, "")});
  panel.commands.line("unset table\nunset contour\nset surface");
  for (const char* style :
       {"linewidth 1.6 linecolor rgb '#b0ffffff'", "linewidth 0.7 linecolor rgb '#202020'"})
    panel.layers.push_back({fmt::format("using 1:2 with lines {}", style), {}, "$lines"});
}

}  // namespace

Figure section(const Cases& cases, const Request& request) {
  const Cuts cuts = cuts_of(cases, request);
  const Patch& first = cuts.patches[0];
  const double true_aspect = first.y.width() / first.x.width();
  Figure out = side_by_side(request, cases);
  out.right = 7.6;
  out.aspect = std::clamp(true_aspect, out.comparison ? 0.35 : 0.25, tallest);
  const double ratio = out.aspect / true_aspect, stretch = std::abs(ratio - 1) < 0.01 ? 1 : ratio;
  const Unit along = unit_for(first.x.magnitude(), "m"),
             depth = stretch == 1 ? along : unit_for(first.y.magnitude(), "m"),
             value = unit_for(cuts.colours.range.magnitude(), cuts.quantity.unit);
  out.title = default_title(cuts, value);
  out.colours = {cuts.colours, value, cuts.quantity.name + cuts.colours.words};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Patch& p = cuts.patches[c];
    out.panels[c].x = axis_of(p.x, along, cuts.sections[c].along());
    out.panels[c].y = axis_of(p.y, depth, "depth z");
    out.panels[c].y->downwards = true;
    if (!cuts.at_one_place()) out.panels[c].label += ", " + cuts.sections[c].label();
  }
  for (std::size_t c = 0; c < cases.size(); ++c)
    tell_stretch(out, c, cuts.patches[c].y.width() / cuts.patches[c].x.width(), cuts.sections[c].along(),
                 "depth");
  // At the numbers of the colour bar, which depend on the room that the axes leave.
  const double step = bar_step(layout_of(out, request), drawable(cuts.colours.range / value.factor));
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Patch& p = cuts.patches[c];
    const Field shown = p.values / value.factor;
    out.panels[c].layers = {raster(shown, lattice_of(p, along, depth), "with image")};
    add_isolines(out.panels[c], shown, lattice_of(p, along, depth), step);
    add_mark(out.panels[c], cuts.marks[c], along, depth);
  }
  return out;
}

}  // namespace asperity::plot
