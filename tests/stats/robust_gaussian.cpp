// What scratches and spikes do to a mean surface, and what they do not.
#include "stats/filter/robust_gaussian.hpp"

#include <numbers>

#include <Eigen/Cholesky>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/gaussian_filter.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double gamma_of_width = 0.73091;  // of the weight of order 2

double rms(const Field& z) {
  return std::sqrt(z.isNaN().select(0, z).square().sum() / static_cast<double>((!z.isNaN()).count()));
}

}  // namespace

// Tukey's biweight of 3 robust standard deviations uses Gaussian heights with an efficiency of 0.85 or so: the
// robust mean differs from the first one, without weights, by √(1/0.85 - 1) = 0.4 of its standard error. That is
// σ times √(∫ H²) = √1.25/(γ λc), H of order 2: 0.109, over N_eff = 64²/(2 γ²λc²/1.25) = 24 places or so.
TEST_CASE("without outliers the robust mean surface is near the plain one", "[filter][statistics]") {
  const Grid grid{{64, 64}, 1, 1, true};
  const Field z = white_noise(grid.shape, 41),
              plain = robust_gaussian_mean_surface(z, grid, 14, 1, 1).surface;
  const RobustMeanSurface robust = robust_gaussian_mean_surface(z, grid, 14);
  CHECK(robust.converged);
  CHECK(robust.steps <= 20);
  CHECK(relative_error(rms(plain), std::sqrt(1.25) / (gamma_of_width * 14)) <= 4 / std::sqrt(2 * 24.0));
  CHECK(rms(robust.surface - plain) <= 0.4 * rms(plain) * 1.5);
  CHECK(relative_error(robust.width, 3) <= 0.1);
  // δ = 0 beyond 3 standard deviations: 0.0027 of Gaussian heights, counted with its root
  CHECK(std::abs(robust.ignored - 0.0027) <= 4 * std::sqrt(0.0027 / 4096) + 0.001);
}

// A weight that is cut at 1.6 λc misses 3e-7 there.
TEST_CASE("a wave at the cut-off passes by half, others by (1 + v) exp(-v)", "[filter][exact]") {
  const Grid grid{{120, 4}, 1, 1, true};
  for (const int waves : {1, 3, 6}) {
    const double v = std::numbers::pi * std::pow(gamma_of_width * waves / 3, 2),
                 passed = (1 + v) * std::exp(-v);
    const Field z = sine(grid.shape, 1, waves);
    const Field w = robust_gaussian_mean_surface(z, grid, 40, 1, 1).surface;
    CAPTURE(waves);
    if (waves == 3) CHECK(std::abs(passed - 0.5) <= 1e-5);
    CHECK((w - passed * z).abs().maxCoeff() <= 5e-5);
  }
}

// On a slope of 30 and a bowl of 100 deviations the filter of order 0 left 30 of them.
TEST_CASE("a slope or a bowl below a roughness with scratches passes the robust filter, edges included",
          "[filter][law]") {
  const Grid grid{{60, 50}, 1, 1};
  Field rough = with_holes(white_noise(grid.shape, 47), 0.05, 48);
  rough.middleRows(20, 2) -= 40;
  const RobustMeanSurface level = robust_gaussian_mean_surface(rough, grid, 20);
  CHECK(level.converged);
  // √1.25/(γ λc) inside; edges and lost points add to it
  CHECK(rms(level.surface) <= 2 * std::sqrt(1.25) / (gamma_of_width * 20));
  for (const Field& form :
       {sample(grid, [](double x, double y) { return 30 * x - 7 * y + 1e3; }),
        sample(grid, [](double x, double y) { return 0.1 * x * x - 0.05 * x * y + y * y; })}) {
    const RobustMeanSurface on_form = robust_gaussian_mean_surface(rough + form, grid, 20);
    // δ is the same to round-off, and so are the steps.
    CHECK(on_form.steps == level.steps);
    CHECK((on_form.surface - form - level.surface)
              .isNaN()
              .select(0, on_form.surface - form - level.surface)
              .abs()
              .maxCoeff() <= 1e-9);
  }
}

