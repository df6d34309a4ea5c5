#include <atomic>
#include <stdexcept>
#include <thread>

#include "core/error.hpp"
#include "layer.hpp"
#include "stress/influence.hpp"
#include "stress/layers.hpp"
#include "stress/load.hpp"
#include "stress/maximum.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Each depth's row of all components, [depth][component][point].
using Rows = std::vector<std::array<std::vector<double>, 6>>;

Rows rows(const StressSolver& section, const std::vector<double>& depths) {
  Rows out(depths.size());
  section.layers(depths, stress::all, [&](Index l, Index, const StressRow& values) {
    for (auto c : stress::components)
      out[static_cast<std::size_t>(l)][c].assign(values[c].begin(), values[c].end());
  });
  return out;
}

}  // namespace

// Two ways of summing the same modes: 16 ε Σ|p| each. Of an adapted layer the section is not interpolated
// across its plane, the volume is: 9e-8 of a mode (transform/interpolation.hpp), of which a deep layer has
// few.
TEST_CASE("a section along x or y is the layers' row in it, with and without friction, periodic or not",
          "[section][exact]") {
  const std::vector<double> depths{0, 0.3, 1.1, 7.0, 30.0};
  for (bool periodic : {false, true})
    for (const Friction& friction : {Friction{}, Friction{0.4, 0.6}}) {
      const Grid grid{{48, 36}, 0.4, 0.3, periodic};
      const Field p = random_field(grid.shape, 41).abs();
      const double exact = 64 * epsilon * p.sum();
      for (auto resolution : {DepthResolution::full, DepthResolution::adapted}) {
        const double interpolated = resolution == DepthResolution::full ? 0 : 2e-7 * p.maxCoeff();
        const StressSolver solver({grid, p, 0.3, friction}, 1, resolution);
        const Rows along_x = rows({{grid, p, 0.3, friction}, Plane{true, 11}, 2, resolution}, depths),
                   along_y = rows({{grid, p, 0.3, friction}, Plane{false, 47}, 1, resolution}, depths);
        for (std::size_t l = 0; l < depths.size(); ++l) {
          const TensorField whole = layer(solver, depths[l]);
          double error = 0;
          for (auto c : stress::components) {
            for (Index i = 0; i < 48; ++i)
              error = std::max(error, std::abs(along_x[l][c][static_cast<std::size_t>(i)] - whole[c](i, 11)));
            for (Index j = 0; j < 36; ++j)
              error = std::max(error, std::abs(along_y[l][c][static_cast<std::size_t>(j)] - whole[c](47, j)));
          }
          const double bound = exact + (depths[l] >= Resolution::least_depth(grid, 2) ? interpolated : 0);
          CAPTURE(periodic, friction.coefficient, depths[l]);
          CHECK(error <= bound);
        }
      }
    }
}

// Lags beyond the farthest load are left out, and where all is unloaded every one.
TEST_CASE("a section far from a load that fills a corner is the layers' row, and without load it is 0",
          "[section][exact]") {
  const Grid grid{{40, 30}, 0.5, 0.5};
  Field p = Field::Zero(40, 30);
  p.topLeftCorner(3, 4) = random_field({3, 4}, 43).abs();
  const std::vector<double> depths{0, 0.7, 4};
  const StressSolver solver({grid, p, 0.3, {0.2, 0}});
  for (Index i : {0, 2, 3, 39}) {
    const Rows found = rows({{grid, p, 0.3, {0.2, 0}}, Plane{false, i}}, depths);
    for (std::size_t l = 0; l < depths.size(); ++l) {
      const TensorField whole = layer(solver, depths[l]);
      double error = 0;
      for (auto c : stress::components)
        for (Index j = 0; j < 30; ++j)
          error = std::max(error, std::abs(found[l][c][static_cast<std::size_t>(j)] - whole[c](i, j)));
      CAPTURE(i, depths[l]);
      CHECK(error <= 64 * epsilon * p.sum());
    }
  }
  const Rows nothing = rows({{grid, Field::Zero(40, 30), 0.3}, Plane{true, 7}}, depths);
  for (const auto& row : nothing)
    for (const auto& component : row)
      for (double value : component) CHECK(value == 0);
}

TEST_CASE("layers are handed over in order from the calling thread, none far ahead, and a failure ends them",
          "[layers][contract]") {
  const Grid grid{{4, 3}, 1, 1};
  const LoadedBody body{grid, Field::Ones(4, 3), 0.3};
  using Work = StressSolver::Workspace;
  for (int threads : {1, 2, 5})
    for (std::size_t count : {0u, 1u, 3u, 40u}) {
      std::atomic<Index> handed_over{0};
      std::vector<int> computed(count);
      std::atomic<bool> ahead{false};
      const auto caller = std::this_thread::get_id();
      StressSolver(body, threads)
          .each_layer(
              std::vector<double>(count, 1.0),
              [&](Index l, Work&) {
                if (l >= handed_over + threads) ahead = true;
                ++computed[static_cast<std::size_t>(l)];
              },
              [&](Index begin, Index end) {
                CHECK(std::this_thread::get_id() == caller);
                CHECK(begin == handed_over);
                CHECK(end > begin);
                for (Index l = begin; l < end; ++l) CHECK(computed[static_cast<std::size_t>(l)] == 1);
                handed_over = end;
              });
      CHECK(handed_over == static_cast<Index>(count));
      CHECK_FALSE(ahead);
    }
  const StressSolver solver(body, 3);
  const std::vector<double> depths(40, 1.0);
  auto fail = [](Index l, Work&) {
    if (l == 7) throw std::runtime_error("the seventh");
  };
  CHECK_THROWS_AS(solver.each_layer(depths, fail), std::runtime_error);
  CHECK_THROWS_AS(solver.each_layer(
                      depths, [](Index, Work&) {}, [](Index, Index) { throw std::runtime_error("full"); }),
                  std::runtime_error);
}

