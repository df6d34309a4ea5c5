// Errors of the material ratio's parameters by influence functions, and of extremes.
#include "stats/height/material_error.hpp"

#include <numeric>
#include <random>

#include <gsl/gsl_cdf.h>

#include "fields.hpp"
#include "named.hpp"
#include "stats/height/extreme_error.hpp"
#include "stats/measure.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr std::array<double, 2> core_bounds{0.1, 0.8};

// The quantiles of a skewed distribution, in random order.
Field shuffled_quantiles(Shape shape, unsigned seed) {
  std::vector<double> heights(size(shape.cells()));
  for (std::size_t k = 0; k < heights.size(); ++k)
    heights[k] = std::exp(
        0.3 * gsl_cdf_ugaussian_Pinv((static_cast<double>(k) + 0.5) / static_cast<double>(heights.size())));
  std::mt19937 random(seed);
  std::ranges::shuffle(heights, random);
  return Eigen::Map<const Field>(heights.data(), shape.nx, shape.ny);
}

constexpr Index figures_number = 15;

// Sk, Spk, Svk, Smr1, Smr2, Vmp, Vmc, Vvc, Vvv, Sak1, Sak2, Sdc, Sxp, u, v of heights that count
// 200 (1 + weight) times.
Eigen::Array<double, figures_number, 1> figures(const Field& z, const Field& weight) {
  std::vector<double> all;
  for (Index i = 0; i < z.size(); ++i)
    all.insert(all.end(), static_cast<std::size_t>(std::lround(200 * (1 + weight(i)))), z(i));
  const MaterialRatioCurve curve(Eigen::Map<const Field>(all.data(), std::ssize(all), 1));
  const CoreParameters core = curve.core();
  const VolumeParameters v = curve.volumes(core_bounds[0], core_bounds[1]);
  Eigen::Array<double, figures_number, 1> out;
  out << core.sk, core.spk, core.svk, core.smr1, core.smr2, v.vmp, v.vmc, v.vvc, v.vvv, core.sak1, core.sak2,
      curve.fall(core_bounds), curve.fall(sxp_ratios), core.upper, core.lower;
  return out;
}

}  // namespace

// Where heights count 1 + ε u_k times, T changes by ε c_k of its influence function: here by a difference over
// ε = ± 0.1. The density over shares of ± 5 %, classes of 1/500 and whole counts are worth 10 %. That of Sxp at
// 2.5 %, over shares of 1.25 to 3.75 %, is 9.5 % too low besides: exp(0.3 x) rises by 0.253 between them.
TEST_CASE("errors of the material ratio are those of the change of every figure with the weights of a wave",
          "[material-error][order]") {
  const Shape shape{40, 50};
  const Grid g = grid(40, 50);
  const Field z = shuffled_quantiles(shape, 3);
  const FieldExtent extent{200, 1};
  const LongWaves waves(g, extent);
  const AxisWaves along(g);
  Eigen::ArrayXXd squares(figures_number, std::ssize(waves.all()));
  constexpr double step = 0.1;
  for (Index k = 0; k < squares.cols(); ++k) {
    const auto [a, b] = waves.all()[size(k)];
    const Field u = (along.x().col(a) * along.y().col(b).transpose()).array();
    squares.col(k) = ((figures(z, step * u) - figures(z, -step * u)) / (2 * step)).square();
  }
  const WaveSpectra spectra(waves.numbers());
  const MaterialErrors of = material_errors(z, g, extent, MaterialRatioCurve(z), core_bounds);
  CHECK_FALSE(of.core_may_be_elsewhere);
  const std::array errors{of.sk,  of.spk,  of.svk,  of.smr1, of.smr2, of.vmp,   of.vmc,  of.vvc,
                          of.vvv, of.sak1, of.sak2, of.sdc,  of.sxp,  of.upper, of.lower};
  STATIC_REQUIRE(errors.size() == figures_number);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    CAPTURE(k);
    const double margin = errors[k].error == of.sxp.error ? 0.2 : 0.1;
    CHECK(relative_error(errors[k].error, spectra.error(squares.row(static_cast<Index>(k))).error) <= margin);
  }
}

TEST_CASE("errors of the material ratio move with the unit, not with the level", "[material-error][law]") {
  const Grid g = grid(60, 50);
  const Field z = moving_average(g.shape, {3, 3}, 4);
  auto errors = [&](const Field& of) {
    return material_errors(of, g, {100, 1}, MaterialRatioCurve(of), core_bounds);
  };
  const MaterialErrors one = errors(z), other = errors(5 + 1e-3 * z);
  CHECK(relative_error(other.sk.error, 1e-3 * one.sk.error) <= 1e-6);
  CHECK(relative_error(other.vmp.error, 1e-3 * one.vmp.error) <= 1e-6);
  CHECK(relative_error(other.smr2.error, one.smr2.error) <= 1e-6);
}

