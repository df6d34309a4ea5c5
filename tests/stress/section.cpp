#include "stress/section.hpp"

#include "layer.hpp"
#include "stress/bound.hpp"
#include "stress/influence.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Each depth's row of all components, [depth][component][point].
using Rows = std::vector<std::array<std::vector<double>, 6>>;

Rows rows(const StressSection& section, const std::vector<double>& depths) {
  Rows out(depths.size());
  section.rows(depths, stress::all, [&](Index l, Index, const StressRow& values) {
    for (auto c : stress::components)
      out[static_cast<std::size_t>(l)][c].assign(values[c], values[c] + section.points());
  });
  return out;
}

}  // namespace

// Two ways of summing the same modes: 16 ε Σ|p| each.
TEST_CASE("a section along x or y is the layers' row in it, with and without friction, periodic or not",
          "[section][exact]") {
  const std::vector<double> depths{0, 0.3, 1.1, 7.0, 30.0};
  for (bool periodic : {false, true})
    for (const Friction& friction : {Friction{}, Friction{0.4, 0.6}}) {
      const Grid grid{{48, 36}, 0.4, 0.3, periodic};
      const Field p = random_field(grid.shape, 41).abs();
      const double bound = 64 * epsilon * p.sum();
      for (auto resolution : {DepthResolution::full, DepthResolution::adapted}) {
        const StressSolver solver(grid, p, friction, 0.3, 1, resolution);
        const Rows along_x = rows({grid, p, friction, 0.3, {true, 11}, 2, resolution}, depths),
                   along_y = rows({grid, p, friction, 0.3, {false, 47}, 1, resolution}, depths);
        for (std::size_t l = 0; l < depths.size(); ++l) {
          const TensorField whole = layer(solver, depths[l]);
          double error = 0;
          for (auto c : stress::components) {
            for (Index i = 0; i < 48; ++i)
              error = std::max(error, std::abs(along_x[l][c][static_cast<std::size_t>(i)] - whole[c](i, 11)));
            for (Index j = 0; j < 36; ++j)
              error = std::max(error, std::abs(along_y[l][c][static_cast<std::size_t>(j)] - whole[c](47, j)));
          }
          CAPTURE(periodic, friction.coefficient, depths[l]);
          CHECK(error <= bound);
        }
      }
    }
}

TEST_CASE("no stress exceeds the bound of its load, and a force at one point comes near it", "[bound][law]") {
  const Grid grid{{24, 20}, 1, 1};
  Field point = Field::Zero(24, 20);
  point(12, 10) = 3;
  for (double nu : {0.0, 0.3, 0.5})
    for (const Friction& friction : {Friction{}, Friction{0.5, 0.3}})
      for (bool single : {true, false}) {
        const Field p = single ? point : Field(random_field(grid.shape, 42).abs());
        const StressSolver solver(grid, p, friction, nu);
        for (double z : {0.5, 4.0, 12.0, 40.0}) {
          double top = 0;
          StressSolver::Workspace work;
          std::vector<double> row(20);
          solver.layer(z, stress::all, work, [&](Index, const StressRow& s) {
            von_mises(s, 20, row.data());
            top = std::max(top, *std::max_element(row.begin(), row.end()));
            for (auto c : stress::components)
              for (Index j = 0; j < 20; ++j) top = std::max(top, std::abs(s[c][j]));
          });
          const double bound = stress_bound(grid, p, friction, nu, z);
          CAPTURE(nu, friction.coefficient, z, top, bound);
          CHECK(top <= bound);
          if (single && z > 10) CHECK(top >= 0.5 * bound);
        }
      }
  CHECK(std::isinf(stress_bound(grid, point, {}, 0.3, 0)));
}
