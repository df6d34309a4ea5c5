/// Points, layers, sections and the search have one field, of a free load and of a periodic one.
#include "stress/points.hpp"

#include <numbers>

#include "core/error.hpp"
#include "layer.hpp"
#include "stress/influence.hpp"
#include "stress/layers.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;
using stress::Tensor;

namespace {

constexpr double pi = std::numbers::pi, nu = 0.3;

double difference(const Tensor& a, const Tensor& b) {
  double top = 0;
  for (auto c : stress::components) top = std::max(top, std::abs(a[c] - b[c]));
  return top;
}

// A mode's amplitude is at most the mean |p|; transforms and the sum over all modes leave 16 ε of their sum.
double round_off(const Field& p) { return 32 * epsilon * p.abs().sum(); }

}  // namespace

// stress_at summed the cells of one period alone: under a pressure that covers it -175 MPa in place of the
// layers' -500.
TEST_CASE(
    "at cell centres the stress at points is that of the layers, periodic or not, with and without friction",
    "[points][exact][slow]") {
  for (Shape shape : {Shape{1, 1}, Shape{1, 9}, Shape{8, 1}, Shape{2, 2}, Shape{7, 5}, Shape{16, 10}})
    for (bool periodic : {false, true})
      for (const Friction& friction : {Friction{}, Friction{0.35, 0.6}, Friction{0.2, -2.0}}) {
        const Grid grid{shape, 0.3, 0.5, periodic};
        const Field p = random_field(shape, 51);
        const StressPoints points({grid, p, nu, friction});
        const StressSolver solver({grid, p, nu, friction});
        for (double z : {0.0, 0.07, 1.1, 40.0, 1e4}) {
          const TensorField whole = layer(solver, z);
          double error = 0;
          for (Index i = 0; i < shape.nx; ++i)
            for (Index j = 0; j < shape.ny; ++j)
              error = std::max(error, difference(points.at(grid.x(i), grid.y(j), z), tensor_at(whole, i, j)));
          CAPTURE(shape.nx, shape.ny, periodic, friction.angle, z);
          CHECK(error <= round_off(p));
        }
      }
}

// Between the centres p = p0 + p1 cos(q x) is what the cells' pressures say. Plane strain [Johnson, Contact
// Mechanics, ch. 13]: σxx = -(1-qz) e cos, σzz = -(1+qz) e cos, σxz = -qz e sin, σyy = ν (σxx + σzz), e = p1
// exp(-qz); of p0 a body held at its sides bears ν/(1-ν) in x and y.
TEST_CASE("between the cells, too, the stress below a periodic wave and its mean is that of plane strain",
          "[points][exact]") {
  for (Index n : {7, 16})
    for (double poisson : {-0.5, 0.0, 0.3, 0.5}) {
      const Grid grid{{n, 3}, 0.25, 0.4, true};
      const double q = 2 * pi / grid.size_x(), p0 = 3, p1 = 2, held = -poisson / (1 - poisson) * p0;
      const Field p = sample(grid, [&](double x, double) { return p0 + p1 * std::cos(q * x); });
      const StressPoints points({grid, p, poisson});
      for (double z : {0.0, 0.2, 1.3, 50.0})
        for (double x : {-0.8, 0.0, 0.125, 0.31, 0.5 * grid.size_x(), 17.0}) {
          const double e = p1 * std::exp(-q * z), cosine = e * std::cos(q * x), sine = e * std::sin(q * x);
          const double xx = -(1 - q * z) * cosine, zz = -(1 + q * z) * cosine;
          const Tensor exact{xx + held, poisson * (xx + zz) + held, zz - p0, 0, -q * z * sine, 0};
          CAPTURE(n, poisson, x, z);
          CHECK(difference(points.at(x, 0.17, z), exact) <= 64 * epsilon * p.sum());
        }
    }
}

