#include "stats/filter/local_quadratic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "math/linear_algebra.hpp"
#include "stats/filter/gaussian_filter.hpp"

namespace asperity {
namespace {

constexpr double least_pivot = 1e-8;
constexpr Index highest = 4;  // powers of (2): up to 4 of M, up to 2 of N

struct Power {
  Index a, b;
};
constexpr std::array<Power, 6> terms{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

// s(u) u^a of the points -r … r away along an axis, a row a power.
struct AxisPowers {
  Index n, reach;
  bool periodic;
  Field weights;

  AxisPowers(Index points, double step, bool repeats, double cutoff) : n(points), periodic(repeats) {
    reach = static_cast<Index>(std::ceil(gaussian_reach * cutoff / step));
    if (!periodic) reach = std::min(reach, n - 1);
    weights = Field::NullaryExpr(highest + 1, 2 * reach + 1, [&](Index a, Index k) {
      const double u = static_cast<double>(k - reach) * step / cutoff;
      return std::exp(-std::numbers::pi * std::numbers::pi / std::numbers::ln2 * u * u) *
             std::pow(u, static_cast<double>(a));
    });
  }
  // The point k away from i; beyond a free end none.
  bool holds(Index i) const { return periodic || (i >= 0 && i < n); }
  Index at(Index i) const { return ((i % n) + n) % n; }
};

// What one thread needs for a row of points.
class RowRegression {
 public:
  RowRegression(const AxisPowers& x, const AxisPowers& y)
      : x_(x), y_(y), along_x_(highest + 1, y.n + 2 * y.reach), of_m_(15, y.n), of_n_(6, y.n) {}

  // The moments of row i, then (2) of each of its points.
  void row(Index i, const Field& weighted, const Field& delta, const Field& former, Field& out) {
    moments(i, delta, highest, of_m_);
    moments(i, weighted, 2, of_n_);
    for (Index j = 0; j < y_.n; ++j) out(i, j) = constant_term(j, former(i, j));
  }

 private:
  // M_ab and N_ab by total degree: 00, 10, 01, 20, 11, 02, 30, …
  static Index place(Index a, Index b) { return (a + b) * (a + b + 1) / 2 + b; }

  void moments(Index i, const Field& values, Index degree, Field& out) {
    along_x_.setZero();
    for (Index k = -x_.reach; k <= x_.reach; ++k)
      if (x_.holds(i + k))
        for (Index a = 0; a <= degree; ++a)
          along_x_.row(a).segment(y_.reach, y_.n) += x_.weights(a, k + x_.reach) * values.row(x_.at(i + k));
    if (y_.periodic) repeat();
    out.setZero();
    for (Index a = 0; a <= degree; ++a)
      for (Index b = 0; a + b <= degree; ++b)
        for (Index k = 0; k <= 2 * y_.reach; ++k)
          out.row(place(a, b)) += y_.weights(b, k) * along_x_.row(a).segment(k, y_.n);
  }
  void repeat() {
    for (Index k = 0; k < y_.reach; ++k) {
      along_x_.col(y_.reach - 1 - k) = along_x_.col(y_.reach + y_.at(-1 - k));
      along_x_.col(y_.reach + y_.n + k) = along_x_.col(y_.reach + y_.at(k));
    }
  }
  double constant_term(Index j, double former) const {
    Eigen::MatrixXd matrix(6, 6);
    Eigen::VectorXd right(6);
    for (Index s = 0; s < 6; ++s) {
      const auto [a, b] = terms[size(s)];
      right[s] = of_n_(place(a, b), j);
      for (Index t = 0; t < 6; ++t)
        matrix(s, t) = of_m_(place(a + terms[size(t)].a, b + terms[size(t)].b), j);
    }
    const auto p = solve_positive(matrix, right, least_pivot);
    return p ? (*p)[0] : former;
  }

  const AxisPowers &x_, &y_;
  Field along_x_, of_m_, of_n_;
};

}  // namespace

Field local_quadratic(const Field& z, const Field& delta, const Field& former, const Grid& grid,
                      double cutoff, int threads) {
  const AxisPowers x(grid.shape.nx, grid.dx, grid.periodic.x, cutoff),
      y(grid.shape.ny, grid.dy, grid.periodic.y, cutoff);
  const Field weighted = z * delta;
  Field out(z.rows(), z.cols());
  parallel_ranges(z.rows(), threads, [&](Index begin, Index end, int) {
    RowRegression regression(x, y);
    for (Index i = begin; i < end; ++i) regression.row(i, weighted, delta, former, out);
  });
  return out;
}

}  // namespace asperity
