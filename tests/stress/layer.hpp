/// A whole layer as fields, and the grids of the tests.
#pragma once

#include "reference/hertz_stress.hpp"
#include "stress/equivalent.hpp"
#include "stress/layers.hpp"

namespace asperity::test {

using TensorField = std::array<Field, 6>;

/// The layer at depth z; components that were not asked for stay empty.
inline TensorField layer(const StressSolver& solver, double z, stress::Set asked = stress::all) {
  const Shape shape = solver.shape();
  TensorField out;
  for (auto c : stress::components)
    if (asked[c]) out[c].resize(shape.nx, shape.ny);
  StressSolver::Workspace work;
  solver.layer(z, asked, work, [&](Index i, const StressRow& row) {
    for (auto c : stress::components)
      if (asked[c]) std::ranges::copy(row[c], out[c].row(i).data());
  });
  return out;
}

inline stress::Tensor tensor_at(const TensorField& field, Index i, Index j) {
  stress::Tensor s;
  for (auto c : stress::components) s[c] = field[c](i, j);
  return s;
}

inline double difference(const TensorField& a, const TensorField& b) {
  double top = 0;
  for (auto c : stress::components) top = std::max(top, (a[c] - b[c]).abs().maxCoeff());
  return top;
}

/// ∂²/∂x² + ∂²/∂y² of the stress of a Hertz contact.
inline stress::Tensor hertz_laplacian(double x, double y, double z, double nu,
                                      const Friction& friction = {}) {
  constexpr double h = 2e-3;
  stress::Tensor sum{};
  const stress::Tensor centre = hertz_stress(x, y, z, nu, friction);
  for (auto [dx, dy] : {std::pair{h, 0.0}, std::pair{-h, 0.0}, std::pair{0.0, h}, std::pair{0.0, -h}}) {
    const stress::Tensor s = hertz_stress(x + dx, y + dy, z, nu, friction);
    for (auto c : stress::components) sum[c] += (s[c] - centre[c]) / (h * h);
  }
  return sum;
}

/// The field moved by so many cells towards the origin, what passes the edge coming in at the other.
inline Field shifted(const Field& f, Index by_x, Index by_y) {
  return Field::NullaryExpr(
      f.rows(), f.cols(), [&](Index i, Index j) { return f((i + by_x) % f.rows(), (j + by_y) % f.cols()); });
}

/// A square of side 3 around the unit contact, n × n cells.
inline Grid hertz_grid(Index n) {
  return {{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)};
}

}  // namespace asperity::test
