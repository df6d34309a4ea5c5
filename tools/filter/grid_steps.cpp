// Parts of a map, and maps on other grids.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/resampling.hpp"
#include "stats/filter/seam.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/filter/chain.hpp"
#include "transform/refinement.hpp"

namespace asperity::cli {
namespace {

StepReport now_has(const Grid& grid) { return {"now " + described(grid)}; }

void refuse_holes(const char* option, const Surface& surface) {
  if (surface.heights.hasNaN())
    throw UsageError(option, "the map has missing points: fill them first (--fill laplace)");
}

// ---- crop ----

struct Range {
  Index begin = 0;
  std::optional<Index> end = {};  ///< none: that of the map
  std::string word = {};

  auto of(Index n) const {
    if (begin >= end.value_or(n) || end.value_or(n) > n)
      throw UsageError("crop", "'" + word + "' is not a range A:B with 0 <= A < B <= " + std::to_string(n));
    return Eigen::seqN(begin, end.value_or(n) - begin);
  }
};

// "A:B"; either may be omitted.
Range range_of(const std::string& word) {
  const std::size_t colon = std::min(word.find(':'), word.size());
  const std::string_view all = word, first = all.substr(0, colon),
                         second = all.substr(std::min(colon + 1, all.size()));
  const auto a = to_number<Index>(first), b = to_number<Index>(second);
  const bool wrong = colon == word.size() || (!a && !first.empty()) || (!b && !second.empty());
  if (wrong || a.value_or(0) < 0) throw UsageError("crop", "'" + word + "' is not a range A:B of points");
  return {a.value_or(0), b, word};
}

struct Crop {
  Range x, y;