TEST_CASE("quadratic surfaces and profiles pass the robust filter as they are", "[filter][exact]") {
  for (const Grid& grid : {Grid{{40, 30}, 1, 1},
                           {{50, 1}, 1, 1},
                           {{1, 50}, 1, 1},
                           {{40, 2}, 1, 1},
                           {{40, 7}, 1, 1, {false, true}},
                           {{40, 1}, 1, 1, {false, true}}}) {
    const bool along_x = grid.periodic.y || grid.shape.ny <= 2;
    const Field bowl = sample(grid, [along_x](double x, double y) {
      return 3 + x - 0.3 * x * x + (along_x ? 0 : 0.5 * x * y - 2 * y + 0.2 * y * y);
    });
    const Field z = with_holes(bowl, 0.1, 49);
    const RobustMeanSurface found = robust_gaussian_mean_surface(z, grid, 9);
    CAPTURE(grid.shape.nx, grid.shape.ny);
    CHECK(found.converged);
    CHECK((found.surface.isNaN() == z.isNaN()).all());
    CHECK(rms(found.surface - z) <= 1e-10 * bowl.abs().maxCoeff());
  }
}

// Scratches over a tenth of the field, 100 deep in a roughness of 1.
TEST_CASE("deep scratches pull the plain mean surface but not the robust one", "[filter][law]") {
  const Grid grid{{100, 60}, 1, 1};
  const Field rough = white_noise(grid.shape, 42);
  Field scratched = rough;
  for (Index i = 5; i < 100; i += 20) scratched.middleRows(i, 2) -= 100;
  const Field plain = gaussian_mean_surface(scratched, grid, 20);
  const RobustMeanSurface robust = robust_gaussian_mean_surface(scratched, grid, 20),
                          clean = robust_gaussian_mean_surface(rough, grid, 20);
  CHECK(robust.converged);
  CHECK(rms(plain - clean.surface) >= 5);
  CHECK(rms(robust.surface - clean.surface) <= 0.2);  // 0.1 of its points are lost: √(0.1)/(0.66·20) and some
  CHECK(robust.ignored >= 0.1);
}

// The weights are a fixed point: the local quadratic with the weights (2) of the result is the result, but for
// the last step's move.
TEST_CASE("the robust mean surface holds its equations to the tolerance", "[filter][law]") {
  const Grid grid{{40, 36}, 1, 1};
  const Field z = with_holes(white_noise(grid.shape, 43), 0.1, 44);
  const RobustMeanSurface robust = robust_gaussian_mean_surface(z, grid, 8);
  CHECK((robust.surface.isNaN() == z.isNaN()).all());
  CHECK(robust.change <= 1e-3 / 3 * robust.width);
  const Field r = z - robust.surface;
  for (const auto& [i, j] : {std::pair<Index, Index>{17, 26}, {0, 1}, {39, 20}}) {
    REQUIRE(!std::isnan(r(i, j)));
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(6, 6);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(6);
    for (Index k = 0; k < 40; ++k)
      for (Index l = 0; l < 36; ++l) {
        const double x = double(k - i) / 8, y = double(l - j) / 8, ratio = r(k, l) / robust.width;
        if (!(std::abs(ratio) < 1) || std::abs(x) > 1.63 || std::abs(y) > 1.63) continue;
        const double weight =
            std::exp(-std::numbers::pi * (x * x + y * y) / (gamma_of_width * gamma_of_width)) *
            std::pow(1 - ratio * ratio, 2);
        const Eigen::VectorXd terms = Eigen::Vector<double, 6>{1, x, y, x * x, x * y, y * y};
        gram += weight * terms * terms.transpose();
        right += weight * z(k, l) * terms;
      }
    CHECK(std::abs(robust.surface(i, j) - gram.ldlt().solve(right)[0]) <= robust.largest + 1e-9);
  }
}

TEST_CASE("a constant stays, however high, and a shift moves the robust mean surface along",
          "[filter][law]") {
  const Grid grid{{30, 20}, 1, 1};
  CHECK((robust_gaussian_mean_surface(Field::Constant(30, 20, 1e9), grid, 6).surface == 1e9).all());
  const Field z = white_noise(grid.shape, 45);
  const Field here = robust_gaussian_mean_surface(z, grid, 6).surface,
              there = robust_gaussian_mean_surface(z + 1e3, grid, 6).surface;
  CHECK((there - 1e3 - here).abs().maxCoeff() <= 1e-10);
}

TEST_CASE("a robust filter that is stopped early says that it has not converged", "[filter][contract]") {
  const Grid grid{{30, 20}, 1, 1};
  const RobustMeanSurface stopped = robust_gaussian_mean_surface(white_noise(grid.shape, 46), grid, 6, 1, 2);
  CHECK_FALSE(stopped.converged);
  CHECK(stopped.steps == 2);
  CHECK_THROWS_AS(robust_gaussian_mean_surface(Field::Ones(8, 8), {{8, 8}, 1, 1}, 1), ParameterError);
}
