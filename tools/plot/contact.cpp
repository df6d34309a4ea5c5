#include <algorithm>

#include "core/error.hpp"
#include "tools/plot/kinds.hpp"
#include "tools/plot/plan_view.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

// Apart in lightness too, so that a grey print tells them: L* 94, 62, 34.
constexpr const char* state_colours[] = {"#ecece6", "#4d9fd6", "#a3123a"};
constexpr const char* state_names[] = {"open", "elastic", "at the limit"};

std::vector<LegendEntry> legend() {
  std::vector<LegendEntry> out;
  for (std::size_t state = 0; state < std::size(state_names); ++state)
    out.push_back({LegendEntry::Key::box, state_colours[state], state_names[state]});
  return out;
}

std::string default_title(const std::vector<Patch>& patches) {
  if (patches.size() > 1) return "";
  const Field& states = patches[0].values;
  const auto points = static_cast<double>(states.isFinite().count());
  return fmt::format("{:.1f} % in contact, {:.1f} % at the limit pressure",
                     100 * static_cast<double>((states >= 1).count()) / points,
                     100 * static_cast<double>((states == 2).count()) / points);
}

}  // namespace

Script contact(const Cases& cases, const Request& request) {
  const std::string variable = request.variable.empty() ? "contact" : request.variable;
  std::vector<Patch> patches;
  for (const Case& c : cases) {
    patches.push_back(patch_of(c.data, variable, request));
    const Range states = range_of(patches.back().values);
    if (states.low < 0 || states.high > 2)
      throw DataError(variable, fmt::format("the state {} is none of 0 (open), 1 (elastic), 2 (at the limit)",
                                            states.low < 0 ? states.low : states.high));
  }
  const Unit length = unit_for(reach(patches[0]), "m");
  Sheet sheet = side_by_side(request, cases.size());
  sheet.legend = legend();
  sheet.aspect = std::clamp(patches[0].y.width() / patches[0].x.width(), flattest, tallest);
  Figure figure(request, sheet, default_title(patches));
  figure.script.line("set palette maxcolors 3 defined (0 '{}', 1 '{}', 2 '{}')", state_colours[0],
                     state_colours[1], state_colours[2]);
  figure.script.line("set cbrange [-0.5:2.5]");
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Lattice at = plan_view(figure, patches[c], length, c, cases[c].label);
    if (c + 1 == cases.size()) figure.legend();
    figure.script.draw("plot", {raster(patches[c].values, at, "with image")});
  }
  return figure.script;
}

}  // namespace asperity::plot
