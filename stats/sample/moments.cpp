#include "stats/sample/moments.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"

namespace asperity {

void MomentSums::Sums::operator+=(const Sums& other) {
  count += other.count;
  absolute += other.absolute;
  second += other.second;
  third += other.third;
  fourth += other.fourth;
  highest = std::max(highest, other.highest);
  lowest = std::min(lowest, other.lowest);
}

void MomentSums::add(const Eigen::Ref<const Field>& strip, const Ranks& ranks) {
  std::vector<Sums> rows;
  Eigen::ArrayXd row(strip.cols()), square;
  for (Index i = 0; i < strip.rows(); ++i) {
    row = (strip.row(i).transpose() - mean_.base) - mean_.above;
    Index there = row.size();
    if (std::isnan(row.sum()))
      there = std::remove_if(row.begin(), row.end(), [](double z) { return std::isnan(z); }) - row.begin();
    const auto d = row.head(there);
    if (d.size() == 0) continue;
    square = d.square();
    rows.push_back({static_cast<double>(d.size()), d.abs().sum(), square.sum(), (square * d).sum(),
                    square.square().sum(), d.maxCoeff(), d.minCoeff()});
  }
  for (const Sums& of_row : gathered(ranks, rows)) sums_ += of_row;
}

Moments MomentSums::moments(std::string_view variable) const {
  const double n = sums_.count, variance = sums_.second / n, fourth = sums_.fourth / n;
  if (sums_.highest == sums_.lowest && std::isfinite(sums_.highest))
    throw DataError(std::string(variable), "every value is the same: skewness and kurtosis are undefined");
  if (!(variance * variance >= std::numeric_limits<double>::min() && std::isfinite(fourth)))
    throw DataError(std::string(variable),
                    "heights up to " + shortest(std::max(sums_.highest, -sums_.lowest)) +
                        " from the mean: infinite, or with fourth powers beyond the range of a double; give "
                        "them in another unit");
  return {.mean = mean_.value(),
          .sa = sums_.absolute / n,
          .sq = std::sqrt(variance),
          .ssk = sums_.third / n / (variance * std::sqrt(variance)),
          .sku = fourth / (variance * variance),
          .sp = sums_.highest,
          .sv = -sums_.lowest};
}

Moments moments(const Field& z, std::string_view variable, const Ranks& ranks) {
  MomentSums sums(mean_above_base(z, ranks));
  sums.add(z, ranks);
  return sums.moments(variable);
}

}  // namespace asperity
