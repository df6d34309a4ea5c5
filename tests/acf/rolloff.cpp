// Spectra of any model levelled above a roll-off, wave by wave.
#include <array>
#include <vector>

#include "waves.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Wave {
  Index j, k;
  double qx, qy;
};

// All but the mean, of odd sides: none looks like another.
std::vector<Wave> waves_of(Shape period) {
  std::vector<Wave> out;
  for (Index j = -period.nx / 2; j <= period.nx / 2; ++j)
    for (Index k = -period.ny / 2; k <= period.ny / 2; ++k)
      if (j != 0 || k != 0)
        out.push_back({j, k, turn * static_cast<double>(j) / static_cast<double>(period.nx),
                       turn * static_cast<double>(k) / static_cast<double>(period.ny)});
  return out;
}

// (4) of band_limited.hpp in the lengths 4 and 3 over r*, along the axes.
double density(const EllipticTarget& t, double qx, double qy) {
  const double r = t.level_radius();
  const auto squared = [&](double along) { return std::pow(along * 4 / r, 2) + std::pow(qy * 3 / r, 2); };
  const auto lorentz = [&](double power, double shift) { return std::pow(1 + squared(qx + shift), power); };
  if (t.model == Model::gaussian) return std::exp(-squared(qx) / 4);
  if (t.model == Model::matern) return lorentz(-1 - t.smoothness, 0);
  if (t.model == Model::self_affine) return std::pow(std::max(1.0, squared(qx)), -1 - t.hurst);
  if (t.model == Model::exponential) return lorentz(-1.5, 0);
  return lorentz(-1.5, turn / t.wavelength) + lorentz(-1.5, -turn / t.wavelength);
}

// At the farthest point of the ellipse in the direction of q that is not nearer than q, by bisection.
double levelled(const EllipticTarget& t, const Band& band, const Wave& w) {
  const double c = std::cos(t.angle), s = std::sin(t.angle);
  const double along = c * w.qx + s * w.qy, across = c * w.qy - s * w.qx;
  const auto inside = [&](double times) {
    return std::pow(times * along * band.rolloff_x / turn, 2) +
               std::pow(times * across * band.rolloff_y / turn, 2) <
           1;
  };
  double low = 1, high = 1000;
  for (int i = 0; i < 60 && inside(1); ++i) (inside((low + high) / 2) ? low : high) = (low + high) / 2;
  return density(t, low * along, low * across);
}

}  // namespace

// An amplitude, √(P N M), is a sum over a kernel of Σ|kernel| ≤ √437, with phases up to 4π rounded by 25 ε: 520
// ε, and as much again for the sum and the kernel.
TEST_CASE("every model is flat below its roll-off and itself beyond, wave by wave, turned and oblong",
          "[rolloff][exact]") {
  const Shape period{23, 19};
  const std::vector<Wave> waves = waves_of(period);
  for (const Model model :
       {Model::exponential, Model::gaussian, Model::matern, Model::self_affine, Model::exponential_cosine})
    for (const double cutoff : {0.0, 4.0})
      for (const auto& [along, across] : {std::array{9.0, 9.0}, {12.0, 7.0}, {8.0, 19.0}}) {
        EllipticTarget t;
        t.model = model;
        t.length_x = 4, t.length_y = 3, t.angle = 0.4, t.wavelength = 8;
        const Band band{cutoff, along, across};
        const BandLimited surfaces(t, band, period);
        const Field kernel = surfaces.kernel();
        const auto in_band = [&](const Wave& w) {
          return cutoff == 0 || std::hypot(w.qx, w.qy) <= turn / cutoff * (1 + 1e-9);
        };
        double sum = 0, slope = 0, worst = 0;
        for (const Wave& w : waves)
          if (in_band(w)) {
            const double law = levelled(t, band, w);
            sum += law, slope += law * (w.qx * w.qx + w.qy * w.qy);
          }
        for (const Wave& w : waves) {
          const double power = in_band(w) ? levelled(t, band, w) / sum * 23 * 19 : 0;
          worst = std::max(worst, std::abs(amplitude(kernel, w.j, w.k) - std::sqrt(power)));
        }
        CAPTURE(name_of(model), cutoff, along, across);
        CHECK(worst <= 1040 * epsilon);
        CHECK(relative_error(surfaces.mean_square_slope(), slope / sum) <= 2 * 437 * epsilon);
      }
}

