/// Error of the contact solution against its cost, on the scenes of contact_scenes.hpp.
///
///     contact_error_time [LARGEST_N [N]]
///
/// First table: scene A for N = 32 … LARGEST_N (1024) to ε = 1e-8, against Hertz, so that the discretisation
/// shows; on one and on two threads. The area's error is that of cells on a circle. Second table: every scene
/// on N × N (256), to ε = 1e-4 … 1e-10, against its solution at ε = 1e-11, so that the tolerance shows; and
/// by the yardsticks of contact_yardsticks.hpp, given up after 600 convolutions.
///
/// convolutions, preconditionings  by their share of the finest cells, coarser grids included
/// setup_seconds                   coefficients, spectra and plans
/// seconds                         the solution, the nested start included; the fastest of three
/// over_operators                  seconds, the nested start included, over (convolutions × the time of one +
///                                 preconditionings × the time of one)
/// convolution_over_r2c            the time of one convolution over that of one padded real transform
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "contact/hertz.hpp"
#include "contact/influence.hpp"
#include "contact/solver.hpp"
#include "contact_scenes.hpp"
#include "contact_yardsticks.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr int give_up = 600;

Contact solve(const ContactScene& s, double tolerance, int threads) {
  auto once = [&] {
    return solve_contact(
        s.grid, s.gap, s.composite_modulus,
        {.load = s.load, .limit_pressure = s.limit_pressure, .tolerance = tolerance, .threads = threads});
  };
  Contact fastest = once();
  for (int again = 0; again < 2; ++again)
    if (Contact c = once(); c.seconds < fastest.seconds) fastest = std::move(c);
  return fastest;
}

// Of one convolution and one preconditioning of the whole grid.
struct OperatorSeconds {
  double convolution = 0, preconditioning = 0;

  OperatorSeconds(const ContactScene& s, int threads) {
    const auto influence = make_influence(s.grid, s.composite_modulus, threads);
    Field p = Field::Ones(s.grid.shape.nx, s.grid.shape.ny), u;
    convolution = seconds_of([&] { influence->apply(p, u); });
    preconditioning = seconds_of([&] { influence->precondition(p, u); });
  }

  double of(const Contact& c) const {
    return c.convolutions * convolution + c.preconditionings * preconditioning;
  }
};

double error(double value, double exact) { return value / exact - 1; }

void discretisation(Index largest) {
  fmt::print(
      "# case\tn\tthreads\tp0_error\tapproach_error\tarea_error\tconvolutions\tpreconditionings\t"
      "setup_seconds\tseconds\tover_operators\tconvolution_over_r2c\tresidual\n");
  const Hertz exact = hertz(scene_bodies, scene_load);
  for (Index n = 32; n <= largest; n *= 2) {
    const ContactScene scene = contact_scene("A", n);
    const double transform = real_transform_seconds({2 * n, 2 * n});
    for (int threads : {1, 2}) {
      const OperatorSeconds one(scene, threads);
      const Contact c = solve(scene, 1e-8, threads);
      fmt::print(
          "A\t{}\t{}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2f}\t{:.2f}\t{:.4f}\t{:.4f}\t{:.2f}\t{:.2f}\t{:.1e}\n", n,
          threads, error(c.max_pressure, exact.pressure), error(c.approach, exact.approach),
          error(c.area, std::numbers::pi * exact.radius * exact.radius), c.convolutions, c.preconditionings,
          c.setup_seconds, c.seconds, c.seconds / one.of(c), one.convolution / transform, c.residual);
      std::fflush(stdout);
    }
  }
}

using Solver = void (*)(const ContactProblem&, const Watch&);

// Its convolutions and seconds when each tolerance is first met.
void yardstick(const ContactScene& s, const char* name, Solver run) {
  const auto influence = make_influence(s.grid, s.composite_modulus);
  const ContactProblem problem{influence.get(), s.gap, s.load / s.grid.cell_area(), s.limit_pressure,
                               influence->self_influence()};
  Field warm_up = s.gap;
  influence->apply(s.gap, warm_up);
  const Stopwatch clock;
  double tolerance = 1e-4;
  run(problem, [&](const ContactResidual& residual, int convolutions) {
    for (; residual.epsilon <= tolerance && tolerance > 1e-11; tolerance /= 100)
      fmt::print("{}\t{}\t{}\t{:.0e}\t\t\t{}\t\t\t{:.4f}\t\t{:.1e}\n", s.name, s.grid.shape.ny, name,
                 tolerance, convolutions, clock.seconds(), residual.epsilon);
    return tolerance > 1e-11 && convolutions < give_up;
  });
  if (tolerance > 1e-11) fmt::print("# {} by {}: {:.0e} not met\n", s.name, name, tolerance);
}

void tolerances(const std::string& name, Index n) {
  const ContactScene scene = contact_scene(name, n);
  const OperatorSeconds one(scene, 1);
  const Contact exact = solve(scene, 1e-11, 1);
  for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Contact c = solve(scene, tolerance, 1);
    fmt::print("{}\t{}\tguarded\t{:.0e}\t{:.1e}\t{:.1e}\t{:.2f}\t{:.2f}\t{:.4f}\t{:.4f}\t{:.2f}\t{:.1e}{}\n",
               name, n, tolerance, error(c.max_pressure, exact.max_pressure), error(c.area, exact.area),
               c.convolutions, c.preconditionings, c.setup_seconds, c.seconds, c.seconds / one.of(c),
               c.residual, c.converged ? "" : "\t" + c.reason);
  }
  yardstick(scene, "polonsky-keer", polonsky_keer);
  yardstick(scene, "projected-gradient", projected_gradient);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 1024, n = argc > 2 ? std::atol(argv[2]) : 256;
  discretisation(largest);
  fmt::print(
      "# case\tn\tmethod\ttol\tp_error\tarea_error\tconvolutions\tpreconditionings\tsetup_seconds\tseconds\t"
      "over_operators\tresidual\n");
  for (const char* name : {"A", "B", "B2", "C10", "C90", "D"}) tolerances(name, n);
}
