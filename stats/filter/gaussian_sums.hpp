/// Sums of a field under the weight of the Gaussian filter.
///
/// (1) of stats/filter/gaussian_filter.hpp without its division by the sum of the weights, which the robust
/// filter takes with weights of its own.
///
/// Cost      of a sum one pruned transform there and back, padded by the reach of the weight.
#pragma once

#include <optional>

#include "core/field.hpp"
#include "transform/convolution.hpp"

namespace asperity {

/// Sums under the weight (1) over the points of a field, and along periodic axes over their images.
class GaussianSums {
 public:
  /// Throws as check_cutoff.
  GaussianSums(const Grid& grid, double cutoff, int threads = 1);

  /// Σ s z about each point; no point is missing.
  Field of(const Field& z) {
    Field out;
    sums_->apply(z, out);
    return out;
  }
  /// Σ s: of a field of ones.
  const Field& of_weights() const { return inside_; }

 private:
  std::optional<EvenConvolution> sums_;
  Field inside_;
};

}  // namespace asperity
