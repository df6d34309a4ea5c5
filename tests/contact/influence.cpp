#include "contact/influence.hpp"

#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Love's integral as it stands in textbooks, in long double: loses ε (r/a)² of 1e-19.
long double textbook(long double x, long double y, long double a, long double b) {
  auto f = [](long double u, long double v) {
    return (u == 0 ? 0 : u * std::asinh(v / std::abs(u))) + (v == 0 ? 0 : v * std::asinh(u / std::abs(v)));
  };
  return f(x + a, y + b) - f(x - a, y + b) - f(x + a, y - b) + f(x - a, y - b);
}

double inner(const Field& p, const Field& q) { return (p * q).sum(); }

Field applied(ElasticOperator& k, const Field& p) {
  Field u;
  k.apply(p, u);
  return u;
}

Grid oblong(Shape shape, bool periodic = false) { return {shape, 2e-6, 5e-6, periodic}; }

}  // namespace

// The textbook form in long double errs by 1e-19 (r/a)² ≤ 1e-14 within 300 half sides.
TEST_CASE("Love's integral is right to 1e-12 near the cell for any aspect", "[influence][exact]") {
  for (double b : {0.02, 0.3, 1.0, 50.0})
    for (double x : {0.0, 0.5, 1.0, 2.0, 7.0, 40.0, 150.0})
      for (double y : {0.0, 0.25, 1.0, 2.0, 8.0, 38.0, 200.0}) {
        CAPTURE(b, x, y);
        const double exact = static_cast<double>(textbook(x, y, 1, b));
        CHECK(relative_error(love_integral(x, y, 1, b), exact) <= 1e-12);
      }
}

// The displacements of the quarters add up to that of the whole, although a quarter is twice as far away in
// units of its size and takes another rule.
TEST_CASE("Love's integral is the sum of its quarters' at any distance up to 16000 cells",
          "[influence][law]") {
  for (double b : {0.02, 1.0, 50.0})
    for (double r : {0.0, 3.0, 39.0, 41.0, 79.0, 159.0, 161.0, 1e3, 4e3, 3.2e4})
      for (double angle : {0.0, 0.01, 0.7, 1.57}) {
        const double x = r * std::cos(angle), y = r * std::sin(angle);
        double sum = 0;
        for (double sx : {-0.5, 0.5})
          for (double sy : {-0.5, 0.5}) sum += love_integral(x + sx, y + sy * b, 0.5, b / 2);
        CAPTURE(b, r, angle);
        CHECK(relative_error(love_integral(x, y, 1, b), sum) <= 1e-12);
      }
}

// 1/r expanded over the cell: 4ab/r [1 + (a²(3x²/r² - 1) + b²(3y²/r² - 1))/6r² + O((a/r)⁴)], the rest below
// (a/r)⁴ = 1e-8.
TEST_CASE("far away a cell acts as a point load with a quadrupole", "[influence][order]") {
  const double a = 1, b = 0.7, r = 100;
  for (double angle : {0.0, 0.4, 0.9, 1.5}) {
    const double x = r * std::cos(angle), y = r * std::sin(angle), c = x * x / (r * r), s = y * y / (r * r);
    const double quadrupole = (a * a * (3 * c - 1) + b * b * (3 * s - 1)) / (6 * r * r);
    CHECK(std::abs(love_integral(x, y, a, b) * r / (4 * a * b) - 1 - quadrupole) <= 1e-8);
  }
}

TEST_CASE("Love's integral does not change when a coordinate changes its sign", "[influence][law]") {
  for (double x : {0.3, 1.0, 500.0}) {
    const double value = love_integral(x, 2, 1, 0.5);
    CHECK(love_integral(-x, 2, 1, 0.5) == value);
    CHECK(love_integral(x, -2, 1, 0.5) == value);
  }
}

