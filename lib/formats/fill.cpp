#include "formats/fill.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <Eigen/SparseCholesky>

#include "core/error.hpp"

namespace asperity {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// (1) of the missing points, numbered in the order of the field.
class Membrane {
 public:
  Membrane(const Field& z, const Grid& grid)
      : z_(z),
        weights_{1 / (grid.dx * grid.dx), 1 / (grid.dy * grid.dy)},
        number_(static_cast<std::size_t>(z.size()), -1) {
    for (Index k = 0; k < z.size(); ++k)
      if (std::isnan(z(k))) number_[static_cast<std::size_t>(k)] = count_++;
  }

  Index count() const { return count_; }
  Eigen::VectorXd solve() const {
    std::vector<Eigen::Triplet<double>> terms;
    Eigen::VectorXd known = Eigen::VectorXd::Zero(count_);
    for (Index i = 0; i < z_.rows(); ++i)
      for (Index j = 0; j < z_.cols(); ++j)
        if (const Index row = number(i, j); row >= 0) add_row(i, j, row, terms, known);
    Matrix matrix(count_, count_);
    matrix.setFromTriplets(terms.begin(), terms.end());
    return Eigen::SimplicialLDLT<Matrix>(matrix).solve(known);
  }

 private:
  Index number(Index i, Index j) const { return number_[static_cast<std::size_t>(i * z_.cols() + j)]; }
  void add_row(Index i, Index j, Index row, std::vector<Eigen::Triplet<double>>& terms,
               Eigen::VectorXd& known) const {
    constexpr std::array<std::array<Index, 2>, 4> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    double sum = 0;
    for (const auto& [di, dj] : steps) {
      const Index p = i + di, q = j + dj;
      if (p < 0 || q < 0 || p >= z_.rows() || q >= z_.cols()) continue;
      const double weight = weights_[di == 0];
      sum += weight;
      if (const Index column = number(p, q); column >= 0)
        terms.emplace_back(row, column, -weight);
      else
        known(row) += weight * z_(p, q);
    }
    terms.emplace_back(row, row, sum);
  }

  const Field& z_;
  std::array<double, 2> weights_;
  std::vector<Index> number_;
  Index count_ = 0;
};

}  // namespace

Field filled(Field z, const Grid& grid, Filling filling) {
  if (!z.hasNaN()) return z;
  const Field there = z.isNaN().select(0, z);
  const auto points = static_cast<double>((!z.isNaN()).count());
  if (points == 0) throw DataError("heights", "every point is missing");
  if (filling == Filling::laplace) {
    const Eigen::VectorXd values = Membrane(z, grid).solve();
    for (Index k = 0, next = 0; k < z.size(); ++k)
      if (std::isnan(z(k))) z(k) = values(next++);
    return z;
  }
  const double value =
      filling == Filling::mean ? there.sum() / points : z.minCoeff<Eigen::PropagateNumbers>();
  return z.isNaN().select(value, z);
}

}  // namespace asperity
