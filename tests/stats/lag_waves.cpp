// Errors of an estimated autocorrelation from the field's own long waves, and of what is found from it.
#include "stats/uncertainty/lag_waves.hpp"

#include <numbers>

#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure.hpp"
#include "stats/measure/acf_estimate.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Waves ν = 1, 2 along either axis at J² = 5: blocks of a sixth of the sides.
constexpr Index blocks = 6;

double block_wave(Index i, Index n, Index number, bool periodic) {
  Index b = 0;
  while (i >= (b + 1) * n / blocks) ++b;
  if (number == 0) return 1;
  const double phase = std::numbers::pi * (static_cast<double>(b) + 0.5) / static_cast<double>(blocks),
               k = static_cast<double>(periodic ? number + number % 2 : number);
  return std::numbers::sqrt2 * (periodic && number % 2 == 0 ? std::sin(k * phase) : std::cos(k * phase));
}

// Of the blocks of the field, where some heights are missing: (3) of long_waves.hpp.
Eigen::MatrixXd directions_of(const Field& z, const Grid& g, const LongWaves& waves) {
  const auto K = static_cast<Index>(waves.all().size());
  if (!z.isNaN().any()) return Eigen::MatrixXd::Identity(K, K);
  const AxisWaves of_blocks({{blocks, blocks}, 1, 1, g.periodic});
  AxisWaves::Squares squares = AxisWaves::none();
  const auto [nx, ny] = g.shape;
  for (Index b = 0; b < blocks; ++b) {
    Eigen::VectorXd points(blocks);
    const Index first = b * nx / blocks, last = (b + 1) * nx / blocks;
    for (Index c = 0; c < blocks; ++c) {
      const Index from = c * ny / blocks, to = (c + 1) * ny / blocks;
      points(c) = static_cast<double>((!z.block(first, from, last - first, to - from).isNaN()).count());
    }
    of_blocks.add_row(squares, b, points);
  }
  return waves.directions(squares);
}

// One by one: the error of the mean over the pairs at a lag of f(z, z'), by the waves.
template <class Function>
double error_of(const Field& z, const Grid& g, const FieldExtent& extent, Index p, Index q, Function f,
                bool structure = false) {
  const LongWaves waves(g, extent, {.least = 5});
  const auto [nx, ny] = g.shape;
  const Eigen::MatrixXd directions = directions_of(z, g, waves);
  const Index K = directions.rows();
  double mean = 0, pairs = 0;
  Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(K), means = sums, squares = sums;
  for (const bool second_pass : {false, true}) {
    for (Index i = 0; i < nx; ++i)
      for (Index j = 0; j < ny; ++j) {
        const Index a = i + p, b = j + q;
        if (!g.periodic.x && a >= nx) continue;
        if (!g.periodic.y && (b < 0 || b >= ny)) continue;
        const double value = f(z(i, j), z(a % nx, (b + ny) % ny));
        if (std::isnan(value)) continue;
        if (!second_pass) {
          mean += value, ++pairs;
          continue;
        }
        Eigen::VectorXd products(directions.cols());
        for (std::size_t k = 0; k < waves.all().size(); ++k)
          products(static_cast<Index>(k)) = block_wave(i, nx, waves.all()[k].x, g.periodic.x) *
                                            block_wave(j, ny, waves.all()[k].y, g.periodic.y);
        const Eigen::ArrayXd u = directions * products;
        sums += u * (value - mean), means += u, squares += u.square();
      }
    if (!second_pass) mean /= pairs;
  }
  const double variance = (sums.square() / (pairs * squares - means.square())).sum() / static_cast<double>(K);
  const double N = extent.patches, loss = structure ? 1 / std::sqrt(N) : 1.4 / std::sqrt(N) + 3 / N;
  return std::sqrt(variance) / (1 - std::min(0.4, loss));
}

}  // namespace

