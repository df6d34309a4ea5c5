/// Plastic strains that the tests of this room share.
#pragma once

#include <random>

#include "plastic/layered_body.hpp"
#include "support.hpp"

namespace asperity::test {

/// 0 = z_0 < … < z_n, the first layer `first` thick, each `ratio` times the one above.
inline std::vector<double> graded(Index layers, double first, double ratio) {
  std::vector<double> out{0};
  for (Index k = 0; k < layers; ++k, first *= ratio) out.push_back(out.back() + first);
  return out;
}

inline LayeredField random_strain(const LayeredBody& body, unsigned seed) {
  LayeredField out(body.layers(), deviator::components, body.grid().shape);
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (double& v : out.values) v = uniform(generator);
  return out;
}

/// `amplitude` times the mean over each layer of exp(-(x² + y² + (z - depth)²) / 2w²).
inline LayeredField gaussian_strain(const LayeredBody& body, const deviator::Vector& amplitude, double depth,
                                    double w) {
  LayeredField out(body.layers(), deviator::components, body.grid().shape);
  auto to = [&](double z) {
    return w * std::sqrt(std::numbers::pi / 2) * std::erf((z - depth) / (std::numbers::sqrt2 * w));
  };
  const Field across =
      sample(body.grid(), [&](double x, double y) { return std::exp(-(x * x + y * y) / (2 * w * w)); });
  for (Index k = 0; k < body.layers(); ++k) {
    const double mean = (to(body.edges()[size(k + 1)]) - to(body.edges()[size(k)])) / body.thickness(k);
    for (Index c = 0; c < deviator::components; ++c) out(k, c) = amplitude[size(c)] * mean * across;
  }
  return out;
}

inline LayeredField residual_stress(LayeredBody& body, const LayeredField& strain,
                                    Index components = deviator::components) {
  LayeredField out(body.layers(), components, body.grid().shape);
  body.set_strain(strain);
  body.stress(nullptr, out);
  return out;
}

/// Σ h a:b.
inline double product(const LayeredBody& body, const LayeredField& a, const LayeredField& b) {
  double sum = 0;
  for (Index k = 0; k < body.layers(); ++k)
    for (Index c = 0; c < deviator::components; ++c) sum += body.thickness(k) * (a(k, c) * b(k, c)).sum();
  return sum;
}

}  // namespace asperity::test
