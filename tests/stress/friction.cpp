#include <numbers>

#include "core/error.hpp"
#include "layer.hpp"
#include "reference/hertz_stress.hpp"
#include "stress/influence.hpp"
#include "stress/load.hpp"
#include "stress/points.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;
using stress::Tensor;

namespace {

constexpr double pi = std::numbers::pi, nu = 0.3;
const std::array directions{0.0, pi / 2, pi / 6, -2.0};

StressSolver sliding_hertz(const Grid& grid, const Friction& friction, double poisson = nu) {
  return StressSolver({grid, hertz_pressure(grid), poisson, friction});
}

}  // namespace

TEST_CASE("along an axis only one traction acts", "[friction][contract]") {
  for (int quarter = -4; quarter <= 4; ++quarter)
    CHECK(acting(Friction{0.2, quarter * pi / 2}.weights()).count() == 2);
  CHECK(acting(Friction{0.2, 0.3}.weights()).count() == 3);
  CHECK(acting(Friction{0, 0.3}.weights()).count() == 1);
}

TEST_CASE("friction that is negative or no number, or beyond a turn, is refused", "[friction][contract]") {
  const Grid grid = hertz_grid(8);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(sliding_hertz(grid, {-0.1, 0}), ParameterError);
  CHECK_THROWS_AS(sliding_hertz(grid, {nan, 0}), ParameterError);
  CHECK_THROWS_AS(sliding_hertz(grid, {0.1, nan}), ParameterError);
  CHECK_THROWS_AS(sliding_hertz(grid, {0.1, 2.001 * pi}), ParameterError);
  CHECK_NOTHROW(sliding_hertz(grid, {0.1, -360 * (pi / 180)}));
}

// Round-off as of a layer without friction (layers.cpp), for each traction.
TEST_CASE("a layer under friction is the direct sum over the loaded cells", "[friction][exact][slow]") {
  for (Shape shape : {Shape{1, 1}, Shape{1, 9}, Shape{6, 1}, Shape{2, 2}, Shape{7, 5}, Shape{19, 10}})
    for (double z : {0.0, 0.07, 1.1, 9.0})
      for (double angle : directions) {
        const Grid grid{shape, 0.3, 0.5};
        const Field p = random_field(shape, 41);
        const Friction friction{0.35, angle};
        const TensorField computed = layer(StressSolver({grid, p, nu, friction}), z);
        const StressPoints direct({grid, p, nu, friction});
        double error = 0;
        for (Index i = 0; i < shape.nx; ++i)
          for (Index j = 0; j < shape.ny; ++j) {
            const Tensor s = direct.at(grid.x(i), grid.y(j), z);
            for (auto c : stress::components) error = std::max(error, std::abs(computed[c](i, j) - s[c]));
          }
        CAPTURE(shape.nx, shape.ny, z, angle);
        CHECK(error <= 32 * epsilon * p.abs().sum());
      }
}

TEST_CASE("without friction the bits are those of the pressure alone", "[friction][exact]") {
  const Grid grid{{20, 13}, 0.4, 0.3};
  const Field p = random_field(grid.shape, 42);
  CHECK(difference(layer(StressSolver({grid, p, nu}), 0.5),
                   layer(StressSolver({grid, p, nu, {0, 0.7}}), 0.5)) == 0);
}

TEST_CASE("the stress is linear in the coefficient of friction, and a turn by pi reverses its part",
          "[friction][law]") {
  const Grid grid{{20, 13}, 0.4, 0.3};
  const Field p = random_field(grid.shape, 43);
  auto at = [&](double mu, double angle) { return layer(StressSolver({grid, p, nu, {mu, angle}}), 0.5); };
  const TensorField none = at(0, 0), some = at(0.2, 0.4), twice = at(0.4, 0.4), back = at(0.2, 0.4 + pi);
  const double bound = 64 * epsilon * p.abs().sum();
  for (auto c : stress::components) {
    CHECK((twice[c] - 2 * some[c] + none[c]).abs().maxCoeff() <= bound);
    CHECK((some[c] + back[c] - 2 * none[c]).abs().maxCoeff() <= bound);
  }
}

TEST_CASE("exchanging x and y turns friction along x into friction along y", "[friction][law]") {
  const Grid grid{{20, 13}, 0.4, 0.3}, turned{{13, 20}, 0.3, 0.4};
  const Field p = random_field(grid.shape, 44);
  for (double angle : directions) {
    const TensorField s = layer(StressSolver({grid, p, nu, {0.3, angle}}), 0.5);
    const TensorField t = layer(StressSolver({turned, p.transpose(), nu, {0.3, pi / 2 - angle}}), 0.5);
    for (auto c : stress::components)
      CHECK((t[c].transpose() - s[stress::exchanged(c)]).abs().maxCoeff() <= 32 * epsilon * p.abs().sum());
  }
}

