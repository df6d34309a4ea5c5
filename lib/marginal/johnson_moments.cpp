#include "marginal/johnson_moments.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "core/field.hpp"

namespace asperity {

namespace {

constexpr int most_nodes = 256;
constexpr double step = 1.0 / 16;
constexpr double farthest_centre = 5;
// From the centre. Beyond it φ is below 1e-62 where S_B rises steeply, 1e-105 where S_U and S_L have their
// tails.
constexpr double reach = 22;

using Nodes = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_nodes, 1>;  // on the stack

struct Substitution {
  Nodes sinh, cosh;
  Substitution() {
    const Nodes s = Nodes::LinSpaced(most_nodes, (1 - most_nodes) / 2.0, (most_nodes - 1) / 2.0) * step;
    sinh = s.sinh();
    cosh = s.cosh();
  }
};

double expectation(const Nodes& weight, const Nodes& values) { return (weight * values).sum(); }

}  // namespace

HeightMoments johnson_moments(const Johnson& j) {
  static const Substitution s;
  const bool steep = j.family == Johnson::Family::bounded && j.delta < 1;
  const double centre = steep ? std::clamp(j.gamma, -farthest_centre, farthest_centre) : 0;
  const double width = steep ? j.delta : 1;
  const Index nodes =
      2 * static_cast<Index>(std::min(std::ceil(std::asinh(reach / width) / step), most_nodes / 2.0));
  const Index first = (most_nodes - nodes) / 2;
  Nodes z = centre + width * s.sinh.segment(first, nodes);
  Nodes weight = s.cosh.segment(first, nodes) * (-z.square() / 2).exp();
  weight /= weight.sum();
  j.apply({z.data(), static_cast<std::size_t>(nodes)});

  const double unit = z.abs().maxCoeff(), mean = expectation(weight, z / unit);
  const Nodes d = z / unit - mean, d2 = d.square();
  const double variance = expectation(weight, d2);
  return {mean * unit, variance * unit * unit, expectation(weight, d2 * d) / (variance * std::sqrt(variance)),
          expectation(weight, d2.square()) / (variance * variance)};
}

HeightMoments unbounded_moments(double gamma, double delta) {
  const double W = std::expm1(1 / (delta * delta)), w = 1 + W;
  const double d = std::exp(-2 * std::abs(gamma) / delta), less = -std::expm1(-2 * std::abs(gamma) / delta);
  const double V = w * (1 + d * d) + 2 * d;
  const double excess = w * w * (((w + 3) * w + 6) * w + 6) * (1 + d * d * d * d) +
                        4 * w * (w + 3) * d * (1 + d * d) - 6 * W * d * d;
  return {less * std::expm1(1 / (delta * delta) / 2), W * V,
          std::sqrt(w * W) * less * (w * (w + 2) * (1 + d + d * d) + 3 * d) / (V * std::sqrt(V)),
          3 + W * excess / (V * V)};
}

HeightMoments lognormal_moments(double v) {
  const double W = std::expm1(v), w = 1 + W;
  return {std::expm1(v / 2), w * W, std::sqrt(W) * (w + 2), 3 + W * (((w + 3) * w + 6) * w + 6)};
}

}  // namespace asperity
