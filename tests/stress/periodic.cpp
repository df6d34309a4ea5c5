#include <numbers>

#include "layer.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double nu = 0.3;

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
