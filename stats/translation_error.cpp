#include "stats/translation_error.hpp"

#include <algorithm>
#include <cmath>

#include "marginal/hermite.hpp"
#include "marginal/johnson.hpp"

namespace asperity {
namespace {

// The square root of (2) for each column of f, values at the nodes of the law.
Eigen::ArrayXd errors_of(const NormalQuadrature& law, const Eigen::ArrayXXd& f, const EffectiveSize& size) {
  Eigen::ArrayXd variance = Eigen::ArrayXd::Zero(f.cols());
  HermiteFunction h(law.nodes, law.weights);
  h.next();
  for (int k = 1; k <= EffectiveSize::powers; ++k)
    variance += (f.matrix().transpose() * h.next().matrix()).array().square() * (size.sum(k) / size.points());
  return variance.sqrt();
}

}  // namespace

LagField underlying_correlation(const LagField& heights, const CorrelationMap& map) {
  return LagField(heights.normalised().half_plane().unaryExpr([&](double r) { return map.inverse(r); }));
}

std::optional<Translation> evident_translation(const Moments& moments, const MomentErrors& gaussian) {
  constexpr double evident = 4;
  if (std::abs(moments.ssk) <= evident * gaussian.ssk && std::abs(moments.sku - 3) <= evident * gaussian.sku)
    return std::nullopt;
  const double skewness = std::clamp(moments.ssk, -largest_skewness, largest_skewness);
  return johnson_translation(skewness, std::clamp(moments.sku, least_kurtosis(skewness), largest_kurtosis));
}

MomentErrors standard_errors(const Moments& moments, const Translation& g, const EffectiveSize& size) {
  // Orders up to 512 need nodes 2/√512 apart.
  const NormalQuadrature law(std::min(NormalQuadrature::step_for(g), 0.085));
  const HeightMoments shape = height_moments(g);
  const Eigen::ArrayXd z = law.heights(g), square = z.square() - 1;
  const double s = shape.skewness, k = shape.kurtosis;
  Eigen::ArrayXXd f(z.size(), 5);
  f.col(0) = z;
  f.col(1) = z.abs() - z * (law.weights * z.sign()).sum();
  f.col(2) = square / 2;
  f.col(3) = z.cube() - 3 * z - 1.5 * s * square;
  f.col(4) = z.square().square() - 4 * s * z - 2 * k * square;
  const Eigen::ArrayXd error = errors_of(law, f, size);
  return {.mean = moments.sq * error(0),
          .sa = moments.sq * error(1),
          .sq = moments.sq * error(2),
          .ssk = error(3),
          .sku = error(4)};
}

}  // namespace asperity
