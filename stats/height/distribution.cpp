#include "stats/height/distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "math/hermite.hpp"

namespace asperity {
namespace {

// Φ(b) - Φ(a) without cancellation in the upper tail.
double gaussian_share(double a, double b) {
  return a > 0 ? gsl_cdf_ugaussian_Q(a) - gsl_cdf_ugaussian_Q(b)
               : gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a);
}

}  // namespace

double misfit_variance(const std::function<double(int)>& weight, double total,
                       const EffectiveSampleSize& size) {
  constexpr int powers = EffectiveSampleSize::powers;
  std::array<double, powers + 1> w;
  for (int k = 1; k <= powers; ++k) w[static_cast<std::size_t>(k)] = weight(k);
  const double dropped = (w[1] + w[2]) * size.sum(powers) / size.points();
  auto kept = [&](int k) { return k < 3 ? 0 : w[static_cast<std::size_t>(k)]; };
  return std::max(size.variance_of_mean(kept, total) - dropped, 0.0);
}

HeightRange height_range(const Field& z) {
  return {z.minCoeff<Eigen::PropagateNumbers>(), z.maxCoeff<Eigen::PropagateNumbers>()};
}

int scott_bins(const Moments& moments, double points) {
  const double width = std::cbrt(24 / std::numbers::inv_sqrtpi / points) * moments.sq;
  return static_cast<int>(std::clamp(std::ceil(moments.sz() / width), 1.0, std::min(points, 1e6)));
}

std::vector<Bin> histogram(const Field& z, int bins, std::optional<HeightRange> range) {
  if (bins < 1) throw ParameterError("bins", "'" + std::to_string(bins) + "' is below 1");
  if (!range) range = height_range(z);
  const double lowest = range->lowest, width = range->width() / bins;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  if (!(width >= epsilon * z.isNaN().select(0, z).abs().maxCoeff()))
    throw DataError("heights", "their range is too narrow for " + std::to_string(bins) +
                                   " bins: neighbouring edges are the same double");
  std::vector<Bin> out(static_cast<std::size_t>(bins));
  for (std::size_t b = 0; b < out.size(); ++b) {
    out[b].lower = lowest + static_cast<double>(b) * width;
    out[b].upper = lowest + static_cast<double>(b + 1) * width;
  }
  for (const double height : z.reshaped<Eigen::RowMajor>()) {
    if (std::isnan(height)) continue;
    const auto b = static_cast<std::size_t>((height - lowest) / width);
    out[std::min(b, out.size() - 1)].count += 1;
  }
  return out;
}

void compare_with_gaussian(std::vector<Bin>& bins, const Moments& moments, const EffectiveSampleSize& size) {
  for (Bin& bin : bins) {
    const double a = (bin.lower - moments.mean) / moments.sq, b = (bin.upper - moments.mean) / moments.sq;
    const double share = gaussian_share(a, b);
    HermiteFunction at_a(a, gsl_ran_ugaussian_pdf(a)), at_b(b, gsl_ran_ugaussian_pdf(b));
    auto weight = [&](int k) {
      const double c = at_a.next() - at_b.next();
      return c * c / k;
    };
    const double n = size.points();
    bin.expected = n * share;
    bin.misfit_error = n * std::sqrt(misfit_variance(weight, share * (1 - share), size));
  }
}

void set_errors(std::vector<Bin>& bins, const Field& z, const Grid& grid, const FieldExtent& extent,
                double sq) {
  // An error of the mean is Sq/√N_eff at least.
  const double step = 0.5 * sq / std::sqrt(std::max(extent.patches, 1.0)), width = bins.front().width();
  const Index parts = sq > 0 ? static_cast<Index>(std::min(std::ceil(width / step), 1e3)) : 1;
  const HeightClasses classes(
      z, grid, extent, {bins.front().lower, bins.back().upper, parts * static_cast<Index>(bins.size())},
      sq > 0);
  std::vector<Frequency> shares;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    ShareErrors::Function in_bin(classes.errors());
    for (Index k = 0; k < parts; ++k) in_bin.add(static_cast<Index>(b) * parts + k, 1);
    shares.push_back(classes.frequency(in_bin, bins[b].count, [&](double delta) {
      return classes.below(bins[b].upper + delta) - classes.below(bins[b].lower + delta);
    }));
  }
  set_intervals(shares, 1);
  for (std::size_t b = 0; b < bins.size(); ++b) bins[b].share = shares[b];
}

