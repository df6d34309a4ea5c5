#include "stats/filter/form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "math/linear_algebra.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

constexpr double least_pivot = 1e-10;  // of (3), of the largest: three passes then reach round-off

double first_valid(const Field& z) {
  for (const double height : z.reshaped<Eigen::RowMajor>())
    if (!std::isnan(height)) return height;
  throw DataError("heights", "every point is missing");
}

// The mean of the rows' means; NaN where a height is missing.
double mean_of_rows(const Eigen::ArrayXd& means) {
  return std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
}

Mean mean_of_valid(const Field& z) {
  const double base = first_valid(z);
  ValidSum total;
  for (Index i = 0; i < z.rows(); ++i) {
    const ValidSum row = sum_of_valid(z.row(i) - base);
    total.sum += row.sum;
    total.count += row.count;
  }
  return {base, total.sum / total.count};
}

// What is left of c.
Eigen::VectorXd step_of(const AxisProducts& products, const Field& heights, const Eigen::MatrixXd& gram,
                        int degree) {
  const auto solution = solve_positive(gram, products.sums(zero_filled(heights)), least_pivot);
  if (!solution)
    throw ParameterError("remove-form", "'" + std::to_string(degree) +
                                            "' is too high a degree for the points that are not missing");
  return *solution;
}

}  // namespace

// xP_{a-1} without what the columns before it hold, twice for the last digits.
Eigen::MatrixXd gram_polynomials(Index n, int degree) {
  const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(n, -1, 1);
  Eigen::MatrixXd p(n, std::min<Index>(degree + 1, n));
  p.col(0).setConstant(1 / std::sqrt(static_cast<double>(n)));
  for (Index a = 1; a < p.cols(); ++a) {
    Eigen::VectorXd next = x * p.col(a - 1).array();
    for (int pass = 0; pass < 2; ++pass) next -= p.leftCols(a) * (p.leftCols(a).transpose() * next).eval();
    p.col(a) = next.normalized();
  }
  return p;
}

Mean mean_above_base(const Field& z) {
  const double base = first_valid(z), above = mean_of_rows((z - base).rowwise().mean());
  return std::isnan(above) ? mean_of_valid(z) : Mean{base, above};
}

AxisProducts polynomials(Shape field, int degree) {
  Eigen::MatrixXd along_x = gram_polynomials(field.nx, degree), along_y = gram_polynomials(field.ny, degree);
  std::vector<AxisProducts::Term> terms;
  for (Index a = 0; a < along_x.cols(); ++a)
    for (Index b = 0; b < along_y.cols() && a + b <= degree; ++b) terms.push_back({a, b});
  return {std::move(along_x), std::move(along_y), std::move(terms)};
}

Field remove_form(Field heights, int degree) {
  if (degree < 0 || degree > largest_form_degree)
    throw ParameterError("remove-form", "'" + std::to_string(degree) + "' is not a degree from 0 to " +
                                            std::to_string(largest_form_degree));
  heights -= first_valid(heights);
  const double level = mean_of_rows(heights.rowwise().mean());
  heights -= std::isnan(level) ? mean_of_valid(heights).value() : level;
  if (degree == 0) return heights;
  const AxisProducts products = polynomials(shape_of(heights), degree);
  const bool missing = has_missing(heights);
  Eigen::MatrixXd gram = products.none();  // (3)
  if (missing) products.add(gram, validity(heights));
  for (int pass = 0; pass < (missing ? 3 : 2); ++pass)
    heights -= products.combined(missing ? step_of(products, heights, gram, degree) : products.sums(heights));
  return heights;
}

// ---- spheres and cylinders ----

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
constexpr int most_fits = 100;
constexpr int parameters = 5;  // c, turns about a and b, κ; of a cylinder a turn about n
using Gradient = Eigen::Matrix<double, parameters, 1>;
using Gram = Eigen::Matrix<double, parameters, parameters>;

const char* name_of(CurvedShape shape) { return shape == CurvedShape::sphere ? "sphere" : "cylinder"; }

[[noreturn]] void refuse(CurvedShape shape, const std::string& why) {
  throw ParameterError("remove-form", "'" + std::string(name_of(shape)) + "': " + why);
}

// The root h of (1), A h² + B h + C = 0, that stays finite as κ → 0; a = 0 of a sphere.
double root(const Vector3d& a, const Vector3d& n, double curvature, double x, double y) {
  const Vector3d flat(x, y, 0);
  const double along = a.dot(flat), A = curvature / 2 * (1 - a.z() * a.z()),
               B = n.z() - curvature * a.z() * along,
               C = curvature / 2 * (x * x + y * y - along * along) + n.dot(flat);
  return -2 * C / (B + std::sqrt(B * B - 4 * A * C));
}

