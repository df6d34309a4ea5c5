/// What the groups of parameters share: rows without a value, and why.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "tools/measure/groups.hpp"

namespace asperity::cli {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Says why of the rows from `first` on that have no value.
inline void explain(Rows& rows, std::size_t first, const std::string& why) {
  for (std::size_t i = first; i < rows.size(); ++i)
    if (!std::isfinite(rows[i].value)) rows[i].why = why;
}

}  // namespace asperity::cli
