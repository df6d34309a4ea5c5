/// A map that stays in its file and passes through the steps in strips of rows: one pass for each form and
/// its figures, one for the range of the result, one that writes it.
#pragma once

#include <string>

#include "tools/filter/chain.hpp"

namespace asperity::cli {

/// Throws ParameterError("memory", …) where a step needs the whole map. Missing points are marked by
/// _FillValue alone, without a mask.
void filter_in_strips(Tool& tool, const Chain& chain, const std::string& path, const std::string& variable,
                      const std::string& output);

}  // namespace asperity::cli
