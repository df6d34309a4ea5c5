#include "marginal/johnson.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <Eigen/Core>

#include "core/field.hpp"
#include "core/words.hpp"
#include "math/bracketed_root.hpp"

namespace asperity {
namespace {

using Family = Johnson::Family;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t block_size = 16;
// Within it e^u is finite; at 1/64 of δ it lies beyond ten standard deviations.
constexpr double largest_u = 700;

// 2^k (e^r - 1) + (2^k - 1), r = u - k ln 2 within ± ln(2)/2, by Taylor's series up to r^13/13!, whose rest
// is 1e-17 of r. It has no branches or calls, so that the compiler makes vectors of it; the error is 1.3 ε of
// the value.
inline double expm1_of(double u) {
  constexpr double rounder = 0x1.8p52;  // added to a number, it leaves the nearest integer in the lowest bits
  constexpr double per_ln2 = 0x1.71547652b82fep0, ln2 = 0x1.62e42fefa38p-1, ln2_rest = 0x1.ef35793c7673p-45;
  const double rounded = u * per_ln2 + rounder, k = rounded - rounder;
  const double power = std::bit_cast<double>((std::bit_cast<std::uint64_t>(rounded) + 1023) << 52);
  const double r = (u - k * ln2) - k * ln2_rest;
  double s = 1.0 / 6227020800.0;
  s = s * r + 1.0 / 479001600.0;
  s = s * r + 1.0 / 39916800.0;
  s = s * r + 1.0 / 3628800.0;
  s = s * r + 1.0 / 362880.0;
  s = s * r + 1.0 / 40320.0;
  s = s * r + 1.0 / 5040.0;
  s = s * r + 1.0 / 720.0;
  s = s * r + 1.0 / 120.0;
  s = s * r + 1.0 / 24.0;
  s = s * r + 1.0 / 6.0;
  s = s * r + 1.0 / 2.0;
  return power * (s * r * r + r) + (power - 1);
}

double exponent(double y, double per_y) { return std::min(std::max(y * per_y, -largest_u), largest_u); }

// use(q) with the q of (2) of the family, from u and a function for e^u - 1.
template <class Use>
auto with_quotient(const Johnson& j, Use use) {
  const double c = std::exp(-std::abs(j.gamma) / j.delta), d = c * c;
  if (j.family == Family::unbounded)  // (e^u - 1) - d (e^-u - 1), by the larger of the two exponentials
    return use([d](double u, auto expm1) {
      const double large = expm1(std::abs(u)), small = large / (1 + large);
      return u < 0 ? -(small + d * large) : large + d * small;
    });
  if (j.family == Family::bounded)
    return use([c](double u, auto expm1) {
      const double m = expm1(u);
      return m / (1 + c + c * m);
    });
  return use([](double u, auto expm1) { return expm1(u); });
}

// Whole blocks only, so that a value does not depend on its neighbours.
template <class Quotient>
void apply_by_blocks(const Johnson& j, std::span<double> values, Quotient q) {
  const double per_y = j.sign / j.delta, a = j.sign * j.slope, b = j.sign * j.offset;
  auto block = [=](double* z) {
    for (std::size_t i = 0; i < block_size; ++i) z[i] = a * q(exponent(z[i], per_y), expm1_of) - b;
  };
  const std::size_t rest = values.size() % block_size, whole = values.size() - rest;
  for (std::size_t i = 0; i < whole; i += block_size) block(&values[i]);
  std::array<double, block_size> last{};
  std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(whole), rest, last.begin());
  block(last.data());
  std::copy_n(last.begin(), rest, values.begin() + static_cast<std::ptrdiff_t>(whole));
}

// ---- bounds and peaks ----

// The y of (5) for the upper sign: of S_B where the left side crosses the right one from below.
std::vector<double> scores_of_peaks(const Johnson& j) {
  if (j.family == Family::lognormal) return {-1 / j.delta};
  const double centre = std::abs(j.gamma), d = j.delta;
  auto rise = [&](double y) { return std::tanh((y - centre) / (2 * d)) - d * y; };
  auto root = [&](double a, double b) { return bracketed_root(rise, {a, rise(a)}, {b, rise(b)}, 1e-13); };
  // Where the right side's slope is that of the left, on both sides of the centre.
  const double steep = d * d < 0.5 ? 2 * d * std::acosh(1 / (std::sqrt(2.0) * d)) : 0;
  std::vector<double> out{root(-1 / d, centre - steep)};
  if (rise(centre + steep) > 0) out.push_back(root(centre + steep, 1 / d));
  return out;
}

}  // namespace

double Johnson::operator()(double y) const {
  if (family == Family::normal) return y;
  const auto expm1 = [](double u) { return std::expm1(u); };
  return with_quotient(*this,
                       [&](auto q) { return sign * (slope * q(exponent(y, sign / delta), expm1) - offset); });
}

void Johnson::apply(std::span<double> y) const {
  if (family == Family::normal) return;
  with_quotient(*this, [&](auto q) { apply_by_blocks(*this, y, q); });
}

