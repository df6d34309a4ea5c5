#include "acf/periodic.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {
namespace {

Index within(Index lag, Index period) { return ((lag % period) + period) % period; }

// The least lag from -reach on that is this one but for whole periods.
Index first(Index lag, Index reach, Index period) { return lag - (lag + reach) / period * period; }

PowerSpectrum spectrum_of(const Field& plane) {
  const RealTransform2D transform(shape_of(plane));
  PowerSpectrum out(size(transform.spectrum_size()));
  transform.forward(plane.data(), out.data());
  return out;
}

Field inverse(PowerSpectrum spectrum, Shape torus) {
  Field out(torus.nx, torus.ny);
  RealTransform2D(torus).inverse(spectrum.data(), out.data());
  return out;
}

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
  Field plane(torus.nx, torus.ny);
  plane.setZero();
  auto place = [&](Index p, Index q) -> double& { return plane(within(p, torus.nx), within(q, torus.ny)); };
  const Index middle = half_plane.cols() / 2;
  for (Index p = 0; p < half_plane.rows(); ++p)
    for (Index q = -middle; q <= middle; ++q) place(p, q) = place(-p, -q) = half_plane(p, middle + q);
  return kernel_of_power(spectrum_of(plane), torus);
}

Field kernel_of_power(PowerSpectrum power, Shape torus) {
  for (Complex& p : power) p = std::sqrt(std::max(p.real(), 0.0));
  const Field plane = inverse(std::move(power), torus);
  const double scale = 1 / std::sqrt(plane.square().sum());
  const Index middle_x = (torus.nx - 1) / 2, middle_y = (torus.ny - 1) / 2;
  return Field::NullaryExpr(torus.nx, torus.ny, [&](Index k, Index l) {
    return scale * plane(within(k - middle_x, torus.nx), within(l - middle_y, torus.ny));
  });
}

Field correlation_of_power(PowerSpectrum power, Shape torus) {
  const Field plane = inverse(std::move(power), torus);
  const Index middle = torus.ny / 2;
  return Field::NullaryExpr(torus.nx / 2 + 1, 2 * middle + 1, [&](Index p, Index column) {
    return plane(p, within(column - middle, torus.ny));
  });
}

Field periodic_autocorrelation(const Field& kernel) {
  PowerSpectrum power = spectrum_of(kernel);
  const double points = static_cast<double>(kernel.size());
  for (Complex& p : power) p = std::norm(p) / points;
  return correlation_of_power(std::move(power), shape_of(kernel));
}

}  // namespace asperity
