#include "stats/uncertainty/wave_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

constexpr Eigen::Index decays = 9, angles = 7, falling = 2 * 3 * decays;

double decay(Eigen::Index k) { return 1e-3 * std::pow(300, static_cast<double>(k) / (decays - 1)); }

// (3) at the angle φ.
Eigen::ArrayXd ridge(const Eigen::ArrayX2d& half_waves, double angle) {
  constexpr double width = std::numbers::pi * std::numbers::pi / 2;
  const Eigen::ArrayXd x = half_waves.col(0) * std::sin(angle), y = half_waves.col(1) * std::cos(angle);
  return 0.5 * ((1 + width * (x - y).square()).inverse() + (1 + width * (x + y).square()).inverse());
}

}  // namespace

double WaveError::half_width() const { return student_quantile(0.025, degrees) * error; }

WaveSpectra::WaveSpectra(const LongWaveNumbers& numbers) {
  const auto& [nu, half_waves] = numbers;
  constexpr double prior_of_falling = 1.0 / 16, prior_of_ridge = 1.0 / 12;
  const bool plane = half_waves.rows() > 0 && (half_waves.colwise().maxCoeff() > 0).all();
  const Eigen::Index shapes = 1 + falling + (plane ? angles : 0);
  inverse_.resize(shapes, nu.size()), before_.resize(shapes), decay_.resize(shapes);
  Eigen::Index i = 0;
  auto add = [&](const Eigen::ArrayXd& s, double prior, double b) {
    inverse_.row(i) = s.inverse().matrix().transpose();
    before_(i) = std::log(prior) - 0.5 * s.log().sum();
    decay_(i++) = b;
  };
  add(Eigen::ArrayXd::Ones(nu.size()), 1, 0);
  for (const double noise : {0.0, 0.1, 0.4})
    for (Eigen::Index k = 0; k < decays; ++k) {
      const Eigen::ArrayXd x = decay(k) * nu;
      add(noise + (1 - noise) * (-x).exp(), prior_of_falling, decay(k));
      add(noise + (1 - noise) * (1 + 2 * x).pow(-1.5), prior_of_falling, decay(k));
    }
  for (Eigen::Index k = 0; plane && k < angles; ++k)
    add(ridge(half_waves, std::numbers::pi / 2 * static_cast<double>(k) / (angles - 1)), prior_of_ridge, 0);
}

WaveSpectra::Posterior WaveSpectra::posterior(const Eigen::ArrayXd& squares) const {
  const auto K = static_cast<double>(waves());
  Posterior out;
  out.logarithms = (inverse_ * squares.matrix() / K).array().log();
  const Eigen::ArrayXd likelihood = before_ - 0.5 * K * out.logarithms;
  out.probabilities = (likelihood - likelihood.maxCoeff()).exp();
  out.probabilities /= out.probabilities.sum();
  return out;
}

WaveError WaveSpectra::error(const Eigen::ArrayXd& squares) const {
  constexpr double least = 1.6, patch = 0.785, few = 20;
  const auto K = static_cast<double>(waves());
  if (waves() == 0) return {std::numeric_limits<double>::quiet_NaN(), least};
  if (!(squares.sum() > 0)) return {std::sqrt(squares.sum()), K};
  const auto [logarithms, p] = posterior(squares);
  const double mean = (p * logarithms).sum(), v = (p * (logarithms - mean).square()).sum(),
               patches = patch / (p * decay_).sum();
  return {std::exp(0.5 * mean), std::max(least, 2 / (2 / K + v) * patches / (patches + few))};
}

Eigen::ArrayXd WaveSpectra::weights(const Eigen::ArrayXd& squares) const {
  if (!(squares.sum() > 0)) return Eigen::ArrayXd::Constant(waves(), 1 / static_cast<double>(waves()));
  const auto [logarithms, p] = posterior(squares);
  const Eigen::ArrayXd mixed = (inverse_.transpose() * p.matrix()).array();
  return mixed * (std::exp((p * logarithms).sum()) / (mixed * squares).sum());
}

}  // namespace asperity
