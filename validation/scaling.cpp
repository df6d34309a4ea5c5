/// How time and memory of every stage grow with the grid.
///
///     scaling [LARGEST_N]         4096 unless given
///
/// First table: each stage on N × N cells, N = 64 … LARGEST_N, on one thread and on two.
///     kernel      the equations of an exponential target at N/8 × N/8 lags, six decay lengths
///     synthesis   a surface by a kernel of 61 × 61, which goes to a sink that throws it away
///     moments     of its heights
///     acf         to lags of half the surface
///     psd         with Hann's windows
///     smooth      contact of two smooth spheres of contact_scenes.hpp, to ε = 1e-8
///     rough       the same with roughness
///     volume      of stress below the smooth contact: the von Mises stress of eight layers in full, whose rows
///                 go to a sink that throws them away, as to a file
///     maximum     the search for the largest von Mises stress below it
/// `seconds` with their set-up, FFTW's plans apart; `transforms` the same in real
/// transforms of (2N)² points, one there or back, on one thread; `MB` what a process takes for it at its peak
/// beyond what it has already, plans and influences included, its input not (2 MB are the program's own
/// pages); `doubles` the same in doubles a cell. N = 4096 is left out where it would take more than ten
/// seconds, or three quarters of the memory.
///
/// Second table: what doubling N takes. `exponent` e of seconds ~ (N² log N)^e, fitted from N = 256 on (from
/// LARGEST_N/2 if that is less); `time` and `memory` of the largest grid over those of one half as wide;
/// `largest` the N whose memory, the field that is given included, is 16 GiB, and `hours` there, both
/// extrapolated from the largest grid.
#include <cstdlib>
#include <functional>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "acf/kernel.hpp"
#include "contact/solver.hpp"
#include "contact_scenes.hpp"
#include "reference/exponential_target.hpp"
#include "reference/hertz_stress.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "stress/equivalent.hpp"
#include "stress/maximum.hpp"
#include "surface/synthesis.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr Index always = 2048;
constexpr double longest = 10;

using Work = std::function<void()>;
/// What a stage does on N × N cells on so many threads, its input made.
using Stage = Work (*)(Index n, int threads);

KernelRequest request(Index lags) {
  const double decay = static_cast<double>(lags) / 6;
  KernelRequest request;
  request.target = ExponentialTarget{decay, decay, std::exp(-1)};
  request.lags = {lags, lags};
  return request;
}

Work kernel(Index n, int) {
  return [r = request(n / 8)] { solve_kernel(r); };
}

Work synthesis(Index n, int threads) {
  return [n, threads, values = solve_kernel(request(31)).values] {
    Synthesis(values, {n, n}, {.threads = threads}).surface(WhiteNoise(1), [](Index, Eigen::Ref<Field>) {});
  };
}

Field heights(Index n) {
  return Synthesis(solve_kernel(request(31)).values, {n, n}, {}).surface(WhiteNoise(1));
}

Grid square(Index n) { return {{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)}; }

Work height_moments(Index n, int) {
  return [z = heights(n)] { moments(z); };
}

Work acf(Index n, int threads) {
  return [z = heights(n), grid = square(n), threads] {
    estimate_autocorrelation(z, grid, {.max_lag = default_max_lag(grid), .threads = threads});
  };
}

Work psd(Index n, int threads) {
  return [z = heights(n), grid = square(n), threads] { power_spectrum(z, grid, {}, threads); };
}

Work contact(const char* name, Index n, int threads) {
  return [s = contact_scene(name, n), threads] {
    solve_contact(
        s.grid, s.gap, s.composite_modulus,
        {.load = s.load, .limit_pressure = s.limit_pressure, .tolerance = 1e-8, .threads = threads});
  };
}
Work smooth(Index n, int threads) { return contact("smooth", n, threads); }
Work rough(Index n, int threads) { return contact("rough", n, threads); }

Work volume(Index n, int threads) {
  return [n, threads, p = hertz_pressure(square(n))] {
    const std::vector<double> depths{0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.2};
    const StressSolver solver({square(n), p, 0.3}, threads);
    std::vector<MisesLayer> sums;
    for (int k = 0; k < threads; ++k) sums.emplace_back(Shape{n, n});
    solver.each_layer(
        depths,
        [&](Index l, StressSolver::Workspace& work) {
          MisesLayer& sum = sums[size(l) % sums.size()];
          for (auto c : stress::components)
            solver.layer(depths[size(l)], stress::Set().set(c), work, [&](Index i, const StressRow& s) {
              sum.add(c, i, s[c]);
              if (c != stress::yz) return;
              std::vector<double> row(size(n));
              sum.row(i, 1, row);
            });
        },
        [](Index, Index) {});
  };
}

