/// What the tests share: Catch2's header, whatever its version, and the arithmetic of claims.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Message;
#else
#include <catch2/catch.hpp>
using Catch::Detail::Approx;
using Catch::Matchers::Message;
inline auto ContainsSubstring(const std::string& text) { return Catch::Matchers::Contains(text); }
#endif

#include <cmath>
#include <limits>
#include <random>

#include "core/field.hpp"

namespace asperity::test {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

inline double relative_error(double value, double exact) { return std::abs(value / exact - 1); }

/// The order p of an error C hᵖ, from two grids of spacing 2h and h.
inline double observed_order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

/// Independent numbers uniform in [-1, 1], the same at every run.
inline Field random_field(Shape shape, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index, Index) { return uniform(generator); });
}

}  // namespace asperity::test
