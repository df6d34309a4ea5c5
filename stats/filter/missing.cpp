#include "stats/filter/missing.hpp"

#include "core/error.hpp"

namespace asperity {

bool has_missing(const Field& z) { return std::isnan(z.sum()); }

double first_valid(const Field& z) {
  for (const double height : z.reshaped<Eigen::RowMajor>())
    if (!std::isnan(height)) return height;
  throw DataError("heights", "every point is missing");
}

Field zero_filled(const Field& z) { return z.isNaN().select(0.0, z); }

Field validity(const Field& z) { return z.isNaN().select(0.0, Field::Ones(z.rows(), z.cols())); }

}  // namespace asperity
