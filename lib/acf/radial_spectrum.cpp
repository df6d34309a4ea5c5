#include "acf/radial_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
constexpr double rounded = 1e-9;     // of a ratio
constexpr double least_fall = 1.5;   // exponent of C1 beyond its end
constexpr double most_change = 0.25; // of the variance, by an isotropic surface
constexpr double no_gap = std::numeric_limits<double>::infinity();
constexpr double nearest = 1.0 / 8;     // rows, in octaves
constexpr double rings_an_octave = 48;  // of which a share is beyond the grid

[[noreturn]] void refuse_row(std::size_t i, const std::string& what) {
  throw DataError("psd", "row " + std::to_string(i + 1) + ": " + what);
}

void check_rows(const SpectrumRows& rows, double widest_gap) {
  if (rows.q.size() < 2)
    throw DataError("psd", "it has " + counted(static_cast<std::ptrdiff_t>(rows.q.size()), "row") +
                               "; at least 2 are needed");
  for (std::size_t i = 0; i < rows.q.size(); ++i) {
    const double q = rows.q[i], before = i > 0 ? rows.q[i - 1] : q, density = rows.density[i];
    if (!(q > 0 && std::isfinite(q)))
      refuse_row(i, "the wave number " + shortest(q) + " must be above 0 and finite");
    if (!(density > 0 && std::isfinite(density)))
      refuse_row(i, "the density " + number(density) + " must be above 0 and finite: leave such rows out");
    if (i > 0 && !(q > before))
      refuse_row(i,
                 "the wave number " + shortest(q) + " follows " + shortest(before) + ": they must increase");
    if (q / before > widest_gap * (1 + rounded))
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

RadialSpectrum::RadialSpectrum(SpectrumRows rows, double gap) : rows_(std::move(rows)) {
  check_rows(rows_, gap);
}

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

// Neighbouring rows with their mean G.
struct PowerBlock {
  double logs, power;
  std::size_t rows;
  double q() const { return std::exp(logs / static_cast<double>(rows)); }
  double mean() const { return power / static_cast<double>(rows); }
};

// The nearest G that falls, from the last row to the first (pool adjacent violators).
std::vector<PowerBlock> falling(const SpectrumRows& rows, const std::vector<double>& power) {
  std::vector<PowerBlock> out;
  for (std::size_t i = power.size(); i-- > 0;) {
    PowerBlock block{std::log(rows.q[i]), power[i], 1};
    for (; !out.empty() && !(block.mean() > out.back().mean()); out.pop_back())
      block.logs += out.back().logs, block.power += out.back().power, block.rows += out.back().rows;
    out.push_back(block);
  }
  return out;
}

// C at the middle of two rows of G.
void add_middle(SpectrumRows& out, const SpectrumRows& power, std::size_t i) {
  const Law g(power, i);
  const double q = std::sqrt(power.q[i] * power.q[i + 1]);
  out.q.push_back(q), out.density.push_back(-g.exponent * g(q) / (q * q));
}

// C at an end: by the law of the middles i and i+1, and flat where rows of G were taken together there.
double at_end(const SpectrumRows& middles, const SpectrumRows& g, std::size_t i, double q, bool flat) {
  const std::size_t next = q < middles.q.front() ? 0 : middles.q.size() - 1;
  const double only = Law(g, 0).exponent - 2,
               exponent = middles.q.size() < 2 ? only : Law(middles, i).exponent;
  return middles.density[next] * std::pow(q / middles.q[next], flat ? 0 : exponent);
}

[[noreturn]] void refuse_profiles(double change) {
  throw DataError("psd",
                  "no isotropic surface has these profiles: the power of their waves would change by " +
                      in_digits(100 * change, 2) + " % of the variance, more than 25 %");
}

}  // namespace

ProfileSpectrum spectrum_of_profiles(const SpectrumRows& rows) {
  check_rows(rows, RadialSpectrum::widest_gap);
  const SpectrumRows profile = thinned(rows);
  const double fall = last_fall(profile);
  std::vector<double> power;
  for (const double q : profile.q) power.push_back(power_beyond(profile, q, fall));
  const std::vector<PowerBlock> blocks = falling(profile, power);
  SpectrumRows g;
  double change = 0;
  for (std::size_t b = blocks.size(), row = 0; b-- > 0;) {
    g.q.push_back(blocks[b].q()), g.density.push_back(blocks[b].mean());
    for (const std::size_t end = row + blocks[b].rows; row < end; ++row)
      change = std::max(change, std::abs(power[row] - blocks[b].mean()) / blocks.back().mean());
  }
  if (blocks.size() < 2 || change > most_change) refuse_profiles(change);
  SpectrumRows middles;
  for (std::size_t i = 0; i + 1 < g.q.size(); ++i) add_middle(middles, g, i);
  SpectrumRows out;
  const std::size_t most = middles.q.size();
  out.q.push_back(profile.q.front());
  out.density.push_back(at_end(middles, g, 0, profile.q.front(), blocks.back().rows > 1));
  out.q.insert(out.q.end(), middles.q.begin(), middles.q.end());
  out.density.insert(out.density.end(), middles.density.begin(), middles.density.end());
  out.q.push_back(profile.q.back());
  out.density.push_back(
      at_end(middles, g, most < 2 ? 0 : most - 2, profile.q.back(), blocks.front().rows > 1));
  return {RadialSpectrum(std::move(out), no_gap), change, g.density.back() / g.density.front()};
}

}  // namespace asperity