// A point on a side was none of its two cells', or one of both: σzz = 0 in place of -p, or -2 p, by the round-off
// of its distances from them. At z = 0 σzz = -p and (σxz, σyz) = -q hold as the means of the cells that meet;
// half a unit in the last place of the coordinates is 1e-16 of a cell, whose steps show at depth 0 only.
TEST_CASE("at the surface on sides and corners of cells the tractions are the means of those that meet there",
          "[points][exact]") {
  const Friction friction{0.3, 0.6};
  const double qx = 0.3 * std::cos(0.6), qy = 0.3 * std::sin(0.6);
  for (Periodic periodic : {Periodic{}, Periodic{true, false}, Periodic{false, true}})
    for (Shape shape : {periodic.any() ? Shape{4, 3} : Shape{13, 7}, Shape{1, 4}, Shape{5, 1}}) {
      const Grid grid{shape, 3e-3 / 128, 0.7e-3 / 3, periodic};
      const Field p = random_field(shape, 54).abs();
      const StressPoints points({grid, p, nu, friction});
      auto at = [&](Index i, Index j) {
        if (periodic.x) i = (i + shape.nx) % shape.nx;
        if (periodic.y) j = (j + shape.ny) % shape.ny;
        return i >= 0 && j >= 0 && i < shape.nx && j < shape.ny ? p(i, j) : 0;
      };
      auto check = [&](double x, double y, double mean) {
        const Tensor s = points.at(x, y, 0);
        CAPTURE(shape.nx, shape.ny, periodic.x, periodic.y, x, y, mean);
        const double bound = periodic.any() ? 1e-11 : 64 * epsilon * p.sum();
        CHECK(std::abs(s[stress::zz] + mean) <= bound);
        CHECK(std::abs(s[stress::xz] + qx * mean) <= bound);
        CHECK(std::abs(s[stress::yz] + qy * mean) <= bound);
      };
      for (Index i = 0; i <= shape.nx; ++i)
        for (Index j = 0; j <= shape.ny; ++j) {
          const double x = static_cast<double>(i) * grid.dx - grid.size_x() / 2,  // as typed
              y = (static_cast<double>(j) - static_cast<double>(shape.ny) / 2) * grid.dy;
          if (j < shape.ny) check(x, grid.y(j), (at(i - 1, j) + at(i, j)) / 2);
          if (i < shape.nx) check(grid.x(i), y, (at(i, j - 1) + at(i, j)) / 2);
          check(x, y, (at(i - 1, j - 1) + at(i, j - 1) + at(i - 1, j) + at(i, j)) / 4);
        }
    }
}

TEST_CASE("a mean traction is met by its own shear at any point, however deep", "[points][exact]") {
  const Grid grid{{6, 5}, 0.5, 0.4, true};
  const StressPoints points({grid, Field::Constant(6, 5, 2.0), nu, {0.25, pi / 6}});
  for (double z : {0.0, 3.0, 1e3, farthest}) {
    const Tensor exact{-2 * nu / (1 - nu), -2 * nu / (1 - nu), -2, 0, -0.5 * std::cos(pi / 6), -0.25};
    CHECK(difference(points.at(0.3, -0.1, z), exact) <= 32 * epsilon * 60);
  }
}

TEST_CASE("a periodic pressure shifted by whole cells shifts the stress at points, and a period leaves it",
          "[points][law]") {
  const Grid grid{{12, 9}, 0.5, 0.4, true};
  const Field p = random_field(grid.shape, 52).abs();
  const Friction friction{0.3, 2.5};
  const StressPoints points({grid, p, nu, friction}), moved({grid, shifted(p, 5, 7), nu, friction});
  for (double z : {0.0, 0.3, 6.0})
    for (auto [x, y] : {std::array{0.0, 0.0}, std::array{0.25, -0.2}, std::array{2.9, 1.77}}) {
      const Tensor here = points.at(x, y, z);
      CHECK(difference(here, moved.at(x - 5 * grid.dx, y - 7 * grid.dy, z)) <= round_off(p));
      CHECK(difference(here, points.at(x + 3 * grid.size_x(), y - grid.size_y(), z)) <= round_off(p));
    }
}

// Modes of half the cells along an even side are those that tiling splits.
TEST_CASE("a periodic load tiled 2 x 2 or 3 x 1 leaves the stress at points, in layers and in sections",
          "[points][law]") {
  for (Shape shape : {Shape{8, 6}, Shape{5, 4}, Shape{1, 6}}) {
    const Grid grid{shape, 0.5, 0.4, true};
    const Field p = random_field(shape, 53).abs();
    const Friction friction{0.4, 0.7};
    const StressPoints points({grid, p, nu, friction});
    for (auto [in_x, in_y] : {std::array<Index, 2>{2, 2}, std::array<Index, 2>{3, 1}}) {
      const Grid wide{{in_x * shape.nx, in_y * shape.ny}, 0.5, 0.4, true};
      const Field q = p.replicate(in_x, in_y);
      const StressPoints tiles({wide, q, nu, friction});
      const double dx = wide.x(0) - grid.x(0), dy = wide.y(0) - grid.y(0), bound = round_off(q);
      for (double z : {0.0, 0.2, 3.0}) {
        for (auto [x, y] : {std::array{0.1, 0.2}, std::array{-0.25, 0.4}, std::array{1.9, -1.1}})
          CHECK(difference(points.at(x, y, z), tiles.at(x + dx, y + dy, z)) <= bound);
        const TensorField whole = layer(StressSolver({wide, q, nu, friction}), z);
        const Index i = wide.shape.nx - 1, j = wide.shape.ny - 1;
        CHECK(difference(points.at(wide.x(i) - dx, wide.y(j) - dy, z), tensor_at(whole, i, j)) <= bound);
        StressSolver({wide, q, nu, friction}, Plane{true, j})
            .layers({z}, stress::all, [&](Index, Index, const StressRow& row) {
              for (Index k = 0; k < wide.shape.nx; ++k)
                for (auto c : stress::components)
                  CHECK(std::abs(row[c][k] - points.at(wide.x(k) - dx, wide.y(j) - dy, z)[c]) <= bound);
            });
      }
    }
  }
}

