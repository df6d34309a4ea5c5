#include <algorithm>

#include "marginal/johnson.hpp"
#include "marginal/prescribed.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Pair {
  double skewness, kurtosis;
};
const std::vector<Pair> bounded{{-1, 3}, {1.1, 3},  {1.3, 3.5}, {0, 1.7},   {0, 1.8},   {0, 2},
                                {-2, 9}, {3, 16.5}, {0.2, 3},   {0.3, 1.6}, {-0.3, 1.6}};

double log_density(const Johnson& j, double y) {
  const double h = 1e-4;
  return -y * y / 2 - std::log(j(y + h) - j(y - h));
}

// Where a walk along y meets a larger density than on both sides.
std::vector<double> scanned_peaks(const Johnson& j, double step) {
  std::vector<double> out;
  for (double y = -6; y <= 6; y += step)
    if (log_density(j, y) > log_density(j, y - step) && log_density(j, y) > log_density(j, y + step))
      out.push_back(j(y));
  return out;
}

}  // namespace

TEST_CASE("heights come as near to their bounds as one likes, and S_U and the normal have none",
          "[johnson][exact]") {
  for (const Pair& p : bounded) {
    const Johnson j = fit_johnson(p.skewness, p.kurtosis);
    const DensityShape shape = density_shape(j);
    CAPTURE(p.skewness, p.kurtosis);
    CHECK(relative_error(shape.low, j(-1e5)) <= 1e-12);
    CHECK(relative_error(shape.high, j(1e5)) <= 1e-12);
  }
  const DensityShape normal = density_shape(fit_johnson(0, 3)),
                     unbounded = density_shape(fit_johnson(-0.5, 4));
  for (const DensityShape& shape : {normal, unbounded}) {
    CHECK(std::isinf(shape.low));
    CHECK(std::isinf(shape.high));
  }
}

TEST_CASE("a lognormal ends on its short side alone", "[johnson][exact]") {
  const double W = 0.1, w = 1 + W, skewness = std::sqrt(W) * (w + 2);
  const double kurtosis = 3 + W * (w * w * w + 3 * w * w + 6 * w + 6);
  const Johnson right = fit_johnson(skewness, kurtosis), left = fit_johnson(-skewness, kurtosis);
  REQUIRE(right.family == Johnson::Family::lognormal);
  // Of exp(y √ln w), mean √w and variance w W: 0 lies 1/√W below the mean, the mode w⁻¹.
  CHECK(relative_error(density_shape(right).low, -1 / std::sqrt(W)) <= 1e-12);
  CHECK(std::isinf(density_shape(right).high));
  CHECK(relative_error(density_shape(left).high, 1 / std::sqrt(W)) <= 1e-12);
  REQUIRE(density_shape(right).peaks.size() == 1);
  CHECK(relative_error(density_shape(right).peaks[0], (1 / w - std::sqrt(w)) / std::sqrt(w * W)) <= 1e-12);
  CHECK(relative_error(density_shape(left).peaks[0], -density_shape(right).peaks[0]) <= 1e-12);
}

// A step in y is so much in z as g rises there; the density's peak is within one.
TEST_CASE("the peaks are those that a walk along the density meets", "[johnson][law]") {
  const double step = 1e-3;
  for (const Pair& p : bounded) {
    const Johnson j = fit_johnson(p.skewness, p.kurtosis);
    std::vector<double> peaks = density_shape(j).peaks;
    // A walk to |y| = 6 does not come to the others.
    std::erase_if(peaks, [&](double z) { return z <= j(-5.9) || z >= j(5.9); });
    const std::vector<double> met = scanned_peaks(j, step);
    CAPTURE(p.skewness, p.kurtosis, j.gamma, j.delta);
    REQUIRE(met.size() == peaks.size());
    for (std::size_t i = 0; i < met.size(); ++i) CHECK(std::abs(met[i] - peaks[i]) <= 2 * step);
  }
}

// Johnson (1949): S_B of γ = 0 has two peaks where δ < 1/√2, at K = 1.87 of about that.
TEST_CASE("symmetric heights have two peaks below a kurtosis of 1.87 and one above", "[johnson][exact]") {
  CHECK(density_shape(fit_johnson(0, 1.9)).peaks.size() == 1);
  const DensityShape two = density_shape(fit_johnson(0, 1.8));
  REQUIRE(two.peaks.size() == 2);
  CHECK(std::abs(two.peaks[0] + two.peaks[1]) <= 1e-9);
}

// A kurtosis of 3 was kept whatever the skewness: at -1 the heights are cut at 1.09 Sq, and densest there.
TEST_CASE("a skewness alone has the kurtosis of the gamma family, whose heights have one peak inside",
          "[prescribed][law]") {
  for (double skewness = -3; skewness <= 3; skewness += 0.25) {
    const double kurtosis = gamma_kurtosis(skewness);
    const HeightMoments m = height_moments(PrescribedHeights{skewness, kurtosis}.translation());
    CAPTURE(skewness, kurtosis);
    CHECK(std::abs(m.skewness - skewness) <= 1e-9);
    CHECK(std::abs(m.kurtosis - kurtosis) <= 1e-9 * kurtosis);
    if (skewness == 0) continue;
    const DensityShape shape = density_shape(fit_johnson(skewness, kurtosis));
    REQUIRE(shape.peaks.size() == 1);
    const double inside = std::min(shape.peaks[0] - shape.low, shape.high - shape.peaks[0]);
    CHECK(inside >= (std::abs(skewness) <= 2 ? 0.5 : 0.15));
  }
  const DensityShape cut = density_shape(fit_johnson(-1, 3));
  CHECK(std::abs(cut.high - 1.09) <= 0.01);
  CHECK(cut.high - cut.peaks.back() <= 0.06);
}