// Heights of feed marks are dense at both ends, and the curve falls as little at the valleys as at the peaks.
TEST_CASE("the core of feed marks may be elsewhere, and says so, and that of noise is where it is",
          "[material-error][contract]") {
  const Field z = Field::NullaryExpr(128, 128, [](Index i, Index j) {
    return 1e-6 * (std::sin(0.5 * static_cast<double>(j) + 0.02 * static_cast<double>(i)) +
                   1e-3 * std::sin(3.1 * static_cast<double>(i * j)));
  });
  const Parameters all = measure({.grid = grid(128, 128), .heights = z}, {.groups = {Group::material}});
  const Parameters of_noise =
      measure({.grid = grid(64, 64), .heights = white_noise({64, 64}, 3)}, {.groups = {Group::material}});
  for (const char* name : {"Sk", "Smr1", "Smr2"}) {
    CAPTURE(name, named(all, name).why);
    CHECK(std::isnan(named(all, name).standard_error));
    CHECK(named(of_noise, name).standard_error > 0);
  }
}

// Once, the density over several steps gave Vmp of eight levels an error of a sixth of the true one.
TEST_CASE("volumes of heights in a few steps have no error", "[material-error][contract]") {
  const Field z = (1.6 * moving_average({128, 128}, {4, 4}, 3)).floor().max(-4).min(3);
  const Parameters all = measure({.grid = grid(128, 128), .heights = z}, {.groups = {Group::material}});
  for (const char* name : {"Vmp", "Vmc", "Vvc", "Vvv", "Sk", "Spkx", "Sak1", "Sdc", "Sxp"})
    CHECK(std::isnan(named(all, name).standard_error));
}

// Seven peaks of the heights 7, …, 1 on a plain of -1 … 0; the next to the highest is near a higher one.
TEST_CASE("the error of an extreme is that of the tail of the highest summits apart",
          "[extreme-error][exact]") {
  for (const bool periodic : {false, true}) {
    const Grid g = grid(90, 90, periodic);
    Field z = -Field::Ones(90, 90);
    const double heights[] = {9, 8, 7, 6, 5, 4};
    for (Index k = 0; k < 6; ++k) z(10 + 12 * k, 40) = heights[k];
    z(12, 43) = 8.5;  // √(2² + 3²)/(2 · 2) < 1 of the highest
    if (periodic) z(10, 40) = z(12, 43) = -1, z(0, 5) = 9, z(89, 6) = 8.7;  // beside it over the seam
    const auto error = extreme_error(z, g, 2, 2, 0.3);
    REQUIRE(error);
    const double a = (9 + 8 + 7 + 6 + 5) / 5.0 - 4,
                 relative =
                     (std::log(9) + std::log(8) + std::log(7) + std::log(6) + std::log(5)) / 5 - std::log(4);
    CHECK(relative_error(error->error, std::hypot(0.9 * 9 * relative, 0.3)) <= 1e-12);
    CHECK(relative_error(error->interval.high,
                         std::max(9 + std::hypot(5.14 * a, 0.66), 9 * std::exp(5.14 * relative))) <= 1e-12);
    CHECK(relative_error(error->interval.low,
                         std::min(9 - std::hypot(1.89 * a, 0.66), 9 * std::exp(-1.89 * relative))) <= 1e-12);
    CHECK_FALSE(extreme_error(z, g, 60, 60, 0.3));
    CHECK_FALSE(extreme_error((z > 0).select(Field::Ones(90, 90), z), g, 2, 2, 0.3));  // of one height
  }
}

TEST_CASE("extremes of few patches have no error, and say how many there are", "[extreme-error][contract]") {
  const Field few = moving_average({64, 64}, {14, 14}, 3), many = moving_average({160, 160}, {3, 3}, 3);
  const Parameters of_few = measure({.grid = grid(64, 64), .heights = few}, {}),
                   of_many = measure({.grid = grid(160, 160), .heights = many}, {});
  for (const char* name : {"Sp", "Sv", "Sz"}) {
    CHECK_THAT(named(of_few, name).why, ContainsSubstring("independent patches, fewer than 100"));
    CHECK(named(of_many, name).standard_error > 0);
    CHECK(named(of_many, name).interval_95().known());
  }
}

TEST_CASE("the error of a kurtosis above 4 says that it is rough, that of Gaussian heights does not",
          "[height-error][contract]") {
  const Field y = moving_average({128, 128}, {4, 4}, 3);
  auto sku = [](const Field& z) { return named(measure({.grid = grid(128, 128), .heights = z}, {}), "Sku"); };
  const Parameter heavy = sku((0.7 * y).exp()), gaussian = sku(y);
  REQUIRE(heavy.value > 4);
  CHECK(heavy.standard_error > 0);
  CHECK(heavy.note() == "its error is rough, as few heights decide it");
  CHECK(gaussian.note().empty());
}