// Sums by the transform and by hand: round-off of 10⁴ products.
TEST_CASE("errors of lags are those of waves summed pair by pair", "[lag-waves][exact]") {
  for (const FieldExtent extent : {FieldExtent{300, 1}, {100, 1}})
    for (const Periodic periodic : {Periodic{false, false}, {false, true}, {true, true}})
      for (const double share : {0.0, 0.1}) {
        const Grid g{{45, 38}, 1, 1, periodic};
        Field z = moving_average(g.shape, {4, 3}, 7);
        if (share > 0) z = with_holes(z, share, 8);
        const Field d = remove_form(z);
        const LagField rho = estimate_autocorrelation(d, g, {.max_lag = {9, 7}}).normalised();
        const double variance = moments(d).sq * moments(d).sq;
        for (const int threads : {1, 3}) {
          const LagWaves waves(d, g, {9, 7}, extent, threads);
          const LagField of_R = waves.of_covariance(), of_S = waves.of_structure(),
                         of_rho = waves.of_ratio(rho).errors();
          for (const auto [p, q] : {Shape{0, 3}, {1, 0}, {9, 7}, {9, -7}, {4, -2}}) {
            CAPTURE(periodic.x, periodic.y, share, threads, p, q);
            const double expected_R = error_of(d, g, extent, p, q, [](double a, double b) { return a * b; }),
                         expected_S = error_of(
                             d, g, extent, p, q, [](double a, double b) { return (a - b) * (a - b); }, true),
                         r = rho(p, q), of_pairs = error_of(d, g, extent, p, q, [&](double a, double b) {
                                          return (a * b - 0.5 * r * (a * a + b * b)) / variance;
                                        });
            double squares = 0, pairs = 0;
            for (Index i = 0; i < 45; ++i)
              for (Index j = 0; j < 38; ++j) {
                const Index a = i + p, b = j + q;
                if ((!g.periodic.x && a >= 45) || (!g.periodic.y && (b < 0 || b >= 38))) continue;
                const double value = 0.5 * (std::pow(d(i, j), 2) + std::pow(d(a % 45, (b + 38) % 38), 2));
                if (!std::isnan(value)) squares += value, ++pairs;
              }
            const double at_edges = r * (squares / pairs / variance - 1);
            CHECK(relative_error(of_R(p, q), expected_R) <= 1e-9);
            CHECK(relative_error(of_S(p, q), expected_S) <= 1e-9);
            CHECK(relative_error(of_rho(p, q), std::hypot(of_pairs, at_edges)) <= 1e-9);
          }
        }
      }
}

// Of a direction that no contour has, an error would be one of chance.
TEST_CASE("directions have an error if the contour is not a circle, else a reason", "[lag-waves][contract]") {
  for (const bool oblong : {false, true}) {
    const Field z = moving_average({96, 96}, oblong ? Shape{12, 3} : Shape{6, 6}, 21);
    const Parameters all = measure({.grid = grid(96, 96), .heights = z}, {.groups = {Group::spatial}});
    for (const char* name : {"Sal_direction", "slowest_direction", "gamma_direction"}) {
      const auto found = std::ranges::find(all, name, &Parameter::name);
      REQUIRE(found != all.end());
      CAPTURE(oblong, name, found->standard_error, found->why);
      CHECK(std::isfinite(found->standard_error) == oblong);
      CHECK(found->why.empty() == oblong);
    }
    for (const char* name : {"Sal", "slowest_decay", "Str", "gamma"})
      CHECK(std::ranges::find(all, name, &Parameter::name)->standard_error > 0);
  }
}

// The logarithm of exp(10 x + 100 x²), x the deviation of one lag, of error σ, is biased by 100 σ², and the
// interval lower by that than about x of ρ' = (ρ + b)/(1 + b).
TEST_CASE("the interval of a ratio allows for its bias and for the field's own mean", "[lag-waves][law]") {
  const Grid g = grid(96, 96);
  const Field d = remove_form(moving_average(g.shape, {5, 4}, 22));
  const AcfEstimate estimate = AcfEstimate::of({.grid = g, .heights = d}, {.max_lag = {48, 48}});
  const LengthErrors errors(estimate, d, 0.2);
  const double here = estimate.rho(3, 0),
               sigma = LagWaves(d, g, {8, 8}, estimate.basis.extent()).of_ratio(estimate.rho).errors()(3, 0);
  const Estimate ratio = errors.ratio(
      1,
      [here](const LagField& rho) {
        const double x = rho(3, 0) - here;
        return std::optional(std::exp(10 * x + 100 * x * x));
      },
      0, 100);
  REQUIRE(ratio.interval);
  const double shift = -0.5 * std::log(ratio.interval->low * ratio.interval->high),
               x = estimate.size.freed(estimate.rho)(3, 0) - here;
  CHECK(x > 0);
  CHECK(shift == Approx(100 * sigma * sigma - 10 * x - 100 * x * x).epsilon(1e-6));
}

