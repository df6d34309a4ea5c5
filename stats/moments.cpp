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
  double count = 0, absolute = 0, second = 0, third = 0, fourth = 0;
  double highest = -std::numeric_limits<double>::infinity(), lowest = std::numeric_limits<double>::infinity();

  void add(const Eigen::Ref<const Eigen::ArrayXd>& d, Eigen::ArrayXd& square) {
    square = d.square();
    count += static_cast<double>(d.size());
    absolute += d.abs().sum();
    second += square.sum();
    third += (square * d).sum();
    fourth += square.square().sum();
    highest = std::max(highest, d.maxCoeff());
    lowest = std::min(lowest, d.minCoeff());
  }
};

// Of the heights of a row that are there, moved to its beginning.
Index compact(Eigen::ArrayXd& d) {
  return std::remove_if(d.begin(), d.end(), [](double height) { return std::isnan(height); }) - d.begin();
}

Sums central_sums(const Field& z, const Mean& mean) {
  Sums sums;
  Eigen::ArrayXd d(z.cols()), square;
  for (Index i = 0; i < z.rows(); ++i) {
    d = (z.row(i).transpose() - mean.base) - mean.above;
    if (const Index there = std::isnan(d.sum()) ? compact(d) : d.size(); there > 0)
      sums.add(d.head(there), square);
  }
  return sums;
}

}  // namespace

Moments moments(const Field& z, std::string_view variable) {
  const Mean mean = mean_above_base(z);
  const Sums sums = central_sums(z, mean);
  const double n = sums.count, variance = sums.second / n;
  if (!(variance > 0))
    throw DataError(std::string(variable),
                    "every value is the same: skewness and kurtosis need some roughness");
  return {.mean = mean.value(),
          .sa = sums.absolute / n,
          .sq = std::sqrt(variance),
          .ssk = sums.third / n / (variance * std::sqrt(variance)),
          .sku = sums.fourth / n / (variance * variance),
          .sp = sums.highest,
          .sv = -sums.lowest};
}

}  // namespace asperity
