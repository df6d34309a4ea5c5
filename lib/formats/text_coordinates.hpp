/// Whether columns of a bare matrix look like coordinates: a map that contains coordinates as heights would
/// go unnoticed.
///
/// Columns do if the first ascends or descends in even steps and the last does not; if the first of two is
/// monotonic; if the first two of three lie on a grid or one of them is monotonic; or if the first line,
/// apart from its corner, ascends evenly too. The first line does if it alone ascends or descends in even
/// steps, of three lines and four columns at least; or apart from its corner, if that is missing, of three
/// columns. Even steps differ by a twentieth at most.
#pragma once

#include "core/field.hpp"

namespace asperity {

enum class Coordinates { none, columns, line };
Coordinates coordinates_in(const Eigen::Map<const Field>& lines);

}  // namespace asperity
