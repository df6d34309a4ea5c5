#include "stats/uncertainty/wave_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

constexpr Eigen::Index decays = 9, shapes = 1 + 2 * 3 * decays;

double decay(Eigen::Index k) { return 1e-3 * std::pow(300, static_cast<double>(k) / (decays - 1)); }

}  // namespace

double WaveError::half_width() const { return student_quantile(0.025, degrees) * error; }

WaveSpectra::WaveSpectra(const Eigen::ArrayXd& nu)
    : inverse_(Eigen::MatrixXd::Ones(shapes, nu.size())),
      before_(Eigen::ArrayXd::Zero(shapes)),
      decay_(Eigen::ArrayXd::Zero(shapes)) {
  Eigen::Index i = 1;  // the first is s = 1
  for (const double noise : {0.0, 0.1, 0.4})
    for (Eigen::Index k = 0; k < decays; ++k)
      for (const bool gaussian : {true, false}) {
        const Eigen::ArrayXd x = decay(k) * nu;
        const Eigen::ArrayXd s =
            noise + (1 - noise) * (gaussian ? (-x).exp().eval() : (1 + 2 * x).pow(-1.5).eval());
        inverse_.row(i) = s.inverse().matrix().transpose();
        before_(i) = -std::log(6) - 0.5 * s.log().sum();
        decay_(i++) = decay(k);
      }
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
  constexpr double least = 1.6, patch = 0.785, few = 10;
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
  const Eigen::ArrayXd falling = (inverse_.transpose() * p.matrix()).array();
  return falling * (std::exp((p * logarithms).sum()) / (falling * squares).sum());
}

}  // namespace asperity
