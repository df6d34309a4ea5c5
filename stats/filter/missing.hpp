/// Missing heights: points that were not measured, or are masked.
///
/// A missing point is NaN. Every statistic leaves it out: a sum runs over the measured points and is divided
/// by their number; a difference, cell or pair with a missing point does not count. A sum that is not NaN has
/// no missing point, so that complete fields need no extra pass.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "core/field.hpp"

namespace asperity {

/// A sum over the entries that are not NaN, and their number.
struct ValidSum {
  double sum = 0, count = 0;
};

template <class Derived>
ValidSum sum_of_valid(const Eigen::ArrayBase<Derived>& values) {
  if (const double sum = values.sum(); !std::isnan(sum)) return {sum, static_cast<double>(values.size())};
  const auto there = !values.isNaN();
  return {there.select(values, 0).sum(), static_cast<double>(there.count())};
}

inline bool has_missing(const Field& z) { return std::isnan(z.sum()); }

/// The field with zeros in place of missing points.
inline Field zero_filled(const Field& z) { return z.isNaN().select(0.0, z); }

/// 1 where there is a height, 0 where it is missing.
inline Field validity(const Field& z) { return z.isNaN().select(0.0, Field::Ones(z.rows(), z.cols())); }

}  // namespace asperity
