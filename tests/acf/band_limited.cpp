// Periodic surfaces with prescribed waves in a band, against the sums of their definition.
#include "acf/band_limited.hpp"

#include <utility>

#include "acf/radial.hpp"
#include "waves.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Field circular(const Field& kernel) {
  const Index n = kernel.rows(), m = kernel.cols(), middle = m / 2;
  return Field::NullaryExpr(n / 2 + 1, 2 * middle + 1, [&](Index p, Index column) {
    double sum = 0;
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < m; ++j) sum += kernel(i, j) * kernel((i + p) % n, (j + column - middle + m) % m);
    return sum;
  });
}

}  // namespace

// Every kernel below has Σ|kernel|² = 1 and at most 24 × 18 values: sums of that many products, rounded.
TEST_CASE("the kernel of a band has its autocorrelation to round-off on even, odd and oblong periods",
          "[band][exact]") {
  for (const Model model :
       {Model::exponential, Model::gaussian, Model::matern, Model::self_affine, Model::exponential_cosine})
    for (const Shape period : {Shape{24, 18}, Shape{17, 13}, Shape{12, 21}, Shape{8, 8}}) {
      EllipticTarget t;
      t.model = model;
      t.length_x = 4, t.length_y = 3, t.angle = 0.4, t.wavelength = 6;
      for (const double cutoff : {2.0, 3.3}) {
        CAPTURE(name_of(model), period.nx, period.ny, cutoff);
        const BandLimited band(t, {cutoff}, period);
        const Field target = band.correlation(), kernel = band.kernel();
        CHECK(shape_of(target) == Shape{period.nx / 2 + 1, period.ny / 2 * 2 + 1});
        CHECK(std::abs(target(0, target.cols() / 2) - 1) <= 10 * epsilon);
        CHECK((circular(kernel) - target).abs().maxCoeff() <= 432 * epsilon);
        CHECK((periodic_autocorrelation(kernel) - target).abs().maxCoeff() <= 100 * epsilon);
      }
    }
}

// |kernel^|² is the power times N M; amplitudes of rounding are below ε Σ|kernel| ≤ 24 ε.
TEST_CASE("waves shorter than the cut-off, and the mean, have no power, others that of the model",
          "[band][exact]") {
  const Shape period{24, 20};
  const double hurst = 0.7, rolloff = 11, cutoff = 4;
  const Field kernel = BandLimited(self_affine(hurst, rolloff), {cutoff}, period).kernel();
  const double plateau = std::pow(amplitude(kernel, 1, 0), 2);
  int within = 0, beyond = 0;
  for (Index j = 0; j < period.nx; ++j)
    for (Index k = 0; k < period.ny; ++k) {
      const double q = wave_number(period, j, k), a = amplitude(kernel, j, k);
      CAPTURE(j, k);
      if (q == 0 || q > turn / cutoff * (1 + 1e-9)) {
        CHECK(a <= 24 * epsilon * 4);
        ++beyond;
      } else {
        const double law = std::pow(std::max(q * rolloff / turn, 1.0), -2 * (1 + hurst));
        CHECK(a * a == Approx(plateau * law).epsilon(1e-12));
        ++within;
      }
    }
  CHECK(within == 90);  // lattice points with (j/6)² + (k/5)² ≤ 1, less the origin
  CHECK(beyond == 480 - 90);
}

// The DFT of the model's own correlation, summed over 7² periods of 96 × 80 samples, has besides each wave its
// aliases, Σ C(q + 2π(m, n)) over C(q): 6e-3 of the exponential's (half of that at q ± 2π/20 of the cosine's),
// 5e-4 of Matérn's with ν = 1, 1e-2 for H = 0.8, the ripple that is cut off at 336 samples included.
TEST_CASE("the powers are those of the model's correlation, of every model, turned too", "[band][law]") {
  const Shape period{96, 80};
  for (const auto& [model, tolerance] : {std::pair{Model::exponential, 6e-3},
                                         {Model::gaussian, 1e-6},
                                         {Model::matern, 5e-4},
                                         {Model::self_affine, 1e-2},
                                         {Model::exponential_cosine, 6e-3}}) {
    EllipticTarget t;
    t.model = model;
    t.length_x = 12, t.length_y = 8, t.angle = 0.5, t.wavelength = 20;
    const Target target = t.target();
    Field sum = Field::Zero(period.nx, period.ny);
    for (Index p = -336; p < 336; ++p)
      for (Index q = -280; q < 280; ++q)
        sum((p + 960) % period.nx, (q + 800) % period.ny) +=
            target(static_cast<double>(p), static_cast<double>(q));
    const Field band = BandLimited(t, {4}, period).correlation();
    const auto exact = [&](Index p, Index q) { return sum(p, q); };
    const double scale = power_at(exact, period, 1, 1) / power_at(on_torus(band, period), period, 1, 1);
    for (const auto& [j, k] : {std::pair{Index{1}, Index{0}}, {0, 1}, {2, 79}, {5, 3}, {93, 2}, {4, 4}}) {
      const double own = scale * power_at(on_torus(band, period), period, j, k);
      CAPTURE(name_of(model), j, k, own);
      CHECK(relative_error(own, power_at(exact, period, j, k)) <= tolerance);
    }
  }
}

TEST_CASE("a finer grid of the same size has the same autocorrelation at the common lags", "[band][law]") {
  EllipticTarget t = self_affine(0.8, 16);
  const Field coarse = BandLimited(t, {4}, {48, 32}).correlation();
  t.spacing_x = 0.5, t.spacing_y = 0.25;
  const Field fine = BandLimited(t, {4}, {96, 128}).correlation();
  for (Index p = 0; p < coarse.rows(); ++p)
    for (Index q = -16; q <= 16; ++q)
      CHECK(std::abs(coarse(p, 16 + q) - fine(2 * p, 64 + 4 * q)) <= 100 * epsilon);
}

