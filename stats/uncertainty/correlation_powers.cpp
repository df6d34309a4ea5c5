#include "stats/uncertainty/correlation_powers.hpp"

#include <cmath>
#include <cstdlib>

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

// Of a ρ with weights that are even, so that the spectrum is real.
Eigen::ArrayXd spectrum_of(const LagField& rho, const RealTransform2D& transform, Shape torus,
                           const auto& weight) {
  AlignedVector<Complex> values(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(unfolded(rho, torus, weight).data(), values.data());
  return Eigen::Map<const Eigen::ArrayXcd>(values.data(), static_cast<Index>(values.size())).real();
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

CorrelationPowers::CorrelationPowers(const LagField& all, const Grid& grid) {
  const LagField rho = grid.periodic ? all.within({grid.shape.nx / 2, grid.shape.ny / 2}) : all;
  const Shape torus = torus_for(rho, grid);
  const RealTransform2D transform(torus);
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(unfolded(rho, torus, one).data(), spectrum.data());
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

double mean_of_triples(const LagField& rho, const Grid& grid) {
  if (grid.periodic) return CorrelationPowers(rho, grid).third(0, 0);
  const auto [nx, ny] = grid.shape;
  const LagField inside = rho.within({nx - 1, ny - 1});
  const Shape torus = torus_of_triples(inside);
  const RealTransform2D transform(torus);
  auto spectrum = [&](const auto& weight) { return spectrum_of(inside, transform, torus, weight); };
  auto share = [](Index lag, Index n) { return static_cast<double>(std::abs(lag)) / static_cast<double>(n); };
  const Eigen::ArrayXd r = spectrum(one), rx = spectrum([&](Index p, Index) { return share(p, nx); }),
                       ry = spectrum([&](Index, Index q) { return share(q, ny); }),
                       rxy = spectrum([&](Index p, Index q) { return share(p, nx) * share(q, ny); });
  const Eigen::ArrayXd terms = r * r * (r - 1.5 * (rx + ry) + 0.75 * rxy) + 1.5 * rx * ry * r;
  return (multiplicities(transform, torus) * terms).sum() / static_cast<double>(torus.cells());
}

}  // namespace asperity
