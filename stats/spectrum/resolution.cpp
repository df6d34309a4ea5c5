#include "stats/spectrum/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "stats/filter/missing.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

// κ of Hann's window falls as n⁻⁶: below 1e-18 beyond.
constexpr Index hann_reach = 1024;

// W², not at f = 0 and Hann's not at ±1.
double power(double f, DataWindow window) {
  const double sinc = std::sin(std::numbers::pi * f) / (std::numbers::pi * f);
  return std::pow(window == DataWindow::none ? sinc : sinc / (1 - f * f), 2);
}

// (1), by the midpoint rule: W is smooth within a wave number, and no node is a whole number.
double smoothing(Index n, DataWindow window) {
  constexpr int nodes = 16;
  double sum = 0;
  for (int i = 0; i < nodes; ++i) sum += power(static_cast<double>(n) - 0.5 + (i + 0.5) / nodes, window);
  return sum / nodes / (window == DataWindow::none ? 1 : 1.5);
}

class Densities {
 public:
  Densities(const std::vector<SpectrumPoint>& points, const WindowedSpectrum& spectrum)
      : spectrum_(spectrum), first_(spectrum.kind == PointKind::ring ? 1 : 0) {
    if (first_ == 1) density_.push_back(0);
    for (const SpectrumPoint& p : points) density_.push_back(p.density);
    reach_ = spectrum.window == DataWindow::hann ? std::min(2 * count(), hann_reach) : 2 * count();
    for (Index n = 0; n <= reach_; ++n) kappa_.push_back(smoothing(n, spectrum.window));
  }

  Index first() const { return first_; }
  Index count() const { return static_cast<Index>(density_.size()); }  // with wave number 0
  double at(Index k) const { return density_[static_cast<std::size_t>(k)]; }

  // What lobes beyond the main one bring.
  double leakage(Index k) const {
    const Index lobes = spectrum_.window == DataWindow::none ? 1 : 2;
    auto share = [&](Index n) { return n < lobes ? 0 : kappa(n); };
    double sum = 0;
    for (Index j = std::max(k - reach_, first_); j <= std::min(k + reach_, count() - 1); ++j)
      sum += at(j) * share(std::abs(k - j));
    for (Index j = 1; j <= std::min(reach_ - k, count() - 1); ++j) sum += at(j) * share(k + j);
    return sum;
  }
  // The waves that a form took, from those beyond.
  void continue_below(Index k) {
    const Index next = std::min(k + 2, count() - 1);
    if (next <= k || !(at(k) > 0 && at(next) > 0)) return;
    const double higher =
        at(k) * std::exp(std::max(0.0, std::log(at(k) / at(next)) / static_cast<double>(next - k)));
    for (Index j = 1; j < k; ++j) density_[static_cast<std::size_t>(j)] = std::max(at(j), higher);
    density_[0] = density_[1];
  }
  // κ * C of (2).
  double once_more(Index k) const {
    double sum = 0, flat = 0;
    for (Index j = k - std::min(reach_, count() - 1); j <= k + std::min(reach_, count() - 1); ++j) {
      const Index of = mirrored(j);
      if (of >= count()) continue;
      const double share = kappa(std::abs(k - j)) * (first_ == 0 ? 1 : root(j));
      sum += share * at(of), flat += share;
    }
    return sum / flat;
  }

 private:
  double kappa(Index n) const { return kappa_[static_cast<std::size_t>(n)]; }
  static double root(Index j) { return std::sqrt(std::max(static_cast<double>(std::abs(j)), 0.25)); }
  // The wave number at 0 or above with the same density.
  Index mirrored(Index j) const {
    if (first_ == 1) return std::abs(j);
    const Index n = spectrum_.points, from_zero = (j % n + n) % n;
    return std::min(from_zero, n - from_zero);
  }

  WindowedSpectrum spectrum_;
  Index first_, reach_ = 0;
  std::vector<double> density_ = {}, kappa_ = {};
};

Index taken_by_form(const WindowedSpectrum& spectrum) {
  return (spectrum.window == DataWindow::none ? 1 : 2) + (spectrum.degree + 1) / 2;
}

}  // namespace

void judge_resolution(std::vector<SpectrumPoint>& points, const WindowedSpectrum& spectrum) {
  Densities densities(points, spectrum);
  const double most_leakage = spectrum.window == DataWindow::none ? 0.3 : 0.1;
  const Index lost = taken_by_form(spectrum);
  std::vector<double> leakage;
  for (Index k = densities.first(); k < densities.count(); ++k) leakage.push_back(densities.leakage(k));
  densities.continue_below(lost);
  std::vector<double> once_more, present;
  for (Index k = densities.first(); k < densities.count(); ++k)
    once_more.push_back(densities.once_more(k)), present.push_back(densities.at(k));
  const std::vector<double> bias = pooled_bias(once_more, present, spectrum.kind);
  for (std::size_t i = 0; i < points.size(); ++i) {
    SpectrumPoint& point = points[i];
    point.bias = bias[i];
    if (static_cast<Index>(i) + densities.first() < lost)
      point.no_error = NoError::form;
    else if (leakage[i] > most_leakage * point.density)
      point.no_error = NoError::leakage;
    else if (hidden_by(bias[i], point))
      point.no_error = NoError::resolution;
    if (point.no_error != NoError::none)
      point.standard_error = point.degrees = std::numeric_limits<double>::quiet_NaN();
  }
}

// ---- degrees of freedom from neighbours ----