// (1), in units of half the field's diagonal.
struct Quadric {
  CurvedShape shape;
  double c = 0, curvature = 0;
  Matrix3d frame = Matrix3d::Identity();  // a, b, n: the axis, across it, the normal

  double height(double x, double y) const { return root(axis(), frame.col(2), curvature, x, y); }
  Vector3d axis() const { return shape == CurvedShape::cylinder ? Vector3d(frame.col(0)) : Vector3d::Zero(); }
  // ∂(c + h)/∂ the parameters, where the height is h.
  Gradient gradient(double x, double y, double h) const {
    const Vector3d d(x, y, h), m = d - axis() * axis().dot(d);
    const auto a = frame.col(0), b = frame.col(1), n = frame.col(2);
    const double slope = curvature * m.z() + n.z(), of_axis = curvature * axis().dot(d);
    Gradient F;  // ∂F, of a turn about a: n → -b; about b: n → a, a → -n; about n: a → b
    F << -slope, -b.dot(d), a.dot(d) + of_axis * n.dot(d), d.dot(m) / 2, -of_axis * b.dot(d);
    return -F / slope;
  }
  Quadric moved(const Gradient& by) const {
    Quadric out = *this;
    out.c += by[0];
    out.curvature += by[3];
    const Vector3d turn = frame.col(0) * by[1] + frame.col(1) * by[2] + frame.col(2) * by[4];
    if (const double angle = turn.norm(); angle > 0)
      out.frame = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * frame;
    return out;
  }
};

// The heights to fit, in the same units, about their mean.
struct Points {
  const Field& z;
  const Grid& grid;
  double level, unit;
  int threads;

  double x(Index i) const { return grid.x(i) / unit; }
  double y(Index j) const { return grid.y(j) / unit; }
  double height(Index i, Index j) const { return (z(i, j) - level) / unit; }
};

// Σ g gᵀ, Σ g r and Σ r² over the points, r = z - form; NaN if one lies beyond the form's outline.
struct Sums {
  Gram gram = Gram::Zero();
  Gradient right = Gradient::Zero();
  double squares = 0, count = 0;

  void add(const Sums& row) {
    gram += row.gram, right += row.right, squares += row.squares, count += row.count;
  }
};

template <class AddPoint>
Sums over_points(const Points& points, AddPoint add) {
  std::vector<Sums> rows(size(points.z.rows()));
  parallel_ranges(points.z.rows(), points.threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i)
      for (Index j = 0; j < points.z.cols(); ++j)
        if (!std::isnan(points.z(i, j))) add(rows[size(i)], points.x(i), points.y(j), points.height(i, j));
  });
  Sums out;
  for (const Sums& row : rows) out.add(row);
  return out;
}

Sums sums_of(const Quadric& quadric, const Points& points) {
  return over_points(points, [&](Sums& sums, double x, double y, double z) {
    const double h = quadric.height(x, y), r = z - quadric.c - h;
    const Gradient g = quadric.gradient(x, y, h);
    sums.gram += g * g.transpose();
    sums.right += r * g;
    sums.squares += r * r;
    sums.count += 1;
  });
}

// Σ_{p+q≤2} c_pq x^p y^q of least squares, in the order 1, x, y, x², xy, y².
Eigen::ArrayXd parabola(CurvedShape shape, const Points& points) {
  using Terms = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right = Terms::Zero();
  const double u = 1 / points.x(points.z.rows() - 1), v = 1 / points.y(points.z.cols() - 1);  // to ±1 each
  for (Index i = 0; i < points.z.rows(); ++i)
    for (Index j = 0; j < points.z.cols(); ++j) {
      if (std::isnan(points.z(i, j))) continue;
      const double x = u * points.x(i), y = v * points.y(j);
      const Terms t{1, x, y, x * x, x * y, y * y};
      gram += t * t.transpose();
      right += points.height(i, j) * t;
    }
  const auto c = solve_positive(gram, right, 1e-10);
  if (!c) refuse(shape, "the points that are not missing do not determine a form of degree 2");
  return c->array() * Eigen::Array<double, 6, 1>{1, u, v, u * u, u * v, v * v};
}

// The slopes of the parabola as n, its principal directions as a and b, the axis along the lesser curvature.
Quadric start(CurvedShape shape, const Points& points) {
  const Eigen::VectorXd c = parabola(shape, points);
  Quadric out{.shape = shape, .c = c[0]};
  const double angle = 0.5 * std::atan2(c[4], c[3] - c[5]), half = std::hypot(c[4], c[3] - c[5]) / 2,
               middle = (c[3] + c[5]) / 2;
  const bool first =
      std::abs(middle + half) >= std::abs(middle - half);  // the direction at `angle` bends more
  const double across = first ? angle : angle + std::numbers::pi / 2;
  out.curvature = shape == CurvedShape::sphere ? -2 * middle : -2 * (first ? middle + half : middle - half);
  const Vector3d n = Vector3d(-c[1], -c[2], 1).normalized(), b(std::cos(across), std::sin(across), 0);
  out.frame.col(2) = n;
  out.frame.col(1) = (b - n * n.dot(b)).normalized();
  out.frame.col(0) = out.frame.col(1).cross(n);
  return out;
}

