#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "tools/plot/layout.hpp"
#include "tools/plot/source.hpp"
#include "tools/plot/tics.hpp"

namespace asperity::plot {
namespace {

constexpr Index most_points = 128;     // along a side: more are not legible on paper
constexpr double height_share = 0.22;  // of the longer side that the range of values should take

// The side of blocks of which at most `most_points` lie along a side of the field.
Index block_of(const std::string& variable, const Field& values) {
  const Index nx = values.rows(), ny = values.cols();
  if (nx < 2 || ny < 2)
    throw DataError(variable, fmt::format("a perspective view needs at least 2 x 2 points, found {} x {}: "
                                          "draw a map or a profile",
                                          nx, ny));
  return (std::max(nx, ny) + most_points - 1) / most_points;
}

// Two blocks at least along a side.
Field thinned(const Field& values, Index block) {
  const Shape number = blocks_in(values, {block, block});
  return in_blocks(values, {std::max<Index>(number.nx, 2), std::max<Index>(number.ny, 2)}, Block::mean);
}

// A patch is drawn where four neighbouring points are there.
void require_a_cell(const std::string& variable, const Field& values) {
  const auto there = values.isFinite().cast<int>().eval();
  const Index nx = values.rows() - 1, ny = values.cols() - 1;
  const auto pairs = (there.topRows(nx) * there.bottomRows(nx)).eval();
  if ((pairs.leftCols(ny) * pairs.rightCols(ny)).maxCoeff() == 0)
    throw DataError(variable,
                    "a perspective view needs four neighbouring points, and no such four are all "
                    "there: draw a map");
}

// All cases as drawn: thinned alike, on one scale.
struct Relief {
  std::vector<Patch> patches;
  Quantity quantity;
  Level level = {};  ///< that the values are measured from
  Range values = {};
  Index block = 1;               ///< of so many points a side
  double factor = 1;             ///< plotted metres per unit of the quantity: 1, 2 or 5 × 10ⁿ
  Unit length = {}, value = {};  ///< of the axes

  double scale() const { return factor / length.factor; }  ///< plotted units per unit of the quantity
  /// With the factor of heights.
  std::string label() const {
    return value.label(quantity.name + level.difference()) +
           (quantity.unit == "m" ? " × " + brief(factor) : "");
  }
};

Relief relief_of(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases, variable);
  Relief out{.patches = patches_of(cases, variable, request), .quantity = quantity};
  for (const Patch& p : out.patches) out.block = std::max(out.block, block_of(variable, p.values));
  out.values =
      request.range.empty() ? range_of(out.patches) : field_colours(out.patches, quantity, request).range;
  out.level = level_of(out.patches, out.values, quantity);
  out.values = {out.values.low - out.level.value, out.values.high - out.level.value};
  for (Patch& p : out.patches) {
    p.values = thinned(p.values, out.block) - out.level.value;
    require_a_cell(variable, p.values);
  }
  if (!(drawable(out.values) == out.values)) {  // one value everywhere: a plane amid some room
    const double room = out.values.magnitude() > 0 ? out.values.magnitude() : 1;
    out.values = {out.values.low - room, out.values.high + room};
  }
  const double side = std::max(out.patches[0].x.width(), out.patches[0].y.width());
  out.factor = round_step(0.7 * (height_share * side / std::max(out.values.width(), 1e-300)), 1);
  for (std::size_t c = 0; c < cases.size(); ++c)
    if (const Patch& p = out.patches[c]; out.factor * out.values.width() > std::max(p.x.width(), p.y.width()))
      throw DataError(variable, fmt::format("of {} is too small beside the others for one scale: draw it "
                                            "apart",
                                            cases[c].label));
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

// How the axes are seen from (50°, 30°): right and up per unit of length.
const double lean = std::cos(50 * std::numbers::pi / 180), turn = 30 * std::numbers::pi / 180;
struct Seen {
  double right, up;
  double length() const { return std::hypot(right, up); }
};
const Seen seen_x{std::cos(turn), -std::sin(turn) * lean}, seen_y{std::sin(turn), std::cos(turn) * lean};

// A panel in which the longer side, seen from the front, would take 0.72 of its width.
struct View {
  const Relief& relief;
  const Patch& patch;
  double ems;  ///< of the panel's width

