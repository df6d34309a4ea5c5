#include "stats/hypothesis/simulated_law.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "math/bracketed_root.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

using Eigen::ArrayXd, Eigen::ArrayXXd;
using RowArray = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double largest_power = 8;
constexpr Eigen::Index ensembles = 800, most_drawn = 400;

double skewness(const ArrayXd& x) {
  const ArrayXd d = x - x.mean();
  return d.cube().mean() / std::pow(d.square().mean(), 1.5);
}

// (1)
ArrayXd power(const ArrayXd& x, double lambda) {
  if (std::abs(lambda) < 1e-9) return x.log();
  return ((lambda * x.log()).exp() - 1) / lambda;
}

// √m times the means of m rows.
ArrayXXd drawn_means(const RowArray& rows, Eigen::Index m) {
  std::mt19937_64 generator(1);
  RowArray means = RowArray::Zero(ensembles, rows.cols());
  for (auto mean : means.rowwise())
    for (Eigen::Index i = 0; i < m; ++i)
      mean += rows.row(static_cast<Eigen::Index>(generator() % static_cast<std::uint64_t>(rows.rows())));
  return means / std::sqrt(static_cast<double>(m));
}

// (3), or (5) of the mean over several surfaces.
ArrayXd largest_simulated(const ArrayXXd& simulated, Eigen::Index surfaces) {
  surfaces = std::min(surfaces, most_drawn);
  const double k = static_cast<double>(simulated.rows()), m = static_cast<double>(surfaces);
  ArrayXXd u = simulated.rowwise() - simulated.colwise().mean();
  u.rowwise() *= (k / u.square().colwise().sum()).sqrt();
  if (surfaces > 1) u = drawn_means(u, surfaces);
  const ArrayXXd of_others = ((k - 2) / (k - 1 - u.square() / m).max(1e-9)).sqrt(),
                 of_student = 1 + (1 - 1 / m) * (u.square() + 1) / (4 * (k - 1));
  return (u.abs() * of_others * of_student).rowwise().maxCoeff();
}

}  // namespace

double sample_deviation(const ArrayXd& x) {
  return std::sqrt((x - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

bool Compared::known() const {
  return simulated.isFinite().all() && observed.isFinite().all() && sample_deviation(simulated) > 0;
}

double Compared::expected() const {
  const double mean = simulated.mean();
  return knows_limit ? mean - (mean - limit) * (1 - 1 / worth) : mean;
}

double Compared::standard_error() const {
  const auto k = static_cast<double>(simulated.size()), m = static_cast<double>(observed.size());
  return sample_deviation(simulated) * std::sqrt(1 / (worth * m) + 1 / (knows_limit ? worth * worth * k : k));
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

double p_of_mean(const Compared& quantity) {
  return 2 * student_tails(std::abs(quantity.t()), static_cast<double>(quantity.simulated.size() - 1)).above;
}

double p_of_skewed_mean(const Compared& quantity) {
  return p_of_mean(quantity.mapped(NormalisingPower(quantity.simulated)));
}

SimulatedTogether::SimulatedTogether(const std::vector<Compared>& quantities)
    : deviations_(quantities.size()) {
  ArrayXXd simulated(quantities.front().simulated.size(), deviations_.size());
  double surfaces = 0;
  for (Eigen::Index i = 0; const Compared& one : quantities) {
    deviations_(i) = one.t(), simulated.col(i++) = one.simulated;
    surfaces += one.worth * static_cast<double>(one.observed.size()) / static_cast<double>(quantities.size());
  }
  const ArrayXd largest = largest_simulated(simulated, std::lround(surfaces));
  const ArrayXd found = ArrayXd::Constant(1, deviations_.abs().maxCoeff());
  const double t = Compared{largest, found}.mapped(NormalisingPower(largest)).t();
  p_ = student_tails(t, static_cast<double>(simulated.rows() - 1)).above;
}

}  // namespace asperity
