#include "stats/sample/moments.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace asperity {

void MomentSums::add(const Eigen::Ref<const Field>& strip) {
  Eigen::ArrayXd row(strip.cols()), square;
  for (Index i = 0; i < strip.rows(); ++i) {
    row = (strip.row(i).transpose() - mean_.base) - mean_.above;
    Index there = row.size();
    if (std::isnan(row.sum()))
      there = std::remove_if(row.begin(), row.end(), [](double z) { return std::isnan(z); }) - row.begin();
    const auto d = row.head(there);
    if (d.size() == 0) continue;
    square = d.square();
    count_ += static_cast<double>(d.size());
    absolute_ += d.abs().sum();
    second_ += square.sum();
    third_ += (square * d).sum();
    fourth_ += square.square().sum();
    highest_ = std::max(highest_, d.maxCoeff());
    lowest_ = std::min(lowest_, d.minCoeff());
  }
}

Moments MomentSums::moments(std::string_view variable) const {
  const double n = count_, variance = second_ / n, fourth = fourth_ / n;
  if (highest_ == lowest_ && std::isfinite(highest_))
    throw DataError(std::string(variable), "every value is the same: skewness and kurtosis are undefined");
  if (!(variance * variance >= std::numeric_limits<double>::min() && std::isfinite(fourth)))
    throw DataError(std::string(variable),
                    "a value is infinite, or its fourth power exceeds the range of a double");
  return {.mean = mean_.value(),
          .sa = absolute_ / n,
          .sq = std::sqrt(variance),
          .ssk = third_ / n / (variance * std::sqrt(variance)),
          .sku = fourth / (variance * variance),
          .sp = highest_,
          .sv = -lowest_};
}

Moments moments(const Field& z, std::string_view variable) {
  MomentSums sums(mean_above_base(z));
  sums.add(z);
  return sums.moments(variable);
}

}  // namespace asperity