  double side() const { return std::max(patch.x.width(), patch.y.width()); }
  /// Length of an axis in the picture [em].
  double length(const Range& range, Seen seen) const {
    return 0.72 * ems * seen.length() * range.width() / side();
  }
};

// Two or three where there is room, 0.8 em apart; their places are in plotted units.
Tics tics_of_heights(const View& view) {
  const Relief& relief = view.relief;
  const double seen = 0.6 * std::sin(50 * std::numbers::pi / 180) * view.ems,
               side = view.side() / relief.length.factor,
               most = std::clamp(seen * relief.values.width() * relief.scale() / side / 0.8, 1.5, 4.0);
  const Range shown = relief.values / relief.value.factor;
  const double step = round_step(shown.width(), most);
  Tics out = tics_at(shown, step);
  if (out.size() < 2) {  // midway between
    out.clear();
    for (const double v : multiples({shown.low - step / 2, shown.high - step / 2}, step))
      out.push_back({v + step / 2, brief(v + step / 2)});
  }
  if (out.size() < 2) out = two_at_least(shown, step, 0.5);
  for (Tic& t : out) t.at *= relief.value.factor * relief.scale();
  return out;
}

// Numbers of x stand beside each other or one below the next, those of y below each other. The lowest of y
// stays clear of the highest of x at the corner in front.
Tics tics_of_x(const View& view, double unit) {
  const double length = view.length(view.patch.x, seen_x);
  return two_at_least(view.patch.x / unit,
                      round_step(view.patch.x.width() / unit, std::clamp(length / 3, 0.6, 4.0)),
                      2.2 / length);
}
Tics tics_of_y(const View& view, double unit) {
  const Range& y = view.patch.y;
  const double length = view.length(y, seen_y), clear = std::min(0.5, std::max(0.06, 1.3 / length));
  return two_at_least(Range{y.low + clear * y.width(), y.high} / unit,
                      round_step(y.width() / unit, std::clamp(length / 1.8, 0.6, 4.0)), 1.8 / length);
}

// Beside an axis, off by so many em: gnuplot's own labels know nothing of the numbers.
std::string label_at(const std::string& text, std::array<double, 3> at, double right, double up,
                     const Layout& layout, const char* style) {
  return fmt::format("set label {} at {},{},{} {} noenhanced offset screen {},{}", gnuplot_string(text),
                     at[0], at[1], at[2], style, right * layout.em / static_cast<double>(layout.pixels.nx),
                     up * layout.em / static_cast<double>(layout.pixels.ny));
}

Script axes_of(const View& view, const Layout& layout, bool leftmost) {
  Script script;
  const auto& [relief, p, ems] = view;
  const double unit = relief.length.factor, scale = relief.scale();
  const Range x = p.x / unit, y = p.y / unit, z{relief.values.low * scale, relief.values.high * scale};
  for (const auto& [name, range] : {std::pair{"x", x}, {"y", y}, {"z", z}})
    script.line("set {}range [{}:{}]", name, range.low, range.high);
  const Tics of_y = tics_of_y(view, unit);
  Tics of_z = tics_of_heights(view);
  script.line("{} offset 0,-0.3", command("x", tics_of_x(view, unit)));
  script.line("{} offset 0.4,-0.2", command("y", of_y));
  const auto middle = [](Range r) { return 0.5 * (r.low + r.high); };
  script.line("{}",
              label_at(relief.length.label("x"), {middle(x), y.low, z.low}, -1.4, -2.2, layout, "right"));
  script.line("{}", label_at(relief.length.label("y"), {x.high, y.low + 0.2 * y.width(), z.low},
                             1.2 + longest(of_y), -1.2, layout, "left"));
  if (leftmost)
    script.line("{}",
                label_at(shortened(relief.label(), 1.15 * layout.panel_height / layout.em),
                         {x.low, y.low, middle(z)}, -2.6 - longest(of_z), 0, layout, "rotate by 90 center"));
  for (Tic& tic : of_z)
    if (!leftmost) tic.text.clear();  // beside the panel on the left, whose scale they share
  script.line("{}", command("z", of_z));
  return script;
}

}  // namespace

Figure surface(const Cases& cases, const Request& request) {
  const Relief relief = relief_of(cases, request);
  const double scale = relief.scale();
  Colours colours = field_colours(relief.patches, relief.quantity, request);
  if (!request.range.empty() || !relief.level.number.empty()) colours.range = relief.values;
  colours.range = {colours.range.low * scale, colours.range.high * scale};
  Figure out = side_by_side(request, cases);
  out.title = relief.quantity.name;
  if (relief.quantity.unit == "m") out.title += " × " + brief(relief.factor);
  out.title += colours.words;
  if (relief.block > 1) out.title += fmt::format(", means of {0} × {0} points", relief.block);
  out.in_space = true;
  out.aspect = 0.72;
  out.left = 6.4, out.right = 4, out.bottom = 3.2, out.top = 1.6;
  out.gap_x = 3.5, out.gap_y = 3.2;
  out.colours = {colours, {}, ""};
  out.commands = view_of(relief);
  const Layout layout = layout_of(out, request);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Patch& p = relief.patches[c];
    out.panels[c].commands =
        axes_of({relief, p, layout.panel_width / layout.em}, layout, c % out.columns == 0);
    out.panels[c].layers = {
        raster(p.values * scale, lattice_of(p, relief.length, relief.length, true), "with pm3d")};
  }
  return out;
}

}  // namespace asperity::plot
