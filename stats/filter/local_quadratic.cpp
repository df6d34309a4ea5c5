#include "stats/filter/local_quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "stats/filter/gaussian_filter.hpp"

namespace asperity {
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

}  // namespace asperity