// Points beyond the outline of a steep parabola's sphere: a flatter one reaches them.
Sums reach_all_points(Quadric& quadric, const Points& points) {
  for (int k = 0; k < 60; ++k) {
    const Sums sums = sums_of(quadric, points);
    if (!std::isnan(sums.squares)) return sums;
    quadric.curvature /= 1.5;
  }
  refuse(quadric.shape, "no such form reaches all points");
}

struct Fit {
  Quadric quadric;
  Sums sums;
  int steps = 0;
};

Gradient solved(const Sums& sums, double damping, Index count) {
  Gram gram = sums.gram;
  gram.diagonal() *= 1 + damping;
  Gradient step = Gradient::Zero();
  const auto some = solve_positive(gram.topLeftCorner(count, count), sums.right.head(count), 0);
  if (some) step.head(count) = *some;
  return step;
}

// Levenberg and Marquardt. Ends where a step lowers (2) by less than its round-off.
Fit fit(CurvedShape shape, const Points& points) {
  const Index count = shape == CurvedShape::sphere ? 4 : 5;
  Fit out{start(shape, points), {}, 0};
  out.sums = reach_all_points(out.quadric, points);
  double damping = 1e-4;
  while (++out.steps <= most_fits) {
    const Gradient step = solved(out.sums, damping, count);
    const double predicted = step.dot(out.sums.right), squares = out.sums.squares;
    const Quadric next = out.quadric.moved(step);
    const Sums sums = sums_of(next, points);
    if (sums.squares <= squares) {
      out.quadric = next;
      out.sums = sums;
      damping = damping > 1e-12 ? damping / 10 : 0;
    } else {
      damping = std::max(10 * damping, 1e-6);
    }
    if (predicted <= 1e-14 * squares || step.norm() <= 1e-14 || damping > 1e6) return out;
  }
  refuse(shape,
         "no least squares within " + std::to_string(most_fits) + " steps: the points do not determine it");
}

// The variance of κ if residuals were independent with variance 1. The turn about n, which κ = 0 leaves open,
// is left out.
double variance_of_curvature(const Gram& gram) {
  const Eigen::Vector4d scale = gram.diagonal().head(4).cwiseSqrt().cwiseInverse();
  const Eigen::Matrix4d scaled = scale.asDiagonal() * gram.topLeftCorner(4, 4) * scale.asDiagonal();
  const auto inverse = solve_positive(scaled, Eigen::Vector4d::Unit(3), 1e-12);
  return inverse ? (*inverse)[3] * scale[3] * scale[3] : HUGE_VAL;
}

// Whether κ differs from zero by three standard errors and by more than round-off.
void check_determined(const Fit& fit, double unit) {
  const double free = fit.sums.count - parameters;
  if (!(free > 0)) refuse(fit.quadric.shape, "fewer points than it has parameters");
  const double error = std::sqrt(fit.sums.squares / free * variance_of_curvature(fit.sums.gram));
  if (!(std::abs(fit.quadric.curvature) > std::max(3 * error, 1e-13)))
    refuse(fit.quadric.shape, "the points are flat: their curvature is " +
                                  number(fit.quadric.curvature / unit) + " 1/m with a standard error of " +
                                  number(error / unit) + " 1/m at least");
}

std::array<double, 3> array_of(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

double CurvedForm::above_level(double x, double y) const {
  return rise + root(Vector3d(axis.data()), Vector3d(normal.data()), 1 / radius, x, y);
}

CurvedForm fit_curved_form(const Field& z, const Grid& grid, CurvedShape shape, int threads) {
  if (z.rows() == 1 || z.cols() == 1) refuse(shape, "a profile does not determine it: remove a polynomial");
  const Points points{z, grid, mean(z), std::hypot(grid.size_x(), grid.size_y()) / 2, threads};
  const Fit found = fit(shape, points);
  check_determined(found, points.unit);
  const Quadric& q = found.quadric;
  CurvedForm out{
      .shape = shape, .radius = points.unit / q.curvature, .level = points.level, .steps = found.steps};
  out.axis = array_of(q.axis());
  out.normal = array_of(q.frame.col(2));
  out.rise = q.c * points.unit;
  out.centre = array_of(Vector3d(0, 0, out.level + out.rise) - out.radius * q.frame.col(2));
  out.rms = points.unit * std::sqrt(found.sums.squares / found.sums.count);
  return out;
}

Field above_form(const Field& z, const Grid& grid, const CurvedForm& form) {
  return (z - form.level) - sample(grid, [&](double x, double y) { return form.above_level(x, y); });
}

}  // namespace asperity
