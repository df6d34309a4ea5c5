// What scratches and spikes do to a mean surface, and what they do not.
#include "stats/filter/robust_gaussian.hpp"

#include <numbers>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/gaussian_filter.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double rms(const Field& z) {
  return std::sqrt(z.isNaN().select(0, z).square().sum() / static_cast<double>((!z.isNaN()).count()));
}

}  // namespace

// Tukey's biweight of 3 robust standard deviations uses Gaussian heights with an efficiency of 0.85 or so: the
// robust mean differs from the plain one by √(1/0.85 - 1) = 0.4 of the plain one's standard error, σ over the
// root of the points under the weight, (λc α)²/(2 (1/2)) … = 0.44 λc²: σ/9 at λc = 14. Four of those at N_eff
// = 64²/86 places.
TEST_CASE("without outliers the robust mean surface is near the plain one", "[filter][statistics]") {
  const Grid grid{{64, 64}, 1, 1, true};
  const Field z = white_noise(grid.shape, 41), plain = gaussian_mean_surface(z, grid, 14);
  const RobustMeanSurface robust = robust_gaussian_mean_surface(z, grid, 14);
  CHECK(robust.converged);
  CHECK(robust.steps <= 20);
  CHECK(rms(robust.surface - plain) <= 0.4 * rms(plain) * 1.5);
  CHECK(relative_error(robust.width, 3) <= 0.1);
  // δ = 0 beyond 3 standard deviations: 0.0027 of Gaussian heights, counted with its root
  CHECK(std::abs(robust.ignored - 0.0027) <= 4 * std::sqrt(0.0027 / 4096) + 0.001);
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

// The weights are a fixed point: what (1) gives with the weights (2) of the result is the result, but for the
// last step's move.
TEST_CASE("the robust mean surface holds its equations to the tolerance", "[filter][law]") {
  const Grid grid{{40, 36}, 1, 1};
  const Field z = with_holes(white_noise(grid.shape, 43), 0.1, 44);
  const RobustMeanSurface robust = robust_gaussian_mean_surface(z, grid, 8);
  const Field r = z - robust.surface;
  const double c = robust.width;
  Field thinned = (r.abs() < c).select(z, none);
  CHECK((robust.surface.isNaN() == z.isNaN()).all());
  const auto [i, j] = std::pair<Index, Index>{17, 25};
  double sum = 0, weights = 0;
  for (Index k = 0; k < 40; ++k)
    for (Index l = 0; l < 36; ++l) {
      if (std::isnan(thinned(k, l))) continue;
      const double d = static_cast<double>((k - i) * (k - i) + (l - j) * (l - j));
      const double w =
          std::exp(-9.8696044 / std::numbers::ln2 * d / 64) * std::pow(1 - std::pow(r(k, l) / c, 2), 2);
      sum += w * z(k, l), weights += w;
    }
  CHECK(std::abs(robust.surface(i, j) - sum / weights) <= robust.largest);
  CHECK(robust.change <= 1e-3 * c);
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
