#include "contact/influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/calibration.hpp"
#include "contact/repeated_cell.hpp"
#include "core/stopwatch.hpp"
#include "math/asinh_difference.hpp"
#include "math/gauss_legendre.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

constexpr double pi = std::numbers::pi;

double edge(double w, double y, double b) { return w == 0 ? 0 : w * asinh_difference(w, y, b); }

double closed_form(double x, double y, double a, double b) {
  return edge(x + a, y, b) - edge(x - a, y, b) + edge(y + b, x, a) - edge(y - b, x, a);
}

// The integrand 1/r is analytic: n nodes a side leave (size/2r)^2n.
template <std::size_t n>
double gauss_rule(const GaussLegendre<n>& rule, double x, double y, double a, double b) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double dx = x + a * rule.nodes[i], dy = y + b * rule.nodes[j];
      sum += rule.weights[i] * rule.weights[j] / std::sqrt(dx * dx + dy * dy);
    }
  return a * b * sum;
}

// The rectangle's moments up to the fourth; the sixth leave 0.2 (size/2r)⁶.
double multipoles(double x, double y, double a, double b) {
  const double x2 = x * x, y2 = y * y, inverse = 1 / (x2 + y2), c = x2 * inverse, s = y2 * inverse;
  const double A = a * a * inverse, B = b * b * inverse;
  const double second = (A * (3 * c - 1) + B * (3 * s - 1)) / 6;
  const double fourth = (A * A * ((105 * c - 90) * c + 9) + B * B * ((105 * s - 90) * s + 9)) / 120 +
                        A * B * (105 * c * s - 12) / 36;
  return 4 * a * b * std::sqrt(inverse) * (1 + second + fourth);
}

// The transform of (2) on a torus, K between nearest images.
Field love_symbol(const Grid& grid, Shape torus, double composite_modulus, int threads, const Ranks& ranks) {
  const double a = grid.dx / 2, b = grid.dy / 2, scale = 1 / (pi * composite_modulus);
  return even_transfer_function(
      torus,
      [&](Index i, Index j) {
        return scale *
               love_integral(static_cast<double>(i) * grid.dx, static_cast<double>(j) * grid.dy, a, b);
      },
      threads, ranks);
}

// |q| of (3).
double wave_number(const Grid& grid, Index i, Index j) {
  constexpr double turn = 2 * pi;
  return std::hypot(turn / grid.size_x() * static_cast<double>(i),
                    turn / grid.size_y() * static_cast<double>(j));
}

// The same at some ky.
Field wave_numbers(const Grid& grid, Extent columns) {
  return Field::NullaryExpr(grid.shape.nx / 2 + 1, columns.count,
                            [&](Index i, Index j) { return wave_number(grid, i, columns.first + j); });
}

// The mean of 1/|q| over the torus, 0 at q = 0: the displacement of a cell under itself.
double mean_inverse(const Grid& grid) {
  const auto [nx, ny] = grid.shape;
  auto images = [](Index k, Index n) { return k == 0 || 2 * k == n ? 1.0 : 2.0; };
  double sum = 0;
  for (Index i = 0; i <= nx / 2; ++i)
    for (Index j = 0; j <= ny / 2; ++j)
      if (i + j > 0) sum += images(i, nx) * images(j, ny) / wave_number(grid, i, j);
  return sum / static_cast<double>(grid.shape.cells());
}

// Coefficients of (3), along the periodic axis and across, for distances of up to rows - 1 cells.
RepeatedCell repeated_cell(const Grid& grid, Index rows, double datum, int threads) {
  const double a = grid.dx / 2, b = grid.dy / 2;
  return grid.periodic.x ? RepeatedCell(a, b, grid.shape.nx, rows, datum, threads)
                         : RepeatedCell(b, a, grid.shape.ny, rows, datum, threads);
}

// The transform of (3) on a torus, K between nearest images across.
Field repeated_symbol(const Grid& grid, Shape torus, double datum, double composite_modulus, int threads,
                      const Ranks& ranks) {
  const bool in_x = grid.periodic.x;
  const RepeatedCell cell = repeated_cell(grid, (in_x ? torus.ny : torus.nx) / 2 + 1, datum, threads);
  const double scale = 1 / (pi * composite_modulus);
  return even_transfer_function(
      torus, [&](Index i, Index j) { return scale * (in_x ? cell(i, j) : cell(j, i)); }, threads, ranks);
}

