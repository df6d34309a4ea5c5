// Bodies that repeat along one axis: their influence, and line contact.
#include "contact/repeated_cell.hpp"
#include "contact/windowed.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr Periodic along_x{true, false}, along_y{false, true};

Field applied(ElasticOperator& k, const Field& p) {
  Field u;
  k.apply(p, u);
  return u;
}

Grid oblong(Shape shape, Periodic periodic) { return {shape, 2e-6, 5e-6, periodic}; }

// (2) over |m| ≤ N: off by O(1/R²), R = (N + ½) L.
double image_sum(double x, double y, double a, double b, double length, double datum, int N) {
  double sum = 0;
  for (int m = N; m > 0; --m)
    sum += love_integral(x + m * length, y, a, b) + love_integral(x - m * length, y, a, b);
  return sum + love_integral(x, y, a, b) - 8 * a * b / length * std::log((2 * N + 1) * length / datum);
}

// Two such sums without their common error; what is left is (r/R)⁴.
double all_images(double x, double y, double a, double b, double length, double datum) {
  const int few = 10000, many = 20000;
  const double less = std::pow(few + 0.5, 2), more = std::pow(many + 0.5, 2);
  return (more * image_sum(x, y, a, b, length, datum, many) -
          less * image_sum(x, y, a, b, length, datum, few)) /
         (more - less);
}

// Cylinders along an axis of the domain, radius 10 mm.
Bodies cylinders(Periodic periodic) {
  return {.radius = {periodic.x ? Radii(infinity, 10e-3) : Radii(10e-3, infinity)}};
}

// As many cells along the axis as `length`, n across; the contact of 100 N/mm fills 0.44 of the domain.
Grid line_grid(Index length, Index n, Periodic periodic) {
  const double across = 1e-3 / static_cast<double>(n);
  return periodic.x ? Grid{{length, n}, 2e-5, across, periodic} : Grid{{n, length}, across, 2e-5, periodic};
}

Contact press_line(const Grid& grid, const Bodies& bodies, double per_length) {
  const double length = grid.periodic.x ? grid.size_x() : grid.size_y();
  return solve_contact(grid, undeformed_gap(grid, bodies), modulus,
                       {.load = per_length * length, .tolerance = 1e-10});
}

}  // namespace

// 40 000 terms of up to S(0, 0) round to 1e-13 of it or so; (r/R)⁴ ≤ 1e-13 within 10 periods.
TEST_CASE("a repeated cell's displacement is the sum over its images to 1e-12", "[line][exact]") {
  struct Case {
    double a, b;
    Index period;
  };
  for (const auto& [a, b, period] : {Case{1, 1, 64}, {1, 0.1, 7}, {1, 8, 10}, {1, 3, 1}, {1, 40, 2}}) {
    const double length = 2 * a * static_cast<double>(period), datum = 17;
    const Index rows = 1 + static_cast<Index>(5 * length / b);
    const RepeatedCell cell(a, b, period, rows, datum);
    for (Index i : {Index{0}, period / 3, period / 2})
      for (Index j : {Index{0}, std::min<Index>(1, rows - 1), rows / 5, rows - 1}) {
        CAPTURE(a, b, period, i, j);
        const double exact =
            all_images(2 * a * static_cast<double>(i), 2 * b * static_cast<double>(j), a, b, length, datum);
        CHECK(std::abs(cell(i, j) - exact) <= 1e-12 * love_integral(0, 0, a, b));
      }
  }
}

// Round-off of `period` terms.
TEST_CASE("a row of repeated cells displaces as a strip in plane strain, logarithm and datum",
          "[line][exact]") {
  for (Index period : {1, 9, 64})
    for (double b : {0.2, 1.0, 6.0}) {
      const double a = 1, datum = 12;
      const RepeatedCell cell(a, b, period, 200, datum);
      auto edge = [&](double y) { return y == 0 ? 0 : y * std::log(std::abs(y) / datum); };
      for (Index j : {0, 1, 5, 199}) {
        const double y = 2 * b * static_cast<double>(j), strip = -2 * (edge(y + b) - edge(y - b) - 2 * b);
        double sum = 0, largest = 0;
        for (Index i = 0; i < period; ++i) {
          sum += cell(std::min(i, period - i), j);
          largest = std::max(largest, std::abs(cell(std::min(i, period - i), j)));
        }
        CAPTURE(period, b, j);
        CHECK(std::abs(sum - strip) <= 1e-12 * (largest + love_integral(0, 0, a, b)));
      }
    }
}

