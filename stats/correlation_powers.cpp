#include "stats/correlation_powers.hpp"

#include "transform/plan.hpp"

namespace asperity {
namespace {

Index wrapped(Index lag, Index period) { return (lag % period + period) % period; }

Shape torus_for(const LagField& rho, const Grid& grid) {
  if (grid.periodic) return grid.shape;
  return {fast_length(6 * rho.max_p() + 2), fast_length(6 * rho.max_q() + 2)};
}

// At half a period, where p and -p are one, a table may hold either or both: it is the same value.
AlignedVector<double> unfolded(const LagField& rho, Shape torus) {
  AlignedVector<double> out(static_cast<std::size_t>(torus.cells()), 0);
  for (Index p = -rho.max_p(); p <= rho.max_p(); ++p)
    for (Index q = -rho.max_q(); q <= rho.max_q(); ++q)
      out[static_cast<std::size_t>(wrapped(p, torus.nx) * torus.ny + wrapped(q, torus.ny))] = rho(p, q);
  return out;
}

}  // namespace

CorrelationPowers::CorrelationPowers(const LagField& rho, const Grid& grid) {
  const Shape torus = torus_for(rho, grid);
  const RealTransform2D transform(torus);
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(unfolded(rho, torus).data(), spectrum.data());
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

}  // namespace asperity
