/// The scenes of the contact tests.
#pragma once

#include <limits>
#include <numbers>

#include "contact/bodies.hpp"
#include "contact/influence.hpp"
#include "contact/solver.hpp"
#include "core/error.hpp"
#include "support.hpp"

namespace asperity::test {

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two steel spheres: p₀ = 2724.3224 MPa, a = 0.9361090 mm, δ = 35.052006 µm under 5000 N.
inline const Bodies spheres{.radius = {50e-3, 50e-3}};
inline constexpr double load = 5000;
/// A limit pressure between Hertz's and that of rough peaks [Pa].
inline constexpr double limit = 3.6e9;
inline const double modulus = spheres.composite_modulus();

inline Grid square(Index n, double side = 3e-3) {
  return {{n, n}, side / static_cast<double>(n), side / static_cast<double>(n)};
}

inline Grid periodic(Grid grid) {
  grid.periodic = true;
  return grid;
}

/// Forty random waves of 1 to 16 periods a side, amplitudes falling as 1/k; unit rms, periodic.
inline Field random_waves(Shape shape, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_int_distribution<int> periods(-16, 16);
  std::uniform_real_distribution<double> phase(0, 2 * pi);
  Field z = Field::Zero(shape.nx, shape.ny);
  for (int wave = 0; wave < 40; ++wave) {
    const double kx = periods(generator), ky = periods(generator), phi = phase(generator);
    for (Index i = 0; i < shape.nx; ++i)
      for (Index j = 0; j < shape.ny; ++j)
        z(i, j) += std::cos(2 * pi *
                                (kx * static_cast<double>(i) / static_cast<double>(shape.nx) +
                                 ky * static_cast<double>(j) / static_cast<double>(shape.ny)) +
                            phi) /
                   (1 + std::hypot(kx, ky));
  }
  z -= z.mean();
  return z / std::sqrt(z.square().mean());
}

/// Gaussian heights that decay exponentially along both axes, by 1/e in so many cells: new asperities on every
/// finer grid. Unit rms.
inline Field exponential_heights(Shape shape, double length, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  const double a = std::exp(-1 / length), b = std::sqrt(1 - a * a);
  Field z = Field::NullaryExpr(shape.nx, shape.ny, [&](Index, Index) { return normal(generator); });
  for (Index i = 1; i < shape.nx; ++i) z.row(i) = a * z.row(i - 1) + b * z.row(i);
  for (Index j = 1; j < shape.ny; ++j) z.col(j) = a * z.col(j - 1) + b * z.col(j);
  return z;
}

/// "name: words" of what refuses a call, or nothing.
template <class Call>
std::string refusal(Call call) try {
  call();
  return "";
} catch (const ParameterError& error) {
  return error.name + ": " + error.what();
}

inline Contact press(const Grid& grid, const Field& gap, ContactParameters parameters = {}) {
  if (parameters.load == 0) parameters.load = load;
  parameters.tolerance = std::min(parameters.tolerance, 1e-8);
  return solve_contact(grid, gap, modulus, parameters);
}

/// The spheres with 0.4 µm of roughness, whose highest peaks meet about three times Hertz's pressure.
inline Field rough_gap(const Grid& grid, unsigned seed = 7) {
  return undeformed_gap(grid, spheres) - 0.4e-6 * random_waves(grid.shape, seed);
}

}  // namespace asperity::test
