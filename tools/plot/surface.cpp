#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "tools/plot/layout.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

constexpr Index most_points = 128;     // along a side: more are not legible on paper
constexpr double height_share = 0.22;  // of the longer side that the range of values should take

// Keeps at least two points along a side.
Patch thinned(const Patch& patch, Index most) {
  const Index rows = patch.values.rows(), columns = patch.values.cols();
  const Index along_x = std::min(most, rows - 1), along_y = std::min(most, columns - 1);
  const Index nx = (rows + along_x - 1) / along_x, ny = (columns + along_y - 1) / along_y;
  const double step_x = patch.dx() * static_cast<double>(along_x),
               step_y = patch.dy() * static_cast<double>(along_y);
  const double x0 = patch.x_at(0) - 0.5 * step_x, y0 = patch.y_at(0) - 0.5 * step_y;
  return {
      Field::NullaryExpr(nx, ny, [&](Index i, Index j) { return patch.values(i * along_x, j * along_y); }),
      {x0, x0 + step_x * static_cast<double>(nx)},
      {y0, y0 + step_y * static_cast<double>(ny)}};
}

// The stride that leaves at most `most_points` points along a side.
Index stride_of(const std::string& variable, const Field& values) {
  const Index nx = values.rows(), ny = values.cols();
  if (nx < 2 || ny < 2)
    throw DataError(variable, fmt::format("a perspective view needs at least 2 x 2 points, found {} x {}: "
                                          "draw a map or a profile",
                                          nx, ny));
  return (std::max(nx, ny) + most_points - 1) / most_points;
}

// Multiples of the step; if only one fits, the midpoints between multiples, so that the axis has two numbers.
std::string tics(Range values, double step, double scale, const Unit& unit) {
  const Range shown{values.low / unit.factor, values.high / unit.factor};
  std::vector<double> at = multiples(shown, step);
  if (at.size() < 2) {
    at = multiples({shown.low - step / 2, shown.high - step / 2}, step);
    for (double& v : at) v += step / 2;
  }
  std::string out;
  for (const double v : at)
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", gnuplot_string(brief(v)), v * unit.factor * scale);
  return out;
}

// All cases as drawn: thinned alike, on one scale.
struct Relief {
  std::vector<Patch> patches;
  Quantity quantity;
  Range values = {};
  Index stride = 1;
  double factor = 1;             ///< plotted metres per unit of the quantity: 1, 2 or 5 × 10ⁿ
  Unit length = {}, value = {};  ///< of the axes

  double scale() const { return factor / length.factor; }  ///< plotted units per unit of the quantity
};

Relief relief_of(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases[0].data.at(variable));
  Relief out{.patches = patches_of(cases, variable, request), .quantity = quantity};
  for (const Patch& p : out.patches) out.stride = std::max(out.stride, stride_of(variable, p.values));
  out.values = value_range(request, out.quantity.unit, range_of(out.patches));
  for (Patch& p : out.patches) p = thinned(p, out.stride);
  if (!(drawable(out.values) == out.values)) {  // one value everywhere: a plane amid some room
    const double room = out.values.magnitude() > 0 ? out.values.magnitude() : 1;
    out.values = {out.values.low - room, out.values.high + room};
  }
  const double side = std::max(out.patches[0].x.width(), out.patches[0].y.width());
  out.factor = round_step(0.7 * (height_share * side / std::max(out.values.width(), 1e-300)), 1);
  out.length = unit_for(reach(out.patches[0]), "m");
  out.value = unit_for(out.values.magnitude(), out.quantity.unit);
  return out;
}

Script view_of(const Relief& relief) {
  Script script;
  script.line(
      "set view 50,30,0.98\n"
      "set view equal xyz\n"
      "set xyplane at {}\n"
      "set pm3d depthorder explicit corners2color mean\n"
      "set pm3d lighting primary 0.45 specular 0.0\n"
      "set border 127+256+512 linewidth 0.6\n"
      "set grid ztics linewidth 0.4 linecolor rgb '#c8c8c8'",
      relief.values.low * relief.scale());
  return script;
}

// The step of the height axis: numbers at least 0.8 em apart. In this view the longer side takes about 0.6 of
// the panel's width. There is room for two or three numbers, so the choice is finer than round_step's.
double step_of_heights(double ems_wide, const Relief& relief, const Patch& p) {
  const double seen = 0.6 * std::sin(50 * std::numbers::pi / 180) * ems_wide;
  const double side = std::max(p.x.width(), p.y.width()) / relief.length.factor;
  const double most = std::clamp(seen * relief.values.width() * relief.scale() / side / 0.8, 1.5, 4.0);
  const double least = relief.values.width() / relief.value.factor / most;
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (factor * decade >= least) return factor * decade;
  return 10 * decade;
}

Script axes_of(double ems_wide, const Relief& relief, const Patch& p, bool first) {
  Script script;
  const double unit = relief.length.factor, scale = relief.scale();
  script.line("set xrange [{}:{}]\nset yrange [{}:{}]", p.x.low / unit, p.x.high / unit, p.y.low / unit,
              p.y.high / unit);
  script.line("set zrange [{}:{}]", relief.values.low * scale, relief.values.high * scale);
  script.line("set xtics {} offset 0,-0.3", round_step(p.x.width() / unit, 4));
  // The lowest of y would stand where the highest of x does, at the corner in front.
  const double step = round_step(p.y.width() / unit, 4), corner = (p.y.low + 0.06 * p.y.width()) / unit;
  script.line("set ytics {},{} offset 0.4,-0.2", step * std::ceil(corner / step), step);
  script.line("set ztics ({})",
              tics(relief.values, step_of_heights(ems_wide, relief, p), scale, relief.value));
  for (const char* axis : {"x", "y"})
    script.line("set {}label {} noenhanced offset 0,-0.3", axis, gnuplot_string(relief.length.label(axis)));
  script.line("set zlabel {} noenhanced rotate by 90 offset 1,0",
              gnuplot_string(first ? relief.value.label(relief.quantity.name) : ""));
  return script;
}

}  // namespace

Figure surface(const Cases& cases, const Request& request) {
  const Relief relief = relief_of(cases, request);
  const double scale = relief.scale();
  Colours colours = field_colours(relief.patches, relief.quantity, request);
  colours.range = {colours.range.low * scale, colours.range.high * scale};
  Figure out = side_by_side(request, cases);
  out.title = relief.quantity.name;
  if (relief.quantity.unit == "m") out.title += fmt::format(" × {:.6g}", relief.factor);
  if (relief.stride > 1) out.title += fmt::format(", every {}th point", relief.stride);
  out.in_space = true;
  out.aspect = 0.72;
  out.left = 4.5, out.right = 4, out.bottom = 3.2;
  out.gap_x = 3.5, out.gap_y = 3.2;
  out.colours = {colours, {}, ""};
  out.commands = view_of(relief);
  const Layout layout = layout_of(out, request);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Patch& p = relief.patches[c];
    out.panels[c].commands = axes_of(layout.panel_width / layout.em, relief, p, c == 0);
    out.panels[c].layers = {
        raster(p.values * scale, lattice_of(p, relief.length, relief.length, true), "with pm3d")};
  }
  return out;
}

}  // namespace asperity::plot
