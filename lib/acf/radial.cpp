#include "acf/radial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_bessel.h>

#include "math/bracketed_root.hpp"

namespace asperity {

QuinticTable::QuinticTable(double first, double step, const std::vector<Node>& nodes)
    : first_(first), step_(step) {
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double f0 = nodes[i][0], d0 = step * nodes[i][1], s0 = step * step * nodes[i][2];
    const double f1 = nodes[i + 1][0], d1 = step * nodes[i + 1][1], s1 = step * step * nodes[i + 1][2];
    const double rise = f1 - f0;
    pieces_.push_back({f0, d0, s0 / 2, 10 * rise - 6 * d0 - 4 * d1 - 1.5 * s0 + 0.5 * s1,
                       -15 * rise + 8 * d0 + 7 * d1 + 1.5 * s0 - s1,
                       6 * rise - 3 * d0 - 3 * d1 - 0.5 * s0 + 0.5 * s1});
  }
}

double falls_to(const std::function<double(double)>& correlation, double t) {
  auto excess = [&](double log_r) { return correlation(std::exp(log_r)) - t; };
  double low = std::log(0.01), high = low;
  while (excess(high) > 0) low = high, high += 0.1;
  while (!(excess(low) > 0)) {
    if (low < std::log(1e-300)) return 0;
    high = low, low -= 2;
  }
  return std::exp(bracketed_root(excess, {low, excess(low)}, {high, excess(high)}, 0));
}

// ---- Matérn ----

namespace {

constexpr double least_radius = 1e-8, most_radius = 1000, matern_step = 1.0 / 32;

double log_bessel_k(double order, double r) { return gsl_sf_bessel_lnKnu(std::abs(order), r); }

// ln ρ and its first two derivatives in ln r, by (1) and (3).
QuinticTable::Node matern_node(double nu, double r) {
  const double k = log_bessel_k(nu, r), u = -r * std::exp(log_bessel_k(nu - 1, r) - k);
  const double value = (1 - nu) * std::numbers::ln2 - std::lgamma(nu) + nu * std::log(r) + k;
  return {std::min(value, 0.0), u, 2 * nu * u + r * r - u * u};
}

}  // namespace

MaternCorrelation::MaternCorrelation(double smoothness) {
  std::vector<QuinticTable::Node> nodes;
  const double first = std::log(least_radius);
  for (int i = 0; first + (i - 1) * matern_step < std::log(most_radius); ++i)
    nodes.push_back(matern_node(smoothness, std::exp(first + i * matern_step)));
  logarithm_ = QuinticTable(first, matern_step, nodes);
  exponent_ = 2 * std::min(smoothness, 1.0);
  coefficient_ = -std::expm1(nodes[0][0]) * std::pow(least_radius, -exponent_);
}

double MaternCorrelation::operator()(double r) const {
  if (r < least_radius) return 1 - coefficient_ * std::pow(r, exponent_);
  return r < most_radius ? std::min(1.0, std::exp(logarithm_(std::log(r)))) : 0;
}

// ---- self-affine ----

