/// Error of the contact solution against its cost, on the scenes of contact_scenes.hpp.
///
///     contact_error_time [LARGEST_N [N]]
///
/// First table: smooth spheres for N = 32 … LARGEST_N (1024) to ε = 1e-8, against Hertz, so that the discretisation
/// shows; on one and on two threads. The area's error is that of cells on a circle. Second table: every scene
/// on N × N (256), to ε = 1e-4 … 1e-10, against its solution at ε = 1e-11, so that the tolerance shows; and
/// by the yardsticks of contact_yardsticks.hpp, given up after 600 convolutions.
///
/// convolutions, preconditionings  by their share of the finest cells, coarser grids included
/// setup_seconds                   coefficients, spectra and plans
/// seconds                         the solution, the nested start included
/// over_operators                  seconds, the nested start included, over (convolutions × the time of one +
///                                 preconditionings × the time of one)
/// convolution_over_r2c            the time of one convolution over that of one padded real transform
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "contact/bodies.hpp"
#include "contact/influence.hpp"
#include "contact/solver.hpp"
#include "contact_scenes.hpp"
#include "contact_yardsticks.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr int give_up = 600;

struct Solved {
  Contact contact;
  Seconds setup, seconds;
};

Solved solve(const ContactScene& s, double tolerance, int threads) {
  Contact contact;
  Runs setup, seconds;
  repeat([&] {
    contact = solve_contact(
        s.grid, s.gap, s.composite_modulus,
        {.load = s.load, .limit_pressure = s.limit_pressure, .tolerance = tolerance, .threads = threads});
    setup.add(contact.setup_seconds);
    seconds.add(contact.seconds);
  });
  return {std::move(contact), setup.seconds(), seconds.seconds()};
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
      "setup_seconds\tsetup_seconds_spread\tseconds\tseconds_spread\tover_operators\tconvolution_over_"
      "r2c\tresidual\n");
  const Hertz exact = hertz(scene_bodies, scene_load);
  for (Index n = 32; n <= largest; n *= 2) {
    const ContactScene scene = contact_scene("smooth", n);
    const double transform = real_transform_seconds({2 * n, 2 * n});
    for (int threads : {1, 2}) {
      const OperatorSeconds one(scene, threads);
      const auto [c, setup, seconds] = solve(scene, 1e-8, threads);
      fmt::print(
          "smooth\t{}\t{}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2f}\t{:.2f}\t{:.2e}\t{:.2e}\t{:.2f}\t{:.2f}\t{:.1e}\n",
          n, threads, error(c.max_pressure, exact.pressure), error(c.approach, exact.approach),
          error(c.area, std::numbers::pi * exact.radius * exact.radius), c.convolutions, c.preconditionings,
          setup, seconds, seconds / one.of(c), one.convolution / transform, c.residual);
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
  struct Met {
    double tolerance = 0, epsilon = 0;
    int convolutions = 0;
    Runs seconds = {};
  };
  std::vector<Met> all{{1e-4}, {1e-6}, {1e-8}, {1e-10}};
  repeat([&] {
    const Stopwatch clock;
    auto next = all.begin();
    run(problem, [&](const ContactResidual& residual, int convolutions) {
      for (; next != all.end() && residual.epsilon <= next->tolerance; ++next) {
        next->epsilon = residual.epsilon, next->convolutions = convolutions;
        next->seconds.add(clock.seconds());
      }
      return next != all.end() && convolutions < give_up;
    });
  });
  for (const Met& met : all)
    if (met.convolutions > 0)
      fmt::print("{}\t{}\t{}\t{:.0e}\t\t\t{}\t\t\t\t{:.2e}\t\t{:.1e}\n", s.name, s.grid.shape.ny, name,
                 met.tolerance, met.convolutions, met.seconds.seconds(), met.epsilon);
    else
      fmt::print("# {} by {}: {:.0e} not met\n", s.name, name, met.tolerance);
}

void tolerances(const std::string& name, Index n) {
  const ContactScene scene = contact_scene(name, n);
  const OperatorSeconds one(scene, 1);
  const Contact exact = solve(scene, 1e-11, 1).contact;
  for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const auto [c, setup, seconds] = solve(scene, tolerance, 1);
    fmt::print("{}\t{}\tguarded\t{:.0e}\t{:.1e}\t{:.1e}\t{:.2f}\t{:.2f}\t{:.2e}\t{:.2e}\t{:.2f}\t{:.1e}{}\n",
               name, n, tolerance, error(c.max_pressure, exact.max_pressure), error(c.area, exact.area),
               c.convolutions, c.preconditionings, setup, seconds, seconds / one.of(c), c.residual,
               c.converged ? "" : "\t" + c.reason);
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
      "# case\tn\tmethod\ttol\tp_error\tarea_error\tconvolutions\tpreconditionings\tsetup_seconds\t"
      "setup_seconds_spread\tseconds\tseconds_spread\tover_operators\tresidual\n");
  for (const char* name : contact_scene_names) tolerances(name, n);
}