// Waves up to (3,0) and (0,4) lie on or within a roll-off of 16 × 12 of 48 samples. Amplitudes are above 1 and
// rounded as above, by 25 ε √(48²) and as much again.
TEST_CASE("an isotropic model has one power below its roll-off, an oblong roll-off one along each direction",
          "[rolloff][exact]") {
  const Shape period{48, 48};
  EllipticTarget t;
  t.length_x = t.length_y = 30;
  const Field round = BandLimited(t, {6, 16, 16}, period).kernel();
  const double level = amplitude(round, 1, 0);
  for (const auto& [j, k] : {std::array<Index, 2>{0, 1}, {1, 1}, {2, 1}, {2, 2}, {3, 0}, {1, -2}})
    CHECK(relative_error(amplitude(round, j, k), level) <= 2400 * epsilon);
  CHECK(amplitude(round, 3, 1) < 0.99 * level);
  const Field oblong = BandLimited(t, {6, 16, 12}, period).kernel();
  CHECK(relative_error(amplitude(oblong, 1, 1), amplitude(oblong, 2, 2)) <= 2400 * epsilon);
  CHECK(relative_error(amplitude(oblong, 0, 1), amplitude(oblong, 0, 4)) <= 2400 * epsilon);
  CHECK(relative_error(amplitude(oblong, 1, 0), amplitude(oblong, 3, 0)) <= 2400 * epsilon);
  CHECK(amplitude(oblong, 1, 0) > 1.1 * amplitude(oblong, 0, 1));
}

// Beyond its own roll-off a self-affine spectrum is a power law: levelled anew it is another of the same law.
// The kernels have values below 1 that are rounded as their 12 transforms' steps are.
TEST_CASE("the roll-off of a self-affine model is the same as its length", "[rolloff][law]") {
  const Shape period{48, 36};
  EllipticTarget own = self_affine(0.7, 1), longer = self_affine(0.7, 30);
  own.length_x = length_for_rolloff(own, 20), own.length_y = length_for_rolloff(own, 12);
  longer.length_x *= 2, longer.length_y = longer.length_x * 12 / 20;
  own.angle = longer.angle = 0.6;
  const Field one = BandLimited(own, {5}, period).kernel(),
              other = BandLimited(longer, {5, 20, 12}, period).kernel();
  CHECK((one - other).abs().maxCoeff() <= 20 * epsilon);
}

// With u = 1 + (qℓ)²: ∫ q C dq = -u^-ν / 2νℓ², ∫ q³ C dq = (u^(1-ν)/(1-ν) + u^-ν/ν) / 2ℓ⁴. The lattice has πR²
// points in a circle but for 2√2 πR (Gauss), 2.2 % at R = 128, where the slope is.
TEST_CASE("the mean square slope of a levelled Matérn spectrum is its second moment", "[rolloff][law]") {
  const Index n = 512;
  const double L = 512, nu = 0.8, r = turn / (L / 16), s = turn / (L / 128);
  EllipticTarget t;
  t.model = Model::matern, t.smoothness = nu, t.length_x = t.length_y = 60;
  const double l = 60 / t.level_radius(), from = 1 + r * r * l * l, to = 1 + s * s * l * l;
  const auto zeroth = [&](double u) { return -std::pow(u, -nu) / (2 * nu * l * l); };
  const auto second = [&](double u) {
    return (std::pow(u, 1 - nu) / (1 - nu) + std::pow(u, -nu) / nu) / (2 * std::pow(l, 4));
  };
  const double level = std::pow(from, -1 - nu);
  const double power = level * r * r / 2 + zeroth(to) - zeroth(from),
               slope = level * std::pow(r, 4) / 4 + second(to) - second(from);
  const BandLimited band(t, {L / 128, L / 16, L / 16}, {n, n});
  CHECK(relative_error(band.mean_square_slope(), slope / power) <= 0.022);
  CHECK(relative_error(BandLimited(t, {L / 128}, {n, n}).mean_square_slope(), slope / power) > 0.1);
}

TEST_CASE("a roll-off beyond the samples, the period, the cut-off or the cosine's wave is refused",
          "[rolloff][contract]") {
  const auto refused = [](const EllipticTarget& t, const Band& band, Shape period) -> std::string {
    try {
      BandLimited(t, band, period);
    } catch (const ParameterError& error) {
      return error.name;
    }
    return "";
  };
  EllipticTarget t;
  CHECK(refused(t, {0, 48, 2}, {64, 48}).empty());
  CHECK(refused(t, {0, 48.1, 20}, {64, 48}) == "rolloff");
  CHECK(refused(t, {0, 20, 1.9}, {64, 48}) == "rolloff");
  CHECK(refused(t, {0, NAN, 20}, {64, 48}) == "rolloff");
  CHECK(refused(t, {0, 20}, {64, 48}) == "rolloff");
  CHECK(refused(t, {0, 20, -20}, {64, 48}) == "rolloff");
  CHECK(refused(t, {8, 20, 8}, {64, 48}).empty());
  CHECK(refused(t, {8, 20, 7.9}, {64, 48}) == "cutoff");
  t.model = Model::stretched_exponential;
  CHECK(refused(t, {0, 20, 20}, {64, 48}) == "model");
  t.model = Model::exponential_cosine, t.wavelength = 12;
  CHECK(refused(t, {0, 12, 5}, {64, 48}).empty());
  CHECK(refused(t, {0, 11.9, 20}, {64, 48}) == "rolloff");
}
