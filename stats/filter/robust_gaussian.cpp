#include "stats/filter/robust_gaussian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/missing.hpp"
#include "transform/rows.hpp"

namespace asperity {

// ---- the Gaussian regression of order 2 ----

namespace {

// Gaussian regression of order 2: about each point the quadratic that fits best.
//
//     min Σ_k s(x_k - x) δ_k (z_k - P(x_k - x))²  over P of total degree 2,   w(x) = P(0),            (1)
//     s(x,y) ∝ exp(-π (x² + y²) / (γ λ_c)²),   γ = √(u/π) = 0.7309,   (1 + u) e^{-u} = 1/2,           (2)
// δ a weight of each point, 0 where it is missing. Quadratic surfaces stay as they are, edges and holes
// included. Where δ = 1, far from an edge, a wave of length λ passes by (1 + v) e^{-v}, v = u (λ_c/λ)²: half
// of it at the cut-off λ_c. With the weight of order 0 (stats/filter/gaussian_filter.hpp) it would be 0.85.
// With u = (x_k - x)/γλ_c the coefficients of P solve
//     Σ_cd M_{a+c,b+d} p_cd = N_ab,   M_ab = Σ s δ u^a v^b,   N_ab = Σ s δ z u^a v^b:                  (3)
// 15 moments of δ, 6 of δz. Terms that the points under the weight do not tell, such as those across a
// profile, are left out.
//
// Accuracy  The weight is cut at 1.6 λ_c, where it is 3e-7. Round-off of the sums is some 1e-15 of the
//           largest value; where the points determine w to less than a millionth of their weight, it keeps
//           its former value.
// Cost      39 transforms in one dimension of each row or column, and one equation of six unknowns a point:
//           0.3 s for 1024². Memory: eight fields.
//
// ISO 16610-31:2016; ISO 16610-71:2014. W. Zeng, X. Jiang, P. J. Scott, S. Xiao, L. Blunt,
// Proc. 9th int. conf. euspen (2009) 356-359.

// Σ_k s(x_k - x) u^a f_k about each point of an axis, a = 0 … 4, of eight rows at a time.
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

  // Of `count` rows of points, `apart`: out(a), a ≤ degree, is where moment a goes, rows points() apart.
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
  AlignedVector<Complex> symbols_;  // in the blocks of the transform, a row a power
};

class LocalQuadratic {
 public:
  // Throws ParameterError("cut-off") as the Gaussian filter.
  LocalQuadratic(const Grid& grid, double cutoff, int threads = 1);

  // w of (1); `former` where the points do not determine it. No field has missing points.
  Field operator()(const Field& z, const Field& delta, const Field& former) const;

 private:
  using Moments = std::array<Field, AxisMoments::highest + 1>;
  Moments along_x(const Field& values, int degree) const;

  AxisMoments x_, y_;
  int threads_;
};

}  // namespace

namespace {

constexpr Index rows = AxisMoments::rows;
constexpr int most_powers = AxisMoments::highest;
constexpr double gamma_of_width = 0.73091342809;           // √(u/π), (1 + u) e^{-u} = 1/2
constexpr double cut = 1.6;                                // of the weight, in cut-offs
constexpr double least_share = 1e-9, pivot_bound = 1e-14;  // of a term: below, it is round-off
constexpr double least_weight = 1e-6;                      // of the constant term

struct Power {
  Index a, b;
};
// The constant last: only it is wanted.
constexpr std::size_t unknowns = 6;
constexpr std::array<Power, unknowns> terms{{{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {0, 0}}};

// Moments by total degree: 00, 10, 01, 20, 11, 02, 30, …
constexpr Index term_at(Index a, Index b) { return (a + b) * (a + b + 1) / 2 + b; }

// The constant term of (3), by L D Lᵀ; `apart` from one moment of the point to the next.
double constant_term(const double* m, const double* n, Index apart, double former) {
  std::array<std::array<double, unknowns>, unknowns> l{};
  std::array<double, unknowns> pivot{}, right{};
  for (std::size_t i = 0; i < unknowns; ++i) {
    const auto [a, b] = terms[i];
    double left = m[term_at(2 * a, 2 * b) * apart];
    const double whole = left;
    right[i] = n[term_at(a, b) * apart];
    for (std::size_t j = 0; j < i; ++j) {
      if (pivot[j] == 0) continue;
      double sum = m[term_at(a + terms[j].a, b + terms[j].b) * apart];
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k] * pivot[k];
      l[i][j] = sum / pivot[j];
      left -= l[i][j] * sum;
      right[i] -= l[i][j] * right[j];
    }
    pivot[i] = left > least_share * whole + pivot_bound ? left : 0;
  }
  return pivot.back() > least_weight ? right.back() / pivot.back() : former;
}

}  // namespace

AxisMoments::AxisMoments(Index points, double step, bool periodic, double width)
    : points_(points), transform_(1) {
  const double most = static_cast<double>(periodic ? 1000 * points : points - 1);
  const auto half = static_cast<Index>(std::min(std::ceil(cut / gamma_of_width * width / step), most));
  const Index torus = periodic ? points : fast_length(points + half, 2);
  transform_ = RowTransform(torus);
  Field weights = Field::Zero(most_powers + 1, torus);
  for (Index k = -half; k <= half; ++k) {
    const double u = static_cast<double>(k) * step / width;
    double power = std::exp(-std::numbers::pi * u * u);
    for (int a = 0; a <= most_powers; ++a, power *= u) weights(a, (k % torus + torus) % torus) += power;
  }
  weights /= weights.row(0).sum() * static_cast<double>(torus);
  symbols_.resize(size(transform_.blocks() * block));
  Work space = work();
  transform_.forward(weights.data(), torus, torus, most_powers + 1, symbols_.data(), block, space.transform);
}

