#include "tools/filter/seam_step.hpp"

#include <fmt/format.h>

#include "stats/filter/seam.hpp"

namespace asperity::cli {
namespace {

enum class Closing { none, tilt, taper };

struct Seam {
  bool x = false, y = false;
  Closing how = Closing::none;
  SampledLength length = {};
};

Seam seam_of(const std::string& value) {
  const char* option = "make-periodic";
  const std::vector<std::string> words = split(value, ',');
  const std::string& axis = words.front();
  if (words.size() > 2 || (axis != "x" && axis != "y" && axis != "both"))
    refuse(option, value, "is not x, y or both, with ,tilt or ,taper=LENGTH behind it");
  Seam out{.x = axis != "y", .y = axis != "x"};
  if (words.size() == 1) return out;
  const std::string taper = "taper=";
  if (words[1] == "tilt") {
    out.how = Closing::tilt;
  } else if (words[1].starts_with(taper)) {
    out.how = Closing::taper;
    out.length = parse_length(option, words[1].substr(taper.size()));
  } else {
    refuse(option, words[1], "is neither tilt nor taper=LENGTH");
  }
  return out;
}

// "the jump at the seam of x is 0.3um rms and 1.2um at most, steps inside 0.1um rms"
std::string jump(const Surface& surface, Axis1D axis) {
  const SeamJump at = seam_jump(surface.heights, axis);
  const auto of = [&](double height) { return figure(height, surface.units); };
  return fmt::format("the jump at the seam of {} is {} rms and {} at most, steps inside {} rms",
                     axis == Axis1D::x ? "x" : "y", of(at.rms), of(at.largest), of(at.step_rms));
}

std::string close(Surface& surface, const Seam& seam, Axis1D axis) {
  bool& periodic = axis == Axis1D::x ? surface.grid.periodic.x : surface.grid.periodic.y;
  const Field former = surface.heights;
  std::string words = jump(surface, axis);
  if (seam.how == Closing::tilt) surface.heights = closed_by_tilt(surface.heights, axis);
  if (seam.how == Closing::taper) {
    const double spacing = axis == Axis1D::x ? surface.grid.dx : surface.grid.dy;
    surface.heights = closed_by_taper(surface.heights, surface.grid, axis, seam.length.metres(spacing));
  }
  if (seam.how != Closing::none)
    words += "; " + removed(former, surface.heights, surface.units) + "; now " + jump(surface, axis);
  periodic = true;
  return words;
}

}  // namespace

const std::string seam_text =
    "Let the map repeat along AXIS: x, y or both. The jump at the seam is told. HOW makes it smaller; tilt: "
    "by a tilt that removes its mean, taper=LENGTH: by fading the heights to their mean within LENGTH of "
    "both ends; x,tilt";

Act make_periodic(const std::string& value) {
  return [seam = seam_of(value)](const Tool&, Surface& surface) -> Account {
    std::string words;
    if (seam.x) words = close(surface, seam, Axis1D::x);
    if (seam.y) words += (words.empty() ? "" : "; ") + close(surface, seam, Axis1D::y);
    if (seam.how == Closing::taper)
      words += "; heights are lower there, so that errors of parameters are too large";
    return {words, true};
  };
}

}  // namespace asperity::cli
