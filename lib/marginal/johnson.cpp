#include "marginal/johnson.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/bracketed_root.hpp"

namespace asperity {
namespace {

using Family = Johnson::Family;

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

constexpr double infinity = std::numeric_limits<double>::infinity();

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

}  // namespace asperity
