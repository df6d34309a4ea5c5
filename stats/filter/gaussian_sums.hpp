/// Sums of a field under the weight of the Gaussian filter.
///
/// (1) of stats/filter/gaussian_filter.hpp without its division by the sum of the weights, which the robust
/// filter takes with weights of its own.
///
/// Cost      of a sum one pruned transform there and back, padded by the reach of the weight.
#pragma once

#include <optional>
#include <utility>

#include "core/field.hpp"
#include "transform/convolution.hpp"

namespace asperity {

/// Sums under the weight (1) over the points of a field, and along periodic axes over their images.
class GaussianSums {
 public:
  /// Throws as check_cutoff.
  GaussianSums(const Grid& grid, double cutoff, int threads = 1);

  /// Σ s z about each point; no point is missing.
  Field of(Field z) {
    sums_->apply(z, z);
    return z;
  }
  /// Σ s z / Σ s.
  Field mean(Field z) {
    z = of(std::move(z));
    for (Index i = 0; i < z.rows(); ++i) z.row(i) /= inside_x_[i] * inside_y_.transpose();
    return z;
  }

 private:
  std::optional<EvenConvolution> sums_;
  Eigen::ArrayXd inside_x_, inside_y_;  ///< Σ s along each axis
};

}  // namespace asperity