// Where one side of a mode leads beyond the lags, no end of the interval can be stated on that side.
TEST_CASE("the interval of a ratio is open where a length may lie beyond the lags", "[lag-waves][contract]") {
  const Grid g = grid(96, 96);
  const Field d = remove_form(moving_average(g.shape, {5, 4}, 22));
  const AcfEstimate estimate = AcfEstimate::of({.grid = g, .heights = d}, {.max_lag = {48, 48}});
  const LengthErrors errors(estimate, d, 0.2);
  const double freed = estimate.size.freed(estimate.rho)(3, 0);
  auto ratio = [&](double below, double above) {
    return errors.ratio(
        1,
        [=](const LagField& rho) {
          const double x = rho(3, 0) - freed, tiny = 1e-9;
          return std::optional(x < -tiny ? below : x > tiny ? above : 1);
        },
        0.1, 100);
  };
  const Estimate low = ratio(0, 1.1), high = ratio(0.9, AcfDeviations::beyond), closed = ratio(0.9, 1.1);
  CHECK(low.interval->low == 0.1);
  CHECK(low.interval->high < 100);
  CHECK(high.interval->low > 0.1);
  CHECK(high.interval->high == 100);
  CHECK(closed.interval->low > 0.1);
  CHECK(closed.interval->high < 100);
}

// A triangle of 26 samples falls to 0.2 at 21 of 24 lags. Intervals with both ends held the truth in 65 % of
// the fields of two such lays.
TEST_CASE("Str and the ellipticity of a lay that is as long as the lags have one end",
          "[lag-waves][contract]") {
  const Field z = moving_average({48, 48}, {26, 4}, 5);
  const Parameters all = measure({.grid = grid(48, 48), .heights = z}, {.groups = {Group::spatial}});
  auto interval = [&](const char* name) {
    const auto found = std::ranges::find(all, name, &Parameter::name);
    REQUIRE(found != all.end());
    return found->interval_95();
  };
  CHECK(interval("Str").low == 0);
  CHECK(interval("Str").high < 1);
  CHECK(interval("gamma").low > 1);
  CHECK(std::isinf(interval("gamma").high));
}

// The least of many lengths over the longest may be biased by more than its error.
TEST_CASE("the interval of a ratio holds the value, also that of a contour which is a circle",
          "[lag-waves][contract]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Field z = moving_average({96, 96}, {6, 6}, 300 + seed);
    for (const Parameter& p : measure({.grid = grid(96, 96), .heights = z}, {.groups = {Group::spatial}}))
      if ((p.name == "Str" || p.name == "gamma") && std::isfinite(p.standard_error)) {
        CAPTURE(seed, p.name, p.value, p.interval->low, p.interval->high);
        CHECK(p.interval->low <= p.value);
        CHECK(p.value <= p.interval->high);
      }
  }
}

// 200 fields of N_eff = 1000 (Gaussian) and their exponentials: a spread of skewed sums is known to 10 %, the
// rms error, of K = 12 squares each, to 3 %; and waves lose up to a tenth.
TEST_CASE("errors of lags are those of simulated fields, Gaussian or not", "[lag-waves][statistics][slow]") {
  const Grid g = grid(96, 96);
  for (const bool lognormal : {false, true}) {
    const Shape lags[] = {{1, 0}, {3, 0}, {0, 2}, {2, -2}, {20, 0}};
    Spread found[5];
    double squares[5] = {};
    for (unsigned f = 0; f < 200; ++f) {
      Field z = moving_average(g.shape, {4, 4}, 900 + f);
      if (lognormal) z = (0.6 * z).exp();
      const AcfEstimate estimate =
          AcfEstimate::of({.grid = g, .heights = remove_form(z)}, {.max_lag = {48, 48}});
      const LagField errors =
          LagWaves(remove_form(z), g, {20, 3}, estimate.basis.extent()).of_ratio(estimate.rho).errors();
      for (std::size_t k = 0; k < 5; ++k) {
        found[k].add(estimate.rho(lags[k].nx, lags[k].ny));
        squares[k] += std::pow(errors(lags[k].nx, lags[k].ny), 2) / 200;
      }
    }
    for (std::size_t k = 0; k < 5; ++k) {
      CAPTURE(lognormal, lags[k].nx, lags[k].ny);
      CHECK(std::sqrt(squares[k]) == Approx(found[k].deviation()).epsilon(0.25));
    }
  }
}

