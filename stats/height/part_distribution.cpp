#include "stats/height/part_distribution.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "stats/height/distribution.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/block_error.hpp"

namespace asperity {
namespace {

// Scott's width on the range from 0; one bin where all values are the same.
int bins_of(const Field& z, double points) {
  if (z.maxCoeff<Eigen::PropagateNumbers>() == z.minCoeff<Eigen::PropagateNumbers>()) return 1;
  Moments m = moments(z);
  m.sp = m.mean + m.sp;  // from 0 on
  m.sv = 0;
  return scott_bins(m, points);
}

}  // namespace

std::vector<PartBin> part_histogram(const Field& z, int bins) {
  const double points = static_cast<double>((!z.isNaN()).count());
  if (bins > points)
    throw ParameterError("bins", fmt::format("'{}' is above the number of counted cells, {}", bins, points));
  if (points == 0) throw DataError("values", "there are none");
  return part_histogram(z, bins == 0 ? bins_of(z, points) : bins, z.maxCoeff<Eigen::PropagateNumbers>());
}

std::vector<PartBin> part_histogram(const Field& z, int bins, double largest) {
  if (!(largest > 0)) throw DataError("values", "none is above 0");
  const double points = static_cast<double>((!z.isNaN()).count());
  std::vector<double> edges;
  for (int k = 1; k < bins; ++k) edges.push_back(largest * k / bins);
  const ShareErrors errors = share_errors(z, edges);
  std::vector<PartBin> out(static_cast<std::size_t>(bins));
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].lower = k == 0 ? 0 : edges[k - 1];
    out[k].upper = k == edges.size() ? largest : edges[k];
    out[k].count_error = points * errors.within[k];
  }
  for (const double value : z.reshaped<Eigen::RowMajor>())
    if (!std::isnan(value))
      out[static_cast<std::size_t>(std::ranges::upper_bound(edges, value) - edges.begin())].count += 1;
  return out;
}

std::vector<PartQuantile> part_quantiles(const Field& z, int rows, int threads) {
  const MaterialRatioCurve curve(z, threads);
  std::vector<PartQuantile> out;
  std::vector<double> values;
  for (int k = 1; k <= rows; ++k) {
    const double share = static_cast<double>(k) / (rows + 1);
    out.push_back({.share = share, .value = curve.quantile(share)});
    values.push_back(out.back().value);
  }
  const ShareErrors errors = share_errors(z, values);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double e = errors.below[k], share = out[k].share;
    auto at = [&](double s) { return curve.quantile(std::clamp(s, 0.0, 1.0)); };
    out[k].error = std::isnan(e) ? e : (at(share + e) - at(share - e)) / 2;
  }
  return out;
}

}  // namespace asperity
