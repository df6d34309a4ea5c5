#include "stats/spectrum/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

constexpr double most_bias = 0.5;  // relative errors

// W², not at f = 0 and Hann's not at ±1.
double power(double f, DataWindow window) {
  const double sinc = std::sin(std::numbers::pi * f) / (std::numbers::pi * f);
  return std::pow(window == DataWindow::none ? sinc : sinc / (1 - f * f), 2);
}

// (1), by the midpoint rule: W is smooth within a wave number, and no node is a whole number.
double spread(Index n, DataWindow window) {
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
    for (Index n = 0; n <= 2 * count(); ++n) kappa_.push_back(spread(n, spectrum.window));
  }

  Index first() const { return first_; }
  Index count() const { return static_cast<Index>(density_.size()); }  // with wave number 0
  double at(Index k) const { return density_[static_cast<std::size_t>(k)]; }

  // What lobes beyond the main one bring.
  double leakage(Index k) const {
    const Index lobes = spectrum_.window == DataWindow::none ? 1 : 2;
    auto share = [&](Index n) { return n < lobes ? 0 : kappa(n); };
    double sum = 0;
    for (Index j = first_; j < count(); ++j)
      sum += at(j) * (share(std::abs(k - j)) + (j > 0 ? share(k + j) : 0));
    return sum;
  }
  // The waves that a form took, from those beyond.
  void continue_below(Index k) {
    const Index next = std::min(k + 2, count() - 1);
    if (next <= k || !(at(k) > 0 && at(next) > 0)) return;
    const double higher =
        at(k) * std::exp(std::max(0.0, std::log(at(k) / at(next)) / static_cast<double>(next - k)));
    for (Index j = first_; j < k; ++j)
      density_[static_cast<std::size_t>(j)] = j == 0 ? higher : std::max(at(j), higher);
    density_[0] = density_[1];
  }
  // b of (2) at one point.
  double bias(Index k) const {
    double sum = 0, flat = 0;
    for (Index j = k - count() + 1; j < k + count(); ++j) {
      const Index of = mirrored(j);
      if (of >= count()) continue;
      const double share = kappa(std::abs(k - j)) * (first_ == 0 ? 1 : root(j));
      sum += share * at(of), flat += share;
    }
    const double b = std::log(sum / flat / at(k));
    return std::isnan(b) ? 0 : std::clamp(b, -2.0, 2.0);
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
  Index first_;
  std::vector<double> density_ = {}, kappa_ = {};
};

Index taken_by_form(const WindowedSpectrum& spectrum) {
  return (spectrum.window == DataWindow::none ? 1 : 2) + (spectrum.degree + 1) / 2;
}

// The mean over neighbours.
std::vector<double> pooled_bias(const Densities& densities) {
  const Index first = densities.first(), last = densities.count() - 1;
  std::vector<double> single(static_cast<std::size_t>(first)), out;
  for (Index k = first; k <= last; ++k) single.push_back(densities.bias(k));
  for (Index k = first; k <= last; ++k) {
    const Index from = std::max(k - pooled_reach(k), first), to = std::min(k + pooled_reach(k), last);
    double sum = 0;
    for (Index j = from; j <= to; ++j) sum += single[static_cast<std::size_t>(j)];
    out.push_back(sum / static_cast<double>(to - from + 1));
  }
  return out;
}

}  // namespace

void judge_resolution(std::vector<SpectrumPoint>& points, const WindowedSpectrum& spectrum) {
  Densities densities(points, spectrum);
  const double most_leakage = spectrum.window == DataWindow::none ? 0.3 : 0.1;
  const Index lost = taken_by_form(spectrum);
  std::vector<double> leakage;
  for (Index k = densities.first(); k < densities.count(); ++k) leakage.push_back(densities.leakage(k));
  densities.continue_below(lost);
  const std::vector<double> bias = pooled_bias(densities);
  for (std::size_t i = 0; i < points.size(); ++i) {
    SpectrumPoint& point = points[i];
    point.bias = bias[i];
    if (static_cast<Index>(i) + densities.first() < lost)
      point.no_error = NoError::form;
    else if (leakage[i] > most_leakage * point.density)
      point.no_error = NoError::leakage;
    else if (std::abs(bias[i]) * point.density > most_bias * point.standard_error)
      point.no_error = NoError::resolution;
    if (point.no_error != NoError::none)
      point.standard_error = point.degrees = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace asperity