// ∫ q³ C dq / ∫ q C dq of (1) and (4). The lattice has πR² points in a circle of radius R but for 2√2 πR at
// most (Gauss): 2.2 % of all at R = 128, where the slope is, and less of both than in the plateau, R = 16.
TEST_CASE("the mean square slope is the second moment of the spectrum", "[band][law]") {
  const Index n = 512;
  const double L = 512, H = 0.8, r = turn / (L / 16), s = turn / (L / 128);
  const BandLimited band(self_affine(H, L / 16), {L / 128}, {n, n});
  const double slope = std::pow(r, 4) / 4 + std::pow(r, 2 + 2 * H) *
                                                (std::pow(s, 2 - 2 * H) - std::pow(r, 2 - 2 * H)) /
                                                (2 - 2 * H),
               power =
                   r * r / 2 + std::pow(r, 2 + 2 * H) * (std::pow(r, -2 * H) - std::pow(s, -2 * H)) / (2 * H);
  CHECK(relative_error(band.mean_square_slope(), slope / power) <= 0.022);
  // And the curvature of R at zero: 2 (R(0) - R(h))/h² along both axes, for h of 1/1024 of the shortest wave,
  // where the next term is (2πh/λ)²/12 < 4e-6 of it.
  EllipticTarget t = self_affine(H, 64);
  const Shape period{64, 32};
  const double cutoff = 16, h = cutoff / 1024;
  double curvature = 0;
  const BandLimited coarse(t, {cutoff}, period);
  const Field R = coarse.correlation();
  for (Index j = -8; j <= 8; ++j)
    for (Index k = -8; k <= 8; ++k) {
      const double P = power_at(on_torus(R, period), period, (j + 64) % 64, (k + 32) % 32) / (64. * 32.);
      curvature += 2 * P *
                   (2 - std::cos(turn * static_cast<double>(j) * h / 64) -
                    std::cos(turn * static_cast<double>(k) * h / 32)) /
                   (h * h);
    }
  CHECK(relative_error(coarse.mean_square_slope(), curvature) <= 4e-6);
}

TEST_CASE("a roll-off is the wavelength of the corner of the self-affine correlation", "[band][exact]") {
  const double rolloff = 30;
  const EllipticTarget t = self_affine(0.6, rolloff);
  CHECK(relative_error(rolloff_of(t, t.length_x), rolloff) <= 4 * epsilon);
  const SelfAffineCorrelation rho(0.6);
  for (const double lag : {1.0, 5.0, 21.0})
    CHECK(std::abs(t.target()(lag, 0) - rho(turn * lag / rolloff)) <= 1e-11);
}

// The two ways to (1): the same C, as a model over its power at q = 0 and as a table of power laws.
TEST_CASE("a table of the spectrum has the waves of its model, and their mean square in its own unit",
          "[band][law]") {
  const Shape period{30, 21};
  const double hurst = 0.8, rolloff = 10, corner = turn / rolloff, least = turn / 30, most = 6;
  const RadialSpectrum table({{least, corner, most}, {5, 5, 5 * std::pow(most / corner, -2 - 2 * hurst)}});
  const BandLimited asked(self_affine(hurst, rolloff), {}, period), drawn(table, {1, 1}, period);
  CHECK((asked.correlation() - drawn.correlation()).abs().maxCoeff() <= 1e-13);
  CHECK(relative_error(drawn.mean_square_slope(), asked.mean_square_slope()) <= 1e-13);
  double sum = 0;
  for (Index j = -15; j <= 15; ++j)
    for (Index k = -10; k <= 10; ++k)
      sum += table(turn * std::hypot(static_cast<double>(j) / 30, static_cast<double>(k) / 21));
  CHECK(relative_error(drawn.mean_square(), sum / (30 * 21)) <= 1e-13);
  CHECK_THROWS_AS(BandLimited(RadialSpectrum({{10, 20}, {1, 1}}), {1, 1}, period), DataError);
}

TEST_CASE("a cut-off beyond the samples, the period or the roll-off is refused", "[band][contract]") {
  const auto refused = [](const EllipticTarget& t, double cutoff, Shape period) -> std::string {
    try {
      BandLimited(t, {cutoff}, period);
    } catch (const ParameterError& error) {
      return error.name;
    }
    return "";
  };
  EllipticTarget t = self_affine(0.8, 20);
  CHECK(refused(t, 2, {64, 48}).empty());
  CHECK(refused(t, 20, {64, 48}).empty());
  CHECK(refused(t, 1.9, {64, 48}) == "cutoff");
  CHECK(refused(t, 20.1, {64, 48}) == "cutoff");
  CHECK(refused(t, NAN, {64, 48}) == "cutoff");
  CHECK(refused(t, INFINITY, {64, 48}) == "cutoff");
  t.model = Model::exponential;
  CHECK(refused(t, 48, {64, 48}).empty());
  CHECK(refused(t, 48.1, {64, 48}) == "cutoff");
  CHECK(refused(t, 2, {64, 1}) == "cutoff");
  t.spacing_y = 3;
  CHECK(refused(t, 5, {64, 48}) == "cutoff");
  t.model = Model::stretched_exponential;
  CHECK(refused(t, 8, {64, 48}) == "model");
  t.model = Model::gaussian;
  t.length_x = t.length_y = 1e4;
  CHECK(refused(t, 8, {64, 48}) == "length");
}
