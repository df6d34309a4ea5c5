#include "stats/moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "grid/error.hpp"
#include "stats/form.hpp"

namespace asperity {
namespace {

// Σ|d|, Σd², Σd³, Σd⁴ and the extremes of d.
struct Sums {
  double absolute = 0, second = 0, third = 0, fourth = 0;
  double highest = -std::numeric_limits<double>::infinity(), lowest = std::numeric_limits<double>::infinity();

  void add(const Eigen::ArrayXd& d, Eigen::ArrayXd& square) {
    square = d.square();
    absolute += d.abs().sum();
    second += square.sum();
    third += (square * d).sum();
    fourth += square.square().sum();
    highest = std::max(highest, d.maxCoeff());
    lowest = std::min(lowest, d.minCoeff());
  }
};

Sums central_sums(const Field& z, double shift, double level) {
  Sums sums;
  Eigen::ArrayXd d(z.cols()), square(z.cols());
  for (Index i = 0; i < z.rows(); ++i) {
    d = (z.row(i).transpose() - shift) - level;
    sums.add(d, square);
  }
  return sums;
}

}  // namespace

Moments moments(const Field& z, std::string_view variable) {
  const double shift = z(0, 0), level = (z - shift).rowwise().mean().mean();
  const Sums sums = central_sums(z, shift, level);
  const double n = static_cast<double>(z.size()), variance = sums.second / n;
  if (!(variance > 0))
    throw DataError(std::string(variable),
                    "every value is the same: skewness and kurtosis need some roughness");
  return {.mean = shift + level,
          .sa = sums.absolute / n,
          .sq = std::sqrt(variance),
          .ssk = sums.third / n / (variance * std::sqrt(variance)),
          .sku = sums.fourth / n / (variance * variance),
          .sp = sums.highest,
          .sv = -sums.lowest};
}

}  // namespace asperity
