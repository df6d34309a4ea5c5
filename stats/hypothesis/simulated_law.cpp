#include "stats/hypothesis/simulated_law.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "math/bracketed_root.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

using Eigen::ArrayXd, Eigen::ArrayXXd;

constexpr double largest_power = 8;
constexpr Eigen::Index ensembles = 800;

double skewness(const ArrayXd& x) {
  const ArrayXd d = x - x.mean();
  return d.cube().mean() / std::pow(d.square().mean(), 1.5);
}

// (1)
ArrayXd power(const ArrayXd& x, double lambda) {
  if (std::abs(lambda) < 1e-9) return x.log();
  return ((lambda * x.log()).exp() - 1) / lambda;
}

struct Normal {
  double mean, deviation, count;

  static Normal of(const ArrayXd& x) { return {x.mean(), sample_deviation(x), double(x.size())}; }
  /// (2), of a mean over so many.
  double t(double value, double of) const {
    return (value - mean) / (deviation * std::sqrt(1 / of + 1 / count));
  }
};

// (3), or of the mean over several surfaces.
ArrayXd largest_simulated(const ArrayXXd& simulated, Eigen::Index surfaces) {
  const double k = static_cast<double>(simulated.rows()), m = static_cast<double>(surfaces);
  ArrayXXd u = simulated.rowwise() - simulated.colwise().mean();
  u.rowwise() *= (k / u.square().colwise().sum()).sqrt();
  if (surfaces > 1) {
    std::mt19937_64 generator(1);
    ArrayXXd means = ArrayXXd::Zero(ensembles, u.cols());
    for (auto mean : means.rowwise())
      for (Eigen::Index i = 0; i < surfaces; ++i)
        mean += u.row(static_cast<Eigen::Index>(generator() % static_cast<std::uint64_t>(u.rows())));
    u = means / std::sqrt(m);
  }
  return (u.abs() * ((k - 2) / (k - 1 - u.square() / m).max(1e-9)).sqrt()).rowwise().maxCoeff();
}

}  // namespace

double sample_deviation(const ArrayXd& x) {
  return std::sqrt((x - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

NormalisingPower::NormalisingPower(const ArrayXd& simulated) : scale_(std::exp(simulated.log().mean())) {
  const ArrayXd x = simulated / scale_;
  least_ = x.minCoeff(), most_ = x.maxCoeff();
  auto skew = [&](double lambda) { return skewness(power(x, lambda)); };
  const CurvePoint low{-largest_power, skew(-largest_power)}, high{largest_power, skew(largest_power)};
  lambda_ = !(low.f < 0) ? low.x : !(high.f > 0) ? high.x : bracketed_root(skew, low, high, 1e-6);
}

double NormalisingPower::operator()(double x) const {
  const double end = lambda_ < 0 ? std::min(x / scale_, most_) : std::max(x / scale_, least_);
  return power(ArrayXd::Constant(1, end), lambda_)(0) + std::pow(end, lambda_) * std::log(x / scale_ / end);
}

double p_of_mean(const ArrayXd& simulated, const ArrayXd& observed) {
  const double t = Normal::of(simulated).t(observed.mean(), static_cast<double>(observed.size()));
  return 2 * student_tails(std::abs(t), static_cast<double>(simulated.size() - 1)).above;
}

double p_of_skewed_mean(const ArrayXd& simulated, const ArrayXd& observed) {
  const NormalisingPower y(simulated);
  return p_of_mean(y(simulated), y(observed));
}

SimulatedTogether::SimulatedTogether(const ArrayXXd& simulated, const ArrayXXd& observed)
    : deviations_(simulated.cols()) {
  const auto surfaces = static_cast<double>(observed.rows());
  for (Eigen::Index i = 0; i < simulated.cols(); ++i)
    deviations_(i) = Normal::of(simulated.col(i)).t(observed.col(i).mean(), surfaces);
  const ArrayXd largest = largest_simulated(simulated, observed.rows());
  const NormalisingPower y(largest);
  const double t = Normal::of(y(largest)).t(y(deviations_.abs().maxCoeff()), 1);
  p_ = student_tails(t, static_cast<double>(simulated.rows() - 1)).above;
}

}  // namespace asperity
