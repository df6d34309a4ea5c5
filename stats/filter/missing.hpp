/// Missing heights: points that were not measured, or are masked.
///
/// In a field that is measured a missing point is NaN. Every statistic leaves it out: a sum runs over the points that
/// are there and is divided by their number, a difference or a cell with a missing point does not count, a pair of
/// points counts when both are there (stats/spatial/pairs.hpp). Nothing is made up for it.
///
/// Differences of what is missing are NaN too, and so is a sum over them: a sum that is a number shows that nothing
/// is missing from it, and a field without missing points pays nothing for those that others have.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "core/field.hpp"

namespace asperity {

/// A sum over the entries that are there, and their number.
struct ValidSum {
  double sum = 0, count = 0;
};

template <class Derived>
ValidSum sum_of_valid(const Eigen::ArrayBase<Derived>& values) {
  if (const double sum = values.sum(); !std::isnan(sum)) return {sum, static_cast<double>(values.size())};
  const auto there = !values.isNaN();
  return {there.select(values, 0).sum(), static_cast<double>(there.count())};
}

bool has_missing(const Field& z);

/// The first height that is there; throws DataError("heights", …) when every point is missing.
double first_valid(const Field& z);

/// The field with zeros in place of missing points.
Field zero_filled(const Field& z);

/// 1 where there is a height, 0 where it is missing.
Field validity(const Field& z);

}  // namespace asperity
