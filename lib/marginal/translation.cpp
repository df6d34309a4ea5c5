#include "marginal/translation.hpp"

#include <cmath>
#include <numbers>

#include "core/field.hpp"

namespace asperity {
namespace {

// A pole is about π details away: h = 0.4 details leaves exp(-2π²/0.4) = 4e-22; the normal law asks for h ≤
// 0.5.
constexpr double steps_a_detail = 2.5;

}  // namespace

NormalQuadrature::NormalQuadrature(double step) {
  const auto half = static_cast<Index>(std::floor(reach / step));
  nodes =
      Eigen::ArrayXd::LinSpaced(2 * half + 1, -static_cast<double>(half), static_cast<double>(half)) * step;
  weights = (-0.5 * nodes.square()).exp() * (step / std::sqrt(2 * std::numbers::pi));
}

double NormalQuadrature::step_for(const Translation& g) { return g.detail / steps_a_detail; }

Eigen::ArrayXd NormalQuadrature::heights(const Translation& g) const {
  Eigen::ArrayXd z = nodes;
  g.apply({z.data(), size(z.size())});
  return z;
}

HeightMoments height_moments(const Translation& g) {
  const NormalQuadrature law(NormalQuadrature::step_for(g));
  Eigen::ArrayXd z = law.heights(g);
  const double mean = (law.weights * z).sum();
  z -= mean;
  const double variance = (law.weights * z.square()).sum();
  z /= std::sqrt(variance);
  return {mean, variance, (law.weights * z.cube()).sum(), (law.weights * z.square().square()).sum()};
}

}  // namespace asperity
