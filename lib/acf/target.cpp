#include "acf/target.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <numbers>

#include <Eigen/Core>

#include "acf/radial.hpp"
#include "core/words.hpp"

// A model that a switch forgets is an error with any compiler.
#pragma GCC diagnostic error "-Wswitch"

namespace asperity {

namespace {

constexpr Index most_lags = Index{1} << 30;

void require(bool holds, const char* name, double value, const char* bound) {
  check_parameter(holds, name, in_digits(value, 6) + bound);
}

void require_length(const char* name, double value) {
  require(value >= 1e-100 && value <= 1e100, name, value, ": must lie in 1e-100 ... 1e100");
}

struct Direction {
  double cosine = 1, sine = 0;
};

// An angle within 1e-12 of a multiple of a right angle is that.
Direction direction(double angle) {
  constexpr double right = std::numbers::pi / 2;
  int quarters = 0;
  if (std::abs(std::remquo(angle, right, &quarters)) > 1e-12) return {std::cos(angle), std::sin(angle)};
  return quarters % 2 == 0 ? Direction{1, 0} : Direction{0, 1};
}

// The lags of (1): principal coordinates in units of the lengths, and boxes around the ellipses.
struct Ellipse {
  double xp, xq, yp, yq;  // x'/λx* = xp p + xq q, y'/λy* = yp p + yq q
  double half_x, half_y;  // of the box around the unit ellipse [lags]

  Ellipse(const EllipticTarget& t, Direction d)
      : xp(d.cosine * t.spacing_x / t.length_x),
        xq(d.sine * t.spacing_y / t.length_x),
        yp(-d.sine * t.spacing_x / t.length_y),
        yq(d.cosine * t.spacing_y / t.length_y),
        half_x(std::hypot(t.length_x * d.cosine, t.length_y * d.sine) / t.spacing_x),
        half_y(std::hypot(t.length_x * d.sine, t.length_y * d.cosine) / t.spacing_y) {}

