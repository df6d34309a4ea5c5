#include "stats/twins/twin_fields.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "marginal/measured.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/acf.hpp"

namespace asperity {
namespace {

// The lags |p| and |q| that hold three quarters of Σ ρ² each. Lag zero counts a twentieth: it needs no width,
// and the lags that noise alone makes significant weigh less.
std::array<double, 2> widths(const LagField& significant, const Pairs& pairs) {
  std::vector<double> along_x(static_cast<std::size_t>(significant.max_p()) + 1),
      along_y(static_cast<std::size_t>(significant.max_q()) + 1);
  for_each_lag(significant, pairs, [&](Index p, Index q, double weight) {
    const double value = std::pow(significant(p, q), 2) * (p == 0 && q == 0 ? 0.05 : weight);
    along_x[static_cast<std::size_t>(p)] += value;
    along_y[static_cast<std::size_t>(std::abs(q))] += value;
  });
  auto quantile = [](const std::vector<double>& of) {
    double sum = 0, total = 0;
    for (const double value : of) total += value;
    for (std::size_t p = 0; p < of.size(); ++p) {
      if (sum + of[p] >= 0.75 * total) return static_cast<double>(p) + (0.75 * total - sum) / of[p];
      sum += of[p];
    }
    return static_cast<double>(of.size());
  };
  return {quantile(along_x), quantile(along_y)};
}

struct Window {
  double hx, hy;
  int power = 2;  // of r² in the exponent: 1 is positive definite, 2 keeps more of what is within h

  double operator()(Index p, Index q) const {
    const double u = static_cast<double>(p) / hx, v = static_cast<double>(q) / hy;
    return std::exp(-0.5 * std::pow(u * u + v * v, power));
  }
  Window wider(double factor) const { return {factor * hx, factor * hy, power}; }
};

// The estimate with the form's share put back; 0 where there is no pair of points.
LagField without_form(const Sample& sample) {
  return LagField(zero_filled(sample.size().freed(sample.basis().correlation.normalised()).half_plane()));
}

// (2), (3).
Window window_for(const LagField& rho, const Sample& sample) {
  const Pairs& pairs = sample.basis().pairs;
  const auto [wx, wy] = widths(significant_lags(sample.basis().correlation, pairs), pairs);
  const double c = std::clamp(4 * std::pow(sample.size().effective(2) / 218, 0.25), 2.0, 12.0);
  const Window widest{2 * c * wx, 2 * c * wy};
  auto sum_of_squares = [&](const Window& window) {
    double sum = 0, lags = 0;
    for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
      const double g = std::pow(window(p, q), 2);
      sum += weight * g * std::pow(rho(p, q), 2);
      lags += weight * g / pairs.pair_fraction(p, q);
    });
    return std::pair{sum, sum / (1 + lags / pairs.points())};
  };
  const double aim = sum_of_squares(widest).second;
  double least = 1.0 / 8, most = 1;
  for (int step = 0; step < 12; ++step) {
    const double middle = std::sqrt(least * most);
    (sum_of_squares(widest.wider(middle)).first > aim ? most : least) = middle;
  }
  return widest.wider(most);
}

// Hann's, of a side of n points, and what it makes of a correlation: 1 - 6.6 (p/n)², as exp(-13.2 (p/n)²/2).
Eigen::ArrayXd hann(Index n, bool periodic) {
  if (periodic) return Eigen::ArrayXd::Ones(n);
  return 1 - (Eigen::ArrayXd::LinSpaced(n, 0.5, static_cast<double>(n) - 0.5) *
              (2 * std::numbers::pi / static_cast<double>(n)))
                 .cos();
}
double without_hann(double h, Index n, bool periodic) {
  const double taken = periodic ? 0 : 13.2 / static_cast<double>(n * n);
  return 1 / std::sqrt(std::max(1 / (h * h) - taken, 1e-12));
}

// What slopes vary with where heights are not Gaussian, those about them, has long waves too.
Window window_for_short_waves(const Sample& sample) {
  if (sample.distribution()) return window_for(without_form(sample), sample);
  const Pairs& pairs = sample.basis().pairs;
  const auto [wx, wy] = widths(significant_lags(sample.basis().correlation, pairs), pairs);
  return {std::max(1.5 * wx, 2.0), std::max(1.5 * wy, 2.0), 1};
}

LagField short_wave_correlation(const Sample& sample) {
  const Grid& grid = sample.grid();
  const auto [nx, ny] = grid.shape;
  const Window own = window_for_short_waves(sample);
  const Window window{without_hann(own.hx, nx, grid.periodic.x), without_hann(own.hy, ny, grid.periodic.y),
                      1};
  Field tapered = sample.surface().heights;
  tapered.colwise() *= hann(nx, grid.periodic.x);
  tapered.rowwise() *= hann(ny, grid.periodic.y).transpose();
  const LagField rho =
      estimate_autocorrelation(tapered, grid, {.max_lag = longest_lags(grid), .biased = true}).normalised();
  return LagField::of(rho.max_lag(), [&](Index p, Index q) { return rho(p, q) * window(p, q); });
}

LagField correlation_of(const Sample& sample, TwinWaves waves) {
  if (!sample.basis().estimated) return sample.basis().correlation.normalised();
  if (waves == TwinWaves::short_ones) return short_wave_correlation(sample);
  const LagField rho = without_form(sample);
  const Window window = window_for(rho, sample);
  return LagField::of(rho.max_lag(), [&](Index p, Index q) { return rho(p, q) * window(p, q); });
}

std::optional<Translation> translation_of(const Sample& sample) {
  if (sample.surface().distribution) return sample.surface().distribution;
  if (!sample.distribution()) return std::nullopt;
  std::vector<double> heights;
  for (const double z : sample.surface().heights.reshaped<Eigen::RowMajor>())
    if (std::isfinite(z)) heights.push_back(z);
  return MeasuredHeights::of(std::move(heights)).translation();
}

Field missing_of(const Field& heights) {
  if (!heights.isNaN().any()) return {};
  return heights.isNaN().select(Field::Constant(heights.rows(), heights.cols(), NAN), 0);
}

}  // namespace

TwinFields::TwinFields(const Sample& sample, TwinWaves waves, std::uint64_t seed)
    : missing_(missing_of(sample.surface().heights)),
      correlation_(correlation_of(sample, waves)),
      translation_(translation_of(sample)),
      fields_({.grid = sample.grid(),
               .correlation = correlation_,
               .translation = translation_,
               .negligible = waves == TwinWaves::all ? 1e-3 : 1e-12},
              seed) {}

Field TwinFields::heights(Index k) const {
  Field out = fields_.heights(k);
  if (missing_.size() > 0) out += missing_;
  return out;
}

}  // namespace asperity