std::string_view name_of(Family family) {
  constexpr std::array names{"normal", "S_L", "S_U", "S_B"};
  return names[static_cast<std::size_t>(family)];
}

Translation Johnson::translation() const {
  return {std::string(name_of(family)), std::min(1.0, delta),
          [johnson = *this](std::span<double> y) { johnson.apply(y); }};
}

Translation johnson_translation(double skewness, double kurtosis) {
  return fit_johnson(skewness, kurtosis).translation();
}

DensityShape density_shape(const Johnson& j) {
  const bool bounded = j.family == Family::bounded;
  if (!bounded && j.family != Family::lognormal) return {-infinity, infinity, {}};
  const double far = bounded ? j.slope * std::exp(std::abs(j.gamma) / j.delta) - j.offset : infinity;
  DensityShape out{-(j.slope + j.offset), far, {}};
  if (j.sign < 0) out = {-out.high, -out.low, {}};
  for (double y : scores_of_peaks(j)) out.peaks.push_back(j(j.sign * y));
  std::ranges::sort(out.peaks);
  return out;
}

namespace {

// ---- moments ----

constexpr int most_nodes = 256;
constexpr double step = 1.0 / 16;
constexpr double farthest_centre = 5;
// From the centre. Beyond it φ is below 1e-62 where S_B rises steeply, 1e-105 where S_U and S_L have their
// tails.
constexpr double reach = 22;

using Nodes = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_nodes, 1>;  // on the stack

double expectation(const Nodes& weight, const Nodes& values) { return (weight * values).sum(); }

// (3), with a = 1, b = 0 and the upper sign.
HeightMoments unbounded_moments(double gamma, double delta) {
  const double W = std::expm1(1 / (delta * delta)), w = 1 + W;
  const double d = std::exp(-2 * std::abs(gamma) / delta), less = -std::expm1(-2 * std::abs(gamma) / delta);
  const double V = w * (1 + d * d) + 2 * d;
  const double excess = w * w * (((w + 3) * w + 6) * w + 6) * (1 + d * d * d * d) +
                        4 * w * (w + 3) * d * (1 + d * d) - 6 * W * d * d;
  return {less * std::expm1(1 / (delta * delta) / 2), W * V,
          std::sqrt(w * W) * less * (w * (w + 2) * (1 + d + d * d) + 3 * d) / (V * std::sqrt(V)),
          3 + W * excess / (V * V)};
}

HeightMoments lognormal_moments(double v) {
  const double W = std::expm1(v), w = 1 + W;
  return {std::expm1(v / 2), w * W, std::sqrt(W) * (w + 2), 3 + W * (((w + 3) * w + 6) * w + 6)};
}

// ---- the fit ----

constexpr double least_delta = 1.0 / 64;
constexpr double same = 1e-12;       // distances from the normal and from S_L that are none
constexpr double tolerance = 1e-14;  // of a moment, relative to its size or to 1

double unit_of(double moment) { return std::max(1.0, std::abs(moment)); }

// The outer unknown x, in which K runs linearly from the normal, x = 1/(2δ²), to the edge, x = 1-δ.
double inverse_delta_squared(double x) { return x * (2 - x) / ((1 - x) * (1 - x)); }
double outer_unknown(double v) { return v / (std::sqrt(1 + v) * (1 + std::sqrt(1 + v))); }

// 1/δ² of S_L: w + 1 = 2 cosh(θ/3) solves (1) with Sk = 2 sinh(θ/2).
double lognormal_v(double skewness) {
  const double root = std::sinh(std::asinh(skewness / 2) / 3);
  return std::log1p(4 * root * root);
}

// 1/δ² of the symmetric S_U, where K = (w⁴ + 2w² + 3)/2.
double symmetric_v(double kurtosis) {
  const double excess = kurtosis - 3;
  return std::log1p(2 * excess / (2 + std::sqrt(4 + 2 * excess))) / 2;
}

// Unit slope, no offset, positive skewness. A difference, because -γ of a symmetric one would print as -0.
Johnson plain(Family family, double gamma, double delta) {
  return {family, family == Family::unbounded ? 0 - gamma : gamma, delta, 1, 1, 0};
}

HeightMoments moments_of(const Johnson& j) {
  if (j.family == Family::bounded) return johnson_moments(j);
  if (j.family == Family::unbounded) return unbounded_moments(j.gamma, j.delta);
  return lognormal_moments(1 / (j.delta * j.delta));
}

// γ for which a distribution of this δ has the skewness; infinite where even S_L, the most skewed, has none
// larger.
double gamma_for(Family family, double delta, double skewness) {
  if (skewness == 0) return 0;
  if (lognormal_moments(1 / (delta * delta)).skewness <= skewness) return infinity;
  auto excess = [&](double gamma) { return moments_of(plain(family, gamma, delta)).skewness - skewness; };
  CurvePoint low{0, -skewness}, high{std::max(1.0, delta), 0};
  while ((high.f = excess(high.x)) < 0) {
    if (high.x > 80 * std::max(1.0, delta)) return infinity;
    low = high;
    high.x *= 2;
  }
  return bracketed_root(excess, low, high, tolerance * unit_of(skewness));
}

Johnson with_skewness(Family family, double v, double skewness) {
  const double delta = 1 / std::sqrt(v), gamma = gamma_for(family, delta, skewness);
  return std::isinf(gamma) ? plain(Family::lognormal, 0, delta) : plain(family, gamma, delta);
}

double kurtosis_at(Family family, double v, double skewness) {
  return moments_of(with_skewness(family, v, skewness)).kurtosis;
}

// Between S_L and where the other end of the family has passed the kurtosis.
Johnson fitted(Family family, double skewness, double kurtosis) {
  auto excess = [&](double x) { return kurtosis_at(family, inverse_delta_squared(x), skewness) - kurtosis; };
  const double v = lognormal_v(skewness);
  const CurvePoint line{outer_unknown(v), lognormal_moments(v).kurtosis - kurtosis};
  const double last =
      outer_unknown(family == Family::bounded ? 1 / (least_delta * least_delta) : symmetric_v(kurtosis));
  const double x = bracketed_root(excess, line, {last, excess(last)}, tolerance * kurtosis);
  return with_skewness(family, inverse_delta_squared(x), skewness);
}

Johnson of_positive_skewness(double skewness, double kurtosis) {
  if (skewness <= same && std::abs(kurtosis - 3) <= same * kurtosis) return {};
  const double v = lognormal_v(skewness), line = lognormal_moments(v).kurtosis;
  if (std::abs(kurtosis - line) <= same * kurtosis) return plain(Family::lognormal, 0, 1 / std::sqrt(v));
  return fitted(kurtosis > line ? Family::unbounded : Family::bounded, skewness, kurtosis);
}

// Mean 0 and variance 1 by slope and offset.
Johnson standardised(Johnson j) {
  if (j.family == Family::normal) return j;
  const HeightMoments m = moments_of(j);
  j.slope = 1 / std::sqrt(m.variance);
  j.offset = m.mean * j.slope;
  return j;
}

Johnson mirrored(Johnson j) {
  j.sign = -1;
  j.gamma = 0 - j.gamma;
  return j;
}

std::string text(double value) { return in_digits(value, 7); }

void check_skewness(double skewness) {
  check_parameter(
      std::abs(skewness) <= largest_skewness, "skewness",
      text(skewness) + ": must lie in " + text(-largest_skewness) + " ... " + text(largest_skewness));
}

void check_kurtosis(double skewness, double kurtosis) {
  const double least = least_kurtosis(skewness);
  if (kurtosis >= least && kurtosis <= largest_kurtosis) return;
  std::string message = text(kurtosis) + ": must lie in " + text(least) + " ... " + text(largest_kurtosis) +
                        " at skewness " + text(skewness);
  if (kurtosis < least)
    message +=
        " (heights of two values have the least, skewness^2 + 1 = " + text(skewness * skewness + 1) + ")";
  throw ParameterError("kurtosis", message);
}

}  // namespace