double self_influence_of(const Grid& grid, double datum, double modulus) {
  if (grid.periodic.both()) return 2 / modulus * mean_inverse(grid);
  const double integral = grid.periodic.any() ? repeated_cell(grid, 1, datum, 1)(0, 0)
                                              : love_integral(0, 0, grid.dx / 2, grid.dy / 2);
  return integral / (pi * modulus);
}

class HalfSpace final : public ElasticOperator {
 public:
  HalfSpace(const Grid& grid, double datum, double modulus, int threads, WorkSpace work, const Ranks& ranks)
      : grid_(grid),
        ranks_(ranks),
        slabs_(shared_rows(grid.shape, ranks)),
        datum_(datum),
        modulus_(modulus),
        self_(self_influence_of(grid, datum, modulus)),
        threads_(threads),
        work_(std::move(work)) {}

  Shape shape() const override { return grid_.shape; }
  bool fits(const Grid& grid) const override {
    auto same = [](double one, double other) { return std::abs(one / other - 1) <= 1e-9; };
    return grid.shape == grid_.shape && grid.periodic == grid_.periodic && same(grid.dx, grid_.dx) &&
           same(grid.dy, grid_.dy);
  }
  Slabs slabs() const override { return slabs_; }
  void apply(const Field& p, Field& u) override { made(influence_, &HalfSpace::influence).apply(p, u); }
  void apply_single(const Field& p, Field& u) override {
    if (!is_large()) return apply(p, u);
    made(single_, &HalfSpace::single).apply(p, u);
  }
  void precondition(const Field& r, Field& z) override {
    if (is_large())
      made(single_inverse_, &HalfSpace::inverse<float>).apply(r, z);
    else
      made(inverse_, &HalfSpace::inverse<double>).apply(r, z);
  }
  double self_influence() const override { return self_; }
  double setup_seconds() const override { return setup_ + (window_ ? window_->setup_seconds() : 0); }

  std::span<double> room(std::size_t doubles) override {
    return {reinterpret_cast<double*>(room_in(work_, doubles * sizeof(double))), doubles};
  }

  // (1), for images are too far to vary from cell to cell.
  Field near_influence(Index reach) override {
    return Field::NullaryExpr(reach + 1, reach + 1, [&](Index i, Index j) {
      return love_integral(static_cast<double>(i) * grid_.dx, static_cast<double>(j) * grid_.dy, grid_.dx / 2,
                           grid_.dy / 2) /
             (pi * modulus_);
    });
  }

  std::unique_ptr<ElasticOperator> coarsened(Index factor) const override {
    auto covering = [factor](Index n) { return (n + factor - 1) / factor; };
    const double wide = static_cast<double>(factor);
    const Grid coarse{
        {covering(shape().nx), covering(shape().ny)}, wide * grid_.dx, wide * grid_.dy, grid_.periodic};
    return std::make_unique<HalfSpace>(coarse, datum_, modulus_, threads_, work_, ranks_);
  }

  void forget_windows() override { asked_ = false; }
  std::shared_ptr<ElasticOperator> windowed(Shape least) override {
    if (grid_.periodic.both()) return nullptr;
    if (grid_.periodic.x) least.nx = shape().nx;
    if (grid_.periodic.y) least.ny = shape().ny;
    const Shape torus = torus_for(least);
    const Grid window{
        {grid_.periodic.x ? torus.nx : torus.nx / 2, grid_.periodic.y ? torus.ny : torus.ny / 2},
        grid_.dx,
        grid_.dy,
        grid_.periodic};
    auto exceeds = [](Shape a, double share, Shape b) {
      return static_cast<double>(a.cells()) > share * static_cast<double>(b.cells());
    };
    if (exceeds(torus, contact::largest_window, torus_for(shape())) || !covers(shape(), window.shape))
      return nullptr;
    const bool goes_on = window_ && std::exchange(asked_, true) && covers(window_->shape(), least) &&
                         !exceeds(window_->shape(), contact::shared_window, window.shape);
    if (goes_on || (window_ && window_->shape() == window.shape)) return window_;
    asked_ = true;
    setup_ = setup_seconds();
    return window_ = std::make_shared<HalfSpace>(window, datum_, modulus_, threads_, work_, ranks_);
  }

