#include "transform/interpolation.hpp"

#include <numbers>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// A wave of k radians a sample, prepared, refined s times: the largest error at 40 s values.
double error(double k, Index s, double phase) {
  const Interpolation interpolation(s);
  std::vector<double> samples(64), out(static_cast<std::size_t>(interpolation.padded(40 * s)));
  auto wave = [&](double x) { return std::cos(k * x + phase); };
  for (std::size_t m = 0; m < samples.size(); ++m)
    samples[m] = Interpolation::prepared(k) * wave(static_cast<double>(m) - Interpolation::before);
  interpolation.refine(samples.data(), 40 * s, out.data());
  double worst = 0;
  for (Index j = 0; j < 40 * s; ++j)
    worst = std::max(worst, std::abs(out[static_cast<std::size_t>(j)] -
                                     wave(static_cast<double>(j) / static_cast<double>(s))));
  return worst;
}

}  // namespace

// The header's figures.
TEST_CASE("between its samples a wave is found within the error of its mode", "[interpolation][order]") {
  for (Index s : {2, 4, 8, 16, 32})
    for (double phase : {0.0, 1.0}) {
      CAPTURE(s, phase);
      CHECK(error(0, s, phase) <= 9e-8);
      CHECK(error(std::numbers::pi / 2, s, phase) <= 8e-7);
      CHECK(error(0.75 * std::numbers::pi, s, phase) <= 5e-3);
    }
}

TEST_CASE("values are those of the weights, whatever their number", "[interpolation][law]") {
  const Field samples = random_field({1, 40}, 3);
  for (Index s : {2, 4, 16})
    for (Index count : {1, 7, 8, 33}) {
      const Interpolation interpolation(s);
      std::vector<double> out(static_cast<std::size_t>(interpolation.padded(count)));
      interpolation.refine(samples.data(), count, out.data());
      for (Index j = 0; j < count; ++j) {
        double sum = 0, scale = 0;
        for (Index t = 0; t < Interpolation::taps; ++t) {
          const double term = interpolation.weights(j % s)[t] * samples(0, j / s + t);
          sum += term, scale += std::abs(term);
        }
        CHECK(std::abs(out[static_cast<std::size_t>(j)] - sum) <= 8 * epsilon * scale);
      }
    }
}
