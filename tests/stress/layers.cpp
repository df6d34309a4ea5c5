#include "stress/layers.hpp"

#include <numbers>

#include "core/error.hpp"
#include "layer.hpp"
#include "reference/hertz_stress.hpp"
#include "stress/influence.hpp"
#include "stress/points.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;
using stress::Tensor;

namespace {

const Grid oblong{{20, 13}, 0.4, 0.3};

TensorField direct(const Grid& grid, const Field& pressure, double z, double nu) {
  TensorField out;
  for (auto& f : out) f.resize(grid.shape.nx, grid.shape.ny);
  const StressPoints points({grid, pressure, nu});
  for (Index i = 0; i < grid.shape.nx; ++i)
    for (Index j = 0; j < grid.shape.ny; ++j) {
      const Tensor s = points.at(grid.x(i), grid.y(j), z);
      for (auto c : stress::components) out[c](i, j) = s[c];
    }
  return out;
}

// Round-off of a layer: corners to 4 ulp of atan and of log, at most 16 ε per coefficient, and transforms.
double round_off(const Field& pressure) { return 16 * epsilon * pressure.abs().sum(); }

}  // namespace

TEST_CASE("a layer is the direct sum over the loaded cells, for every shape, depth and Poisson's number",
          "[layers][exact][slow]") {
  for (Shape shape :
       {Shape{1, 1}, Shape{1, 9}, Shape{6, 1}, Shape{2, 2}, Shape{7, 5}, Shape{8, 16}, Shape{19, 10}})
    for (double z : {0.0, 0.07, 1.1, 9.0})
      for (double nu : {-0.9, 0.0, 0.3, 0.5}) {
        const Grid grid{shape, 0.3, 0.5};
        const Field p = random_field(shape, 21);
        CAPTURE(shape.nx, shape.ny, z, nu);
        CHECK(difference(layer(StressSolver({grid, p, nu}), z), direct(grid, p, z, nu)) <= round_off(p));
      }
}

// A cell's mean differs from the pressure by h²/24 ∇²p, and so does the constant pressure in it from the
// pressure: together h²/12 ∇²p, whose stress is h²/12 ∇²σ. The next term is of the order of h² of this one,
// below 2 % at N = 64.
TEST_CASE("the stress of a Hertz contact converges at order 2 with the error h^2/12 of its Laplacian",
          "[layers][order]") {
  const double z = 0.4809, nu = 0.3;
  for (Friction friction : {Friction{}, Friction{0.3, 0.4}}) {
    double coarse = 0;
    for (Index n : {32, 64, 128}) {
      const Grid grid = hertz_grid(n);
      const TensorField field = layer(StressSolver({grid, hertz_pressure(grid), nu, friction}), z);
      double error = 0, predicted = 0;
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
          const Tensor exact = hertz_stress(grid.x(i), grid.y(j), z, nu, friction);
          const Tensor laplacian = hertz_laplacian(grid.x(i), grid.y(j), z, nu, friction);
          for (auto c : stress::components) {
            error = std::max(error, std::abs(field[c](i, j) - exact[c]));
            predicted = std::max(predicted, std::abs(laplacian[c]) * grid.dx * grid.dx / 12);
          }
        }
      CAPTURE(friction.coefficient, n, error, predicted);
      CHECK(error == Approx(predicted).epsilon(n == 32 ? 0.06 : 0.02));
      if (coarse > 0) CHECK(observed_order(coarse, error) == Approx(2).margin(0.05));
      coarse = error;
    }
  }
}

