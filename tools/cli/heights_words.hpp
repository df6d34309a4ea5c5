/// What is to be said of heights where a tool reads or draws them.
#pragma once

#include <fmt/format.h>

#include "core/words.hpp"
#include "stats/sample/moments.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// Where heights in metres are too high or too steep for their width: a unit is wrong, it seems. Not with
/// --quiet.
inline void warn_of_proportions(const Tool& tool, const Proportions& of, std::string_view unit = "m") {
  if (unit != "m" || !of.implausible()) return;
  const auto metres = [](double length) { return format_quantity(std::stod(number(length)), "m"); };
  const std::string what =
      of.too_high()
          ? fmt::format("Sq = {} on a surface {} long: rough surfaces are lower than a tenth of that",
                        metres(of.sq()), metres(of.longer_side()))
          : fmt::format("the rms slope is {}: rough surfaces are less steep than 1", number(of.rms_slope()));
  tool.note("warning: " + what + "; check the units of heights and lengths");
}

/// And before any advice to measure more, where most of the heights is a tilt; `how` takes it off.
inline void warn_of_heights(const Tool& tool, const Proportions& of, std::string_view unit,
                            const std::string& how) {
  warn_of_proportions(tool, of, unit);
  if (of.tilted())
    tool.warn("a plane makes up " + in_digits(100 * of.plane_share(), 4) +
              " % of the variance of the heights: take it off first, " + how);
}

}  // namespace asperity::cli