// Modes a and b of one lag: its error √(a² + b²), and that of e^ρ relative to it, without a bias of ln e^ρ.
TEST_CASE("a figure of the autocorrelation has the error of the deviations of its lags",
          "[acf-deviations][law]") {
  auto mode = [](double there, double beside) {
    Field values = Field::Zero(2, 3);
    values(1, 1) = there, values(0, 2) = beside;
    return LagField(values);
  };
  const AcfDeviations of({mode(0.03, 0), mode(0.04, 0.02)}, 5);
  Field rho = Field::Ones(2, 3);
  rho(1, 1) = 0.5;
  CHECK(of.errors()(1, 0) == Approx(0.05).epsilon(1e-14));
  CHECK(of.errors()(0, 1) == Approx(0.02).epsilon(1e-14));
  CHECK(of.correlation({{1, 0}, {0, 1}})(0, 1) == Approx(0.8).epsilon(1e-14));
  CHECK(of.quantile(0.025) == Approx(2.5706).epsilon(1e-4));
  const auto exponential = of.relative(
      LagField(rho), [](const LagField& r) { return std::optional(std::exp(r(1, 0))); }, 3);
  CHECK(exponential.error == Approx(0.05).epsilon(1e-12));
  CHECK(std::abs(exponential.bias) <= 1e-14);
  const Eigen::ArrayXd several = of.relative_errors(
      LagField(rho),
      [](const LagField& r) { return Eigen::Array2d(std::exp(r(1, 0)), std::exp(2 * r(0, 1))); }, 2);
  CHECK(several(0) == Approx(0.05).epsilon(1e-12));
  CHECK(several(1) == Approx(0.04).epsilon(1e-12));
  // Of a convex function the logarithm is biased: (3) of 10 u times the modes.
  const auto cosh = of.relative(
      LagField(rho), [](const LagField& r) { return std::optional(std::cosh(10 * (r(1, 0) - 0.5))); });
  const double u = of.quantile(0.025);
  CHECK(cosh.bias ==
        Approx((std::log(std::cosh(0.3 * u)) + std::log(std::cosh(0.4 * u))) / (u * u)).epsilon(1e-12));
  // Beyond the lags on one side: the difference on the other.
  const auto rising = of.relative(LagField(rho), [](const LagField& r) {
    return std::optional(r(1, 0) > 0.5 ? AcfDeviations::beyond : std::exp(r(1, 0)));
  });
  CHECK(rising.error == Approx(0.05).epsilon(1e-12));
  CHECK(rising.rises);
  CHECK_FALSE(rising.falls);
  CHECK_FALSE(exponential.rises);
  CHECK_FALSE(exponential.falls);
  const AcfDeviations::Figure axis = [](const LagField& r) {
    return std::optional(std::numbers::pi / 2 + r(1, 0) - 0.5);
  };
  CHECK(of.of_axis(LagField(rho), axis) == Approx(0.05).epsilon(1e-12));
  const AcfDeviations::Figure wild = [](const LagField& r) { return std::optional(50 * r(1, 0)); };
  CHECK(std::isnan(of.of_axis(LagField(rho), wild)));
  const AcfDeviations::Figure rare = [](const LagField& r) {
    return r(1, 0) > 0.5 ? std::optional(r(1, 0)) : std::nullopt;
  };
  CHECK(std::isnan(of.relative(LagField(rho), rare).error));
}