// The discrete field solves the equations of equilibrium exactly, so differences of it leave the truncation
// error of the differences alone, which is that of Huber's field to a relative h².
TEST_CASE("differences of the stress fulfil equilibrium at order 2, with the remainder of Huber's field",
          "[layers][order]") {
  const double z = 0.4, nu = 0.3;
  for (Friction friction : {Friction{}, Friction{0.3, 0.4}}) {
    double coarse = 0;
    for (Index n : {32, 64, 128}) {
      const Grid grid = hertz_grid(n);
      const double h = grid.dx;
      const StressSolver solver({grid, hertz_pressure(grid), nu, friction});
      const TensorField above = layer(solver, z - h), here = layer(solver, z), below = layer(solver, z + h);
      auto remainder = [&](auto s_x, auto s_y, auto s_z) {
        double top = 0;
        for (Index i = 1; i + 1 < n; ++i)
          for (Index j = 1; j + 1 < n; ++j) {
            top = std::max(top,
                           std::abs(s_x(i, j, stress::xx) + s_y(i, j, stress::xy) + s_z(i, j, stress::xz)));
            top = std::max(top,
                           std::abs(s_x(i, j, stress::xz) + s_y(i, j, stress::yz) + s_z(i, j, stress::zz)));
          }
        return top / (2 * h);
      };
      const double computed =
          remainder([&](Index i, Index j, auto c) { return here[c](i + 1, j) - here[c](i - 1, j); },
                    [&](Index i, Index j, auto c) { return here[c](i, j + 1) - here[c](i, j - 1); },
                    [&](Index i, Index j, auto c) { return below[c](i, j) - above[c](i, j); });
      auto hertz = [&](Index i, Index j, double depth, auto c) {
        return hertz_stress(grid.x(i), grid.y(j), depth, nu, friction)[c];
      };
      const double exact =
          remainder([&](Index i, Index j, auto c) { return hertz(i + 1, j, z, c) - hertz(i - 1, j, z, c); },
                    [&](Index i, Index j, auto c) { return hertz(i, j + 1, z, c) - hertz(i, j - 1, z, c); },
                    [&](Index i, Index j, auto c) { return hertz(i, j, z + h, c) - hertz(i, j, z - h, c); });
      CAPTURE(friction.coefficient, n, computed, exact);
      CHECK(computed == Approx(exact).epsilon(20 * h * h));
      if (n > 64) CHECK(observed_order(coarse, computed) == Approx(2).margin(0.05));
      coarse = computed;
    }
  }
}

// One loaded cell: by reciprocity the sum over the layer is the stress in the middle of a wholly loaded
// domain.
TEST_CASE("a layer carries the load, less what passes beside the domain", "[layers][exact]") {
  const Grid grid{{33, 21}, 0.2, 0.3};
  Field p = Field::Zero(33, 21);
  p(16, 10) = 1;
  for (double z : {0.0, 0.5, 2.0, 20.0}) {
    const double whole = rectangle_stress(0, 0, z, grid.size_x() / 2, grid.size_y() / 2, 0.3)[stress::zz];
    CHECK(std::abs(layer(StressSolver({grid, p, 0.3}), z)[stress::zz].sum() - whole) <= 693 * round_off(p));
  }
}

// On the axis the first correction to the point load is -(5/2) <r²>/z², <r²> = 0.4 + h²/3 for cells of side h
// (h²/12 in x and in y, twice); the next is of relative order 1/z².
TEST_CASE(
    "far below a Hertz contact the normal stress is a point load's, less 5/2 of the mean square radius over "
    "z^2",
    "[layers][order]") {
  const Grid grid{{33, 33}, 1.0 / 11, 1.0 / 11};
  const StressSolver solver({grid, hertz_pressure(grid), 0.3});
  const double load = 2 * std::numbers::pi / 3, mean_square = 0.4 + grid.dx * grid.dx / 3;
  for (double z : {10.0, 20.0, 40.0}) {
    const double zz = layer(solver, z, stress::Set().set(stress::zz))[stress::zz](16, 16);
    const double correction = zz / (load * point_load_stress(0, 0, z, 0.3)[stress::zz]) - 1;
    CHECK(correction == Approx(-2.5 * mean_square / (z * z)).epsilon(2 / (z * z)).margin(1e-7));
  }
}

TEST_CASE("at the surface the layer holds the pressure and no shear", "[layers][exact]") {
  const Field p = random_field(oblong.shape, 22);
  const TensorField surface = layer(StressSolver({oblong, p, 0.3}), 0);
  CHECK((surface[stress::zz] + p).abs().maxCoeff() <= round_off(p));
  CHECK(surface[stress::xz].abs().maxCoeff() <= round_off(p));
  CHECK(surface[stress::yz].abs().maxCoeff() <= round_off(p));
}

TEST_CASE("the stress is linear in the pressure", "[layers][law]") {
  const Field p = random_field(oblong.shape, 23), q = random_field(oblong.shape, 24);
  const TensorField a = layer(StressSolver({oblong, p, 0.3}), 0.5),
                    b = layer(StressSolver({oblong, q, 0.3}), 0.5),
                    sum = layer(StressSolver({oblong, 3 * p - 2 * q, 0.3}), 0.5);
  for (auto c : stress::components)
    CHECK((3 * a[c] - 2 * b[c] - sum[c]).abs().maxCoeff() <= 3 * round_off(p) + 2 * round_off(q));
}