AxisMoments::Work AxisMoments::work() const {
  const AlignedVector<Complex> modes(size(transform_.blocks() * block));
  return {transform_.work(), modes, modes};
}

// The moments are those about x of -u, of which P has the same P(0).
void AxisMoments::multiply(int a, Index count, Work& work) const {
  constexpr Index width = RowTransform::width;
  for (Index b = 0; b < transform_.blocks(); ++b)
    for (Index r = 0; r < count; ++r)
      for (Index k = 0; k < width; ++k) {
        const Index at = b * block + r * width + k;
        work.product[size(at)] = work.modes[size(at)] * symbols_[size(b * block + a * width + k)];
      }
}

LocalQuadratic::LocalQuadratic(const Grid& grid, double cutoff, int threads)
    : x_((check_cutoff(grid, cutoff), grid.shape.nx), grid.dx, grid.periodic.x, gamma_of_width * cutoff),
      y_(grid.shape.ny, grid.dy, grid.periodic.y, gamma_of_width * cutoff),
      threads_(threads) {}

// Of columns, eight at a time.
auto LocalQuadratic::along_x(const Field& values, int degree) const -> Moments {
  const Index nx = values.rows(), ny = values.cols();
  const Field columns = values.transpose();
  Moments out;
  for (int a = 0; a <= degree; ++a) out[size(a)].resize(nx, ny);
  parallel_ranges((ny + rows - 1) / rows, threads_, [&](Index begin, Index end, int) {
    AxisMoments::Work work = x_.work();
    Moments part;
    part.fill(Field(rows, nx));
    for (Index first = begin * rows; first < std::min(end * rows, ny); first += rows) {
      const Index count = std::min(rows, ny - first);
      x_(&columns(first, 0), nx, count, degree, work, [&](int a) { return part[size(a)].data(); });
      for (int a = 0; a <= degree; ++a)
        out[size(a)].middleCols(first, count) = part[size(a)].topRows(count).transpose();
    }
  });
  return out;
}

Field LocalQuadratic::operator()(const Field& z, const Field& delta, const Field& former) const {
  const Moments of_delta = along_x(delta, most_powers), of_weighted = along_x(delta * z, 2);
  const Index nx = z.rows(), ny = z.cols();
  Field out(nx, ny);
  parallel_ranges((nx + rows - 1) / rows, threads_, [&](Index begin, Index end, int) {
    AxisMoments::Work work = y_.work();
    Field m(term_at(0, most_powers) + 1, rows * ny), n(term_at(0, 2) + 1, rows * ny);
    for (Index first = begin * rows; first < std::min(end * rows, nx); first += rows) {
      const Index count = std::min(rows, nx - first);
      auto along_y = [&](const Field& moment, int a, int degree, Field& to) {
        y_(&moment(first, 0), ny, count, degree - a, work, [&](int b) { return &to(term_at(a, b), 0); });
      };
      for (int a = 0; a <= most_powers; ++a) along_y(of_delta[size(a)], a, most_powers, m);
      for (int a = 0; a <= 2; ++a) along_y(of_weighted[size(a)], a, 2, n);
      for (Index k = 0; k < count * ny; ++k)
        out(first + k / ny, k % ny) =
            constant_term(&m(0, k), &n(0, k), m.cols(), former(first + k / ny, k % ny));
    }
  });
  return out;
}

// ---- the robust filter ----

namespace {

constexpr double width_of_median = 4.4478;  // 3 × 1.4826, of (3)
constexpr double tolerance = 1e-3 / 3;      // of c
constexpr double round_off = 1e-12;         // of the largest height

double median_size(const Field& differences) {
  std::vector<double> sizes;
  sizes.reserve(size(differences.size()));
  for (const double r : differences.reshaped<Eigen::RowMajor>())
    if (!std::isnan(r)) sizes.push_back(std::abs(r));
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + std::ssize(sizes) / 2;
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

// (2); zero where a point is missing.
Field biweights(const Field& differences, double width) {
  return (differences.abs() < width).select((1 - (differences / width).square()).square(), 0);
}

}  // namespace

RobustMeanSurface robust_gaussian_mean_surface(const Field& heights, const Grid& grid, double cutoff,
                                               int threads, int most) {
  const double level = mean(heights);
  const Field z = heights - level, filled = zero_filled(z), valid = validity(z);
  const LocalQuadratic regression(grid, cutoff, threads);
  const double least = round_off * filled.abs().maxCoeff();
  RobustMeanSurface out{.surface = regression(filled, valid, filled), .steps = 1};
  while (!out.converged && out.steps < most) {
    ++out.steps;
    out.width = width_of_median * median_size(z - out.surface);
    const Field weights = biweights(z - out.surface, out.width),
                next = regression(filled, weights, out.surface);
    const Field moves = valid * (next - out.surface);
    out.change = std::sqrt(moves.square().sum() / valid.sum());
    out.largest = moves.abs().maxCoeff();
    out.surface = next;
    out.ignored = (valid * (weights == 0).select(Field::Ones(z.rows(), z.cols()), 0)).sum() / valid.sum();
    out.converged = out.change <= std::max(tolerance * out.width, least);
  }
  out.surface = (valid > 0).select(out.surface + level, NAN);
  return out;
}

}  // namespace asperity
