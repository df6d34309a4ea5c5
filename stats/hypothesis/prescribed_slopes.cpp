#include "stats/hypothesis/prescribed_slopes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "core/extent.hpp"
#include "core/parallel.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/hypothesis/simulated_law.hpp"
#include "stats/uncertainty/lag_spectrum.hpp"
#include "stats/uncertainty/random_fields.hpp"

namespace asperity {
namespace {

// ---- the probability of a summit ----

constexpr Index neighbours = 8;
constexpr std::array<Shape, neighbours> around{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
constexpr double least_deviation = 1e-6;  // of a difference, of heights of variance 1

using Differences = Eigen::Matrix<double, neighbours, neighbours>;
using CubePoint = std::array<double, neighbours>;

// (3)
Differences covariance_of_differences(const LagField& rho) {
  return Differences::NullaryExpr([&](Index i, Index j) {
    const auto [p, q] = around[static_cast<std::size_t>(i)];
    const auto [k, l] = around[static_cast<std::size_t>(j)];
    return 1 - rho(p, q) - rho(k, l) + rho(p - k, q - l);
  });
}

// L of LLᵀ in Genz's order: next comes the least probable, where those before have their expected values.
Differences ordered_factor(Differences c) {
  Differences l = Differences::Zero();
  Eigen::Matrix<double, neighbours, 1> expected = expected.Zero();
  for (Index k = 0; k < neighbours; ++k) {
    auto deviation = [&](Index i) { return std::sqrt(std::max(0.0, c(i, i) - l.row(i).squaredNorm())); };
    auto limit = [&](Index i) { return -l.row(i).dot(expected) / std::max(deviation(i), least_deviation); };
    Index least = k;
    for (Index i = k + 1; i < neighbours; ++i)
      if (limit(i) > limit(least)) least = i;
    c.row(k).swap(c.row(least)), c.col(k).swap(c.col(least)), l.row(k).swap(l.row(least));
    const double d = deviation(k), a = limit(k);
    if (d > least_deviation)
      for (Index i = k + 1; i < neighbours; ++i) l(i, k) = (c(i, k) - l.row(i).dot(l.row(k))) / d;
    l(k, k) = d;
    expected(k) = gsl_ran_ugaussian_pdf(a) / std::max(gsl_cdf_ugaussian_Q(a), 1e-300);
  }
  return l;
}

// The product of the probabilities that each difference is positive, given those before.
double conditional_product(const Differences& l, const CubePoint& at) {
  Eigen::Matrix<double, neighbours, 1> y = y.Zero();
  double out = 1;
  for (Index k = 0; k < neighbours && out > 0; ++k) {
    const double mean = l.row(k).head(k).dot(y.head(k));
    if (l(k, k) > least_deviation) {
      const double positive = gsl_cdf_ugaussian_Q(-mean / l(k, k));
      out *= positive;
      if (positive > 0 && k + 1 < neighbours)
        y(k) = gsl_cdf_ugaussian_Qinv(at[static_cast<std::size_t>(k)] * positive);
    } else if (!(mean > 0)) {
      return 0;
    }
  }
  return out;
}

// Richtmyer's lattice, folded so that the integrand is periodic, in eight places.
SummitShare lattice_mean(const Differences& l, int points) {
  constexpr int places = 8;
  constexpr CubePoint primes{2, 3, 5, 7, 11, 13, 17, 19};
  std::mt19937_64 generator(1);
  Eigen::ArrayXd means = Eigen::ArrayXd::Zero(places);
  for (double& mean : means) {
    CubePoint shift{}, at{};
    for (double& s : shift) s = static_cast<double>(generator() >> 11) * 0x1p-53;
    for (int n = 0; n < points; ++n) {
      for (std::size_t k = 0; k < at.size(); ++k) {
        const double x = std::fmod(shift[k] + n * std::sqrt(primes[k]), 1.0);
        at[k] = std::clamp(std::abs(2 * x - 1), 1e-15, 1 - 1e-15);
      }
      mean += conditional_product(l, at) / points;
    }
  }
  return {means.mean(), sample_deviation(means) / std::sqrt(1.0 * places)};
}

}  // namespace

SummitShare summit_share(const LagField& rho) {
  constexpr int points = 512, most = 1024;
  constexpr double enough = 5e-3;  // relative error
  const Differences c = covariance_of_differences(rho);
  if (!(c.diagonal().minCoeff() > least_deviation * least_deviation)) return {0, 0};
  const Differences l = ordered_factor(c);
  const SummitShare quick = lattice_mean(l, points);
  return quick.error > enough * quick.value ? lattice_mean(l, most) : quick;
}

GridSlopes grid_slopes(const Field& z, const Grid& grid, int threads) {
  GridSlopes out;
  try {
    const SlopeParameters slopes = slope_parameters(z, grid, threads);
    out.square = slopes.sdq * slopes.sdq, out.cells = slopes.cells;
    const CountedSummits found = counted_summits(z, grid, 0, threads);
    out.points = found.points, out.share = found.count / found.points;
    if (found.count > 0) out.plateaus = found.plateaus / found.count;
  } catch (const DataError&) {  // no cell, or no neighbourhood
  }
  return out;
}

namespace {

// ---- the variances ----

// (2); beyond the table ρ is 0.
LagField correlation_of_slopes(const LagField& rho, const Grid& grid) {
  const double x = 1 / (grid.dx * grid.dx), y = 1 / (grid.dy * grid.dy);
  const Shape most = grid.periodic.both() ? Shape{grid.shape.nx / 2, grid.shape.ny / 2} : grid.shape;
  return LagField::of({std::min(rho.max_p() + 1, most.nx), std::min(rho.max_q() + 1, most.ny)},
                      [&](Index p, Index q) {
                        return 2 * (x + y) * rho(p, q) - x * (rho(p + 1, q) + rho(p - 1, q)) -
                               y * (rho(p, q + 1) + rho(p, q - 1));
                      });
}

// The lags in x and y within which slopes are correlated.
Shape reach_of_slopes(const LagField& slopes, bool along_axes = false) {
  constexpr double negligible = 0.1;
  Shape out{1, 1};
  for (Index p = 0; p <= slopes.max_p(); ++p)
    for (Index q = -slopes.max_q(); q <= slopes.max_q(); ++q)
      if (std::abs(slopes(p, q)) > negligible * slopes(0, 0) && (!along_axes || p == 0 || q == 0))
        out = {std::max(out.nx, p), std::max(out.ny, std::abs(q))};
  return out;
}

// A periodic field that is long for its summits, on every k-th point where slopes are that smooth.
FieldModel small_model(const LagField& rho, const Grid& grid) {
  constexpr Index resolved = 10, lengths = 6, least = 32, most = 192;
  const Shape along = reach_of_slopes(correlation_of_slopes(rho, grid), true);
  const Index every_x = std::max<Index>(1, along.nx / resolved),
              every_y = std::max<Index>(1, along.ny / resolved);
  const LagField coarse = LagField::of({rho.max_p() / every_x, rho.max_q() / every_y},
                                       [&](Index p, Index q) { return rho(every_x * p, every_y * q); });
  Grid part{grid.shape, grid.dx * static_cast<double>(every_x), grid.dy * static_cast<double>(every_y)};
  const Shape correlated = reach_of_slopes(correlation_of_slopes(coarse, part));
  part.shape = {fast_length(std::clamp(lengths * correlated.nx, least, most)),
                fast_length(std::clamp(lengths * correlated.ny, least, most))};
  part.periodic = {true, true};
  return {.grid = part, .correlation = coarse};
}

}  // namespace

PrescribedSlopes::PrescribedSlopes(const LagField& rho, const Grid& grid) {
  const Shape known = rho.max_lag();
  if (known.nx < 1 || known.ny < 1 || grid.shape.nx < 2 || grid.shape.ny < 2) return;
  const LagField slopes = correlation_of_slopes(rho, grid);
  if (!(slopes(0, 0) > 0)) return;
  square = slopes(0, 0);
  const LagField known_pairs = tapered(slopes, Pairs(grid));
  const Shape correlated = known_pairs.reach();
  const LagSpectrum spectrum =
      grid.periodic.both() ? LagSpectrum(grid.shape)
                           : LagSpectrum::holding({3 * correlated.nx / 2 + 1, 3 * correlated.ny / 2 + 1});
  const Eigen::ArrayXd f = spectrum.of(known_pairs.within(correlated));
  variance = 2 * spectrum.mean(f.square());
  skewness = 8 * spectrum.mean(f.cube()) / std::pow(variance, 1.5);
}

void PrescribedSlopes::set_summits(const LagField& rho, const Grid& grid) {
  if (rho.max_p() >= 2 && rho.max_q() >= 2 && grid.shape.nx > 2 && grid.shape.ny > 2)
    summits = summit_share(rho);
}

void PrescribedSlopes::draw_summits(const LagField& rho, const Grid& grid, int threads, std::uint64_t seed) {
  constexpr Index all_points = 400000, fewest = 40, most = 200;
  if (!(summits.value > 0)) return;
  const FieldModel model = small_model(rho.within(grid.shape), grid);  // a drawn surface carries little more
  const RandomFields fields(model, seed);
  const Index k = std::clamp(all_points / model.grid.shape.cells(), fewest, most);
  Eigen::ArrayXd counts(k);
  parallel_ranges(k, threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i) counts(i) = counted_summits(fields.heights(i), model.grid).count;
  });
  if (!(counts.mean() > 0)) {
    summits = {0, 0};
    return;
  }
  drawn = static_cast<int>(k);
  dispersion = std::pow(sample_deviation(counts), 2) / counts.mean();
  if (grid.periodic.both()) return;
  const Shape correlated = reach_of_slopes(correlation_of_slopes(rho, grid));
  auto part = [](Index lag, Index n) { return static_cast<double>(lag) / static_cast<double>(n); };
  dispersion += (1 - dispersion) *
                std::min(1.0, (part(correlated.nx, grid.shape.nx) + part(correlated.ny, grid.shape.ny)) / 2);
}

}  // namespace asperity