  explicit Crop(const std::string& value) {
    const std::vector<std::string> words = split(value, ',');
    if (words.size() != 2) throw UsageError("crop", "'" + value + "' is not of the form A:B,C:D");
    x = range_of(words[0]), y = range_of(words[1]);
  }
  // A part of a period is not periodic.
  Grid of(Grid grid) const {
    const Shape now{x.of(grid.shape.nx).size(), y.of(grid.shape.ny).size()};
    grid.periodic = {grid.periodic.x && now.nx == grid.shape.nx, grid.periodic.y && now.ny == grid.shape.ny};
    grid.shape = now;
    return grid;
  }
};

Act crop(const std::string& value) {
  return [crop = Crop(value)](const Tool&, Surface& surface) {
    const auto [nx, ny] = surface.grid.shape;
    const Grid part = crop.of(surface.grid);
    const double share = static_cast<double>(part.shape.cells()) / static_cast<double>(nx * ny);
    surface.degree = degree_on_part(surface.degree, surface.grid, share);
    surface.grid = part;
    surface.heights = surface.heights(crop.x.of(nx), crop.y.of(ny)).eval();
    return now_has(surface.grid);
  };
}

// ---- fewer points, and more ----

// A period has whole steps.
Grid thinned(const Grid& grid, Shape step) {
  const auto [nx, ny] = grid.shape;
  if (step.nx > nx || step.ny > ny)
    refuse("decimate", text(step), "is more than the map has points, " + text(grid.shape));
  return {{(nx + step.nx - 1) / step.nx, (ny + step.ny - 1) / step.ny},
          grid.dx * static_cast<double>(step.nx),
          grid.dy * static_cast<double>(step.ny),
          {grid.periodic.x && nx % step.nx == 0, grid.periodic.y && ny % step.ny == 0}};
}

// "A" for both, or "AxB".
Shape factors(const char* option, const std::string& value, const Bounds& bounds) {
  return parse_counts(option, value.find('x') == value.npos ? value + "x" + value : value, bounds);
}

Act decimate(const std::string& value) {
  return [step = factors("decimate", value, 1)](const Tool&, Surface& surface) {
    surface.grid = thinned(surface.grid, step);
    const auto [nx, ny] = surface.grid.shape;
    surface.heights = surface.heights(Eigen::seqN(0, nx, step.nx), Eigen::seqN(0, ny, step.ny)).eval();
    return now_has(surface.grid);
  };
}

Act refine(const std::string& value) {
  const Shape factor = factors("refine", value, {1, 1024});
  return [factor, value](const Tool& tool, Surface& surface) {
    if (factor == Shape{1, 1}) return now_has(surface.grid);
    refuse_holes("refine", surface);
    const Grid fine = refined_grid(surface.grid, factor);
    constexpr double written = 16;  // bytes a point, in a dataset and as it is encoded
    tool.require_memory(refinement_memory(surface.grid, factor) +
                            written * static_cast<double>(fine.shape.nx) * static_cast<double>(fine.shape.ny),
                        "refine", value + ": a map of " + text(fine.shape) + " points");
    surface.heights = refined(surface.heights, surface.grid, factor, tool.thread_count());
    surface.grid = fine;
    return now_has(surface.grid);
  };
}

Act respace(const std::string& value) {
  const auto spacing = parse_quantities("spacing", value, "m");
  return [spacing](const Tool& tool, Surface& surface) {
    refuse_holes("spacing", surface);
    const Grid grid = resampled_grid(surface.grid, spacing[0], spacing[1]);
    constexpr double taken = 48;  // bytes a point, with a transform and as it is encoded
    const auto columns = static_cast<double>(grid.shape.ny);
    tool.require_memory(columns * (taken * static_cast<double>(grid.shape.nx) +
                                   8 * static_cast<double>(surface.grid.shape.nx)),
                        "spacing", "a map of " + text(grid.shape) + " points");
    surface.heights = resampled(surface.heights, surface.grid, spacing[0], spacing[1], tool.thread_count());
    surface.grid = grid;
    return now_has(surface.grid);
  };
}

// ---- turned, mirrored ----

Act rotate(const std::string& value) {
  return [angle = parse_angle("rotate", value)](const Tool& tool, Surface& surface) -> StepReport {
    const Grid grid = rotated_grid(surface.grid, angle);
    constexpr double taken = 32;  // bytes a point, with the map that is turned and as it is encoded
    tool.require_memory(taken * static_cast<double>(grid.shape.cells()), "rotate",
                        "a map of " + text(grid.shape) + " points");
    surface.heights = rotated(surface.heights, surface.grid, angle, tool.thread_count());
    surface.grid = grid;
    const Index outside = missing_in(surface.heights);
    return {now_has(surface.grid).words + ", " + share_of(outside, surface.heights.size()) + " missing",
            outside > 0};
  };
}

Act mirror(const std::string& value) {
  const bool x = value == "x" || value == "both", y = value == "y" || value == "both";
  if (!x && !y) refuse("mirror", value, "is none of x|y|both");
  return [x, y](const Tool&, Surface& surface) -> StepReport {
    if (x) surface.heights = mirrored(surface.heights, Axis1D::x);
    if (y) surface.heights = mirrored(surface.heights, Axis1D::y);
    return {x && y ? "x and y reversed" : x ? "x reversed" : "y reversed"};
  };
}

// ---- the seam: "x", "both,tilt", "y,taper=0.1mm" ----

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
    refuse(option, value, "is not x, y or both, with ,tilt or ,taper=LENGTH after it");
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

Act make_periodic(const std::string& value) {
  return [seam = seam_of(value)](const Tool&, Surface& surface) -> StepReport {
    std::string words;
    if (seam.x) words = close(surface, seam, Axis1D::x);
    if (seam.y) words += (words.empty() ? "" : "; ") + close(surface, seam, Axis1D::y);
    if (seam.how == Closing::taper)
      words += "; heights are lower there, so that errors of parameters are too large";
    return {words, true};
  };
}

}  // namespace

std::vector<StepKind> grid_steps() {
  const char* group = "Grid";
  return {
      {"crop", "A:B,C:D",
       "Keep points A to B-1 in x and C to D-1 in y; the first point is 0, an omitted end is the map's edge",
       group, crop},
      {"decimate", "AxB", "Keep every A-th point in x and every B-th in y, or every A-th in both", group,
       decimate},
      {"refine", "AxB",
       "Put A times as many points in x and B times in y, or A for both, between those of the map, by its "
       "own waves: trigonometric interpolation of a periodic map, mirrored cosines above a form of degree 2 "
       "of any other. The domain stays; of an odd A every A-th point is one of the map's",
       group, refine},
      {"spacing", "A[,B]",
       "Resample to this spacing, by the map's own waves as --refine; waves shorter than two new points are "
       "left out. A periodic axis takes the nearest spacing that divides it",
       group, respace},
      {"rotate", "ANGLE",
       "Turn the map counter-clockwise, from +x towards +y: 30deg. Its corners are missing then, except at "
       "quarter turns",
       group, rotate},
      {"mirror", "x|y|both", "Reverse the order of the points along x, y or both", group, mirror},
      {"make-periodic", "AXIS[,HOW]",
       "Let the map repeat along AXIS: x, y or both. A note gives the jump at the seam. HOW makes it "
       "smaller; tilt: by a tilt that removes its mean, taper=LENGTH: by fading the heights to their mean "
       "within LENGTH of both ends; x,tilt",
       group, make_periodic}};
}

}  // namespace asperity::cli