namespace {

// The norm of the stress at depth 1 below a unit force.
double norm(double x, double y, double nu, stress::Traction load) {
  const stress::Tensor s = point_load_stress(x, y, 1, nu, load);
  double sum = 0;
  for (auto c : stress::components) sum += (c < stress::xy ? 1 : 2) * s[c] * s[c];
  return std::sqrt(sum);
}

// Its maximum: lattices around the best point of the last, each a twentieth as wide.
double largest_norm(double nu, stress::Traction load) {
  double best = 0, x0 = 0, y0 = 0;
  for (double half = 8; half > 1e-6; half /= 20) {
    const double x_centre = x0, y_centre = y0;
    for (int i = -100; i <= 100; ++i)
      for (int j = -100; j <= 100; ++j) {
        const double x = x_centre + 0.01 * half * i, y = y_centre + 0.01 * half * j;
        if (const double value = norm(x, y, nu, load); value > best) best = value, x0 = x, y0 = y;
      }
  }
  return best;
}

}  // namespace

// Superposition carries the bound of a force over to any load, so that only the two maxima are to be tested:
// found here on other lattices, finer at each step down to 1e-7 and four times as wide as the bound's, and
// far away.
TEST_CASE("the bound of a unit force is at least its largest stress anywhere, and 1.01 times that at most",
          "[bound][law]") {
  const Grid grid{{1, 1}, 1, 1};
  const Field unit = Field::Constant(1, 1, 1.0);
  for (double nu : {-0.99, -0.5, 0.0, 0.15, 0.3, 0.4, 0.5}) {
    const double pressed = stress_bound({grid, unit, nu}),
                 slid = stress_bound({grid, unit, nu, {1, 0}}) - pressed;
    for (auto [bound, load] : {std::pair{pressed, stress::normal}, std::pair{slid, stress::shear_x}}) {
      const double top = std::sqrt(1.5) * largest_norm(nu, load);
      CAPTURE(nu, load, top, bound);
      CHECK(top <= bound);
      CHECK(bound <= 1.0101 * top);
      double far = 0;
      for (double t = 4; t < 1e6; t *= 1.1)
        for (double angle = 0; angle < 1.6; angle += 0.05)
          far = std::max(far, norm(t * std::cos(angle), t * std::sin(angle), nu, load));
      CHECK(far <= 0.16 * top);
    }
  }
}

TEST_CASE("no stress exceeds the bound of its load, and a force at one point comes near it", "[bound][law]") {
  const Grid grid{{24, 20}, 1, 1};
  Field point = Field::Zero(24, 20);
  point(12, 10) = 3;
  for (double nu : {-0.9, 0.0, 0.3, 0.5})
    for (const Friction& friction : {Friction{}, Friction{0.5, 0.3}})
      for (bool single : {true, false}) {
        const Field p = single ? point : Field(random_field(grid.shape, 42).abs());
        const StressSolver solver({grid, p, nu, friction});
        for (double z : {0.5, 4.0, 12.0, 40.0}) {
          double top = 0;
          StressSolver::Workspace work;
          std::vector<double> row(20);
          solver.layer(z, stress::all, work, [&](Index, const StressRow& s) {
            von_mises(s, row);
            top = std::max(top, *std::max_element(row.begin(), row.end()));
            for (auto c : stress::components)
              for (Index j = 0; j < 20; ++j) top = std::max(top, std::abs(s[c][static_cast<std::size_t>(j)]));
          });
          const double bound = stress_bound({grid, p, nu, friction}) / (z * z);
          CAPTURE(nu, friction.coefficient, z, top, bound);
          CHECK(top <= bound);
          if (single && z > 10) CHECK(top >= 0.5 * bound);
        }
      }
  CHECK(std::isinf(stress_bound({{{24, 20}, 1, 1, true}, point, 0.3})));
}

// Memory beside the pressure was read.
TEST_CASE("a section in a plane beside the cells is refused", "[section][contract]") {
  const LoadedBody body{{{8, 6}, 1, 1}, Field::Ones(8, 6), 0.3, {}};
  CHECK_NOTHROW(StressSolver(body, Plane{true, 5}));
  CHECK_NOTHROW(StressSolver(body, Plane{false, 7}));
  for (const Plane& plane : {Plane{true, 6}, Plane{false, 8}, Plane{true, -1}})
    CHECK_THROWS_AS(StressSolver(body, plane), ParameterError);
}

// It was a search in one row, told with positions of the first.
TEST_CASE("the largest stress of a section's solver is refused", "[section][contract]") {
  const StressSolver section({{{8, 6}, 1, 1}, Field::Ones(8, 6), 0.3, {}}, Plane{true, 5});
  CHECK_THROWS_AS(maximum_stress(section), ParameterError);
  CHECK_THROWS_AS(maximum_by_depth(section, Criterion::von_mises, {0.5}), ParameterError);
}
