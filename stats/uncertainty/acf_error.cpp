#include "stats/uncertainty/acf_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "transform/lag_sums.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

Index wrapped(Index lag, Index period) { return (lag % period + period) % period; }

Shape torus_for(const LagField& rho, const Grid& grid) {
  if (grid.periodic) return grid.shape;
  return {fast_length(6 * rho.max_p() + 2), fast_length(6 * rho.max_q() + 2)};
}

// Three lags of these add up to none other than zero.
Shape torus_of_triples(const LagField& rho) {
  return {fast_length(3 * rho.max_p() + 1), fast_length(3 * rho.max_q() + 1)};
}

// At half a period, where p and -p are one, a table may hold either or both: it is the same value.
AlignedVector<double> unfolded(const LagField& rho, Shape torus, const auto& weight) {
  AlignedVector<double> out(static_cast<std::size_t>(torus.cells()), 0);
  for (Index p = -rho.max_p(); p <= rho.max_p(); ++p)
    for (Index q = -rho.max_q(); q <= rho.max_q(); ++q)
      out[static_cast<std::size_t>(wrapped(p, torus.nx) * torus.ny + wrapped(q, torus.ny))] =
          rho(p, q) * weight(p, q);
  return out;
}

double one(Index, Index) { return 1; }

AlignedVector<Complex> spectrum_of(const LagField& rho, const RealTransform2D& transform, Shape torus,
                                   const auto& weight) {
  AlignedVector<Complex> values(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(unfolded(rho, torus, weight).data(), values.data());
  return values;
}

// How often a wave number of the half spectrum is one of the whole.
Eigen::ArrayXd multiplicities(const RealTransform2D& transform, Shape torus) {
  const Index columns = transform.spectrum_columns();
  return Eigen::ArrayXd::NullaryExpr(transform.spectrum_size(), [=](Index place) {
    const Index l = place % columns;
    return l == 0 || 2 * l == torus.ny ? 1.0 : 2.0;
  });
}

}  // namespace

double bartlett_covariance(const Convolution& c, const CorrelatedLag& h, const CorrelatedLag& g) {
  const auto [p, q] = h.lag;
  const auto [k, l] = g.lag;
  return c(p - k, q - l) + c(p + k, q + l) - 2 * g.rho * c(p, q) - 2 * h.rho * c(k, l) +
         2 * h.rho * g.rho * c(0, 0);
}

Eigen::MatrixXd bartlett_correlation(const Convolution& c, const std::vector<CorrelatedLag>& lags) {
  const auto n = static_cast<Index>(lags.size());
  Eigen::MatrixXd out(n, n);
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b <= a; ++b)
      out(a, b) = out(b, a) =
          bartlett_covariance(c, lags[static_cast<std::size_t>(a)], lags[static_cast<std::size_t>(b)]);
  const Eigen::VectorXd scale = out.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * out * scale.asDiagonal();
}

CorrelationPowers::CorrelationPowers(const LagField& all, const Grid& grid) {
  const LagField rho = grid.periodic ? all.within({grid.shape.nx / 2, grid.shape.ny / 2}) : all;
  const Shape torus = torus_for(rho, grid);
  const RealTransform2D transform(torus);
  const AlignedVector<Complex> spectrum = spectrum_of(rho, transform, torus, one);
  auto power = [&](int exponent) {
    AlignedVector<Complex> values = spectrum;
    for (Complex& s : values) s = exponent == 2 ? s * s : s * s * s;
    AlignedVector<double> out(static_cast<std::size_t>(torus.cells()));
    transform.inverse(values.data(), out.data());
    return Field(Eigen::Map<const Field>(out.data(), torus.nx, torus.ny) /
                 static_cast<double>(torus.cells()));
  };
  second_ = power(2);
  third_ = power(3);
}

double CorrelationPowers::at(const Field& table, Index p, Index q) {
  return table(wrapped(p, table.rows()), wrapped(q, table.cols()));
}

double CorrelationPowers::third_cumulant(const CorrelatedLag& h) const {
  const double rho = h.rho;
  auto t = [&](Index k) { return third(k * h.lag.nx, k * h.lag.ny); };
  return (3 * t(1) + t(3)) / 4 - 1.5 * rho * (t(0) + t(2)) + 3 * rho * rho * t(1) - rho * rho * rho * t(0);
}

