/// Stress below a Hertz contact: error against Huber's closed form and against run time.
///
/// Six components and von Mises in each layer, on n × n cells of a square three contact radii wide, ν = 0.3, one
/// thread. `error` is the largest of any component anywhere in the layer z = 0.4809 a, in units of p0; `maximum` and
/// `depth` are the relative errors of the search for the largest von Mises stress. Seconds are per layer, the
/// fastest of repeated batches; `ratio_to_padded_r2c` compares them with one real-to-complex transform of the
/// padded square, timed in the same run, which is what is left to compare when the machine is busy.
#include <fmt/format.h>

#include "grid/stopwatch.hpp"
#include "stress/hertz.hpp"
#include "stress/maximum.hpp"
#include "stress/von_mises.hpp"

using namespace asperity;

namespace {

constexpr double poisson = 0.3, depth = 0.4809, hertz_value = 0.620041004, hertz_depth = 0.480864;

/// Seconds of one call: batches of at least 20 ms, the fastest of eight.
template <class Call>
double fastest(Call call) {
  double best = 1e300;
  int calls = 1;
  for (int batch = 0; batch < 8;) {
    const Stopwatch clock;
    for (int k = 0; k < calls; ++k) call();
    const double seconds = clock.seconds();
    if (seconds < 0.02) {
      calls *= 2;
      continue;
    }
    best = std::min(best, seconds / calls);
    ++batch;
  }
  return best;
}

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

double padded_transform_seconds(Index n) {
  const RealTransform2D transform({2 * n, 2 * n});
  AlignedVector<double> field(static_cast<std::size_t>(4 * n * n), 1.0);
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  return fastest([&] { transform.forward(field.data(), spectrum.data()); });
}

double layer_seconds(const StressSolver& solver, StressSolver::Workspace& work) {
  std::vector<double> row(static_cast<std::size_t>(solver.grid().shape.ny));
  return fastest([&] {
    solver.layer(depth, stress::all, work,
                 [&](Index, const StressRow& s) { von_mises(s, solver.grid().shape.ny, row.data()); });
  });
}

}  // namespace

int main() {
  fmt::print(
      "# case\tn\terror\torder\tmaximum\tdepth\tlayers\tsetup_seconds\tseconds\tratio_to_padded_r2c\n");
  double coarse = 0;
  for (Index n : {32, 64, 128, 256, 512}) {
    const Grid grid{{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)};
    const Field pressure = hertz_pressure(grid);
    const Stopwatch clock;
    const StressSolver solver(grid, pressure, poisson);
    StressSolver::Workspace work(solver);
    const double setup = clock.seconds();
    const double error = largest_error(solver, work), seconds = layer_seconds(solver, work);
    const StressMaximum top = maximum_von_mises(solver);
    fmt::print("hertz\t{}\t{:.2e}\t{}\t{:.1e}\t{:.1e}\t{}\t{:.2e}\t{:.2e}\t{:.1f}\n", n, error,
               coarse > 0 ? fmt::format("{:.2f}", std::log2(coarse / error)) : "-",
               top.von_mises / hertz_value - 1, top.depth / hertz_depth - 1, top.layers, setup, seconds,
               seconds / padded_transform_seconds(n));
    coarse = error;
  }
}