TEST_CASE("a mirrored pressure gives the mirrored stress, with the shear across the mirror reversed",
          "[layers][law]") {
  const Field p = random_field(oblong.shape, 25);
  const TensorField s = layer(StressSolver({oblong, p, 0.3}), 0.5);
  const TensorField in_x = layer(StressSolver({oblong, p.colwise().reverse(), 0.3}), 0.5);
  const TensorField in_y = layer(StressSolver({oblong, p.rowwise().reverse(), 0.3}), 0.5);
  for (auto c : stress::components) {
    CAPTURE(stress::names[c]);
    CHECK((in_x[c].colwise().reverse() - (odd_in_x(c) ? -1 : 1) * s[c]).abs().maxCoeff() <= round_off(p));
    CHECK((in_y[c].rowwise().reverse() - (odd_in_y(c) ? -1 : 1) * s[c]).abs().maxCoeff() <= round_off(p));
  }
}

TEST_CASE("a transposed pressure gives the transposed stress, with x and y exchanged", "[layers][law]") {
  const Field p = random_field(oblong.shape, 26);
  const Grid turned{{oblong.shape.ny, oblong.shape.nx}, oblong.dy, oblong.dx};
  const TensorField s = layer(StressSolver({oblong, p, 0.3}), 0.5);
  const TensorField t = layer(StressSolver({turned, p.transpose(), 0.3}), 0.5);
  for (auto [c, exchanged] : {std::pair{stress::xx, stress::yy}, std::pair{stress::zz, stress::zz},
                              std::pair{stress::xy, stress::xy}, std::pair{stress::xz, stress::yz}})
    CHECK((t[c].transpose() - s[exchanged]).abs().maxCoeff() <= round_off(p));
}

TEST_CASE("an unloaded surface has no stress below it, to the last bit", "[layers][exact]") {
  for (const Field& f : layer(StressSolver({oblong, Field::Zero(20, 13), 0.3}), 0.5)) CHECK((f == 0).all());
}

TEST_CASE("a component alone has the same bits as among all", "[layers][law]") {
  const StressSolver solver({oblong, random_field(oblong.shape, 27), 0.3});
  const TensorField all = layer(solver, 0.5);
  for (auto c : stress::components) CHECK((layer(solver, 0.5, stress::Set().set(c))[c] == all[c]).all());
}

TEST_CASE("layers do not depend on the number of threads or on their order, to the last bit",
          "[layers][law]") {
  const Field p = random_field(oblong.shape, 28);
  const std::vector<double> depths{0.3, 0, 1.7, 0.9, 0.1};
  auto volume = [&](int threads) {
    std::vector<Field> layers(depths.size(), Field(20, 13));
    StressSolver({oblong, p, 0.3}, threads)
        .layers(depths, stress::all, [&](Index l, Index i, const StressRow& row) {
          von_mises(row, {layers[static_cast<std::size_t>(l)].row(i).data(), 13});
        });
    return layers;
  };
  const auto one = volume(1), three = volume(3);
  for (std::size_t l = 0; l < depths.size(); ++l) CHECK((one[l] == three[l]).all());
}

// Seen is a quarter of the claim of stress/resolution.hpp: 5e-7 of the maximum pressure at z = 5 s Δ, 1e-7
// below.
TEST_CASE("deep layers from wider cells are those of the cells within 2e-6 of the maximum pressure",
          "[layers][order]") {
  for (const Grid& grid :
       {Grid{{256, 256}, 1, 1}, Grid{{96, 160}, 1, 1}, Grid{{128, 128}, 1, 2.5}, Grid{{101, 67}, 1, 1}}) {
    const Shape shape = grid.shape;
    for (const Field& p : {Field(random_field(shape, 29).abs()), Field(Field::Ones(shape.nx, shape.ny))}) {
      const StressSolver full({grid, p, 0.3}), adapted({grid, p, 0.3}, 1, DepthResolution::adapted);
      for (double z : {10.0, 17.0, 20.0, 40.0, 90.0, 200.0}) {
        CAPTURE(shape.nx, grid.dy, z);
        CHECK(difference(layer(full, z * grid.dy), layer(adapted, z * grid.dy)) <= 2e-6 * p.maxCoeff());
      }
    }
  }
}

