#include "stats/uncertainty/correlation_algebra.hpp"

#include <algorithm>
#include <cmath>

#include "stats/uncertainty/lag_spectrum.hpp"
#include "transform/lag_sums.hpp"

namespace asperity {

CorrelationAlgebra::CorrelationAlgebra(const LagField& correlation, const Pairs& pairs)
    : rho_(correlation.normalised()), pairs_(pairs) {}

PowerSums::Sums PowerSums::sums() const {
  Sums out = sums_;
  for (double& s : out) s = std::max(s, 0.0);
  return out;
}

PowerSums::Sums CorrelationAlgebra::power_sums() const {
  PowerSums out;
  for_each_lag(rho_, pairs_, [&](Index p, Index q, double weight) { out.add(weight, rho_(p, q)); });
  return out.sums();
}

// Over the plane the c of a ρ that ends at P is zero beyond 2P.
LagField CorrelationAlgebra::convolution(Shape max_lag, bool periodic) const {
  const LagField rho = tapered(rho_, pairs_);
  if (periodic) {
    const Shape period = pairs_.grid().shape;
    return LagField(lag_sums(unfolded(rho, period), pairs_.grid(),
                             {std::min(max_lag.nx, period.nx / 2), std::min(max_lag.ny, period.ny / 2)}));
  }
  const Shape reach = rho.reach();
  const Field plane = Field::NullaryExpr(2 * reach.nx + 1, 2 * reach.ny + 1,
                                         [&](Index i, Index j) { return rho(i - reach.nx, j - reach.ny); });
  return LagField(lag_sums(plane, {shape_of(plane), 1, 1, false},
                           {std::min(max_lag.nx, 2 * reach.nx), std::min(max_lag.ny, 2 * reach.ny)}));
}

double bartlett_covariance(const LagField& c, const CorrelatedLag& h, const CorrelatedLag& g) {
  const auto [p, q] = h.lag;
  const auto [k, l] = g.lag;
  return c(p - k, q - l) + c(p + k, q + l) - 2 * g.rho * c(p, q) - 2 * h.rho * c(k, l) +
         2 * h.rho * g.rho * c(0, 0);
}

Eigen::MatrixXd bartlett_correlation(const LagField& c, const std::vector<CorrelatedLag>& lags) {
  const auto n = static_cast<Index>(lags.size());
  Eigen::MatrixXd out(n, n);
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b <= a; ++b)
      out(a, b) = out(b, a) =
          bartlett_covariance(c, lags[static_cast<std::size_t>(a)], lags[static_cast<std::size_t>(b)]);
  const Eigen::VectorXd scale = out.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * out * scale.asDiagonal();
}

}  // namespace asperity