namespace {

constexpr double near_end = 2, far_start = 128, ripple_step = 1.0 / 16;

double J0(double r) { return gsl_sf_bessel_J0(r); }
double J1(double r) { return gsl_sf_bessel_J1(r); }

// ∫_a^b t^-μ J₀(t) dt by Gauss and Legendre's three points.
double panel(double mu, double a, double b) {
  const double middle = (a + b) / 2, half = (b - a) / 2, shift = std::sqrt(0.6) * half;
  auto f = [&](double t) { return std::pow(t, -mu) * J0(t); };
  return half / 9 * (8 * f(middle) + 5 * (f(middle - shift) + f(middle + shift)));
}

template <std::size_t n>
double polynomial(const std::array<double, n>& c, double x) {
  double sum = 0;
  for (std::size_t k = n; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

}  // namespace

SelfAffineCorrelation::SelfAffineCorrelation(double hurst) : H_(hurst) {
  prepare_series();
  prepare_table();
}

// With c_k = (-¼)^k/k!², J₁(r)/r = Σ c_k r^2k/(2k+2), and the integral of (2) is
// 1/(2H) - Γ(1-H)/(2H Γ(1+H)) (r/2)^2H + Σ_{k≥1} c_k r^2k/(2H-2k).
void SelfAffineCorrelation::prepare_series() {
  double c = 1;
  for (std::size_t i = 0; i < terms; ++i) {
    const double k = static_cast<double>(i + 1);
    c *= -0.25 / (k * k);
    even_[i] = c * (1 / (2 * k + 2) + (k > 1 ? 1 / (2 * H_ - 2 * k) : 0));
  }
  const double e = 1 - H_, mu = 1 + 2 * H_;
  // ln Γ(1+e) - ln Γ(1-e) = -2 Σ ζ(k) e^k/k over odd k, ζ(1) standing for Euler's γ; over e.
  const double gammas =
      e > 0.01
          ? (std::lgamma(1 + e) - std::lgamma(1 - e)) / e
          : -2 * (std::numbers::egamma + e * e * (1.2020569031595943 / 3 + e * e * 1.03692775514337 / 5));
  pole_ = gammas - 2 * (e > 0 ? std::log1p(-e) / e : -1);
  double product = 1;
  for (std::size_t k = 0; k < parts; ++k) {
    const double next = mu + 2 * static_cast<double>(k) + 1;
    bessel1_[k] = k == 0 ? 0 : -product;  // the first one takes J₁(r)/r away
    bessel0_[k] = product * next;
    product *= -next * next;
  }
}

void SelfAffineCorrelation::prepare_table() {
  const double mu = 1 + 2 * H_, scale = 2 * H_ / (1 + H_);
  const auto last = static_cast<std::size_t>((far_start - near_end) / ripple_step);
  std::vector<QuinticTable::Node> nodes(last + 1);
  double integral = (far(far_start) / scale - J1(far_start) / far_start) * std::pow(far_start, -2 * H_);
  for (std::size_t i = last + 1; i-- > 0;) {
    const double r = near_end + static_cast<double>(i) * ripple_step;
    if (i < last) integral += panel(mu, r, r + ripple_step);
    const double I = integral * std::pow(r, 2 * H_), dI = (2 * H_ * I - J0(r)) / r;
    const double ddI = ((2 * H_ - 1) * dI + J1(r)) / r;
    const double j = J1(r) / r, dj = (J0(r) - 2 * j) / r, ddj = (-J1(r) - 3 * dj) / r;
    nodes[i] = {scale * (j + I), scale * (dj + dI), scale * (ddj + ddI)};
  }
  table_ = QuinticTable(near_end, ripple_step, nodes);
}

// r²/(8e) - Γ(1-H)/(2H Γ(1+H)) (r/2)^2H, e = 1 - H, is -r²/(8e) expm1(e (2 ln(2/r) + pole)).
double SelfAffineCorrelation::power_terms(double r) const {
  const double e = 1 - H_, s = 2 * std::log(2 / r) + pole_;
  if (e > 0.25) return (r * r - std::exp(e * s + 2 * std::log(r))) / (8 * e);
  return -r * r / 8 * (e > 0 ? std::expm1(e * s) / e : s);
}

double SelfAffineCorrelation::near(double r) const {
  if (r == 0) return 1;
  return 1 + 2 * H_ / (1 + H_) * (power_terms(r) + r * r * polynomial(even_, r * r));
}

double SelfAffineCorrelation::far(double r) const {
  const double x = 1 / (r * r);
  return 2 * H_ / (1 + H_) * (J1(r) / r * polynomial(bessel1_, x) + J0(r) * x * polynomial(bessel0_, x));
}

double SelfAffineCorrelation::operator()(double r) const {
  if (r < near_end) return near(r);
  if (r < far_start) return table_(r);
  return r < 1e10 ? far(r) : 0;
}

// |J₀|, |J₁| ≤ √(2/πr) in (5): a bound of |ρ| from r = 2 on, and above 1 where it is none.
double SelfAffineCorrelation::envelope(double r) const {
  return 4 * H_ * std::sqrt(2 / std::numbers::pi) * std::pow(r, -2.5) * (1 + 10 / r);
}

double SelfAffineCorrelation::last_above(double t) const {
  constexpr double stride = 0.01;  // between two samples the ripple rises by 1 - cos(stride/2) at most
  double r = std::pow(4 * H_ * std::sqrt(2 / std::numbers::pi) / t, 0.4);
  if (r > 1e5) return r + 10;
  while (envelope(r) > t) r += 0.1;
  while (r > 0 && std::abs((*this)(r)) <= (1 - 2e-5) * t) r -= stride;
  return std::max(r, 0.0) + stride;
}

}  // namespace asperity