double mean_of_triples(const LagField& rho, const Grid& grid) {
  if (grid.periodic) return CorrelationPowers(rho, grid).third(0, 0);
  const auto [nx, ny] = grid.shape;
  const LagField inside = rho.within({nx - 1, ny - 1});
  const Shape torus = torus_of_triples(inside);
  const RealTransform2D transform(torus);
  // ρ and its weights are even: their spectra are real.
  auto spectrum = [&](const auto& weight) -> Eigen::ArrayXd {
    const AlignedVector<Complex> values = spectrum_of(inside, transform, torus, weight);
    return Eigen::Map<const Eigen::ArrayXcd>(values.data(), static_cast<Index>(values.size())).real();
  };
  auto part = [](Index lag, Index n) { return static_cast<double>(std::abs(lag)) / static_cast<double>(n); };
  const Eigen::ArrayXd r = spectrum(one), rx = spectrum([&](Index p, Index) { return part(p, nx); }),
                       ry = spectrum([&](Index, Index q) { return part(q, ny); }),
                       rxy = spectrum([&](Index p, Index q) { return part(p, nx) * part(q, ny); });
  const Eigen::ArrayXd terms = r * r * (r - 1.5 * (rx + ry) + 0.75 * rxy) + 1.5 * rx * ry * r;
  return (multiplicities(transform, torus) * terms).sum() / static_cast<double>(torus.cells());
}

AcfError::AcfError(const LagField& correlation, const Pairs& pairs)
    : rho_(correlation.normalised()), pairs_(pairs) {
  for (Index p = -rho_.max_p(); p <= rho_.max_p(); ++p)
    for (Index q = -rho_.max_q(); q <= rho_.max_q(); ++q)
      if (const double rho = rho_(p, q); rho != 0) support_.push_back({{p, q}, rho});
}

double AcfError::pairs(Index p, Index q) const { return pairs_.pair_fraction(p, q) * pairs_.points(); }

double AcfError::weight(Index p, Index q, Index k, Index l) const {
  const double there = pairs_.density(k, l);
  if (pairs_.grid().periodic) return there;
  auto overlapping = [](Index n, Index distance) {
    return std::max(0.0, 1 - static_cast<double>(std::abs(distance)) / static_cast<double>(n));
  };
  const auto [nx, ny] = pairs_.grid().shape;
  return there * overlapping(nx - std::abs(p), k) * overlapping(ny - std::abs(q), l);
}

// The second product of (1) is summed over m = k + h, where ρ(m) ≠ 0.
double AcfError::absolute(Index p, Index q) const {
  double sum = 0;
  for (const auto& [lag, rho] : support_) {
    const auto [k, l] = lag;
    sum += weight(p, q, k, l) * rho * rho + weight(p, q, k - p, l - q) * rho * rho_(k - 2 * p, l - 2 * q);
  }
  return std::sqrt(std::max(sum, 0.0) / pairs(p, q));
}

double AcfError::normalised(Index p, Index q) const {
  if (p == 0 && q == 0) return 0;
  const double at_lag = rho_(p, q);
  double sum = 0;
  for (const auto& [lag, rho] : support_) {
    const auto [k, l] = lag;
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
  for (const auto& [lag, rho] : support_)
    plane(reach.nx + lag.nx, reach.ny + lag.ny) = rho * std::sqrt(weight(0, 0, lag.nx, lag.ny));
  const Shape lags{std::min(max_lag.nx, 2 * reach.nx), std::min(max_lag.ny, 2 * reach.ny)};
  return LagField(lag_sums(plane, {{plane.rows(), plane.cols()}, 1, 1, false}, lags));
}

LagField AcfError::normalised(Shape max_lag) const {
  const LagField c = convolution({2 * max_lag.nx, 2 * max_lag.ny});
  const double square = c(0, 0);
  return LagField::of(max_lag, [&](Index p, Index q) {
    if (p == 0 && q == 0) return 0.0;
    const double rho = rho_(p, q), sum = square * (1 + 2 * rho * rho) - 4 * rho * c(p, q) + c(2 * p, 2 * q);
    return std::sqrt(std::max(sum, 0.0) / pairs(p, q));
  });
}

Eigen::MatrixXd AcfError::correlation(const std::vector<Shape>& lags) const {
  Shape farthest{0, 0};
  std::vector<CorrelatedLag> values;
  for (const auto& [p, q] : lags) {
    farthest = {std::max(farthest.nx, std::abs(p)), std::max(farthest.ny, std::abs(q))};
    values.push_back({{p, q}, rho_(p, q)});
  }
  return bartlett_correlation(convolution({2 * farthest.nx, 2 * farthest.ny}), values);
}

}  // namespace asperity
