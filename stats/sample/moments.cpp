#include "stats/sample/moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"

namespace asperity {

namespace {

struct Sums {
  double count = 0, absolute = 0, second = 0, third = 0, fourth = 0;
  double highest = -std::numeric_limits<double>::infinity(), lowest = std::numeric_limits<double>::infinity();

  void operator+=(const Sums& other) {
    count += other.count;
    absolute += other.absolute;
    second += other.second;
    third += other.third;
    fourth += other.fourth;
    highest = std::max(highest, other.highest);
    lowest = std::min(lowest, other.lowest);
  }
};

Sums sums_of(const Field& z, const Mean& mean) {
  Sums sums;
  Eigen::ArrayXd row(z.cols()), square;
  for (Index i = 0; i < z.rows(); ++i) {
    row = (z.row(i).transpose() - mean.base) - mean.above;
    Index there = row.size();
    if (std::isnan(row.sum()))
      there = std::remove_if(row.begin(), row.end(), [](double height) { return std::isnan(height); }) -
              row.begin();
    const auto d = row.head(there);
    if (d.size() == 0) continue;
    square = d.square();
    sums += {static_cast<double>(d.size()), d.abs().sum(), square.sum(), (square * d).sum(),
             square.square().sum(),         d.maxCoeff(),  d.minCoeff()};
  }
  return sums;
}

}  // namespace

Moments moments(const Field& z, std::string_view variable) {
  const Mean mean = mean_above_base(z);
  const Sums sums = sums_of(z, mean);
  const double n = sums.count, variance = sums.second / n, fourth = sums.fourth / n;
  if (sums.highest == sums.lowest && std::isfinite(sums.highest))
    throw DataError(std::string(variable), "every value is the same: skewness and kurtosis are undefined");
  if (!(variance * variance >= std::numeric_limits<double>::min() && std::isfinite(fourth)))
    throw DataError(std::string(variable),
                    "heights up to " + shortest(std::max(sums.highest, -sums.lowest)) +
                        " from the mean: infinite, or with fourth powers beyond the range of a double; give "
                        "them in another unit");
  return {.mean = mean.value(),
          .sa = sums.absolute / n,
          .sq = std::sqrt(variance),
          .ssk = sums.third / n / (variance * std::sqrt(variance)),
          .sku = fourth / (variance * variance),
          .sp = sums.highest,
          .sv = -sums.lowest};
}

}  // namespace asperity
