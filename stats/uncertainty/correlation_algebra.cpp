#include "stats/uncertainty/correlation_algebra.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "stats/uncertainty/lag_spectrum.hpp"
#include "transform/lag_sums.hpp"

namespace asperity {
namespace {

// A torus on which so many lags of these add up to no other.
Shape torus_for(const LagField& rho, Index lags, Index more) {
  return {fast_length(lags * rho.max_p() + more), fast_length(lags * rho.max_q() + more)};
}

// t on the whole torus.
Field cube_of(const LagField& rho, Shape torus) {
  const LagSpectrum spectrum(torus);
  return spectrum.function(spectrum.of(rho).cube());
}

}  // namespace

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

Eigen::ArrayXd CorrelationAlgebra::third_cumulants(const std::vector<CorrelatedLag>& lags) const {
  const LagField rho = tapered(rho_, pairs_);
  const Field cube = cube_of(rho, pairs_.grid().periodic.both() ? pairs_.grid().shape : torus_for(rho, 6, 2));
  return Eigen::ArrayXd::NullaryExpr(static_cast<Index>(lags.size()), [&](Index i) {
    const auto& [lag, r] = lags[static_cast<std::size_t>(i)];
    auto t = [&](Index k) {
      return cube(wrapped(k * lag.nx, cube.rows()), wrapped(k * lag.ny, cube.cols()));
    };
    return (3 * t(1) + t(3)) / 4 - 1.5 * r * (t(0) + t(2)) + 3 * r * r * t(1) - r * r * r * t(0);
  });
}

double CorrelationAlgebra::mean_of_triples() const {
  const LagField inside = rho_.within(longest_lags(pairs_.grid()));
  if (pairs_.grid().periodic.both()) return cube_of(inside, pairs_.grid().shape)(0, 0);
  const auto [nx, ny] = pairs_.grid().shape;
  auto part = [](Index lag, Index n) { return static_cast<double>(std::abs(lag)) / static_cast<double>(n); };
  const LagSpectrum spectrum(torus_for(inside, 3, 1));
  auto weighted = [&](auto weight) {
    return spectrum.of(LagField::of(
        inside.max_lag(), [&](Index p, Index q) { return inside(p, q) * weight(part(p, nx), part(q, ny)); }));
  };
  const Eigen::ArrayXd r = spectrum.of(inside), rx = weighted([](double x, double) { return x; }),
                       ry = weighted([](double, double y) { return y; }),
                       rxy = weighted([](double x, double y) { return x * y; });
  return spectrum.mean(r * r * (r - 1.5 * (rx + ry) + 0.75 * rxy) + 1.5 * rx * ry * r);
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