TEST_CASE("along a periodic axis pressures act around the domain, across it they do not", "[line][exact]") {
  for (Periodic periodic : {along_x, along_y})
    for (Shape shape : {Shape{1, 1}, Shape{1, 9}, Shape{9, 1}, Shape{12, 7}, Shape{15, 16}}) {
      const Grid grid = oblong(shape, periodic);
      const auto k = make_influence(grid, modulus);
      const Field p = random_field(shape, 1), u = applied(*k, p);
      const Index nx = shape.nx, ny = shape.ny;
      const RepeatedCell cell = periodic.x ? RepeatedCell(1e-6, 2.5e-6, nx, ny, grid.size_y() / 2)
                                           : RepeatedCell(2.5e-6, 1e-6, ny, nx, grid.size_x() / 2);
      auto around = [](Index lag, Index n) { return std::min(std::abs(lag), n - std::abs(lag)); };
      const Field exact = Field::NullaryExpr(nx, ny, [&](Index i, Index j) {
        double sum = 0;
        for (Index s = 0; s < nx; ++s)
          for (Index t = 0; t < ny; ++t)
            sum += p(s, t) * (periodic.x ? cell(around(i - s, nx), std::abs(j - t))
                                         : cell(around(j - t, ny), std::abs(i - s)));
        return sum / (pi * modulus);
      });
      CAPTURE(nx, ny, periodic.x);
      CHECK((u - exact).abs().maxCoeff() <=
            8 * epsilon * std::abs(k->self_influence()) * (1 + p.abs().sum()));
    }
}

TEST_CASE("influence and preconditioner of a repeating strip are symmetric and positive, also under a mean",
          "[line][law]") {
  for (Periodic periodic : {along_x, along_y})
    for (Shape shape : {Shape{16, 16}, Shape{21, 34}, Shape{1, 40}, Shape{64, 8}}) {
      const auto k = make_influence(oblong(shape, periodic), modulus);
      const Field p = random_field(shape, 2), q = random_field(shape, 3) + 1;
      const Field kp = applied(*k, p), kq = applied(*k, q);
      Field mp, mq;
      k->precondition(p, mp);
      k->precondition(q, mq);
      const auto cells = static_cast<double>(shape.cells());
      CAPTURE(shape.nx, shape.ny, periodic.x);
      CHECK(std::abs((q * kp).sum() - (p * kq).sum()) <=
            16 * epsilon * cells * std::max(kp.abs().maxCoeff(), kq.abs().maxCoeff()));
      CHECK(std::abs((q * mp).sum() - (p * mq).sum()) <=
            16 * epsilon * cells * std::max(mp.abs().maxCoeff(), mq.abs().maxCoeff()));
      CHECK((p * kp).sum() > 0);
      CHECK((q * kq).sum() > 0);
      CHECK((q * mq).sum() > 0);
    }
}

TEST_CASE("coarse cells and windows of a repeating strip keep its datum", "[line][exact]") {
  for (Periodic periodic : {along_x, along_y}) {
    const Grid fine = oblong({48, 40}, periodic), coarse{{24, 20}, 2 * fine.dx, 2 * fine.dy, periodic};
    const auto body = make_influence(fine, modulus);
    const auto derived = body->coarsened(2), made = make_influence(coarse, modulus);
    const Field p = random_field(coarse.shape, 5);
    CHECK((applied(*derived, p) - applied(*made, p)).abs().maxCoeff() <=
          16 * epsilon * made->self_influence() * p.abs().sum());

    const auto part = body->windowed({9, 10});
    REQUIRE(part);
    CHECK((periodic.x ? part->shape().nx : part->shape().ny) == (periodic.x ? 48 : 40));
    const ContactWindow window{{periodic.x ? 0 : 20, part->shape().nx},
                               {periodic.x ? 20 : 0, part->shape().ny}};
    Field all = Field::Zero(48, 40);
    const Slabs slabs = body->slabs(), within = part->slabs();
    window.put(random_waves(window.shape(), 1), within, all, slabs);
    const Field u = applied(*body, all);
    const auto inside = [&](const Field& f) { return window.of(f, slabs, within); };
    CHECK((inside(u) - applied(*part, inside(all))).abs().maxCoeff() <= 1e-13 * u.abs().maxCoeff());
  }
}

