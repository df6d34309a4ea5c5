/// What each request for stresses costs: the volume, parts of it, and the search for the maximum.
///
///     stress_request_time [LARGEST_N]         128, or 512 unless given
///
/// Below a Hertz contact of unit radius on n × n cells of a square three radii wide, ν = 0.3, layers at equal
/// steps from the surface to 1.2 radii, everything from the pressure on: transforms planned, influences and
/// pressure transformed, all values on the full grid. `cpu` is processor time of all threads, `wall` what
/// passed, `first` the processor time of the first call, which pays for plans and fresh memory. `MB` is what a
/// process takes at its peak beyond its pressure and the values kept. `r2c` is cpu a
/// layer over one real-to-complex transform of the padded square; `error` the largest difference from the
/// layers in full, over the largest pressure.
#include <cstdlib>
#include <ctime>
#include <functional>

#include <fmt/format.h>

#include "reference/hertz_stress.hpp"
#include "stress/equivalent.hpp"
#include "stress/layers.hpp"
#include "stress/maximum.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double poisson = 0.3;

double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Scene {
  Grid grid;
  Field pressure;
  std::vector<double> depths;

  Scene(Index n, int layers)
      : grid{{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)},
        pressure(hertz_pressure(grid)) {
    for (int l = 0; l < layers; ++l) depths.push_back(1.2 * l / (layers - 1));
  }
};

void report(
    const Scene& scene, const std::string& request, const std::function<void()>& call,
    const std::function<double()>& error = [] { return 0.0; }) {
  auto used = [&] {
    const double start = processor_seconds();
    call();
    return processor_seconds() - start;
  };
  const double megabytes = peak_memory(call), first = used();
  Runs processor, clock;
  repeat([&] {
    const Stopwatch watch;
    processor.add(used());
    clock.add(watch.seconds());
  });
  const Seconds cpu = processor.seconds(), wall = clock.seconds();
  const Index n = scene.grid.shape.nx;
  const auto layers = static_cast<double>(scene.depths.size());
  fmt::print("{}\t{}\t{}\t{:.3f}\t{:.3f}\t{:.3f}\t{:.1f}\t{:.1f}\t{:.1e}\n", request, n, layers, first, cpu,
             wall, megabytes, cpu / layers / real_transform_seconds({2 * n, 2 * n}), error());
}

// Six components, von Mises kept.
void volume(const Scene& s, int threads, DepthResolution resolution, Field& out) {
  const Index n = s.grid.shape.nx;
  StressSolver({s.grid, s.pressure, poisson}, threads, resolution)
      .layers(s.depths, stress::all, [&](Index l, Index i, const StressRow& row) {
        von_mises(row, {out.data() + (l * n + i) * n, row[0].size()});
      });
}

double adapted_error(const Scene& s) {
  const StressSolver full({s.grid, s.pressure, poisson}),
      adapted({s.grid, s.pressure, poisson}, 1, DepthResolution::adapted);
  StressSolver::Workspace one, other;
  const Index n = s.grid.shape.nx;
  double error = 0;
  for (std::size_t l = 0; l < s.depths.size(); l += 4) {
    std::array<Field, 6> whole;
    for (Field& f : whole) f.resize(n, n);
    full.layer(s.depths[l], stress::all, one, [&](Index i, const StressRow& row) {
      for (auto c : stress::components) std::ranges::copy(row[c], whole[c].row(i).data());
    });
    adapted.layer(s.depths[l], stress::all, other, [&](Index i, const StressRow& row) {
      for (auto c : stress::components)
        for (Index j = 0; j < n; ++j)
          error = std::max(error, std::abs(row[c][static_cast<std::size_t>(j)] - whole[c](i, j)));
    });
  }
  return error;
}

void report_all(Index n, int layers) {
  const Scene s(n, layers);
  Field out(layers, n * n);
  out.setZero();
  using enum DepthResolution;
  report(
      s, "volume_adapted", [&] { volume(s, 1, adapted, out); }, [&] { return adapted_error(s); });
  report(s, "volume_adapted_2_threads", [&] { volume(s, 2, adapted, out); });
  report(s, "volume_full", [&] { volume(s, 1, full, out); });
  report(s, "volume_full_2_threads", [&] { volume(s, 2, full, out); });
  report(s, "volume_adapted_zz", [&] {
    StressSolver({s.grid, s.pressure, poisson}, 1, adapted)
        .layers(s.depths, stress::Set().set(stress::zz), [&](Index l, Index i, const StressRow& row) {
          std::ranges::copy(row[stress::zz], out.data() + (l * n + i) * n);
        });
  });
  for (DepthResolution resolution : {adapted, full})
    report(s, resolution == full ? "section_full" : "section_adapted", [&] {
      StressSolver({s.grid, s.pressure, poisson}, Plane{true, n / 2}, 1, resolution)
          .layers(s.depths, stress::all, [&](Index l, Index, const StressRow& row) {
            von_mises(row, {out.row(l).data(), row[0].size()});
          });
    });
  report(s, "maximum", [&] { maximum_stress(StressSolver({s.grid, s.pressure, poisson}, 1, adapted)); });
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  fmt::print("# request\tn\tlayers\tfirst\tcpu\tcpu_spread\twall\twall_spread\tMB\tr2c\terror\n");
  report_all(128, 32);
  if (argc < 2 || std::atol(argv[1]) >= 512) report_all(512, 64);
}
