#include "transform/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

struct Axis {
  Index points, factor;
  bool periodic;

  Index refined() const { return points * factor; }
  // Of the first refined point, in points from the first.
  double first() const { return (1 / static_cast<double>(factor) - 1) / 2; }
};

std::array<Axis, 2> axes_of(const Grid& grid, Shape factor) {
  return {Axis{grid.shape.nx, factor.nx, grid.periodic.x}, Axis{grid.shape.ny, factor.ny, grid.periodic.y}};
}

// ---- the form of degree 2 ----

// The first three polynomials that are orthogonal over equidistant points; u in points from their middle.
class Polynomials {
 public:
  explicit Polynomials(Index points) : middle_(static_cast<double>(points - 1) / 2) {
    const double n = static_cast<double>(points);
    variance_ = (n * n - 1) / 12;
    for (Index i = 0; i < points; ++i)
      for (int degree = 0; degree < 3; ++degree)
        squares_[degree] += std::pow(at(degree, static_cast<double>(i)), 2);
  }

  double at(int degree, double x) const {
    const double u = x - middle_;
    return degree == 0 ? 1 : degree == 1 ? u : u * u - variance_;
  }
  // Of the points' own sum of squares; of one or two points those of higher degrees vanish.
  double square(int degree) const { return squares_[degree]; }

 private:
  double middle_, variance_;
  std::array<double, 3> squares_{};
};

// Σ c(a,b) P_a(x) P_b(y), a + b ≤ 2, of least squares; of degree 0 along a period.
class Form {
 public:
  Form(const Field& z, const std::array<Axis, 2>& axes) : x_(z.rows()), y_(z.cols()) {
    for (int a = 0; a <= (axes[0].periodic ? 0 : 2); ++a)
      for (int b = 0; b <= (axes[1].periodic ? 0 : 2 - a); ++b) {
        const double norm = x_.square(a) * y_.square(b);
        if (norm > 0) terms_.push_back({a, b, projection(z, a, b) / norm});
      }
  }

  // Adds it `times` to a field of so many values a point.
  void add(Field& z, const std::array<Axis, 2>& axes, double times) const {
    for (const auto& [a, b, c] : terms_) {
      const Eigen::ArrayXd along_x = values(x_, a, z.rows(), axes[0]),
                           along_y = values(y_, b, z.cols(), axes[1]);
      for (Index i = 0; i < z.rows(); ++i) z.row(i) += (times * c * along_x(i)) * along_y.transpose();
    }
  }

 private:
  struct Term {
    int a, b;
    double coefficient;
  };

  static Eigen::ArrayXd values(const Polynomials& p, int degree, Index count, const Axis& axis) {
    return Eigen::ArrayXd::NullaryExpr(count, [&](Index m) {
      return p.at(degree, axis.first() + static_cast<double>(m) / static_cast<double>(axis.factor));
    });
  }
  double projection(const Field& z, int a, int b) const {
    const Eigen::ArrayXd along_y = values(y_, b, z.cols(), Axis{z.cols(), 1, false});
    double sum = 0;
    for (Index i = 0; i < z.rows(); ++i)
      sum += x_.at(a, static_cast<double>(i)) * (z.row(i).transpose() * along_y).sum();
    return sum;
  }

  Polynomials x_, y_;
  std::vector<Term> terms_;
};

// ---- the waves ----

// (2) of sequences, one at a time.
class AxisRefinement {
 public:
  explicit AxisRefinement(const Axis& axis)
      : axis_(axis),
        period_(axis.periodic ? axis.points : 2 * axis.points),
        coarse_({1, period_}),
        fine_({1, period_ * axis.factor}),
        given_(size(period_)),
        found_(size(period_ * axis.factor)),
        spectrum_(size(coarse_.spectrum_size())),
        padded_(size(fine_.spectrum_size())) {}

  double* given() { return given_.data(); }              // the sequence
  const double* found() const { return found_.data(); }  // and what apply() makes of it

  void apply() {
    if (!axis_.periodic)
      std::reverse_copy(given_.begin(), given_.begin() + axis_.points, given_.begin() + axis_.points);
    coarse_.forward(given_.data(), spectrum_.data());
    const double scale = 1 / static_cast<double>(period_);
    std::ranges::fill(padded_, 0);
    const double turn = 2 * std::numbers::pi * axis_.first() * scale;
    for (std::size_t k = 0; k < spectrum_.size(); ++k)
      padded_[k] = spectrum_[k] * std::polar(scale, turn * static_cast<double>(k));
    if (period_ % 2 == 0 && axis_.factor > 1) padded_[size(period_ / 2)] /= 2;  // it is there at -n/2 too
    fine_.inverse(padded_.data(), found_.data());
  }

 private:
  Axis axis_;
  Index period_;
  RealTransform2D coarse_, fine_;
  AlignedVector<double> given_, found_;
  AlignedVector<Complex> spectrum_, padded_;
};

Field refined_rows(const Field& z, const Axis& axis) {
  if (axis.factor == 1) return z;
  AxisRefinement refinement(axis);
  Field out(z.rows(), axis.refined());
  for (Index i = 0; i < z.rows(); ++i) {
    std::copy_n(&z(i, 0), z.cols(), refinement.given());
    refinement.apply();
    std::copy_n(refinement.found(), out.cols(), &out(i, 0));
  }
  return out;
}

// Eight columns at a time, which share their lines of the cache.
Field refined_columns(Field z, const Axis& axis) {
  if (axis.factor == 1) return z;
  constexpr Index together = 8;
  AxisRefinement refinement(axis);
  Field out(axis.refined(), z.cols());
  for (Index first = 0; first < z.cols(); first += together) {
    const Index count = std::min(together, z.cols() - first);
    const Field columns = z.middleCols(first, count).transpose();
    Field found(count, out.rows());
    for (Index c = 0; c < count; ++c) {
      std::copy_n(&columns(c, 0), columns.cols(), refinement.given());
      refinement.apply();
      std::copy_n(refinement.found(), found.cols(), &found(c, 0));
    }
    out.middleCols(first, count) = found.transpose();
  }
  return out;
}

void check(Shape factor) {
  check_parameter(factor.nx >= 1 && factor.ny >= 1, "refine", text(factor) + ": at least 1x1");
}

}  // namespace

Grid refined_grid(const Grid& grid, Shape factor) {
  check(factor);
  const auto [x, y] = axes_of(grid, factor);
  Grid out = grid;
  out.shape = {x.refined(), y.refined()};
  out.dx /= static_cast<double>(factor.nx), out.dy /= static_cast<double>(factor.ny);
  return out;
}

double refinement_memory(const Grid& grid, Shape factor) {
  const Shape fine = refined_grid(grid, factor).shape;
  const double nx = static_cast<double>(grid.shape.nx), mx = static_cast<double>(fine.nx),
               my = static_cast<double>(fine.ny);
  return sizeof(double) *
         (mx * my + nx * my + nx * static_cast<double>(grid.shape.ny) + 8 * (mx + nx) + 12 * (mx + my));
}

Field refined(const Field& field, const Grid& grid, Shape factor) {
  check(factor);
  if (!field.allFinite()) throw DataError("heights", "a point is missing or not finite: fill it first");
  const std::array<Axis, 2> axes = axes_of(grid, factor);
  const Form form(field, axes);
  Field out = field;
  form.add(out, {Axis{field.rows(), 1, false}, Axis{field.cols(), 1, false}}, -1);
  out = refined_columns(refined_rows(out, axes[1]), axes[0]);
  form.add(out, axes, 1);
  return out;
}

}  // namespace asperity
