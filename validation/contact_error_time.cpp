/// Error of the contact solution against its cost.
///
/// Scene A: two smooth steel spheres, R = 50 mm, E = 208 GPa, ν = 0.3, Q = 5000 N, on 3 mm × 3 mm; errors
/// against Hertz, so that the discretisation shows. Scene B: A with Gaussian roughness of 0.4 µm rms and
/// exponential autocorrelation, 10 % length 0.328 mm; errors against the same grid's solution at ε = 1e-11,
/// so that the tolerance shows. Scene B2: B with the pressure limited to 3600 MPa.
///
///     contact_error_time [LARGEST_N] [THREADS]
///
/// `convolutions` and `preconditionings` count coarser grids by their share of the cells;
/// `ratio_to_padded_r2c` is the time of one convolution over that of one real transform of the padded size.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "contact/bodies.hpp"
#include "contact/hertz.hpp"
#include "contact/influence.hpp"
#include "contact/solver.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double side = 3e-3, load = 5000, limit = 3.6e9;
const Bodies bodies{.radius = {50e-3, 50e-3}};

/// Gaussian heights of unit rms on the n × n points of one realisation that is drawn on 1024 × 1024 (or n ×
/// n).
Field roughness(Index n) {
  const Index fine = std::max<Index>(n, 1024);
  const RealTransform2D transform({fine, fine});
  const double length = 0.328125e-3, step = side / static_cast<double>(fine);
  auto lag = [&](Index k) { return step * static_cast<double>(std::min(k, fine - k)); };
  const Field acf = Field::NullaryExpr(fine, fine, [&](Index i, Index j) {
    return std::exp(-std::numbers::ln10 * std::hypot(lag(i), lag(j)) / length);
  });
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  Field noise = Field::NullaryExpr(fine, fine, [&](Index, Index) { return normal(generator); });
  const auto size = static_cast<std::size_t>(transform.spectrum_size());
  AlignedVector<Complex> power(size), amplitude(size);
  transform.forward(acf.data(), power.data());
  transform.forward(noise.data(), amplitude.data());
  for (std::size_t k = 0; k < size; ++k) amplitude[k] *= std::sqrt(std::max(0.0, power[k].real()));
  transform.inverse(amplitude.data(), noise.data());
  noise -= noise.mean();
  noise /= std::sqrt(noise.square().mean());
  return noise(Eigen::seqN(0, n, fine / n), Eigen::seqN(0, n, fine / n));
}

Grid square(Index n) { return {{n, n}, side / static_cast<double>(n), side / static_cast<double>(n)}; }

double convolution_over_transform(const Grid& grid, int threads) {
  const auto influence = make_influence(grid, bodies.composite_modulus(), threads);
  const Field p = Field::Ones(grid.shape.nx, grid.shape.ny);
  Field u;
  return seconds_of([&] { influence->apply(p, u); }) /
         real_transform_seconds({2 * grid.shape.nx, 2 * grid.shape.ny});
}

struct Reference {
  double pressure, approach, area;
};

struct Scene {
  std::string name;
  double rms, limit_pressure;
};

void run(const Scene& scene, Index n, int threads) {
  const Grid grid = square(n);
  Field gap = undeformed_gap(grid, bodies);
  if (scene.rms > 0) gap -= scene.rms * roughness(n);
  auto solve = [&](double tolerance) {
    return solve_contact(
        grid, gap, bodies.composite_modulus(),
        {.load = load, .limit_pressure = scene.limit_pressure, .tolerance = tolerance, .threads = threads});
  };
  const Hertz smooth = hertz(bodies, load);
  Reference reference{smooth.pressure, smooth.approach, std::numbers::pi * smooth.radius * smooth.radius};
  if (scene.rms > 0) {
    const Contact exact = solve(1e-11);
    reference = {exact.max_pressure, exact.approach, exact.area};
  }
  const double ratio = convolution_over_transform(grid, threads);
  for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Contact c = solve(tolerance);
    fmt::print("{}\t{}\t{:.0e}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2f}\t{:.2f}\t{:.4f}\t{:.4f}\t{:.3f}\t{:.1e}{}\n",
               scene.name, n, tolerance, c.max_pressure / reference.pressure - 1,
               c.approach / reference.approach - 1, c.area / reference.area - 1, c.convolutions,
               c.preconditionings, c.setup_seconds, c.seconds, ratio, c.residual,
               c.converged ? "" : "\t" + c.reason);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 512;
  const int threads = argc > 2 ? std::atoi(argv[2]) : 1;
  fmt::print(
      "# "
      "case\tn\ttol\tp_error\tapproach_error\tarea_error\tconvolutions\tpreconditionings\tsetup_"
      "seconds\tseconds\t"
      "ratio_to_padded_r2c\tresidual\n");
  for (const Scene& scene : {Scene{"A", 0, 1 / 0.0}, Scene{"B", 0.4e-6, 1 / 0.0}, Scene{"B2", 0.4e-6, limit}})
    for (Index n = 128; n <= largest; n *= 2) run(scene, n, threads);
}
