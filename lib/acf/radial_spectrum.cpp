#include "acf/radial_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include <gsl/gsl_sf_gamma.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "math/gauss_legendre.hpp"

namespace asperity {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounded = 1e-9;        // of a ratio
constexpr double least_fall = 1.5;      // exponent of C1 beyond its end
constexpr double nearest = 1.0 / 8;     // rows, in octaves
constexpr double rings_an_octave = 48;  // of which a share is beyond the grid

[[noreturn]] void refuse_row(std::size_t i, const std::string& what) {
  throw DataError("psd", "row " + std::to_string(i + 1) + ": " + what);
}

void check_rows(const SpectrumRows& rows) {
  if (rows.q.size() < 2)
    throw DataError("psd", "it has " + counted(static_cast<std::ptrdiff_t>(rows.q.size()), "row") +
                               "; at least 2 are needed");
  for (std::size_t i = 0; i < rows.q.size(); ++i) {
    const double q = rows.q[i], before = i > 0 ? rows.q[i - 1] : q, density = rows.density[i];
    if (!(q > 0 && std::isfinite(q)))
      refuse_row(i, "the wave number " + shortest(q) + " must be above 0 and finite");
    if (!(density > 0 && std::isfinite(density)))
      refuse_row(i, "the density " + shortest(density) + " must be above 0 and finite: leave such rows out");
    if (i > 0 && !(q > before))
      refuse_row(i,
                 "the wave number " + shortest(q) + " follows " + shortest(before) + ": they must increase");
    if (q / before > RadialSpectrum::widest_gap * (1 + rounded))
      refuse_row(i, "a gap: the wave number " + shortest(q) + " rad/m is " + number(q / before) +
                        " times that of the row before; at most 10 can be bridged");
  }
}

// The power law of two neighbouring rows: the density at the first, and the exponent.
struct Law {
  double q, density, exponent;
  Law(const SpectrumRows& rows, std::size_t i)
      : q(rows.q[i]),
        density(rows.density[i]),
        exponent(std::log(rows.density[i + 1] / density) / std::log(rows.q[i + 1] / q)) {}
  double operator()(double k) const { return density * std::pow(k / q, exponent); }
  // ∫ k C dk
  double power(double low, double high) const {
    const double steps = std::log(high / low), x = (exponent + 2) * steps;
    return low * low * (*this)(low) * (std::abs(x) < 1e-8 ? steps : steps * std::expm1(x) / x);
  }
};

// f(law, low, high) for each part of low … high.
template <class Part>
void for_each_law(const SpectrumRows& rows, double low, double high, Part f) {
  for (std::size_t i = 0; i + 1 < rows.q.size(); ++i) {
    const double from = std::max(low, rows.q[i]), to = std::min(high, rows.q[i + 1]);
    if (from < to) f(Law(rows, i), from, to);
  }
}

}  // namespace

RadialSpectrum::RadialSpectrum(SpectrumRows rows) : rows_(std::move(rows)) { check_rows(rows_); }

double RadialSpectrum::operator()(double q) const {
  if (!(q >= first() * (1 - rounded) && q <= last() * (1 + rounded))) return 0;
  const auto next = std::upper_bound(rows_.q.begin() + 1, rows_.q.end() - 1, q);
  return Law(rows_, static_cast<std::size_t>(next - rows_.q.begin()) - 1)(q);
}

double RadialSpectrum::mean_square(double low, double high) const {
  double sum = 0;
  for_each_law(rows_, low, high, [&](const Law& law, double from, double to) { sum += law.power(from, to); });
  return sum / (2 * pi);
}

double RadialSpectrum::mean_square_beyond(double most_x, double most_y) const {
  const double corner = std::hypot(most_x, most_y), low = std::min({most_x, most_y, last()});
  const double rings = std::ceil(rings_an_octave * std::log2(corner / low) + 1);
  double sum = mean_square(corner, last());
  for (double i = 0; i < rings; ++i) {
    const double from = low * std::pow(corner / low, i / rings),
                 to = low * std::pow(corner / low, (i + 1) / rings), q = std::sqrt(from * to);
    const double within = std::asin(std::min(1.0, most_y / q)) - std::acos(std::min(1.0, most_x / q));
    sum += (1 - std::max(within, 0.0) / (pi / 2)) * mean_square(from, to);
  }
  return sum;
}

// ---- of profiles ----

namespace {

// Means of q² C1 over parts of an octave, in which a falling spectrum is nearly flat.
SpectrumRows thinned(const SpectrumRows& rows) {
  SpectrumRows out;
  for (std::size_t i = 0, next = 0; i < rows.q.size(); i = next) {
    double logs = 0, power = 0;
    for (;
         next < rows.q.size() && (next == i || std::log2(rows.q[next] / rows.q[i]) < nearest * (1 - rounded));
         ++next)
      logs += std::log(rows.q[next]), power += rows.q[next] * rows.q[next] * rows.density[next];
    const double n = static_cast<double>(next - i), q = std::exp(logs / n);
    out.q.push_back(q), out.density.push_back(power / (n * q * q));
  }
  return out;
}

// How fast C1 falls over its last octave.
double last_fall(const SpectrumRows& rows) {
  std::size_t i = rows.q.size() - 2;
  while (i > 0 && rows.q[i] > rows.q.back() / 2) --i;
  return std::max(least_fall,
                  -std::log(rows.density.back() / rows.density[i]) / std::log(rows.q.back() / rows.q[i]));
}

// G(q) of (3), with k = q cosh u: dv = q cosh u du.
double power_beyond(const SpectrumRows& rows, double q, double fall) {
  double sum = 0;
  for_each_law(rows, q, rows.q.back(), [&](const Law& law, double low, double high) {
    const double u = std::acosh(std::max(low / q, 1.0)), half = (std::acosh(high / q) - u) / 2;
    for (std::size_t i = 0; i < gauss8.nodes.size(); ++i) {
      const double k = q * std::cosh(u + half * (1 + gauss8.nodes[i]));
      sum += half * gauss8.weights[i] * k * law(k);
    }
  });
  const double a = (fall - 1) / 2, x = std::min(q / rows.q.back(), 1.0);
  return 2 * sum +
         q * rows.density.back() * std::pow(x, -fall) * gsl_sf_beta(a, 0.5) * gsl_sf_beta_inc(a, 0.5, x * x);
}

}  // namespace

ProfileSpectrum spectrum_of_profiles(const SpectrumRows& rows) {
  check_rows(rows);
  const SpectrumRows profile = thinned(rows);
  const double fall = last_fall(profile);
  SpectrumRows power;  // G where it falls, from the last row on
  double rise = 0, before = 0;
  for (std::size_t i = profile.q.size(); i-- > 0;) {
    const double g = power_beyond(profile, profile.q[i], fall);
    rise += std::max(before - g, 0.0), before = g;
    if (power.q.empty() || g > power.density.back())
      power.q.push_back(profile.q[i]), power.density.push_back(g);
  }
  std::ranges::reverse(power.q), std::ranges::reverse(power.density);
  check_rows(power);
  SpectrumRows out;
  const std::size_t last = power.q.size() - 1;
  auto add = [&](double q, const Law& g) {
    out.q.push_back(q), out.density.push_back(-g.exponent * g(q) / (q * q));
  };
  add(power.q[0], Law(power, 0));
  for (std::size_t i = 0; i < last; ++i) add(std::sqrt(power.q[i] * power.q[i + 1]), Law(power, i));
  add(power.q[last], Law(power, last - 1));
  const double all = power.density.front();
  return {RadialSpectrum(std::move(out)), rise / all, power.density.back() / all};
}

}  // namespace asperity
