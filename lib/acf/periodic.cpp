#include "acf/periodic.hpp"

#include <algorithm>
#include <cmath>

#include "transform/plan.hpp"

namespace asperity {
namespace {

Index within(Index lag, Index period) { return ((lag % period) + period) % period; }

// The least lag from -reach on that is this one but for whole periods.
Index first(Index lag, Index reach, Index period) { return lag - (lag + reach) / period * period; }

}  // namespace

Field periodic_sum(const Field& half_plane, Shape period) {
  const Index most_p = half_plane.rows() - 1, most_q = half_plane.cols() / 2;
  auto at = [&](Index p, Index q) { return p < 0 ? half_plane(-p, most_q - q) : half_plane(p, most_q + q); };
  const Index half_x = std::min(most_p, period.nx / 2), half_y = std::min(most_q, period.ny / 2);
  return Field::NullaryExpr(half_x + 1, 2 * half_y + 1, [&](Index row, Index column) {
    double sum = 0;
    for (Index p = first(row, most_p, period.nx); p <= most_p; p += period.nx)
      for (Index q = first(column - half_y, most_q, period.ny); q <= most_q; q += period.ny) sum += at(p, q);
    return sum;
  });
}

Field periodic_kernel(const Field& half_plane, Shape torus) {
  const RealTransform2D transform(torus);
  AlignedVector<double> field(size(torus.cells()));
  AlignedVector<Complex> spectrum(size(transform.spectrum_size()));
  const Eigen::Map<Field> plane(field.data(), torus.nx, torus.ny);
  auto place = [&](Index p, Index q) -> double& {
    return field[size(within(p, torus.nx) * torus.ny + within(q, torus.ny))];
  };
  const Index middle = half_plane.cols() / 2;
  for (Index p = 0; p < half_plane.rows(); ++p)
    for (Index q = -middle; q <= middle; ++q) place(p, q) = place(-p, -q) = half_plane(p, middle + q);
  transform.forward(field.data(), spectrum.data());
  for (Complex& s : spectrum) s = std::sqrt(std::max(s.real(), 0.0));
  transform.inverse(spectrum.data(), field.data());
  const double scale = 1 / std::sqrt(plane.square().sum());
  const Index middle_x = (torus.nx - 1) / 2, middle_y = (torus.ny - 1) / 2;
  return Field::NullaryExpr(torus.nx, torus.ny,
                            [&](Index k, Index l) { return scale * place(k - middle_x, l - middle_y); });
}

}  // namespace asperity
