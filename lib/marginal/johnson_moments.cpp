#include "marginal/johnson_moments.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace asperity {

namespace {

constexpr int nodes = 256;
constexpr double step = 1.0 / 16, farthest = 5;
constexpr double largest_y = 38;  // φ is 1e-314 there

using Nodes = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, nodes, 1>;  // on the stack

struct Substitution {
  Nodes sinh, cosh;
  Substitution() {
    const Nodes s = Nodes::LinSpaced(nodes, -(nodes - 1) / 2.0, (nodes - 1) / 2.0) * step;
    sinh = s.sinh();
    cosh = s.cosh();
  }
};

double expectation(const Nodes& weight, const Nodes& values) { return (weight * values).sum(); }

}  // namespace

MarginalMoments johnson_moments(const Johnson& j) {
  static const Substitution s;
  const bool steep = j.family == Johnson::Family::bounded && j.delta < 1;
  const double centre = steep ? std::clamp(j.gamma, -farthest, farthest) : 0, width = steep ? j.delta : 1;
  Nodes z = centre + width * s.sinh;
  Nodes weight = s.cosh * (-z.square() / 2).exp();
  weight /= weight.sum();
  z = z.max(-largest_y).min(largest_y);
  j.apply({z.data(), nodes});

  const double unit = z.abs().maxCoeff(), mean = expectation(weight, z / unit);
  const Nodes d = z / unit - mean, d2 = d.square();
  const double variance = expectation(weight, d2);
  return {mean * unit, variance * unit * unit, expectation(weight, d2 * d) / (variance * std::sqrt(variance)),
          expectation(weight, d2.square()) / (variance * variance)};
}

MarginalMoments unbounded_moments(double gamma, double delta) {
  const double W = std::expm1(1 / (delta * delta)), w = 1 + W;
  const double d = std::exp(-2 * std::abs(gamma) / delta), less = -std::expm1(-2 * std::abs(gamma) / delta);
  const double V = w * (1 + d * d) + 2 * d;
  const double excess = w * w * (((w + 3) * w + 6) * w + 6) * (1 + d * d * d * d) +
                        4 * w * (w + 3) * d * (1 + d * d) - 6 * W * d * d;
  return {less * std::expm1(1 / (delta * delta) / 2), W * V,
          std::sqrt(w * W) * less * (w * (w + 2) * (1 + d + d * d) + 3 * d) / (V * std::sqrt(V)),
          3 + W * excess / (V * V)};
}

MarginalMoments lognormal_moments(double v) {
  const double W = std::expm1(v), w = 1 + W;
  return {std::expm1(v / 2), w * W, std::sqrt(W) * (w + 2), 3 + W * (((w + 3) * w + 6) * w + 6)};
}

}  // namespace asperity
