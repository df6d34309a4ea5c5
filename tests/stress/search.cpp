/// What is searched for, and from which depth on.
#include "core/error.hpp"
#include "layer.hpp"
#include "stress/maximum.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double nu = 0.3;
constexpr std::array criteria{Criterion::von_mises, Criterion::max_shear, Criterion::principal};

double value_of(Criterion of, const stress::Tensor& s) {
  const PrincipalStress p = principal_stress(s);
  return of == Criterion::von_mises   ? von_mises(s)
         : of == Criterion::max_shear ? 0.5 * (p.value[0] - p.value[2])
                                      : p.value[0];
}

struct Place {
  double value = -1, x = 0, z = 0;
};

// Of the closed field in the plane y = 0, where friction along x has its maxima, from z on.
Place largest_of_hertz(Criterion of, double from, const Friction& friction) {
  Place top;
  for (double z = from; z <= from + 1; z += 0.01)
    for (double x = -2.46; x <= 2.46; x += 0.01)
      if (const double v = value_of(of, hertz_stress(x, 0, z, nu, friction)); v > top.value) top = {v, x, z};
  return top;
}

// Five radii wide: the largest tension below a resting contact lies beside it.
Grid wide_grid(Index n) { return {{n, n}, 5.0 / static_cast<double>(n), 5.0 / static_cast<double>(n)}; }

}  // namespace

// The stress is off by 0.25 h² of p0 and the search by 2e-6 of its value (stress_error_time); the closed
// form is looked at every 0.01, beside a maximum by 0.005 at most: of a curvature of 2 p0 at the most, 1e-4.
TEST_CASE("from a depth on, the largest von Mises, shear and principal stress are those of Hertz' field",
          "[maximum][exact]") {
  for (const Friction& friction : {Friction{}, Friction{0.25, 0}, Friction{0.5, 0}})
    for (Criterion of : criteria)
      for (double from : {0.16, 0.3, 0.7}) {
        const Grid grid = wide_grid(64);
        const StressMaximum found =
            maximum_stress(StressSolver({grid, hertz_pressure(grid), nu, friction}), {of, from});
        const Place exact = largest_of_hertz(of, from, friction);
        CAPTURE(friction.coefficient, static_cast<int>(of), from, found.value, exact.value, found.x,
                found.depth);
        CHECK(std::abs(found.value - exact.value) <= 0.25 * grid.dx * grid.dx + 2e-4);
        CHECK(found.depth >= from);
        CHECK(std::abs(found.depth - exact.z) <= 0.05);
      }
}

// Tresca's stress is twice the largest shear, and on the axis, where two principal stresses are equal, von
// Mises stress too; principal is the first of three.
TEST_CASE("each criterion is that of its tensor, at every point of a row", "[maximum][exact]") {
  const Grid grid = hertz_grid(19);
  const TensorField field = layer(StressSolver({grid, hertz_pressure(grid), nu, {0.4, 0.3}}), 0.2);
  for (Index i = 0; i < 19; ++i) {
    StressRow row;
    for (auto c : stress::components) row[c] = {field[c].row(i).data(), 19};
    for (Criterion of : criteria) {
      std::array<double, 19> out{};
      equivalent_stress(of, row, out);
      for (Index j = 0; j < 19; ++j) {
        const double value = out[static_cast<std::size_t>(j)];
        CHECK(std::abs(value - value_of(of, tensor_at(field, i, j))) <= 64 * epsilon);
      }
    }
  }
}

// Nothing of it is left to round: the layers that are looked at are the same.
TEST_CASE("the search from the surface and from above its first depth find the same deep maximum",
          "[maximum][law]") {
  const Grid grid = hertz_grid(48);
  const StressSolver solver({grid, hertz_pressure(grid), nu});
  const StressMaximum whole = maximum_stress(solver);
  for (double below : {1e-30, 1e-9, 0.2 * grid.dx}) {
    const StressMaximum found = maximum_stress(solver, {Criterion::von_mises, below});
    CHECK(found.value == whole.value);
    CHECK(found.depth == whole.depth);
    CHECK(found.layers == whole.layers);
  }
}

// A single cell bears most at the surface or near it; a cell deep and more the stress falls with the depth.
// Corner sums leave 1e-10 of the stress (stress/points.hpp).
TEST_CASE("where the stress falls with the depth the maximum lies at the depth from which it is asked",
          "[maximum][law]") {
  const Grid grid{{21, 17}, 0.1, 0.08};
  Field p = Field::Zero(21, 17);
  p(10, 8) = 1;
  for (double below : {0.1, 0.3, 7.0}) {
    const StressMaximum found = maximum_stress(StressSolver({grid, p, nu}), {Criterion::von_mises, below});
    const TensorField at = layer(StressSolver({grid, p, nu}), below);
    CAPTURE(below, found.depth);
    CHECK(found.depth == below);
    CHECK(relative_error(found.value, von_mises(tensor_at(at, 10, 8))) <= 1e-6);
    CHECK(std::abs(found.x) <= 1e-4);
  }
}

// A uniform pressure p below a body held at its sides: -ν/(1-ν) p along them, at every depth.
TEST_CASE("the largest principal stress is negative where everything is compressed", "[maximum][exact]") {
  const StressSolver solver({{{8, 6}, 0.5, 0.4, true}, Field::Constant(8, 6, 2.0), nu});
  const StressMaximum found = maximum_stress(solver, {Criterion::principal, 0});
  CHECK(std::abs(found.value + 2 * nu / (1 - nu)) <= 64 * epsilon);
}

TEST_CASE("a depth to search from that is none is refused, the deepest one is not", "[maximum][contract]") {
  const Grid grid = hertz_grid(8);
  const StressSolver solver({grid, hertz_pressure(grid), nu});
  for (double below : {-1.0, 1.01e29, double{INFINITY}, double{NAN}})
    CHECK_THROWS_AS(maximum_stress(solver, {Criterion::von_mises, below}), ParameterError);
  CHECK(maximum_stress(solver, {Criterion::von_mises, 1e29}).depth == 1e29);
}

// The parabola in x and y sees a flat even peak up to h⁴; layers themselves are off by 0.25 h² (above).
TEST_CASE("the maximum by depth is that of each layer of Hertz' field", "[maximum][exact]") {
  const Grid grid = hertz_grid(64);
  const std::vector<double> depths{0, 0.2, 0.4, 0.6, 1.2};
  for (int threads : {1, 3}) {
    const auto table = maximum_by_depth(StressSolver({grid, hertz_pressure(grid), nu}, threads),
                                        Criterion::max_shear, depths);
    REQUIRE(table.size() == depths.size());
    for (std::size_t k = 1; k < depths.size(); ++k) {
      double exact = 0;
      for (double x = 0; x < 1.5; x += 0.005)
        exact = std::max(exact, value_of(Criterion::max_shear, hertz_stress(x, 0, depths[k], nu)));
      CAPTURE(depths[k], table[k].value, exact);
      CHECK(table[k].depth == depths[k]);
      CHECK(std::abs(table[k].value - exact) <= 0.25 * grid.dx * grid.dx + 1e-4);
    }
    CHECK(table[0].depth == 0);
  }
}
