#include "stats/uncertainty/translation_error.hpp"

#include <algorithm>
#include <cmath>

#include "marginal/johnson.hpp"
#include "math/hermite.hpp"

namespace asperity {

LagField underlying_correlation(const LagField& heights, const CorrelationMap& map) {
  return heights.normalised().mapped([&](double r) { return map.inverse(r); });
}

std::optional<Translation> evident_translation(const Moments& moments, const MomentErrors& gaussian) {
  constexpr double evident = 4;
  if (std::abs(moments.ssk) <= evident * gaussian.ssk && std::abs(moments.sku - 3) <= evident * gaussian.sku)
    return std::nullopt;
  const double skewness = std::clamp(moments.ssk, -largest_skewness, largest_skewness);
  return johnson_translation(skewness, std::clamp(moments.sku, least_kurtosis(skewness), largest_kurtosis));
}

TranslationErrors::TranslationErrors(const Translation& g, const EffectiveSampleSize& size)
    : covariance_(decltype(covariance_)::Zero()) {
  constexpr double widest_step = 0.085;  // the orders of S_k need nodes this close
  const NormalQuadrature law(std::min(NormalQuadrature::step_for(g), widest_step));
  const Eigen::ArrayXd z = law.heights(g), square = z.square();
  const HeightMoments shape = height_moments(g);
  skewness_ = shape.skewness;
  kurtosis_ = shape.kurtosis;
  sign_ = (law.weights * z.sign()).sum();
  Eigen::Matrix<double, Eigen::Dynamic, 5> f(z.size(), 5);
  f << z, square, z * square, square.square(), z.abs();
  HermiteFunction h(law.nodes, law.weights);
  h.next();
  for (int k = 1; k <= EffectiveSampleSize::powers; ++k) {
    const Means c = f.transpose() * h.next().matrix();
    covariance_ += c * c.transpose() * size.mean_power(k);
  }
}

MomentErrors TranslationErrors::standard_errors(double sq) const {
  const double s = skewness_, k = kurtosis_;
  return {.mean = sq * error({1, 0, 0, 0, 0}),
          .sa = sq * error({-sign_, 0, 0, 0, 1}),
          .sq = sq * error({0, 0.5, 0, 0, 0}),
          .ssk = error({-3, -1.5 * s, 1, 0, 0}),
          .sku = error({-4 * s, -2 * k, 0, 1, 0})};
}

double TranslationErrors::ssk_bias() const {
  const auto& v = covariance_;
  return 1.5 * (v(0, 1) - v(1, 2) + skewness_ * v(0, 0)) + 1.875 * skewness_ * v(1, 1);
}

double TranslationErrors::sku_bias() const {
  const auto& v = covariance_;
  return -4 * v(0, 2) + (6 + 2 * kurtosis_) * v(0, 0) + 3 * kurtosis_ * v(1, 1) - 2 * v(1, 3) +
         8 * skewness_ * v(0, 1);
}

}  // namespace asperity