namespace {

constexpr double left_by_chance = 1.5;
constexpr double most_bias = 0.5;  // relative errors

struct Range {
  Index first, last;
};

// The neighbours of point i, with it; the mean height is not one of the others'.
Range neighbours(Index i, Index count, PointKind kind) {
  const Index first = kind == PointKind::ring ? 1 : 0, k = first + i, reach = 1 + k / 8;
  if (k == 0) return {0, 0};
  return {std::max<Index>(k - reach, 1) - first, std::min(i + reach, count - 1)};
}

double relative_variance(const SpectrumPoint& p) { return std::pow(p.standard_error / p.density, 2); }

// ū at point i; the point of the mean height, which is not one of the others, alone.
double pooled(const std::vector<SpectrumPoint>& points, Index i, PointKind kind) {
  const Index first = kind == PointKind::ring ? 1 : 0, k = first + i;
  const auto [from, to] = neighbours(i, std::ssize(points), kind);
  double sum = 0;
  for (Index j = from; j <= to; ++j) {
    const double share =
        kind == PointKind::ring ? static_cast<double>(first + j) / static_cast<double>(k) : 1;
    sum += share * relative_variance(points[static_cast<std::size_t>(j)]);
  }
  return sum / static_cast<double>(to - from + 1);
}

}  // namespace

void pool_degrees(std::vector<SpectrumPoint>& points, PointKind kind) {
  std::vector<double> all(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) all[i] = pooled(points, static_cast<Index>(i), kind);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(all[i])) continue;  // a density of zero is near
    const double from_mean = std::max(2 / all[i] - 2, 0.0);
    const double degrees =
        std::max(from_mean * from_mean / (from_mean + left_by_chance), std::min(from_mean, 2.0));
    points[i].degrees = degrees;
    points[i].standard_error = points[i].density * std::sqrt(2 / (degrees + 2));
  }
}

std::vector<double> pooled_bias(const std::vector<double>& once_more, const std::vector<double>& densities,
                                PointKind kind) {
  const Index count = std::ssize(densities);
  Eigen::ArrayXd single(count);
  for (Index i = 0; i < count; ++i) {
    const double b = std::log(std::max(once_more[static_cast<std::size_t>(i)], 0.0) /
                              densities[static_cast<std::size_t>(i)]);
    single(i) = std::isnan(b) ? 0 : std::clamp(b, -2.0, 2.0);
  }
  std::vector<double> out;
  for (Index i = 0; i < count; ++i) {
    const auto [from, to] = neighbours(i, count, kind);
    out.push_back(single.segment(from, to - from + 1).mean());
  }
  return out;
}

bool hidden_by(double bias, const SpectrumPoint& point) {
  return std::abs(bias) * point.density > most_bias * point.standard_error;
}

// ---- what holes spread ----

namespace {

constexpr double few_pairs = 0.05;  // of those of lag 0

// Mean correlation at the lags next to one at which hardly a pair is left; 0 if they have none either.
double beside(const Field& lags, const Field& share, Index p, Index q) {
  double sum = 0, known = 0;
  for (Index i = p - 1; i <= p + 1; ++i)
    for (Index j = q - 1; j <= q + 1; ++j) {
      const Index row = (i + lags.rows()) % lags.rows(), column = (j + lags.cols()) % lags.cols();
      if (share(row, column) < few_pairs) continue;
      sum += lags(row, column) / share(row, column), ++known;
    }
  return known > 0 ? sum / known : 0;
}

// (1): a F⁻¹[C] is real and even, and so is C.
Field times_pairs(const Field& lags, const RealTransform2D& transform, const Field& there) {
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  AlignedVector<double> values(there.data(), there.data() + there.size());
  transform.forward(values.data(), spectrum.data());
  for (Complex& c : spectrum) c = std::norm(c);
  transform.inverse(spectrum.data(), values.data());
  const Field share = Eigen::Map<const Field>(values.data(), lags.rows(), lags.cols()) / values[0];
  return Field::NullaryExpr(lags.rows(), lags.cols(), [&](Index p, Index q) {
    return share(p, q) < few_pairs ? beside(lags, share, p, q) : share(p, q) * lags(p, q);
  });
}

}  // namespace

LagField spread_by_holes(const LagField& psd, const Field& d) {
  const Index nx = d.rows(), ny = d.cols();
  const RealTransform2D transform({nx, ny});
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < transform.spectrum_columns(); ++j)
      spectrum[static_cast<std::size_t>(i * transform.spectrum_columns() + j)] =
          i <= psd.max_p() ? psd(i, j) : psd(nx - i, -j);
  AlignedVector<double> lags(static_cast<std::size_t>(d.size()));
  transform.inverse(spectrum.data(), lags.data());
  const Field product = times_pairs(Eigen::Map<const Field>(lags.data(), nx, ny), transform, validity(d));
  std::ranges::copy(product.reshaped<Eigen::RowMajor>(), lags.begin());
  transform.forward(lags.data(), spectrum.data());
  return LagField::of(psd.max_lag(), [&](Index p, Index q) {
    const Index row = q >= 0 ? p : (nx - p) % nx;
    return spectrum[static_cast<std::size_t>(row * transform.spectrum_columns() + std::abs(q))].real() /
           static_cast<double>(d.size());
  });
}

void judge_holes(std::vector<SpectrumPoint>& points, const std::vector<SpectrumPoint>& once_more,
                 PointKind kind) {
  auto densities = [](const std::vector<SpectrumPoint>& of) {
    std::vector<double> out;
    for (const SpectrumPoint& p : of) out.push_back(p.density);
    return out;
  };
  const std::vector<double> bias = pooled_bias(densities(once_more), densities(points), kind);
  for (std::size_t i = 0; i < points.size(); ++i) {
    SpectrumPoint& point = points[i];
    point.bias += bias[i];
    if (point.no_error == NoError::none && hidden_by(bias[i], point)) point.no_error = NoError::holes;
    if (point.no_error != NoError::none)
      point.standard_error = point.degrees = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace asperity