Work maximum(Index n, int threads) {
  return [threads, grid = square(n), p = hertz_pressure(square(n))] {
    maximum_stress(StressSolver({grid, p, 0.3}, threads, DepthResolution::adapted));
  };
}

struct Named {
  const char* name;
  Stage stage;
  bool threaded;
};
constexpr Named stages[] = {{"kernel", kernel, false},
                            {"synthesis", synthesis, true},
                            {"moments", height_moments, false},
                            {"acf", acf, true},
                            {"psd", psd, true},
                            {"smooth", smooth, true},
                            {"rough", rough, true},
                            {"volume", volume, true},
                            {"maximum", maximum, true}};

struct Point {
  Index n = 0;
  Seconds seconds;
  double megabytes = 0;
};

double unit_of(Index n) {
  const double side = static_cast<double>(n);
  return side * side * std::log(side);
}

// The slope of ln seconds over ln(N² log N).
double exponent(const std::vector<Point>& points, Index from) {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Point& p : points) {
    if (p.n < from) continue;
    const double u = std::log(unit_of(p.n)), v = std::log(p.seconds);
    ++count, x += u, y += v, xx += u * u, xy += u * v;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

// A row of the second table.
std::string doubled(const Named& stage, int threads, const std::vector<Point>& points, Index from) {
  constexpr double memory = 16 * 1073.741824;  // [MB]
  const double e = exponent(points, from);
  const Point &last = points.back(), &before = points[points.size() - 2];
  const auto side = static_cast<double>(last.n);
  const auto largest = static_cast<Index>(side * std::sqrt(memory / (last.megabytes + 8e-6 * side * side)));
  const double seconds = last.seconds * std::pow(unit_of(largest) / unit_of(last.n), e);
  return fmt::format("{}\t{}\t{:.2f}\t{:.1f}\t{:.1f}\t{}\t{:.2g}\n", stage.name, threads, e,
                     last.seconds / before.seconds, last.megabytes / before.megabytes, largest,
                     seconds / 3600);
}

double transform_seconds(Index n) {
  static std::map<Index, double> known;
  const auto [at, made] = known.try_emplace(n);
  if (made) at->second = real_transform_seconds({2 * n, 2 * n});
  return at->second;
}

Point measured(const Work& work, Index n) {
  const double megabytes = peak_memory(work);
  return {n, seconds_of(work), megabytes};
}

// Whether the next grid, four times as large, is small enough for this machine.
bool may_grow(const Point& last) {
  const double memory = 1e-6 * static_cast<double>(::sysconf(_SC_PHYS_PAGES) * ::sysconf(_SC_PAGESIZE));
  return 2 * last.n <= always || (4.5 * last.seconds <= longest && 4 * last.megabytes <= 0.75 * memory);
}

std::vector<Point> grow(const Named& stage, int threads, Index largest) {
  std::vector<Point> points;
  for (Index n = 64; n <= largest; n *= 2) {
    if (!points.empty() && !may_grow(points.back())) break;
    const Point p = measured(stage.stage(n, threads), n);
    fmt::print("{}\t{}\t{}\t{:.2e}\t{:.2f}\t{:.1f}\t{:.1f}\n", stage.name, n, threads, p.seconds,
               p.seconds / transform_seconds(n), p.megabytes,
               p.megabytes * 1e6 / (8 * static_cast<double>(n) * static_cast<double>(n)));
    std::fflush(stdout);
    points.push_back(p);
  }
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 4096;
  const Index fitted_from = std::min<Index>(256, largest / 2);
  std::string rows;
  fmt::print("# stage\tN\tthreads\tseconds\tseconds_spread\ttransforms\tMB\tdoubles\n");
  for (const Named& stage : stages)
    for (int threads = 1; threads <= (stage.threaded ? 2 : 1); ++threads)
      rows += doubled(stage, threads, grow(stage, threads, largest), fitted_from);
  fmt::print("\n# stage\tthreads\texponent\ttime\tmemory\tlargest\thours\n{}", rows);
  return 0;
}
