/// Gaussian regression of order 2: about each point the quadratic that fits best.
///
///     min Σ_k s(x_k - x) δ_k (z_k - P(x_k - x))²  over P of total degree 2,   w(x) = P(0),            (1)
///     s(x,y) ∝ exp(-π (x² + y²) / (γ λ_c)²),   γ = √(u/π) = 0.7309,   (1 + u) e^{-u} = 1/2,           (2)
/// δ a weight of each point, 0 where it is missing. Quadratic surfaces stay as they are, edges and holes
/// included. Where δ = 1, far from an edge, a wave of length λ passes by (1 + v) e^{-v}, v = u (λ_c/λ)²: half
/// of it at the cut-off λ_c. With the weight of order 0 (stats/filter/gaussian_filter.hpp) it would be 0.85.
/// With u = (x_k - x)/γλ_c the coefficients of P solve
///     Σ_cd M_{a+c,b+d} p_cd = N_ab,   M_ab = Σ s δ u^a v^b,   N_ab = Σ s δ z u^a v^b:                  (3)
/// 15 moments of δ, 6 of δz. Terms that the points under the weight do not tell, such as those across a
/// profile, are left out.
///
/// Accuracy  The weight is cut at 1.6 λ_c, where it is 3e-7. Round-off of the sums is some 1e-15 of the
///           largest value; where the points determine w to less than a millionth of their weight, it keeps
///           its former value.
/// Cost      39 transforms in one dimension of each row or column, and one equation of six unknowns a point:
///           0.3 s for 1024². Memory: eight fields.
///
/// ISO 16610-31:2016; ISO 16610-71:2014. W. Zeng, X. Jiang, P. J. Scott, S. Xiao, L. Blunt,
/// Proc. 9th int. conf. euspen (2009) 356-359.
#pragma once

#include <array>

#include "core/field.hpp"
#include "transform/rows.hpp"

namespace asperity {

/// Σ_k s(x_k - x) u^a f_k about each point of an axis, a = 0 … 4, of eight rows at a time.
class AxisMoments {
 public:
  static constexpr Index rows = RowTransform::rows;
  static constexpr int highest = 4;

  AxisMoments(Index points, double step, bool periodic, double width);

  struct Work {
    RowTransform::Work transform;
    AlignedVector<Complex> modes, product;
  };
  Work work() const;
  Index points() const { return points_; }

  /// Of `count` rows of points, `apart`: out(a), a ≤ degree, is where moment a goes, rows points() apart.
  template <class Out>
  void operator()(const double* in, Index apart, Index count, int degree, Work& work, Out out) const {
    transform_.forward(in, apart, points_, count, work.modes.data(), block, work.transform);
    for (int a = 0; a <= degree; ++a) {
      multiply(a, count, work);
      transform_.inverse(work.product.data(), block, count, points_, out(a), points_, work.transform);
    }
  }

 private:
  static constexpr Index block = RowTransform::rows * RowTransform::width;
  void multiply(int a, Index count, Work& work) const;

  Index points_;
  RowTransform transform_;
  AlignedVector<Complex> symbols_;  ///< in the blocks of the transform, a row a power
};

class LocalQuadratic {
 public:
  /// Throws ParameterError("cut-off") as the Gaussian filter.
  LocalQuadratic(const Grid& grid, double cutoff, int threads = 1);

  /// w of (1); `former` where the points do not determine it. No field has missing points.
  Field operator()(const Field& z, const Field& delta, const Field& former) const;

 private:
  using Moments = std::array<Field, AxisMoments::highest + 1>;
  Moments along_x(const Field& values, int degree) const;

  AxisMoments x_, y_;
  int threads_;
};

}  // namespace asperity