// The wave of the highest mode that wide cells hold is the hardest: it fades by (1 + 5π) exp(-5π) = 2.5e-6 of
// its amplitude, half the maximum pressure; in x and y together by 1e-8.
TEST_CASE("a pressure in waves as long as two wide cells keeps to 2e-6 of its largest value",
          "[layers][order]") {
  const Grid grid{{96, 96}, 1, 1};
  for (double s : {2.0, 4.0})
    for (double stretch : {0.9, 1.0, 1.1, 1.3, 1.6}) {
      const Field p = sample(
          grid, [&](double x, double) { return 0.5 + 0.5 * std::cos(std::numbers::pi * x / (s * stretch)); });
      CAPTURE(s, stretch);
      CHECK(difference(layer(StressSolver({grid, p, 0.3}), 5 * s),
                       layer(StressSolver({grid, p, 0.3}, 1, DepthResolution::adapted), 5 * s)) <= 2e-6);
    }
}

TEST_CASE("layers above five wide cells, and those of small grids, are computed in full", "[layers][exact]") {
  const Grid grid{{128, 128}, 1, 1}, small{{31, 200}, 1, 1};
  for (auto [g, z] : {std::pair{grid, 9.9}, std::pair{small, 100.0}}) {
    const Field p = random_field(g.shape, 30);
    CHECK(difference(layer(StressSolver({g, p, 0.3}), z),
                     layer(StressSolver({g, p, 0.3}, 1, DepthResolution::adapted), z)) == 0);
  }
}

// The shear of friction reaches farther, as 1/r, and is tapered where it is larger.
TEST_CASE("under friction deep layers keep to 2e-6 of the maximum pressure too", "[layers][order]") {
  const Grid grid{{128, 96}, 1, 1};
  const Friction friction{0.5, 0.7};
  const Field p = Field::Ones(128, 96);
  const StressSolver full({grid, p, 0.3, friction}),
      adapted({grid, p, 0.3, friction}, 1, DepthResolution::adapted);
  for (double z : {10.0, 20.0, 35.0, 100.0}) CHECK(difference(layer(full, z), layer(adapted, z)) <= 2e-6);
}

// The modes left out are below 17 exp(-5π) = 2.5e-6 each at z = 5 s; a random pressure has hardly any of
// them.
TEST_CASE("deep layers of a periodic pressure need fewer modes", "[layers][order]") {
  for (Shape shape : {Shape{128, 128}, Shape{96, 72}}) {
    const Grid grid{shape, 1, 1, true};
    const Field p = random_field(grid.shape, 31);
    const StressSolver full({grid, p, 0.3}), adapted({grid, p, 0.3}, 1, DepthResolution::adapted);
    for (double z : {10.0, 16.0, 20.0, 33.0, 64.0})
      CHECK(difference(layer(full, z), layer(adapted, z)) <= 2e-6);
  }
}

TEST_CASE("a solver refuses what it cannot answer and names it", "[layers][contract]") {
  const Field p = Field::Ones(20, 13);
  Field broken = p;
  broken(3, 4) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(StressSolver({oblong, p, 0.6}), ParameterError);
  CHECK_THROWS_AS(StressSolver({oblong, p, -1}), ParameterError);
  CHECK_THROWS_AS(StressSolver({oblong, p}), ParameterError);  // was solved for ν = 0
  CHECK_NOTHROW(StressSolver({oblong, p, -0.3}));  // was refused here, and taken by the contact before it
  CHECK_THROWS_AS(StressSolver({oblong, broken, 0.3}), DataError);
  CHECK_THROWS_AS(StressSolver({oblong, Field::Ones(13, 20), 0.3}), DataError);
  CHECK_THROWS_AS(layer(StressSolver({oblong, p, 0.3}), -1e-9), ParameterError);
  CHECK_THROWS_AS(layer(StressSolver({oblong, p, 0.3}), 1e200),
                  ParameterError);  // its stress was not a number
  // The von Mises stress of these was infinite and 0.
  CHECK_THROWS_AS(StressSolver({oblong, 1e300 * p, 0.3}), DataError);
  CHECK_THROWS_AS(StressSolver({oblong, 1e-300 * p, 0.3}), DataError);
  CHECK_NOTHROW(StressSolver({oblong, 0 * p, 0.3}));
  CHECK_THROWS_AS(StressSolver({oblong, p, 0.3, {1e200, 0}}), ParameterError);
  CHECK_THROWS_AS(StressSolver({{{0, 0}, 1, 1}, Field(0, 0), 0.3}), DataError);
  CHECK_THROWS_AS(StressSolver({{{20, 13}, 0.4, 0}, p, 0.3}), DataError);
}
