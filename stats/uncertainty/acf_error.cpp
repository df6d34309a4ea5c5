#include "stats/uncertainty/acf_error.hpp"

#include <algorithm>
#include <cmath>

#include "transform/lag_sums.hpp"

namespace asperity {

AcfError::AcfError(const LagField& correlation, const Pairs& pairs)
    : rho_(correlation.normalised()), pairs_(pairs) {
  for (Index p = -rho_.max_p(); p <= rho_.max_p(); ++p)
    for (Index q = -rho_.max_q(); q <= rho_.max_q(); ++q)
      if (const double rho = rho_(p, q); rho != 0) support_.push_back({p, q, rho});
}

double AcfError::pairs(Index p, Index q) const { return pairs_.share(p, q) * pairs_.points(); }

double AcfError::weight(Index p, Index q, Index k, Index l) const {
  const double there = pairs_.density(k, l);
  if (pairs_.grid().periodic) return there;
  auto share = [](Index n, Index distance) {
    return std::max(0.0, 1 - static_cast<double>(std::abs(distance)) / static_cast<double>(n));
  };
  const auto [nx, ny] = pairs_.grid().shape;
  return there * share(nx - std::abs(p), k) * share(ny - std::abs(q), l);
}

// The second product of (1) is summed over m = k + h, where ρ(m) ≠ 0.
double AcfError::absolute(Index p, Index q) const {
  double sum = 0;
  for (const auto& [k, l, rho] : support_)
    sum += weight(p, q, k, l) * rho * rho + weight(p, q, k - p, l - q) * rho * rho_(k - 2 * p, l - 2 * q);
  return std::sqrt(std::max(sum, 0.0) / pairs(p, q));
}

double AcfError::normalised(Index p, Index q) const {
  if (p == 0 && q == 0) return 0;
  const double at_lag = rho_(p, q);
  double sum = 0;
  for (const auto& [k, l, rho] : support_) {
    const double shifted = rho_(k - 2 * p, l - 2 * q), beside = rho_(k + p, l + q);
    sum += weight(p, q, k, l) * rho * ((1 + 2 * at_lag * at_lag) * rho - 4 * at_lag * beside) +
           weight(p, q, k - p, l - q) * rho * shifted;
  }
  return std::sqrt(std::max(sum, 0.0) / pairs(p, q));
}

// c of a ρ that ends at P is zero beyond 2P.
LagField AcfError::convolution(Shape max_lag) const {
  const Shape reach = rho_.reach();
  Field plane = Field::Zero(2 * reach.nx + 1, 2 * reach.ny + 1);
  for (const auto& [p, q, rho] : support_)
    plane(reach.nx + p, reach.ny + q) = rho * std::sqrt(weight(0, 0, p, q));
  const Shape lags{std::min(max_lag.nx, 2 * reach.nx), std::min(max_lag.ny, 2 * reach.ny)};
  return LagField(lag_sums(plane, {{plane.rows(), plane.cols()}, 1, 1, false}, lags));
}

LagField AcfError::normalised(Shape max_lag) const {
  const LagField c = convolution({2 * max_lag.nx, 2 * max_lag.ny});
  const double square = c(0, 0);
  auto error = [&](Index p, Index column) {
    const Index q = column - max_lag.ny;
    if (p == 0 && q == 0) return 0.0;
    const double rho = rho_(p, q), sum = square * (1 + 2 * rho * rho) - 4 * rho * c(p, q) + c(2 * p, 2 * q);
    return std::sqrt(std::max(sum, 0.0) / pairs(p, q));
  };
  return LagField(Field::NullaryExpr(max_lag.nx + 1, 2 * max_lag.ny + 1, error));
}

Eigen::MatrixXd AcfError::correlation(const std::vector<Shape>& lags) const {
  const auto n = static_cast<Index>(lags.size());
  Shape farthest{0, 0};
  for (const auto& [p, q] : lags)
    farthest = {std::max(farthest.nx, std::abs(p)), std::max(farthest.ny, std::abs(q))};
  const LagField c = convolution({2 * farthest.nx, 2 * farthest.ny});
  const double square = c(0, 0);
  Eigen::VectorXd rho(n), beside(n);
  for (Index a = 0; const auto& [p, q] : lags) rho(a) = rho_(p, q), beside(a++) = c(p, q);
  Eigen::MatrixXd out(n, n);
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b <= a; ++b) {
      const Shape h = lags[static_cast<std::size_t>(a)], g = lags[static_cast<std::size_t>(b)];
      out(a, b) = out(b, a) = c(h.nx - g.nx, h.ny - g.ny) + c(h.nx + g.nx, h.ny + g.ny) -
                              2 * rho(b) * beside(a) - 2 * rho(a) * beside(b) + 2 * rho(a) * rho(b) * square;
    }
  const Eigen::VectorXd scale = out.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * out * scale.asDiagonal();
}

}  // namespace asperity