TEST_CASE("at the surface the layer holds the pressure and the traction", "[friction][exact]") {
  const Grid grid{{20, 13}, 0.4, 0.3};
  const Field p = random_field(grid.shape, 45);
  const double bound = 32 * epsilon * p.abs().sum();
  for (double angle : directions) {
    const TensorField surface = layer(StressSolver({grid, p, nu, {0.3, angle}}), 0);
    CHECK((surface[stress::zz] + p).abs().maxCoeff() <= bound);
    CHECK((surface[stress::xz] + 0.3 * std::cos(angle) * p).abs().maxCoeff() <= bound);
    CHECK((surface[stress::yz] + 0.3 * std::sin(angle) * p).abs().maxCoeff() <= bound);
  }
}

// One loaded cell: by reciprocity the sum over the layer is the stress in the middle of a wholly loaded
// domain.
TEST_CASE("a layer carries the tangential force, less what passes beside the domain", "[friction][exact]") {
  const Grid grid{{33, 21}, 0.2, 0.3};
  Field p = Field::Zero(33, 21);
  p(16, 10) = 1;
  for (double z : {0.0, 0.5, 2.0, 20.0}) {
    const TensorField field = layer(StressSolver({grid, p, nu, {1, pi / 4}}), z);
    for (auto [c, t] : {std::pair{stress::xz, stress::shear_x}, std::pair{stress::yz, stress::shear_y}}) {
      const double whole = rectangle_stress(0, 0, z, grid.size_x() / 2, grid.size_y() / 2, nu, t)[c];
      CHECK(std::abs(field[c].sum() - whole / std::numbers::sqrt2) <= 693 * 32 * epsilon);
    }
  }
}

// Of a wave along n, the traction's part along n strains the plane (n, z), that across it, t, shears in
// planes t alone: with e = exp(-qz) and φ = q n,
//     σnn = -(2-qz) e sin φ, σzz = -qz e sin φ, σnz = -(1-qz) e cos φ, σtt = ν (σnn + σzz);
//     σtz = -e cos φ, σtn = -e sin φ.
TEST_CASE("below a periodic traction the stress is plane strain and antiplane shear", "[friction][exact]") {
  for (auto [kx, ky] : {std::pair{1, 0}, std::pair{0, 5}, std::pair{3, 4}, std::pair{5, 2}})
    for (double angle : directions) {
      const Grid grid{{16, 21}, 0.2, 0.1, true};
      const double qx = 2 * pi * kx / grid.size_x(), qy = 2 * pi * ky / grid.size_y(), q = std::hypot(qx, qy);
      const double nx = qx / q, ny = qy / q, mu = 0.4;
      const double along = mu * (std::cos(angle) * nx + std::sin(angle) * ny),
                   across = mu * (std::sin(angle) * nx - std::cos(angle) * ny);  // t = (-ny, nx)
      const Field p = sample(grid, [&](double x, double y) { return std::cos(qx * x + qy * y); });
      for (double z : {0.0, 0.1, 0.8}) {
        const TensorField with = layer(StressSolver({grid, p, nu, {mu, angle}}), z),
                          without = layer(StressSolver({grid, p, nu}), z);
        double error = 0;
        for (Index i = 0; i < 16; ++i)
          for (Index j = 0; j < 21; ++j) {
            const double phase = qx * grid.x(i) + qy * grid.y(j), e = std::exp(-q * z);
            const double sine = e * std::sin(phase), cosine = e * std::cos(phase);
            const double nn = -along * (2 - q * z) * sine, zz = -along * q * z * sine, tt = nu * (nn + zz),
                         nz = -along * (1 - q * z) * cosine, tz = -across * cosine, tn = -across * sine;
            const Tensor exact{nn * nx * nx + tt * ny * ny - 2 * tn * nx * ny,
                               nn * ny * ny + tt * nx * nx + 2 * tn * nx * ny,
                               zz,
                               (nn - tt) * nx * ny + tn * (nx * nx - ny * ny),
                               nz * nx - tz * ny,
                               nz * ny + tz * nx};
            for (auto c : stress::components)
              error = std::max(error, std::abs(with[c](i, j) - without[c](i, j) - exact[c]));
          }
        CAPTURE(kx, ky, angle, z);
        CHECK(error <= 64 * epsilon);
      }
    }
}

TEST_CASE("a uniform periodic traction is met by its own shear at every depth", "[friction][exact]") {
  const Grid grid{{8, 10}, 0.5, 0.4, true};
  const StressSolver with({grid, Field::Constant(8, 10, 2.0), nu, {0.25, pi / 6}});
  for (double z : {0.0, 3.0, 1e3}) {
    const TensorField field = layer(with, z);
    CHECK((field[stress::zz] + 2).abs().maxCoeff() <= 32 * epsilon);
    CHECK((field[stress::xz] + 0.5 * std::cos(pi / 6)).abs().maxCoeff() <= 32 * epsilon);
    CHECK((field[stress::yz] + 0.25).abs().maxCoeff() <= 32 * epsilon);
    CHECK(field[stress::xy].abs().maxCoeff() <= 32 * epsilon);
  }
}