 private:
  template <class Real>
  using Convolution = std::unique_ptr<BasicEvenConvolution<Real>>;

  // Of so many cells that single precision pays.
  bool is_large() const { return shape().cells() >= contact::single_cells; }
  static bool covers(Shape a, Shape b) { return a.nx >= b.nx && a.ny >= b.ny; }

  // The fewest points on which cells do not act around the torus but along a periodic axis.
  Shape torus_for(Shape cells) const {
    const Shape padded = padded_torus(cells);
    return {grid_.periodic.x ? cells.nx : padded.nx, grid_.periodic.y ? cells.ny : padded.ny};
  }

  Field symbol(Shape torus) const {
    return grid_.periodic.any() ? repeated_symbol(grid_, torus, datum_, modulus_, threads_, slabs_.ranks())
                                : love_symbol(grid_, torus, modulus_, threads_, slabs_.ranks());
  }

  template <class Real>
  BasicEvenConvolution<Real>& made(Convolution<Real>& convolution, Convolution<Real> (HalfSpace::*make)()) {
    if (!convolution) {
      const Stopwatch watch;
      convolution = (this->*make)();
      setup_ += watch.seconds();
    }
    return *convolution;
  }

  template <class Real>
  Convolution<Real> convolution(Shape torus, const Field& symbol) const {
    return std::make_unique<BasicEvenConvolution<Real>>(shape(), torus, symbol, threads_, work_,
                                                        slabs_.ranks());
  }

  Convolution<double> influence() {
    if (grid_.periodic.both()) {
      const Field q = wave_numbers(grid_, symbol_columns(shape(), slabs_.ranks()));
      return convolution<double>(shape(), (q > 0).select(2 / (modulus_ * q), 0));
    }
    const Shape torus = torus_for(shape());
    return convolution<double>(torus, symbol(torus));
  }

  Convolution<float> single() {
    if (!influence_) influence_ = influence();
    return std::make_unique<BasicEvenConvolution<float>>(*influence_);
  }

  // Love's symbol is positive, above half of K₀₀ on square cells; the bound keeps M definite on any others.
  template <class Real>
  Convolution<Real> inverse() {
    if (grid_.periodic.both())
      return convolution<Real>(shape(),
                               modulus_ / 2 * wave_numbers(grid_, symbol_columns(shape(), slabs_.ranks())));
    const Shape torus{grid_.periodic.x ? shape().nx : fast_length(shape().nx, 2),
                      grid_.periodic.y ? shape().ny : fast_length(shape().ny, 2)};
    return convolution<Real>(torus, symbol(torus).max(1e-3 * self_).inverse());
  }

  Grid grid_;
  const Ranks& ranks_;  ///< for coarser grids and windows too
  Slabs slabs_;
  double datum_, modulus_, self_;
  int threads_;
  WorkSpace work_;
  Convolution<double> influence_, inverse_;
  Convolution<float> single_, single_inverse_;
  std::shared_ptr<HalfSpace> window_;
  bool asked_ = false;  ///< for a window, of late: window_ is of the present problem
  double setup_ = 0;
};

}  // namespace

double love_integral(double x, double y, double a, double b) {
  x = std::abs(x);
  y = std::abs(y);
  const double r = std::sqrt(x * x + y * y) / (2 * std::max(a, b));
  if (r < 20) return closed_form(x, y, a, b);
  if (r < 80) return gauss_rule(gauss4, x, y, a, b);
  return r < 160 ? gauss_rule(gauss3, x, y, a, b) : multipoles(x, y, a, b);
}

double displacement_datum(const Grid& grid) {
  return grid.periodic.one() ? (grid.periodic.x ? grid.size_y() : grid.size_x()) / 2 : 0;
}

std::unique_ptr<ElasticOperator> make_influence(const Grid& grid, double composite_modulus, int threads,
                                                const Ranks& ranks) {
  return std::make_unique<HalfSpace>(grid, displacement_datum(grid), composite_modulus, threads,
                                     std::make_shared<WorkSpace::element_type>(), ranks);
}

}  // namespace asperity