  double along(double p, double q) const { return xp * p + xq * q; }
  double squared(double p, double q) const {
    const double x = along(p, q), y = yp * p + yq * q;
    return x * x + y * y;
  }
  Shape box(double radius) const {
    auto lags = [&](double half) {
      const double n = std::ceil(radius * half * (1 - 1e-12));
      return n < static_cast<double>(most_lags) ? std::max<Index>(1, static_cast<Index>(n)) : most_lags;
    };
    return {lags(half_x), lags(half_y)};
  }
};

// `radius(t)`: the least multiple of the lengths from which on the model is within t, 0 < t < 1.
template <class Radius>
auto reach(const Ellipse& ellipse, Radius radius) {
  return [=](double t) {
    if (t >= 1) return Shape{1, 1};
    return t > 0 ? ellipse.box(radius(t)) : Shape{most_lags, most_lags};
  };
}

// f(r²) of eight lags of a row at a time; whole packets only, so that a value does not depend on its
// neighbours.
template <class Correlation>
Target::Row by_packets(const Ellipse& ellipse, Correlation f) {
  using Packet = Eigen::Array<double, 8, 1>;
  return [=](double p, double q, std::span<double> out) {
    const Packet lanes = Packet::LinSpaced(0, 7);
    for (std::size_t i = 0; i < out.size(); i += 8) {
      const Packet lag = lanes + (q + static_cast<double>(i));
      const Packet x = ellipse.xp * p + ellipse.xq * lag, y = ellipse.yp * p + ellipse.yq * lag;
      const Packet values = f(Packet(x.square() + y.square()));
      std::copy_n(values.data(), std::min<std::size_t>(8, out.size() - i), out.data() + i);
    }
  };
}

Target stretched(const EllipticTarget& t, const Ellipse& ellipse, double exponent) {
  const double log_level = std::log(t.level);
  Target out;
  if (t.model == Model::exponential_cosine)
    out = Target([=, cycles = t.length_x / t.wavelength](double p, double q) {
      const double envelope = std::exp(log_level * std::sqrt(ellipse.squared(p, q)));
      const double phase = 2 * std::numbers::pi * (cycles * ellipse.along(p, q));
      return envelope > 0 ? envelope * std::cos(phase) : 0;
    });
  else if (exponent == 1)
    out.row =
        by_packets(ellipse, [=](const auto& squared) { return (log_level * squared.sqrt()).exp().eval(); });
  else if (exponent == 2)
    out.row = by_packets(ellipse, [=](const auto& squared) { return (log_level * squared).exp().eval(); });
  else
    out = Target([=](double p, double q) {
      return std::exp(log_level * std::pow(ellipse.squared(p, q), exponent / 2));
    });
  out.reach = reach(ellipse, [=](double u) { return std::pow(std::log(u) / log_level, 1 / exponent); });
  return out;
}

template <class Correlation>
double radius_of(const Correlation& rho, double level) {
  const double radius = falls_to(rho, level);
  require(radius > 0, "length-level", level, ": reached at a lag too near zero; choose a lower level");
  return radius;
}

// `last(t)`: the radius from which on |ρ| ≤ t.
template <class Correlation, class Last>
Target tabulated(const EllipticTarget& t, const Ellipse& ellipse, Correlation correlation, Last last) {
  const auto rho = std::make_shared<const Correlation>(std::move(correlation));
  const double radius = radius_of(*rho, t.level);
  Target out([=](double p, double q) { return (*rho)(radius * std::sqrt(ellipse.squared(p, q))); });
  out.reach = reach(ellipse, [=](double u) { return last(*rho, u) / radius; });
  return out;
}

Target radial(const EllipticTarget& t, const Ellipse& ellipse) {
  switch (t.model) {
    case Model::matern:
      return tabulated(t, ellipse, MaternCorrelation(t.smoothness), falls_to);
    case Model::self_affine:
      return tabulated(t, ellipse, SelfAffineCorrelation(t.hurst),
                       [](const SelfAffineCorrelation& rho, double u) { return rho.last_above(u); });
    case Model::gaussian:
      return stretched(t, ellipse, 2);
    case Model::stretched_exponential:
      return stretched(t, ellipse, t.exponent);
    case Model::exponential:
    case Model::exponential_cosine:
      return stretched(t, ellipse, 1);
  }
  std::abort();  // no such model
}

}  // namespace

void EllipticTarget::check() const {
  require(level > 0 && level < 1, "length-level", level, " does not lie between 0 and 1");
  require(std::isfinite(angle), "angle", angle, ": must be finite");
  for (double length : {length_x, length_y}) require_length("length", length);
  for (double spacing : {spacing_x, spacing_y}) require_length("spacing", spacing);
  switch (model) {
    case Model::matern:
      return require(smoothness >= 0.01 && smoothness <= 100, "smoothness", smoothness,
                     ": must lie in 0.01 ... 100");
    case Model::stretched_exponential:
      return require(exponent > 0 && exponent <= 2, "exponent", exponent, ": must be above 0 and at most 2");
    case Model::self_affine:
      return require(hurst >= 0.01 && hurst <= 1, "hurst", hurst, ": must lie in 0.01 ... 1");
    case Model::exponential_cosine:
      return require_length("wavelength", wavelength);
    case Model::exponential:
    case Model::gaussian:
      return;
  }
}

double EllipticTarget::level_radius() const {
  check();
  switch (model) {
    case Model::matern:
      return radius_of(MaternCorrelation(smoothness), level);
    case Model::self_affine:
      return radius_of(SelfAffineCorrelation(hurst), level);
    case Model::gaussian:
      return std::pow(-std::log(level), 0.5);
    case Model::stretched_exponential:
      return std::pow(-std::log(level), 1 / exponent);
    case Model::exponential:
    case Model::exponential_cosine:
      return -std::log(level);
  }
  std::abort();  // no such model
}

double EllipticTarget::spectrum(double squared) const {
  switch (model) {
    case Model::gaussian:
      return std::exp(-squared / 4);
    case Model::matern:
      return std::pow(1 + squared, -1 - smoothness);
    case Model::self_affine:
      return std::pow(std::max(squared, 1.0), -1 - hurst);
    case Model::exponential:
    case Model::exponential_cosine:
      return std::pow(1 + squared, -1.5);
    case Model::stretched_exponential:
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool EllipticTarget::has_spectrum() const { return !std::isnan(spectrum(1)); }

Target EllipticTarget::target() const {
  check();
  const bool round = length_x == length_y && model != Model::exponential_cosine;
  const Direction d = round ? Direction{} : direction(angle);
  Target out = radial(*this, Ellipse(*this, d));
  out.oriented = d.cosine != 0 && d.sine != 0;
  return out;
}

}  // namespace asperity
