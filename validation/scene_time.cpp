/// What a scene does not need costs nothing: the same scene with a part left out.
///
///     scene_time [N]         256 unless given
///
/// The whole: a kernel of the exponential autocorrelation of 10 % length 0.328 mm; a surface of 0.4 µm rms on
/// N × N cells of 3 mm × 3 mm; two steel spheres of 50 mm under 5000 N, limit pressure 3600 MPa, ε = 1e-8;
/// von Mises stress in 32 layers down to 0.8 mm. Then the same with one thing changed:
///     drawn again     the kernel is there already
///     smooth          no roughness
///     elastic         no limit pressure
///     periodic        flats in place of the spheres, the surface repeats itself, and so do pressure and stress
///     one component   σzz in place of the six that von Mises takes
///     section         the plane y = 0 in place of the volume
///     maximum         the place of the largest von Mises stress in place of the volume
///     no stress
/// Seconds of each part, of eight rounds over all scenes, one thread; `share` is the scene's sum over that of the
/// whole.
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "acf/kernel.hpp"
#include "contact/solver.hpp"
#include "contact_scenes.hpp"
#include "reference/exponential_target.hpp"
#include "stress/equivalent.hpp"
#include "stress/layers.hpp"
#include "stress/maximum.hpp"
#include "surface/synthesis.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double side = 3e-3, length = 0.328125e-3, rms = 0.4e-6;

enum class Asked { volume, one_component, section, maximum, nothing };

struct Scene {
  const char* name;
  bool has_kernel = false, rough = true, plastic = true, periodic = false;
  Asked asked = Asked::volume;
};

constexpr Scene scenes[] = {{"the whole"},
                            {"drawn again", true},
                            {"smooth", false, false},
                            {"elastic", false, true, false},
                            {"periodic", false, true, true, true},
                            {"one component", false, true, true, false, Asked::one_component},
                            {"section", false, true, true, false, Asked::section},
                            {"maximum", false, true, true, false, Asked::maximum},
                            {"no stress", false, true, true, false, Asked::nothing}};

Grid grid_of(const Scene& scene, Index n) {
  const double cell = side / static_cast<double>(n);
  return {{n, n}, cell, cell, scene.periodic};
}

Field kernel(Index n) {
  const double samples = length / side * static_cast<double>(n);
  const ExponentialTarget target{samples, samples, 0.1};
  KernelRequest request;
  request.target = target;
  request.lags = target.lags();
  request.rms = rms;
  return solve_kernel(request).values;
}

Field undeformed(const Scene& scene, const Grid& grid, const Field& heights) {
  const Bodies bodies = scene.periodic ? Bodies{} : scene_bodies;
  return scene.rough ? Field(undeformed_gap(grid, bodies) - heights) : undeformed_gap(grid, bodies);
}

Contact press(const Scene& scene, const Grid& grid, const Field& gap) {
  const double limit = scene.plastic ? 3.6e9 : std::numeric_limits<double>::infinity();
  return solve_contact(grid, gap, scene_bodies.composite_modulus(),
                       {.load = scene_load, .limit_pressure = limit, .tolerance = 1e-8});
}

std::vector<double> depths() {
  std::vector<double> out;
  for (int k = 0; k < 32; ++k) out.push_back(0.8e-3 * k / 31);
  return out;
}

void compute(Asked asked, const Grid& grid, const Field& pressure, Field& out) {
  const Index n = grid.shape.ny;
  const double poisson = scene_bodies.poisson[0];
  constexpr auto adapted = DepthResolution::adapted;
  const auto keep_mises = [&](Index l, Index i, const StressRow& s) {
    von_mises(s, {out.row(l * n + i).data(), s[0].size()});
  };
  if (asked == Asked::volume)
    StressSolver({grid, pressure, poisson}, 1, adapted).layers(depths(), stress::all, keep_mises);
  if (asked == Asked::one_component)
    StressSolver({grid, pressure, poisson}, 1, adapted)
        .layers(depths(), stress::Set().set(stress::zz), [&](Index l, Index i, const StressRow& s) {
          std::ranges::copy(s[stress::zz], out.row(l * n + i).data());
        });
  if (asked == Asked::section)
    StressSolver({grid, pressure, poisson}, Plane{true, n / 2}, 1, adapted)
        .layers(depths(), stress::all, keep_mises);
  if (asked == Asked::maximum) maximum_stress(StressSolver({grid, pressure, poisson}, 1, adapted));
}

struct Times {
  Runs kernel = {}, draw = {}, contact = {}, stress = {};
};

template <class Call>
void time(Runs& runs, Call call) {
  const Stopwatch watch;
  call();
  runs.add(watch.seconds());
}

// One run of a scene, all parts that it needs.
void run(const Scene& scene, Index n, Times& times) {
  const Grid grid = grid_of(scene, n);
  Field values, heights;
  if (scene.rough) {
    time(times.kernel, [&] { values = kernel(n); });
    const Synthesis surfaces(values, grid.shape, {.periodic = grid.periodic.both()});
    time(times.draw, [&] { heights = surfaces.surface(WhiteNoise(7)); });
  }
  const Field gap = undeformed(scene, grid, heights);
  Field pressure, out = Field::Zero(32 * n, n);
  time(times.contact, [&] { pressure = press(scene, grid, gap).pressure; });
  if (scene.asked != Asked::nothing) time(times.stress, [&] { compute(scene.asked, grid, pressure, out); });
}

// Round by round: a machine that drifts then changes all scenes alike.
void print_rows(Index n) {
  std::vector<Times> times(std::size(scenes));
  for (std::size_t k = 0; k < times.size(); ++k) {
    Times warm;
    run(scenes[k], n, warm);
  }
  for (int round = 0; round < batches(); ++round)
    for (std::size_t k = 0; k < times.size(); ++k) run(scenes[k], n, times[k]);
  double whole = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Scene& scene = scenes[k];
    const Seconds solve = scene.has_kernel ? Seconds{} : times[k].kernel.seconds(),
                  draw = times[k].draw.seconds(), contact = times[k].contact.seconds(),
                  stress = times[k].stress.seconds(), sum = solve + draw + contact + stress;
    if (whole == 0) whole = sum;
    fmt::print("{}\t{}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2f}\n", scene.name, n, solve, draw,
               contact, stress, sum, sum / whole);
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index n = argc > 1 ? std::atol(argv[1]) : 256;
  fmt::print(
      "# scene\tN\tkernel\tkernel_spread\tdraw\tdraw_spread\tcontact\tcontact_spread\t"
      "stress\tstress_spread\tsum\tsum_spread\tshare\n");
  print_rows(n);
  return 0;
}