// The transforms add ε log2(P) of max|K| Σ|p|.
TEST_CASE("the half-space's displacement equals the direct sum of Love's coefficients",
          "[influence][exact]") {
  for (Shape shape : {Shape{1, 1}, Shape{1, 9}, Shape{12, 7}, Shape{15, 16}}) {
    const Grid grid = oblong(shape);
    const auto k = make_influence(grid, modulus);
    const Field p = random_field(shape, 1), u = applied(*k, p);
    auto direct = [&](Index i, Index j) {
      double sum = 0;
      for (Index s = 0; s < shape.nx; ++s)
        for (Index t = 0; t < shape.ny; ++t)
          sum += p(s, t) / (pi * modulus) *
                 love_integral(static_cast<double>(i - s) * grid.dx, static_cast<double>(j - t) * grid.dy,
                               grid.dx / 2, grid.dy / 2);
      return sum;
    };
    const Field exact = Field::NullaryExpr(shape.nx, shape.ny, direct);
    CAPTURE(shape.nx, shape.ny);
    CHECK((u - exact).abs().maxCoeff() <= 8 * epsilon * k->self_influence() * (1 + p.abs().sum()));
  }
}

TEST_CASE("influence and preconditioner are symmetric and positive", "[influence][law]") {
  for (bool periodic : {false, true})
    for (Shape shape : {Shape{16, 16}, Shape{21, 34}}) {
      const auto k = make_influence(oblong(shape, periodic), modulus);
      Field p = random_field(shape, 2), q = random_field(shape, 3), mp, mq;
      p -= p.mean();
      q -= q.mean();
      const Field kp = applied(*k, p), kq = applied(*k, q);
      k->precondition(p, mp);
      k->precondition(q, mq);
      const auto cells = static_cast<double>(shape.cells());
      CHECK(std::abs(inner(q, kp) - inner(p, kq)) <= 16 * epsilon * cells * kp.abs().maxCoeff());
      CHECK(std::abs(inner(q, mp) - inner(p, mq)) <= 16 * epsilon * cells * mp.abs().maxCoeff());
      CHECK(inner(p, kp) > 0);
      CHECK(inner(p, mp) > 0);
    }
}

// What the header states, twice.
TEST_CASE("from 256² cells on single precision errs by 1e-6 of the largest displacement",
          "[influence][law]") {
  const Shape shape{256, 300};
  for (bool periodic : {false, true}) {
    const auto k = make_influence(oblong(shape, periodic), modulus);
    const Field p = random_field(shape, 5).abs(), exact = applied(*k, p);
    Field u = p;
    k->apply_single(u, u);
    const double error = (u - exact).abs().maxCoeff() / exact.abs().maxCoeff();
    CHECK(error <= 1e-6);
    CHECK(error > 1e-9);
  }
}

TEST_CASE("a pressure wave on a periodic surface displaces it by 2/(E* q) of itself", "[influence][exact]") {
  for (Shape shape : {Shape{32, 24}, Shape{15, 9}}) {
    const Grid grid = oblong(shape, true);
    const double qx = 2 * pi * 3 / grid.size_x(), qy = 2 * pi * 2 / grid.size_y();
    const Field p = sample(grid, [&](double x, double y) { return std::cos(qx * x - qy * y); });
    const auto k = make_influence(grid, modulus);
    const Field u = applied(*k, p), exact = 2 / (modulus * std::hypot(qx, qy)) * p;
    CHECK((u - exact).abs().maxCoeff() <= 32 * epsilon * exact.abs().maxCoeff());
  }
}

TEST_CASE("the periodic preconditioner is the inverse on pressures of zero sum", "[influence][exact]") {
  const Shape shape{20, 33};
  const auto k = make_influence(oblong(shape, true), modulus);
  Field p = random_field(shape, 4), back;
  p -= p.mean();
  k->precondition(applied(*k, p), back);
  // Its condition is the ratio of the largest wave number to the least, here 43.
  CHECK((back - p).abs().maxCoeff() <= 43 * 16 * epsilon);
}

TEST_CASE("coarsening an influence equals making it on the coarse cells", "[influence][exact]") {
  for (bool periodic : {false, true}) {
    const Grid fine = oblong({24, 40}, periodic), coarse{{12, 20}, 2 * fine.dx, 2 * fine.dy, periodic};
    const auto derived = make_influence(fine, modulus)->coarsened(2), made = make_influence(coarse, modulus);
    const Field p = random_field(coarse.shape, 5);
    CHECK((applied(*derived, p) - applied(*made, p)).abs().maxCoeff() <=
          16 * epsilon * made->self_influence() * p.abs().sum());
    CHECK(derived->self_influence() == Approx(made->self_influence()).epsilon(4 * epsilon));
  }
}
