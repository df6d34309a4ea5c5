/// Stress below a Hertz contact, resting and sliding: error against the closed forms and against run time.
///
///     stress_error_time [LARGEST_N]
///
/// First table: six components and von Mises in each layer, on n × n cells of a square three contact radii
/// wide, ν = 0.3, one thread, n = 32 … LARGEST_N (512). `error` is the largest of any component anywhere in
/// the layer z = 0.4809 a, in units of p0; `maximum` and `depth` are the relative errors of the search for
/// the largest von Mises stress. Seconds are per layer, the fastest of repeated batches;
/// `ratio_to_padded_r2c` compares them with one real-to-complex transform of the padded square, timed in the
/// same run, which is what is left to compare when the machine is busy. Second table: the largest von Mises
/// stress among the points of a volume, 128 × 128 cells (or LARGEST_N, if less) by so many layers down to a,
/// against the closed form's; adapted layers against full ones. Third table: round-off
/// (stress_stability.hpp); depths in sides of a square cell of the same area.
#include <cstdlib>

#include <fmt/format.h>

#include "reference/hertz_stress.hpp"
#include "stress/equivalent.hpp"
#include "stress/maximum.hpp"
#include "stress_stability.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double poisson = 0.3, depth = 0.4809;

struct Case {
  const char* name;
  Friction friction;
  double largest, at;  ///< von Mises stress of the closed form, and its depth
};
constexpr Case resting{"hertz", {}, 0.620041004, 0.480864}, sliding{"sliding", {0.3, 0}, 0.659756, 0.4268};

Grid square(Index n) { return {{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)}; }

double largest_error(const StressSolver& solver, const Friction& friction, StressSolver::Workspace& work) {
  double error = 0;
  const Grid& grid = solver.body().grid;
  solver.layer(depth, stress::all, work, [&](Index i, const StressRow& row) {
    for (Index j = 0; j < grid.shape.ny; ++j) {
      const stress::Tensor exact = hertz_stress(grid.x(i), grid.y(j), depth, poisson, friction);
      for (auto c : stress::components)
        error = std::max(error, std::abs(row[c][static_cast<std::size_t>(j)] - exact[c]));
    }
  });
  return error;
}

Seconds layer_seconds(const StressSolver& solver, StressSolver::Workspace& work) {
  std::vector<double> row(static_cast<std::size_t>(solver.shape().ny));
  return seconds_of(
      [&] { solver.layer(depth, stress::all, work, [&](Index, const StressRow& s) { von_mises(s, row); }); });
}

void discretisation(const Case& c, Index largest) {
  double coarse = 0;
  for (Index n = 32; n <= largest; n *= 2) {
    const Grid grid = square(n);
    const Field pressure = hertz_pressure(grid);
    const StressSolver solver({grid, pressure, poisson, c.friction});
    StressSolver::Workspace work;
    const Seconds setup = seconds_of([&] {
      StressSolver({grid, pressure, poisson, c.friction});
    }),
                  seconds = layer_seconds(solver, work);
    const double error = largest_error(solver, c.friction, work);
    const StressMaximum top = maximum_stress(solver);
    fmt::print("{}\t{}\t{:.2e}\t{}\t{:.1e}\t{:.1e}\t{}\t{:.2e}\t{:.2e}\t{:.1f}\n", c.name, n, error,
               coarse > 0 ? fmt::format("{:.2f}", std::log2(coarse / error)) : "-", top.value / c.largest - 1,
               top.depth / c.at - 1, top.layers, setup, seconds,
               seconds / real_transform_seconds({2 * n, 2 * n}));
    coarse = error;
  }
}

std::vector<double> depths(Index layers, bool geometric, const Grid& grid) {
  std::vector<double> out;
  for (Index k = 0; k < layers; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(layers - 1);
    out.push_back(geometric ? 0.5 * grid.dx * std::pow(2 / grid.dx, t) : t);
  }
  return out;
}

struct Found {
  double von_mises = 0, depth = 0;
};

Found largest_in_volume(const StressSolver& solver, const std::vector<double>& z) {
  Found top;
  std::vector<double> row(static_cast<std::size_t>(solver.shape().ny));
  solver.layers(z, stress::all, [&](Index l, Index, const StressRow& s) {
    von_mises(s, row);
    const double value = *std::max_element(row.begin(), row.end());
    if (value > top.von_mises) top = {value, z[static_cast<std::size_t>(l)]};
  });
  return top;
}

void layers_and_spacing(const Case& c, Index n) {
  const Grid grid = square(n);
  const Field pressure = hertz_pressure(grid);
  const StressSolver full({grid, pressure, poisson, c.friction}),
      adapted({grid, pressure, poisson, c.friction}, 1, DepthResolution::adapted);
  for (bool geometric : {false, true})
    for (Index layers : {8, 16, 32, 64}) {
      const std::vector<double> z = depths(layers, geometric, grid);
      const Found found = largest_in_volume(full, z);
      const Seconds seconds = seconds_of([&] { largest_in_volume(full, z); }),
                    fast = seconds_of([&] { largest_in_volume(adapted, z); });
      fmt::print("{}\t{}\t{}\t{:.1e}\t{:.1e}\t{:.2e}\t{:.2e}\n", c.name, layers,
                 geometric ? "geometric" : "uniform", found.von_mises / c.largest - 1, found.depth / c.at - 1,
                 seconds, fast);
    }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 512;
  fmt::print(
      "# case\tn\terror\torder\tmaximum\tdepth\tlayers\tsetup_seconds\tsetup_seconds_spread\tseconds\t"
      "seconds_spread\tratio_to_padded_r2c\n");
  for (const Case& c : {resting, sliding}) discretisation(c, largest);
  fmt::print(
      "# case\tlayers\tspacing\tmaximum\tdepth\tseconds_full\tseconds_full_spread\tseconds_adapted\t"
      "seconds_adapted_spread\n");
  for (const Case& c : {resting, sliding}) layers_and_spacing(c, std::min<Index>(largest, 128));
  print_stability();
}
