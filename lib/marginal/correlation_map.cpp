#include "marginal/correlation_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/hermite.hpp"

namespace asperity {
namespace {

constexpr double negligible = 1e-13;   // of the variance
constexpr double least_term = 50;      // -log |ρ|ᵏ: all further terms are 2e-22 of the variance at most
constexpr double most_products = 5e7;  // nodes × orders: half a second
constexpr double widest_step = 0.1;    // of the quadrature: resolves 400 orders
constexpr double resolved_phase = 2;   // of h_k, whose wavelength is 2π/√k, from node to node
constexpr Eigen::Index intervals = 2048;

}  // namespace

CorrelationMap::CorrelationMap(const Translation& g) {
  const double step = std::min(widest_step, NormalQuadrature::step_for(g));
  const NormalQuadrature law(step);
  const Eigen::ArrayXd z = law.heights(g);
  const double most =
      std::min(std::pow(resolved_phase / step, 2), most_products / static_cast<double>(z.size()));
  HermiteFunction h(law.nodes, law.weights);
  h.next();
  std::vector<double> powers;
  double left = 1;
  while (left > negligible && static_cast<double>(powers.size()) < most) {
    const double c = (z * h.next()).sum();
    powers.push_back(c * c);
    left -= c * c;
  }
  powers.push_back(std::max(left, 0.0));
  powers_ = Eigen::Map<const Eigen::ArrayXd>(powers.data(), static_cast<Eigen::Index>(powers.size()));

  constexpr double right = std::numbers::pi / 2;
  rhos_ = Eigen::ArrayXd::LinSpaced(intervals + 1, -right, right).sin();
  correlations_ = Eigen::ArrayXd::Zero(rhos_.size());
  Eigen::ArrayXd derivative = correlations_;
  for (Eigen::Index k = orders(); k > 0; --k) {  // Horner
    derivative = derivative * rhos_ + static_cast<double>(k) * powers_(k - 1);
    correlations_ = (correlations_ + powers_(k - 1)) * rhos_;
  }
  slopes_ = 1 / derivative;
}

double CorrelationMap::operator()(double rho) const {
  const double decay = -std::log(std::abs(rho));  // of a term, with each order
  const bool ends = decay * static_cast<double>(orders()) > least_term;
  double sum = 0;
  for (Eigen::Index k = ends ? static_cast<Eigen::Index>(least_term / decay) + 1 : orders(); k > 0; --k)
    sum = (sum + powers_(k - 1)) * rho;
  return sum;
}

double CorrelationMap::inverse(double r) const {
  if (r <= lowest()) return -1;
  if (r >= correlations_(intervals)) return 1;
  const double* const first = correlations_.data();
  const auto i = std::upper_bound(first, first + intervals, r) - first - 1;
  const double width = correlations_(i + 1) - correlations_(i), t = (r - correlations_(i)) / width;
  const double rise = rhos_(i + 1) - rhos_(i);
  const double low = slopes_(i) * width - rise, high = rise - slopes_(i + 1) * width;
  return rhos_(i) + t * rise + t * (1 - t) * ((1 - t) * low + t * high);
}

}  // namespace asperity