// ---- classes of height ----

HeightClasses::HeightClasses(const Field& z, const Grid& grid, const FieldExtent& extent, const Range& range,
                             bool own_mean)
    : range_(range), errors_(grid, extent, range.classes) {
  const double width = range.width(), last = static_cast<double>(range.classes - 1);
  errors_.add(z, [&](double value) {
    return static_cast<Index>(std::clamp((value - range.lowest) / width, 0.0, last));
  });
  for (Index b = 0; b < range.classes; ++b) below_.push_back(below_.back() + errors_.share(b));
  if (own_mean) of_mean_ = ShareErrors::Function(errors_).error(1).error;
}

double HeightClasses::below(double height) const {
  const double place =
      std::clamp((height - range_.lowest) / range_.width(), 0.0, static_cast<double>(range_.classes));
  const auto b = std::min(static_cast<std::size_t>(place), below_.size() - 2);
  return below_[b] + (place - static_cast<double>(b)) * (below_[b + 1] - below_[b]);
}

// ---- steps of an instrument ----

namespace {

constexpr double same = 1e-6, most_steps = 1e5;  // of the range
constexpr double near = 50;                      // steps that a first estimate counts well
constexpr double off = 0.1;                      // of a step

// Runs apart by more than the least difference are different values.
std::vector<double> different(const std::vector<HeightRun>& runs) {
  std::vector<double> out;
  if (runs.empty()) return out;
  const double least = same * (runs.back().height - runs.front().height);
  for (const auto& [count, height] : runs)
    if (out.empty() || height - out.back() > least) out.push_back(height);
  return out;
}

}  // namespace

std::vector<HeightRun> runs_of_equal(const Field& z) {
  std::vector<double> sorted(z.data(), z.data() + z.size());
  std::erase_if(sorted, [](double height) { return !std::isfinite(height); });
  std::ranges::sort(sorted);
  std::vector<HeightRun> out;
  for (const double height : sorted)
    if (!out.empty() && out.back().height == height)
      ++out.back().count;
    else
      out.push_back({1, height});
  return out;
}

HeightSteps height_steps(const std::vector<HeightRun>& runs) {
  const std::vector<double> values = different(runs);
  HeightSteps out{.values = std::ssize(values), .lowest = values.empty() ? NAN : values.front()};
  double points = 0;
  for (const HeightRun& run : runs) points += run.count;
  if (values.size() < 2 || static_cast<double>(values.size()) > 0.5 * points) return out;
  std::vector<double> gaps;
  for (std::size_t k = 1; k < values.size(); ++k) gaps.push_back(values[k] - values[k - 1]);
  const double least = *std::ranges::min_element(gaps);
  double length = 0, count = 0, steps = 0;
  for (const double gap : gaps)
    if (gap < near * least) length += gap, count += std::round(gap / least);
  const double step = length / count;
  for (const double gap : gaps) {
    if (!(std::abs(gap / step - std::round(gap / step)) <= off)) return out;
    steps += std::round(gap / step);
  }
  if (steps > most_steps) return out;
  out.step = (values.back() - values.front()) / steps;
  out.steps = static_cast<Index>(steps);
  return out;
}

double neighbour_step(const Field& z) {
  double equal = 0, pairs = 0, least = std::numeric_limits<double>::infinity();
  auto add_pair = [&](double a, double b) {
    const double difference = std::abs(a - b);
    if (std::isnan(difference)) return;
    ++pairs;
    if (difference > 0)
      least = std::min(least, difference);
    else
      ++equal;
  };
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      if (i > 0) add_pair(z(i, j), z(i - 1, j));
      if (j > 0) add_pair(z(i, j), z(i, j - 1));
    }
  return equal > 0.01 * pairs && std::isfinite(least) ? least : 0;
}

Bins bins_on_steps(const HeightSteps& of, const Bins& wanted) {
  const double width = wanted.range.width() / wanted.number,
               together = std::max(1.0, std::floor(width / of.step * (1 + 1e-9))),
               number = std::ceil(static_cast<double>(of.steps + 1) / together),
               first = of.lowest - 0.5 * of.step;
  return {static_cast<int>(number), {first, first + number * together * of.step}};
}

}  // namespace asperity
