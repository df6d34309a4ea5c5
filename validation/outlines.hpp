/// Outlines of the measured part of a field.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/field.hpp"

namespace asperity::outlines {

/// 1 at the points that are measured, NaN elsewhere, in units of the sides:
///
///     rectangle    all points
///     disc         within a half of the middle
///     triangle     below a diagonal
///     holes        all but nine discs of the radius 0.1
///     islands      nine squares with sides of a fifth, a fifth apart
///     corners      the four squares with sides of a fifth in the corners
inline Field points(const std::string& outline, Shape shape) {
  auto inside = [&](double x, double y) {
    auto from_third = [](double at) { return at - (std::floor(3 * at) + 0.5) / 3; };
    auto on_island = [](double at) { return static_cast<int>(5 * at) % 2 == 0; };
    if (outline == "corners") return std::abs(x - 0.5) > 0.3 && std::abs(y - 0.5) > 0.3;
    if (outline == "disc") return std::hypot(x - 0.5, y - 0.5) < 0.5;
    if (outline == "triangle") return x + y < 1;
    if (outline == "holes") return std::hypot(from_third(x), from_third(y)) > 0.1;
    if (outline == "islands") return on_island(x) && on_island(y);
    if (outline == "rectangle") return true;
    throw std::invalid_argument("no outline is named " + outline);
  };
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index i, Index j) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(shape.nx),
                 y = (static_cast<double>(j) + 0.5) / static_cast<double>(shape.ny);
    return inside(x, y) ? 1.0 : NAN;
  });
}

}  // namespace asperity::outlines
