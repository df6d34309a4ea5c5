/// Stress below a Hertz contact: error against Huber's closed form and against run time.
///
/// Six components and von Mises in each layer, on n × n cells of a square three contact radii wide, ν = 0.3, one
/// thread. `error` is the largest of any component anywhere in the layer z = 0.4809 a, in units of p0; `maximum` and
/// `depth` are the relative errors of the search for the largest von Mises stress. Seconds are per layer, the
/// fastest of repeated batches; `ratio_to_padded_r2c` compares them with one real-to-complex transform of the
/// padded square, timed in the same run, which is what is left to compare when the machine is busy.
#include <fmt/format.h>

#include "stress/hertz.hpp"
#include "stress/maximum.hpp"
#include "stress/von_mises.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double poisson = 0.3, depth = 0.4809, hertz_value = 0.620041004, hertz_depth = 0.480864;

double largest_error(const StressSolver& solver, StressSolver::Workspace& work) {
  double error = 0;
  const Grid& grid = solver.grid();
  solver.layer(depth, stress::all, work, [&](Index i, const StressRow& row) {
    for (Index j = 0; j < grid.shape.ny; ++j) {
      const stress::Tensor exact = hertz_stress(grid.x(i), grid.y(j), depth, poisson);
      for (auto c : stress::components) error = std::max(error, std::abs(row[c][j] - exact[c]));
    }
  });
  return error;
}

double layer_seconds(const StressSolver& solver, StressSolver::Workspace& work) {
  std::vector<double> row(static_cast<std::size_t>(solver.grid().shape.ny));
  return seconds_of([&] {
    solver.layer(depth, stress::all, work,
                 [&](Index, const StressRow& s) { von_mises(s, solver.grid().shape.ny, row.data()); });
  });
}

}  // namespace

int main() {
  print_conditions();
  fmt::print(
      "# case\tn\terror\torder\tmaximum\tdepth\tlayers\tsetup_seconds\tseconds\tratio_to_padded_r2c\n");
  double coarse = 0;
  for (Index n : {32, 64, 128, 256, 512}) {
    const Grid grid{{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)};
    const Field pressure = hertz_pressure(grid);
    const Stopwatch clock;
    const StressSolver solver(grid, pressure, poisson);
    StressSolver::Workspace work;
    const double setup = clock.seconds();
    const double error = largest_error(solver, work), seconds = layer_seconds(solver, work);
    const StressMaximum top = maximum_von_mises(solver);
    fmt::print("hertz\t{}\t{:.2e}\t{}\t{:.1e}\t{:.1e}\t{}\t{:.2e}\t{:.2e}\t{:.1f}\n", n, error,
               coarse > 0 ? fmt::format("{:.2f}", std::log2(coarse / error)) : "-",
               top.von_mises / hertz_value - 1, top.depth / hertz_depth - 1, top.layers, setup, seconds,
               seconds / real_transform_seconds({2 * n, 2 * n}));
    coarse = error;
  }
}