namespace {

struct Wave {
  Grid grid;
  Index kx, ky;

  double qx() const { return 2 * std::numbers::pi * static_cast<double>(kx) / grid.size_x(); }
  double qy() const { return 2 * std::numbers::pi * static_cast<double>(ky) / grid.size_y(); }
  double phase(Index i, Index j) const { return qx() * grid.x(i) + qy() * grid.y(j); }
};

// Plane strain under p = cos(q n), n along the wave vector, t across it [Johnson, Contact Mechanics, ch. 13]:
// σnn = -(1-qz) e cos, σzz = -(1+qz) e cos, σnz = -qz e sin, σtt = ν (σnn + σzz), e = exp(-qz).
stress::Tensor closed_form(const Wave& wave, double z, Index i, Index j) {
  const double q = std::hypot(wave.qx(), wave.qy()), nx = wave.qx() / q, ny = wave.qy() / q,
               e = std::exp(-q * z);
  const double cosine = std::cos(wave.phase(i, j)), sine = std::sin(wave.phase(i, j));
  const double nn = -(1 - q * z) * e * cosine, zz = -(1 + q * z) * e * cosine, nz = -q * z * e * sine,
               tt = nu * (nn + zz);
  return {
      nn * nx * nx + tt * ny * ny, nn * ny * ny + tt * nx * nx, zz, (nn - tt) * nx * ny, nz * nx, nz * ny};
}

}  // namespace

// One mode of unit amplitude: the transforms leave ε log2(cells), below 16 ε, of Σ|p|/cells ≤ 1 each way.
TEST_CASE("below a periodic pressure wave the stress is that of plane strain, in every direction of the wave",
          "[periodic][exact]") {
  for (Wave wave : {Wave{{{16, 12}, 0.2, 0.3, true}, 1, 0}, Wave{{{16, 12}, 0.2, 0.3, true}, 0, 5},
                    Wave{{{15, 21}, 0.2, 0.1, true}, 3, 4}, Wave{{{1, 9}, 1.0, 0.2, true}, 0, 2}}) {
    const Grid& grid = wave.grid;
    Field p(grid.shape.nx, grid.shape.ny);
    for (Index i = 0; i < p.rows(); ++i)
      for (Index j = 0; j < p.cols(); ++j) p(i, j) = std::cos(wave.phase(i, j));
    const StressSolver solver({grid, p, nu});
    for (double z : {0.0, 0.1, 0.8}) {
      const TensorField field = layer(solver, z);
      double error = 0;
      for (Index i = 0; i < p.rows(); ++i)
        for (Index j = 0; j < p.cols(); ++j) {
          const stress::Tensor exact = closed_form(wave, z, i, j);
          for (auto c : stress::components) error = std::max(error, std::abs(field[c](i, j) - exact[c]));
        }
      CAPTURE(wave.kx, wave.ky, z);
      CHECK(error <= 32 * epsilon);
    }
  }
}

TEST_CASE("a uniform pressure on a periodic half-space is borne by a body held at its sides, at every depth",
          "[periodic][exact]") {
  const Grid grid{{8, 10}, 0.5, 0.4, true};
  const StressSolver solver({grid, Field::Constant(8, 10, 2.0), nu});
  for (double z : {0.0, 3.0, 1e3}) {
    const TensorField field = layer(solver, z);
    CHECK((field[stress::zz] + 2).abs().maxCoeff() <= 32 * epsilon);
    CHECK((field[stress::xx] + 2 * nu / (1 - nu)).abs().maxCoeff() <= 32 * epsilon);
    CHECK((field[stress::yy] + 2 * nu / (1 - nu)).abs().maxCoeff() <= 32 * epsilon);
    for (auto c : {stress::xy, stress::xz, stress::yz}) CHECK(field[c].abs().maxCoeff() <= 32 * epsilon);
  }
}

TEST_CASE("a shifted periodic pressure gives the shifted stress", "[periodic][law]") {
  const Grid grid{{12, 10}, 0.5, 0.4, true};
  const Field p = random_field(grid.shape, 31);
  const TensorField s = layer(StressSolver({grid, p, nu}), 0.2),
                    t = layer(StressSolver({grid, shifted(p, 5, 3), nu}), 0.2);
  for (auto c : stress::components) CHECK((shifted(s[c], 5, 3) - t[c]).abs().maxCoeff() <= 32 * epsilon);
}