TEST_CASE("a strip of two periods is that of one, twice", "[line][law]") {
  const Grid one{{24, 32}, 1e-5, 1.5e-5, along_x}, two{{48, 32}, 1e-5, 1.5e-5, along_x};
  const Field gap =
      sample(one, [](double, double y) { return y * y / (2 * 5e-3); }) - 2e-7 * random_waves(one.shape, 3);
  Field twice(48, 32);
  twice << gap, gap;
  const Contact a = solve_contact(one, gap, modulus, {.load = 3, .tolerance = 1e-11}),
                b = solve_contact(two, twice, modulus, {.load = 6, .tolerance = 1e-11});
  CHECK((b.pressure.topRows(24) - a.pressure).abs().maxCoeff() <= 1e-8 * a.max_pressure);
  CHECK(b.approach == Approx(a.approach).epsilon(1e-9));
}
// Measured, with n cells across the contact: p₀ off by -0.15…-0.56 /n², as the edge falls between the cells,
// b = 2√⟨y²⟩ by 0.4/n² at most, δ by 0.17/n²; the profile in L2 by 0.16…0.39 /n, the edge's.
TEST_CASE("a cylinder's line contact converges to Hertz's at order 2 with its constant",
          "[line][hertz][order]") {
  const double q = 1e5;  // N/m
  for (Periodic periodic : {along_x, along_y})
    for (Index n : {64, 128, 256, 512, 1024}) {
      const Grid grid = line_grid(periodic.x ? 8 : 64, n, periodic);
      const Bodies bodies = cylinders(periodic);
      const Contact contact = press_line(grid, bodies, q);
      const Field p = periodic.x ? contact.pressure : Field(contact.pressure.transpose());
      const auto [b, p0, approach] =
          hertz_line(grid, bodies, q * (periodic.x ? grid.size_x() : grid.size_y()));
      const double step = 1e-3 / static_cast<double>(n), cells = 2 * b / step;
      double second = 0, square = 0;
      for (Index j = 0; j < n; ++j) {
        const double y = (static_cast<double>(j) + 0.5) * step - 0.5e-3, t = y / b;
        second += p(0, j) * y * y * step / q;
        square += std::pow(p(0, j) / p0 - (t * t < 1 ? std::sqrt(1 - t * t) : 0), 2) * step / b;
      }
      CAPTURE(periodic.x, n, cells, contact.levels);
      CHECK(std::abs(contact.max_pressure / p0 - 1 + 0.4 / (cells * cells)) <= 0.2 / (cells * cells));
      CHECK(std::abs(2 * std::sqrt(second) / b - 1) <= 0.5 / (cells * cells));
      CHECK(std::abs(contact.approach / approach - 1) <= 0.2 / (cells * cells));
      CHECK(std::sqrt(square) <= 0.4 / cells);
      CHECK((p.rowwise() - p.row(0)).abs().maxCoeff() <= 1e-9 * p0);  // uniform but for ε = 1e-10
    }
}

// Of a cylinder as long as the domain, b/length = 0.08: at its ends the pressure grows without end with the
// grid (Johnson, section 5.4), where a repeating one has Hertz's.
TEST_CASE("a cylinder that ends has spikes there, one that repeats has none", "[line][law]") {
  const Bodies bodies = cylinders(along_x);
  Grid grid{{64, 64}, 2e-5, 0.5e-3 / 64, along_x};
  const double q = 1e5, load = q * grid.size_x(), p0 = hertz_line(grid, bodies, load).pressure;
  CHECK(press(grid, undeformed_gap(grid, bodies), {.load = load}).max_pressure == Approx(p0).epsilon(1e-3));
  grid.periodic = {};
  const Contact ended = press(grid, undeformed_gap(grid, bodies), {.load = load});
  CHECK(ended.max_pressure > 1.3 * p0);
  CHECK(ended.pressure(32, 32) < 1.05 * p0);
  CHECK(ended.max_pressure ==
        std::max(ended.pressure.row(0).maxCoeff(), ended.pressure.row(63).maxCoeff()));  // alike to rounding
}

// Every other along x, half with a limit pressure, half sunk by the approach that a load had before.
TEST_CASE("40 random strips end at a residual of 1e-8 within bounds and load, and again by their approach",
          "[line][law]") {
  for (unsigned k = 0; k < 40; ++k) {
    std::mt19937_64 generator(k);
    auto decade = [&](double a, double b) {
      return std::pow(10, std::uniform_real_distribution<double>(a, b)(generator));
    };
    const Shape shape{k % 3 == 0 ? 64 : 27, k % 5 == 0 ? 32 : 64};
    const Periodic periodic = k % 2 == 0 ? along_x : along_y;
    const Grid grid{shape, 2e-5, k % 4 == 1 ? 2e-5 * decade(-1.5, 1.5) : 2e-5, periodic};
    const double curvature = k % 7 == 0 ? 0 : 1 / decade(-2.5, 0), rms = decade(-8, -6);
    const Field round =
        sample(grid, [&](double x, double y) { return curvature / 2 * (periodic.x ? y * y : x * x); });
    const Field gap = round - rms * random_waves(shape, k);
    ContactParameters parameters{.load = decade(-2, 3), .tolerance = 1e-8};
    if (k % 4 < 2)
      parameters.limit_pressure = parameters.load / (grid.size_x() * grid.size_y()) * (1 + decade(-2, 1));
    const Contact contact = solve_contact(grid, gap, modulus, parameters);
    CAPTURE(k, contact.reason, contact.convolutions);
    CHECK(contact.residual <= 1e-8);
    CHECK(contact.load_residual <= 1e-12);
    CHECK(contact.pressure.minCoeff() >= 0);
    CHECK(contact.pressure.maxCoeff() <= parameters.limit_pressure);
    if (contact.plastic_area >= 0.9999 * grid.size_x() * grid.size_y()) continue;  // δ is any
    const Contact sunk = solve_contact(
        grid, gap, modulus,
        {.approach = contact.approach, .limit_pressure = parameters.limit_pressure, .tolerance = 1e-8});
    CHECK(relative_error(sunk.load, contact.load) <= 1e-4);
  }
}
