#include "stats/measure/instrument_noise.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/hybrid/spectral_moments.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Parameter& noise_row(const Parameters& rows, const std::string& name) {
  return *std::ranges::find(rows, name, &Parameter::name);
}

}  // namespace

// The mean over all signs of noise is its expectation: round-off of 512 sums.
TEST_CASE("what noise adds to Sq, slopes and second derivatives is its mean over all signs of it",
          "[noise][exact]") {
  const double n = 0.3;
  const Grid g{{3, 3}, 0.5, 0.7, true};
  const double c = std::cos(0.4), s = std::sin(0.4);
  double sq = 0, m2 = 0, m4 = 0, m40 = 0;
  for (int pattern = 0; pattern < 512; ++pattern) {
    const Field z =
        Field::NullaryExpr(3, 3, [&](Index i, Index j) { return (pattern >> (3 * i + j)) & 1 ? n : -n; });
    const SpectralMoments of = spectral_moments(z, g);
    sq += z.square().mean() / 512, m40 += of.m40 / 512;
    m2 += of.along(0.4).m2 / 512, m4 += of.along(0.4).m4 / 512;
  }
  const Parameters rows{{"Sq", 5, "m", 0.1, ""},
                        {"m2_direction", 100, "1", 1, ""},
                        {"m4_direction", 1000, "m-2", 1, ""},
                        {"m4_x", 1000, "m-2", 1, ""},
                        {"Sdr", 1, "1", 1, ""}};
  const Parameters out = without_noise(rows, n, g, Direction{0.4, "0.4rad"});
  REQUIRE(out.size() == 4);
  CHECK(relative_error(out[0].value, std::sqrt(25 - sq)) <= 1e-13);
  CHECK(relative_error(out[0].standard_error, 0.1 * 5 / std::sqrt(25 - sq)) <= 1e-13);
  CHECK(relative_error(out[1].value, 100 - m2) <= 1e-12);
  CHECK(relative_error(out[2].value, 1000 - m4) <= 1e-12);
  CHECK(relative_error(out[3].value, 1000 - m40) <= 1e-12);
  CHECK(relative_error(m2, 2 * n * n * (c * c / 0.25 + s * s / 0.49)) <= 1e-12);
}

// 128² points know the noise to 0.55 %; holes, an offset and units are no noise.
TEST_CASE("two maps of one place tell their noise, other maps none", "[noise][statistics]") {
  const Field z = gaussian_acf_field({128, 128}, 8, 1);
  Field a = z + 0.2 * white_noise({128, 128}, 2), b = z + 0.2 * white_noise({128, 128}, 3) + 5;
  a(3, 4) = b(7, 7) = NAN;
  const auto noise = noise_of_repeated(a, b);
  REQUIRE(noise);
  CHECK(std::abs(*noise / 0.2 - 1) <= 4 * 0.0055);
  CHECK(!noise_of_repeated(a, a));
  CHECK(!noise_of_repeated(z, gaussian_acf_field({128, 128}, 8, 4)));
}

// Means of 60 maps within 4 errors, and 95 % intervals of at least 50.
TEST_CASE("without its noise a map has the Sq and the slope of its surface", "[noise][statistics]") {
  const Grid g = grid(96, 96, true);
  Spread sq, sdq;
  int held = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Field z = gaussian_acf_field(g.shape, 8, seed), noisy = z + 0.2 * white_noise(g.shape, 1000 + seed);
    const Sample sample({.grid = g, .heights = noisy - noisy.mean()});
    Parameters rows = measure(sample, Group::height, {});
    const Parameters slopes = measure(sample, Group::hybrid, {});
    rows.insert(rows.end(), slopes.begin(), slopes.end());
    const Parameters out = without_noise(rows, 0.2, g);
    const double truth = std::sqrt(spectral_moments(z, g).m20 + spectral_moments(z, g).m02);
    sq.add(std::pow(noise_row(out, "Sq_without_noise").value, 2) - (z - z.mean()).square().mean());
    sdq.add(std::pow(noise_row(out, "Sdq_without_noise").value, 2) - truth * truth);
    const Interval ends = noise_row(out, "Sdq_without_noise").interval_95();
    held += ends.low <= 2 / 8. && 2 / 8. <= ends.high;  // √(2 · 2)/length
  }
  CHECK(std::abs(sq.mean()) <= 4 * sq.deviation() / std::sqrt(60.0));
  CHECK(std::abs(sdq.mean()) <= 4 * sdq.deviation() / std::sqrt(60.0));
  CHECK(held >= 50);
}

TEST_CASE("noise as large as Sq is refused, and as large as a slope leaves it without a value",
          "[noise][contract]") {
  const Grid g = grid(16, 16);
  const Sample sample({.grid = g, .heights = sine(g.shape, 1, 1)});
  const Parameters rows{{"Sq", 0.7, "m", 0.1, ""}, {"Sdq", 0.3, "1", 0.1, ""}};
  for (const double noise : {0.0, -1.0, 0.8, static_cast<double>(NAN)})
    CHECK_THROWS_AS(check_noise(noise, sample), ParameterError);
  const Parameters out = without_noise(rows, 0.2, g);  // of slope 0.4
  CHECK(std::isnan(noise_row(out, "Sdq_without_noise").value));
  CHECK(noise_row(out, "Sdq_without_noise").why.starts_with("no value"));
}
