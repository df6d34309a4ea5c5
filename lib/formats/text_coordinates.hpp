/// Whether columns of a bare matrix look like coordinates: a map that contains coordinates as heights would
/// go unnoticed.
///
/// The first ascends or descends in even steps and the last does not; the first of two is monotonic; the
/// first two of three lie on a grid or one of them is monotonic; or the first line, apart from its corner,
/// ascends evenly too. Even steps differ by a twentieth at most.
#pragma once

#include "core/field.hpp"

namespace asperity {

bool has_coordinates(const Eigen::Map<const Field>& lines);

}  // namespace asperity
