#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "tools/plot/kinds.hpp"
#include "tools/plot/plan_view.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

// One field needs no label in its panel; its title says what the colours cannot.
std::string default_title(const std::vector<Patch>& patches, const Quantity& quantity) {
  if (patches.size() > 1) return "";
  const Range range = range_of(patches[0].values);
  const Unit unit = unit_for(range.magnitude(), quantity.unit);
  return fmt::format("{} from {} to {} {}", quantity.name, brief(range.low / unit.factor),
                     brief(range.high / unit.factor), unit.name);
}

}  // namespace

Script map(const Cases& cases, const Request& request) {
  const std::string variable = request.variable.empty() ? "heights" : request.variable;
  std::vector<Patch> patches;
  for (const Case& c : cases) patches.push_back(patch_of(c.data, variable, request));
  const Quantity quantity = quantity_of(cases[0].data.at(variable));
  const Colours colours = field_colours(patches, quantity, request);
  const Unit length = unit_for(reach(patches[0]), "m"),
             value = unit_for(colours.range.magnitude(), quantity.unit);
  Sheet sheet = side_by_side(request, cases.size());
  sheet.right = 7.6;
  sheet.aspect = std::clamp(patches[0].y.width() / patches[0].x.width(), flattest, tallest);
  Figure figure(request, sheet, default_title(patches, quantity));
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Lattice at = plan_view(figure, patches[c], length, c, cases[c].label);
    figure.colours(colours, value, quantity.name);
    figure.script.draw("plot", {raster(patches[c].values / value.factor, at, "with image")});
  }
  return figure.script;
}

}  // namespace asperity::plot
