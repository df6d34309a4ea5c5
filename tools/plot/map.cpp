// Fields seen from above, with equal scales on both axes.
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "tools/plot/layout.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

// The lightness differs too, L* 94, 62, 34, so that the states differ in grey print.
constexpr struct {
  const char *colour, *name;
} states[] = {{"#ecece6", "open"}, {"#4d9fd6", "elastic"}, {"#a3123a", "at the limit"}};

// The points of a pixel along x and y; SVG and PDF are looked at enlarged too.
Shape block_of(const Patch& p, const Layout& layout, const Request& request) {
  const double scale = request.format == "png" ? 1 : 4, most = static_cast<double>(request.most_blocks);
  auto per_pixel = [&](Index points, double pixels) {
    return static_cast<Index>(
        std::ceil(static_cast<double>(points) / (most > 0 ? most : std::max(1.0, scale * pixels))));
  };
  return {per_pixel(p.values.rows(), layout.panel_width), per_pixel(p.values.cols(), layout.panel_height)};
}

// Values are divided by `unit`. Each panel has the unit of length that suits its size.
void add_plan_views(Figure& out, const std::vector<Patch>& patches, double unit, const Request& request,
                    Block shown) {
  out.aspect = std::clamp(patches[0].y.width() / patches[0].x.width(), flattest, tallest);
  if (request.scale_bar) out.left = 1.2, out.bottom = 2;
  for (std::size_t c = 0; c < patches.size(); ++c) {
    const Unit length = unit_for(reach(patches[c]), "m");
    out.panels[c].x = axis_of(patches[c].x, length, "x");
    out.panels[c].y = axis_of(patches[c].y, length, "y");
    for (auto* axis : {&out.panels[c].x, &out.panels[c].y})
      if (request.scale_bar) (*axis)->bar = length.name;
  }
  for (std::size_t c = 0; c < patches.size(); ++c)
    tell_stretch(out, c, patches[c].y.width() / patches[c].x.width(), "x", "y");
  if (std::ranges::any_of(patches, [](const Patch& p) { return !p.values.isFinite().all(); }))
    show_missing(out);
  const Layout layout = layout_of(out, request);
  for (std::size_t c = 0; c < patches.size(); ++c) {
    const Patch& p = patches[c];
    const Shape block = block_of(p, layout, request);
    if (block.cells() > 1)
      add_note(out, c,
               fmt::format("{} of {} × {} points", shown == Block::mean ? "means" : "largest", block.nx,
                           block.ny));
    const Unit length = unit_for(reach(p), "m");
    const Patch drawn{in_blocks(p.values, blocks_in(p.values, block), shown) / unit, p.x, p.y};
    out.panels[c].layers = {raster(drawn.values, lattice_of(drawn, length, length), "with image")};
  }
}

// One row or column of points each, along the same side.
bool are_rows(const Cases& cases, const std::string& variable) {
  auto row = [&](const Case& c, const char* across) {
    const Variable& v = c.data.at(variable);
    return v.dimensions == std::vector<std::string>{"x", "y"} && c.data.length(across) == 1 &&
           c.data.length("x") + c.data.length("y") > 2;
  };
  return std::ranges::all_of(cases, [&](const Case& c) { return row(c, "x"); }) ||
         std::ranges::all_of(cases, [&](const Case& c) { return row(c, "y"); });
}

// The title of a single field gives its range in numbers.
std::string range_in_words(const Patch& patch, const Quantity& quantity, const Level& level) {
  const Range range = range_of(patch.values);
  const Unit unit = unit_for(range.magnitude(), quantity.unit);
  return fmt::format("{} from {} to {} {}{}", quantity.name, brief(range.low / unit.factor),
                     brief(range.high / unit.factor), unit.name, level.words());
}

std::string shares_in_words(const Field& found) {
  const auto points = static_cast<double>(found.isFinite().count());
  return fmt::format("{:.1f} % in contact, {:.1f} % at the limit pressure",
                     100 * static_cast<double>((found >= 1).count()) / points,
                     100 * static_cast<double>((found == 2).count()) / points);
}

}  // namespace

Figure map(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  if (are_rows(cases, variable)) return profile(cases, request);
  std::vector<Patch> patches = patches_of(cases, variable, request);
  const Quantity quantity = quantity_of(cases, variable);
  Colours colours = field_colours(patches, quantity, request);
  const Level level = level_of(patches, colours.range, quantity);
  for (Patch& p : patches) p.values -= level.value;
  colours.range = {colours.range.low - level.value, colours.range.high - level.value};
  const Unit value = unit_for(colours.range.magnitude(), quantity.unit);
  Figure out = side_by_side(request, cases);
  if (!out.comparison) out.title = range_in_words(patches[0], quantity, level);
  out.right = 7.6;
  out.colours = {colours, value, quantity.name + level.words() + colours.words};
  add_plan_views(out, patches, value.factor, request, Block::mean);
  return out;
}

Figure contact(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("contact");
  const std::vector<Patch> patches = patches_of(cases, variable, request);
  for (const Patch& p : patches)
    if (const Range r = range_of(p.values); r.low < 0 || r.high > 2)
      throw DataError(variable,
                      fmt::format("contact state {} is none of 0 (open), 1 (elastic), 2 (at the limit)",
                                  r.low < 0 ? r.low : r.high));
  Figure out = side_by_side(request, cases);
  if (!out.comparison) out.title = shares_in_words(patches[0].values);
  for (const auto& state : states) out.legend.push_back({LegendEntry::Key::box, state.colour, state.name});
  add_plan_views(out, patches, 1, request, Block::largest);
  out.commands.line("set palette maxcolors 3 defined (0 '{}', 1 '{}', 2 '{}')", states[0].colour,
                    states[1].colour, states[2].colour);
  out.commands.line("set cbrange [-0.5:2.5]");
  return out;
}

}  // namespace asperity::plot