// (4).
HeightMoments johnson_moments(const Johnson& j) {
  static const Nodes s = Nodes::LinSpaced(most_nodes, (1 - most_nodes) / 2.0, (most_nodes - 1) / 2.0) * step,
                     sinh = s.sinh(), cosh = s.cosh();
  const bool steep = j.family == Family::bounded && j.delta < 1;
  const double centre = steep ? std::clamp(j.gamma, -farthest_centre, farthest_centre) : 0;
  const double width = steep ? j.delta : 1;
  const Index nodes =
      2 * static_cast<Index>(std::min(std::ceil(std::asinh(reach / width) / step), most_nodes / 2.0));
  const Index first = (most_nodes - nodes) / 2;
  Nodes z = centre + width * sinh.segment(first, nodes);
  Nodes weight = cosh.segment(first, nodes) * (-z.square() / 2).exp();
  weight /= weight.sum();
  j.apply({z.data(), static_cast<std::size_t>(nodes)});

  const double unit = z.abs().maxCoeff(), mean = expectation(weight, z / unit);
  const Nodes d = z / unit - mean, d2 = d.square();
  const double variance = expectation(weight, d2);
  return {mean * unit, variance * unit * unit, expectation(weight, d2 * d) / (variance * std::sqrt(variance)),
          expectation(weight, d2.square()) / (variance * variance)};
}

double least_kurtosis(double skewness) {
  check_skewness(skewness);
  return kurtosis_at(Family::bounded, 1 / (least_delta * least_delta), std::abs(skewness));
}

Johnson fit_johnson(double skewness, double kurtosis) {
  check_kurtosis(skewness, kurtosis);
  const Johnson j = standardised(of_positive_skewness(std::abs(skewness), kurtosis));
  return skewness < 0 ? mirrored(j) : j;
}

}  // namespace asperity
