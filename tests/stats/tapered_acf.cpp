// The autocorrelation of a tapered field.
#include "stats/spatial/tapered_acf.hpp"

#include <numbers>

#include "acf/periodic.hpp"
#include "acf/target.hpp"
#include "core/error.hpp"
#include "fields.hpp"
#include "stats/spatial/acf.hpp"
#include "surface/synthesis.hpp"
#include "transform/plan.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double tukey_window(Index i, Index n) {
  const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(n), end = std::min(t, 1 - t);
  return end < 0.2 ? 0.5 - 0.5 * std::cos(std::numbers::pi * end / 0.2) : 1;
}

// Eq. (1), a sum for each lag.
double tapered_directly(const Field& z, Index p, Index q) {
  const Field w = Field::NullaryExpr(z.rows(), z.cols(), [&](Index i, Index j) {
    return tukey_window(i, z.rows()) * tukey_window(j, z.cols());
  });
  const Field d = w * (z - (w.square() * z).sum() / w.square().sum());
  double sum = 0;
  for (Index i = std::max<Index>(0, -p); i < std::min(z.rows(), z.rows() - p); ++i)
    for (Index j = std::max<Index>(0, -q); j < std::min(z.cols(), z.cols() - q); ++j)
      sum += d(i, j) * d(i + p, j + q);
  return sum / w.square().sum();
}

// Of a Gaussian model of 1/e length `length`, drawn on a torus.
Field smooth_surface(Shape shape, double length, std::uint64_t seed) {
  EllipticTarget model;
  model.model = Model::gaussian, model.length_x = model.length_y = length, model.level = std::exp(-1.0);
  const Target target = model.target();
  const Shape torus{2 * shape.nx, 2 * shape.ny};
  const Field plane = Field::NullaryExpr(shape.nx + 1, 2 * shape.ny + 1, [&](Index p, Index column) {
    return target(static_cast<double>(p), static_cast<double>(column - shape.ny));
  });
  return Synthesis(spectral_root(plane, torus), 1, shape, {}).surface(WhiteNoise(seed));
}

// The mean square difference of neighbours in x of what a table draws.
double square_differences(const LagField& acf) { return 2 * (acf(0, 0) - acf(1, 0)); }
double square_differences(const Field& z) {
  return (z.bottomRows(z.rows() - 1) - z.topRows(z.rows() - 1)).square().mean();
}

LagField whole_tapered(const Field& z) {
  return tapered_autocorrelation(z, grid(z.rows(), z.cols()), {z.rows() - 1, z.cols() - 1});
}

// Missing points in a disc, as scattered points, and along an edge.
Field with_holes(Field z) {
  const Field scattered = random_field(shape_of(z), 4);
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j)
      if (std::hypot(static_cast<double>(i - 40), static_cast<double>(j - 60)) < 14 ||
          scattered(i, j) > 0.9 || j < 7)
        z(i, j) = NAN;
  return z;
}

// The least of its spectrum over the largest, on a torus that it does not wrap around.
double least_power(const LagField& acf) {
  const Shape torus{2 * (acf.max_p() + 1), 2 * (acf.max_q() + 1)};
  const Field plane = Field::NullaryExpr(torus.nx, torus.ny, [&](Index i, Index j) {
    return acf(i < torus.nx / 2 ? i : i - torus.nx, j < torus.ny / 2 ? j : j - torus.ny);
  });
  const RealTransform2D transform(torus);
  AlignedVector<double> in(plane.data(), plane.data() + plane.size());
  AlignedVector<Complex> out(size(transform.spectrum_size()));
  transform.forward(in.data(), out.data());
  double least = 0, most = 0;
  for (const Complex& power : out) least = std::min(least, power.real()), most = std::max(most, power.real());
  return least / most;
}

}  // namespace

// Transforms add ε log2(torus) ≤ 12 ε of Σd² to each sum.
TEST_CASE("the ACF of a tapered field equals the sum over its lags, of any shape", "[acf][exact]") {
  for (Shape shape : {Shape{1, 9}, Shape{12, 1}, Shape{8, 8}, Shape{13, 10}, Shape{7, 33}}) {
    const Field z = 3 + random_field(shape, 11);
    const LagField acf = tapered_autocorrelation(z, grid(shape.nx, shape.ny), {shape.nx - 1, shape.ny - 1});
    CAPTURE(shape.nx, shape.ny);
    double worst = 0;
    for (Index p = 0; p <= acf.max_p(); ++p)
      for (Index q = -acf.max_q(); q <= acf.max_q(); ++q)
        worst = std::max(worst, std::abs(acf(p, q) - tapered_directly(z, p, q)));
    CHECK(worst <= 12 * epsilon * z.square().sum());
  }
}

