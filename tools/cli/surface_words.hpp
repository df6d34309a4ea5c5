/// Grids in words, when two are the same, and warnings of heights that a tool reads or draws.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/field.hpp"
#include "core/words.hpp"
#include "stats/sample/ensemble.hpp"
#include "stats/sample/moments.hpp"
#include "tools/cli/messages.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {

/// ", periodic", ", periodic along x", or nothing.
inline std::string periodic_words(Periodic periodic) {
  if (!periodic.any()) return "";
  return periodic.both() ? ", periodic" : periodic.x ? ", periodic along x" : ", periodic along y";
}

/// "64x32 cells on 1mm x 0.5mm, periodic"
inline std::string described(const Grid& grid) {
  return std::to_string(grid.shape.nx) + "x" + std::to_string(grid.shape.ny) + " cells on " +
         format_quantity(grid.size_x(), "m") + " x " + format_quantity(grid.size_y(), "m") +
         periodic_words(grid.periodic);
}

inline bool same_grid(const Grid& one, const Grid& other) {
  return one.shape == other.shape && one.periodic == other.periodic && same_spacing(one, other);
}

/// Where heights in metres are too high or too steep for their width: a unit is wrong, it seems. Not with
/// --quiet.
inline void warn_of_proportions(const Messages& messages, const Proportions& of,
                                std::string_view unit = "m") {
  if (unit != "m" || !of.implausible()) return;
  const auto metres = [](double length) { return format_quantity(std::stod(number(length)), "m"); };
  const std::string what =
      of.too_high()
          ? fmt::format("Sq = {} on a surface {} long: rough surfaces are lower than a tenth of that",
                        metres(of.sq()), metres(of.longer_side()))
          : fmt::format("the rms slope is {}: rough surfaces are less steep than 1", number(of.rms_slope()));
  messages.note("warning: " + what + "; check the units of heights and lengths");
}

/// And before any advice to measure more, where most of the heights is a tilt; `how` takes it off.
inline void warn_of_heights(const Messages& messages, const Proportions& of, std::string_view unit,
                            const std::string& how) {
  warn_of_proportions(messages, of, unit);
  if (of.tilted())
    messages.warn("a plane makes up " + in_digits(100 * of.plane_share(), 4) +
                  " % of the variance of the heights: take it off first, " + how);
}

}  // namespace asperity::cli
