#include "contact/influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "grid/parallel.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

constexpr double pi = std::numbers::pi;

// asinh((y+b)/|w|) - asinh((y-b)/|w|), without cancellation where both have one sign.
double asinh_difference(double w, double y, double b) {
  const double above = y + b, below = y - b;
  if (above * below <= 0) return std::asinh(above / std::abs(w)) - std::asinh(below / std::abs(w));
  return std::asinh(4 * b * y / (above * std::hypot(below, w) + below * std::hypot(above, w)));
}

double edge(double w, double y, double b) { return w == 0 ? 0 : w * asinh_difference(w, y, b); }

double closed_form(double x, double y, double a, double b) {
  return edge(x + a, y, b) - edge(x - a, y, b) + edge(y + b, x, a) - edge(y - b, x, a);
}

struct Node {
  double at, weight;
};
constexpr std::array<Node, 3> gauss3{
    {{-0.7745966692414834, 5.0 / 9}, {0, 8.0 / 9}, {0.7745966692414834, 5.0 / 9}}};
constexpr std::array<Node, 4> gauss4{{{-0.8611363115940526, 0.3478548451374538},
                                      {-0.3399810435848563, 0.6521451548625461},
                                      {0.3399810435848563, 0.6521451548625461},
                                      {0.8611363115940526, 0.3478548451374538}}};

// The integrand 1/r is analytic: n nodes a side leave (size/2r)^2n.
template <std::size_t n>
double gauss_rule(const std::array<Node, n>& rule, double x, double y, double a, double b) {
  double sum = 0;
  for (const auto [s, v] : rule)
    for (const auto [t, w] : rule) {
      const double dx = x + a * s, dy = y + b * t;
      sum += v * w / std::sqrt(dx * dx + dy * dy);
    }
  return a * b * sum;
}

// K(i, j) for 0 ≤ i ≤ Px/2, 0 ≤ j ≤ Py/2 of the padded torus.
Field love_coefficients(const Grid& grid, double composite_modulus, int threads) {
  const Shape torus = padded_torus(grid.shape);
  Field k(torus.nx / 2 + 1, torus.ny / 2 + 1);
  const double a = grid.dx / 2, b = grid.dy / 2, scale = 1 / (pi * composite_modulus);
  parallel_ranges(k.rows(), threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i)
      for (Index j = 0; j < k.cols(); ++j)
        k(i, j) =
            scale * love_integral(static_cast<double>(i) * grid.dx, static_cast<double>(j) * grid.dy, a, b);
  });
  return k;
}

Field symbol_of(const Field& coefficients, Shape torus) {
  return even_symbol(torus, [&](Index i, Index j) { return coefficients(i, j); });
}

// A torus about as large as the field, for nearest images.
Shape unpadded_torus(Shape field) { return {fast_length(field.nx, 2), fast_length(field.ny, 2)}; }

class HalfSpace final : public ElasticOperator {
 public:
  HalfSpace(Shape shape, Field coefficients, int threads)
      : coefficients_(std::move(coefficients)),
        influence_(shape, padded_torus(shape), symbol_of(coefficients_, padded_torus(shape)), threads),
        inverse_(shape, unpadded_torus(shape), inverse_symbol(shape), threads),
        threads_(threads) {}

  Shape shape() const override { return influence_.shape(); }
  void apply(const Field& p, Field& u) override { influence_.apply(p, u); }
  void precondition(const Field& r, Field& z) override { inverse_.apply(r, z); }
  double self_influence() const override { return coefficients_(0, 0); }

  // (1) is homogeneous: twice the lengths, twice the displacement.
  std::unique_ptr<ElasticOperator> coarsened() const override {
    const Shape coarse{shape().nx / 2, shape().ny / 2}, torus = padded_torus(coarse);
    return std::make_unique<HalfSpace>(
        coarse, 2 * coefficients_.topLeftCorner(torus.nx / 2 + 1, torus.ny / 2 + 1), threads_);
  }

 private:
  // The symbol is positive, above half of K₀₀ on square cells; the bound keeps M definite on any others.
  Field inverse_symbol(Shape shape) const {
    return symbol_of(coefficients_, unpadded_torus(shape)).max(1e-3 * self_influence()).inverse();
  }

  Field coefficients_;
  EvenConvolution influence_, inverse_;
  int threads_;
};

class PeriodicHalfSpace final : public ElasticOperator {
 public:
  PeriodicHalfSpace(const Grid& grid, double composite_modulus, int threads)
      : PeriodicHalfSpace(grid, composite_modulus, threads, wave_numbers(grid)) {}

  Shape shape() const override { return grid_.shape; }
  void apply(const Field& p, Field& u) override { influence_.apply(p, u); }
  void precondition(const Field& r, Field& z) override { inverse_.apply(r, z); }
  double self_influence() const override { return self_; }

  std::unique_ptr<ElasticOperator> coarsened() const override {
    const Grid coarse{{grid_.shape.nx / 2, grid_.shape.ny / 2}, 2 * grid_.dx, 2 * grid_.dy, true};
    return std::make_unique<PeriodicHalfSpace>(coarse, modulus_, threads_);
  }

 private:
  PeriodicHalfSpace(const Grid& grid, double modulus, int threads, const Field& q)
      : grid_(grid),
        modulus_(modulus),
        threads_(threads),
        self_(2 / modulus * mean_inverse(q, grid.shape)),
        influence_(grid.shape, grid.shape, (q > 0).select(2 / (modulus * q), 0), threads),
        inverse_(grid.shape, grid.shape, modulus / 2 * q, threads) {}

  static Field wave_numbers(const Grid& grid) {
    const double qx = 2 * pi / grid.size_x(), qy = 2 * pi / grid.size_y();
    return Field::NullaryExpr(grid.shape.nx / 2 + 1, grid.shape.ny / 2 + 1, [=](Index i, Index j) {
      return std::hypot(qx * static_cast<double>(i), qy * static_cast<double>(j));
    });
  }

  // The mean of 1/|q| over the torus, 0 at q = 0: the displacement of a cell under itself.
  static double mean_inverse(const Field& q, Shape torus) {
    auto images = [](Index k, Index n) { return k == 0 || 2 * k == n ? 1.0 : 2.0; };
    double sum = 0;
    for (Index i = 0; i < q.rows(); ++i)
      for (Index j = 0; j < q.cols(); ++j)
        if (q(i, j) > 0) sum += images(i, torus.nx) * images(j, torus.ny) / q(i, j);
    return sum / static_cast<double>(torus.cells());
  }

  Grid grid_;
  double modulus_;
  int threads_;
  double self_;
  EvenConvolution influence_, inverse_;
};

}  // namespace

double love_integral(double x, double y, double a, double b) {
  x = std::abs(x);
  y = std::abs(y);
  const double r2 = x * x + y * y, size = 2 * std::max(a, b), near = 20 * size, far = 80 * size;
  if (r2 < near * near) return closed_form(x, y, a, b);
  return r2 < far * far ? gauss_rule(gauss4, x, y, a, b) : gauss_rule(gauss3, x, y, a, b);
}

std::unique_ptr<ElasticOperator> make_influence(const Grid& grid, double composite_modulus, int threads) {
  if (grid.periodic) return std::make_unique<PeriodicHalfSpace>(grid, composite_modulus, threads);
  return std::make_unique<HalfSpace>(grid.shape, love_coefficients(grid, composite_modulus, threads),
                                     threads);
}

}  // namespace asperity
