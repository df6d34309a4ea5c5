#include "stats/filter/fill.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <Eigen/SparseCholesky>

#include "core/error.hpp"

namespace asperity {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Across the seam of a periodic axis; -1 beyond the edge of another.
Index place(Index k, Index n, bool periodic) {
  if (k >= 0 && k < n) return k;
  return periodic ? (k + n) % n : -1;
}

// Solves (1) for the missing points, in the order of the field.
Eigen::VectorXd membrane(const Field& z, const Grid& grid) {
  constexpr std::array<std::array<Index, 2>, 4> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const std::array<double, 2> weights{1 / (grid.dx * grid.dx), 1 / (grid.dy * grid.dy)};
  Eigen::Array<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> number(z.rows(), z.cols());
  Index count = 0;
  for (Index k = 0; k < z.size(); ++k) number(k) = std::isnan(z(k)) ? count++ : -1;
  std::vector<Eigen::Triplet<double>> terms;
  Eigen::VectorXd known = Eigen::VectorXd::Zero(count);
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      const Index row = number(i, j);
      if (row < 0) continue;
      double sum = 0;
      for (const auto& [di, dj] : steps) {
        const Index p = place(i + di, z.rows(), grid.periodic.x),
                    q = place(j + dj, z.cols(), grid.periodic.y);
        if (p < 0 || q < 0) continue;
        const double weight = weights[di == 0];
        sum += weight;
        if (number(p, q) >= 0)
          terms.emplace_back(row, number(p, q), -weight);
        else
          known(row) += weight * z(p, q);
      }
      terms.emplace_back(row, row, sum);
    }
  Matrix matrix(count, count);
  matrix.setFromTriplets(terms.begin(), terms.end());
  return Eigen::SimplicialLDLT<Matrix>(matrix).solve(known);
}

}  // namespace

Field filled(Field z, const Grid& grid, Filling filling) {
  if (!z.hasNaN()) return z;
  const Field there = z.isNaN().select(0, z);
  const auto points = static_cast<double>((!z.isNaN()).count());
  if (points == 0) throw DataError("heights", "all points are missing");
  if (filling == Filling::laplace) {
    const Eigen::VectorXd values = membrane(z, grid);
    for (Index k = 0, next = 0; k < z.size(); ++k)
      if (std::isnan(z(k))) z(k) = values(next++);
    return z;
  }
  const double value =
      filling == Filling::mean ? there.sum() / points : z.minCoeff<Eigen::PropagateNumbers>();
  return z.isNaN().select(value, z);
}

}  // namespace asperity