// Bochner. Transforms leave ε log2(torus) < 20 ε.
TEST_CASE("the ACF of a tapered field is positive definite, with missing points and with lags cut off",
          "[acf][law]") {
  const Field smooth = smooth_surface({96, 120}, 6, 2), rough = random_field({31, 50}, 7);
  CHECK(least_power(whole_tapered(smooth)) >= -20 * epsilon);
  CHECK(least_power(whole_tapered(with_holes(smooth))) >= -20 * epsilon);
  CHECK(least_power(whole_tapered(rough)) >= -20 * epsilon);
  for (const Shape lags : {Shape{0, 0}, Shape{3, 3}, Shape{20, 9}, Shape{29, 49}}) {
    CAPTURE(lags.nx, lags.ny);
    CHECK(least_power(tapered_autocorrelation(rough, grid(31, 50), lags)) >= -20 * epsilon);
  }
}

// The window adds 16.4/n² of the variance to the square of a difference, here 0.2 %; it weights the slopes of
// some 250 patches (128/8)² otherwise than the map, √(2/250 · (1/0.56 - 1)) = 8 % at the most. The biased
// estimate adds 2/n, 50 %; without a ramp the hole of a disc and of a strip would add 10 to 20 %.
TEST_CASE("twins of a smooth map have its slopes, with missing points too", "[acf][law]") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Field z = smooth_surface({128, 128}, 8, seed);
    const double own = square_differences(z), twins = square_differences(whole_tapered(z)),
                 holed = square_differences(whole_tapered(with_holes(z)));
    CAPTURE(seed, own, twins, holed);
    CHECK(std::abs(twins / own - 1) <= 0.08);
    CHECK(std::abs(holed / own - 1) <= 0.12);
    const LagField biased =
        estimate_autocorrelation(z, grid(128, 128), {.max_lag = {127, 127}, .biased = true});
    CHECK(square_differences(biased) >= 1.3 * own);
  }
}

// E[R(1)] = ρ(1) W(1)/W(0), so that Σ(R(0) - R(1)) of maps is too large by 1/(1 - s). The mean over 60 maps is
// compared with the model's within 4 standard errors; the level that is taken off adds the 2 % of a patch's area.
TEST_CASE("what the taper adds to the slopes of twins is said: at holes, and of a cut", "[acf][statistics]") {
  const Shape shape{64, 64};
  const double length = 5, exact = 1 - std::exp(-1 / (length * length));
  for (const bool holes : {false, true})
    for (const Shape lags : {Shape{63, 63}, Shape{20, 20}}) {
      double sum = 0, squares = 0, least = INFINITY;
      constexpr int maps = 60;
      for (std::uint64_t seed = 1; seed <= maps; ++seed) {
        Field z = smooth_surface(shape, length, seed);
        if (holes) z.block(10, 20, 30, 12).setConstant(NAN);
        const LagField acf = tapered_autocorrelation(z, grid(64, 64), lags);
        const double by = slopes_by_taper(z, grid(64, 64), acf);
        const double mean = (acf(0, 0) - (acf(1, 0) + acf(0, 1)) / 2) / (by * by);
        sum += mean, squares += mean * mean, least = std::min(least, by);
      }
      const double mean = sum / maps, error = std::sqrt((squares / maps - mean * mean) / maps);
      CAPTURE(holes, lags.nx, mean / exact, error / exact, least);
      CHECK(std::abs(mean - exact) <= 4 * error + 0.02 * exact);
      CHECK(least >= (lags.nx < 63 ? 1.15 : holes ? 1.03 : 1.01));
    }
  const Field level = Eigen::ArrayXd::LinSpaced(64, 0, 1).replicate(1, 64);
  const LagField of_tilt = tapered_autocorrelation(level, grid(64, 64), {63, 63});
  CHECK(slopes_by_taper(level, grid(64, 64), of_tilt) >= 1.3);
  const Field rough = random_field({64, 64}, 3);
  CHECK(slopes_by_taper(rough, grid(64, 64, true),
                        tapered_autocorrelation(rough, grid(64, 64, true), {32, 32})) == 1);
}

TEST_CASE("a tapered field without a height that counts is refused, a periodic one needs no taper",
          "[acf][contract]") {
  CHECK_THROWS_AS(tapered_autocorrelation(Field::Constant(9, 9, NAN), grid(9, 9), {8, 8}), DataError);
  CHECK_THROWS_AS(tapered_autocorrelation(random_field({9, 9}, 1), grid(9, 9), {9, 8}), ParameterError);
  const Field z = random_field({16, 12}, 5);
  const Grid around = grid(16, 12, true);
  CHECK((tapered_autocorrelation(z, around, {8, 6}).half_plane() -
         estimate_autocorrelation(z, around, {.max_lag = {8, 6}}).half_plane())
            .abs()
            .maxCoeff() <= 20 * epsilon);
}
