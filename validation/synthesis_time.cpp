/// Cost of drawing a surface, and where the direct sum crosses the transform.
///
/// First table: `peak` is what a process that draws a surface of N × M heights takes more than one that does
/// not, `working_set` what the program says that it will take, both in MB; two threads.
///
/// Second table: a surface of N × N heights with a kernel of K × K goes to a sink that throws it away.
/// `noise` are the seconds of its random numbers, `transforms` those of one real transform there and back of
/// the padded surface, (N+K-1)², and `ratio` is (surface - noise)/transforms, all on one thread; `surface_2`
/// are seconds on two threads.
///
/// Third table: `direct` and `transform` are seconds of the two summations, the noise included; `model` is
/// the ratio direct/transform of the sums alone that the cost model predicts, which decides at 1.
///
/// Fourth table: what the exactness of the autocorrelation costs. An exponential target of five samples'
/// decay length, lags that cover `c` decay lengths; `error` is the largest of the surface's autocorrelation
/// over all lags of the plane, `kernel` the seconds of the kernel, `surface` those of N × N heights, the
/// noise included.
///
///     synthesis_time [LARGEST_N]         1024 unless given
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "acf/kernel.hpp"
#include "reference/exponential_target.hpp"
#include "surface/synthesis.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

Field kernel(Index size) {
  return Field::NullaryExpr(size, size, [&](Index k, Index l) {
    const double middle = 0.5 * static_cast<double>(size - 1), reach = middle + 1;
    return std::exp(-4.6 * std::hypot(static_cast<double>(k) - middle, static_cast<double>(l) - middle) /
                    reach);
  });
}

void throw_away(Index, Eigen::Ref<Field>) {}

Synthesis synthesis(Index size, Shape shape, int threads, Summation summation = Summation::transform) {
  return Synthesis(kernel(size), shape, {false, summation, threads});
}

Seconds drawn(const Synthesis& synthesis) {
  return seconds_of([&] { synthesis.surface(WhiteNoise(1), throw_away); });
}

Seconds noise_seconds(Index n) {
  WhiteNoise noise(1);
  std::vector<double> row(static_cast<std::size_t>(n));
  return seconds_of([&] {
    for (Index i = 0; i < n; ++i) noise.row(i, row);
  });
}

Seconds padded_transform(Index n) {
  const Index side = fast_length(n, 2);
  const RealTransform2D transform({side, side});
  AlignedVector<double> field(static_cast<std::size_t>(side * side));
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  return seconds_of([&] {
    transform.forward(field.data(), spectrum.data());
    transform.inverse(spectrum.data(), field.data());
  });
}

void print_memory(Index size, Shape shape) {
  const Synthesis two = synthesis(size, shape, 2);
  const double peak = peak_memory([&] { two.surface(WhiteNoise(1), throw_away); });
  fmt::print("{}\t{}\t{}\t{:.0f}\t{:.0f}\n", shape.nx, shape.ny, size, peak,
             static_cast<double>(two.working_set()) * 1e-6);
}

void print_cost(Index n, Index size) {
  const Seconds noise = noise_seconds(n + size - 1), transforms = padded_transform(n + size - 1),
                surface = drawn(synthesis(size, {n, n}, 1));
  fmt::print("{}\t{}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2f}\n", n, size, noise, transforms, surface,
             drawn(synthesis(size, {n, n}, 2)), (surface - noise) / transforms);
}

void print_crossing(Index n, Index size) {
  const Seconds direct = drawn(synthesis(size, {n, n}, 1, Summation::direct)),
                fast = drawn(synthesis(size, {n, n}, 1));
  const SynthesisCost model = synthesis_cost({size, size}, {n, n});
  fmt::print("{}\t{}\t{:.2e}\t{:.2e}\t{:.2f}\t{:.2f}\n", n, size, direct, fast, direct / fast,
             model.direct / model.transform);
}

void print_exactness(Index n, double c) {
  const ExponentialTarget target{5, 5, std::exp(-1)};
  KernelRequest request;
  request.target = target;
  request.lags = target.lags(c);
  const Kernel k = solve_kernel(request);
  const Synthesis surfaces(k.values, {n, n}, {});
  fmt::print("{}\t{}\t{}\t{:.1e}\t{:.2e}\t{:.2e}\n", n, c, k.values.rows(), k.report.error,
             seconds_of([&] { solve_kernel(request); }), drawn(surfaces));
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 1024;
  fmt::print("# N\tM\tK\tpeak\tworking_set\n");
  for (Index size : {15, 61, 253}) print_memory(size, {largest, largest});
  if (largest >= 4096) print_memory(61, {65536, 4096});
  fmt::print(
      "\n# N\tK\tnoise\tnoise_spread\ttransforms\ttransforms_spread\t"
      "surface\tsurface_spread\tsurface_2\tsurface_2_spread\tratio\n");
  for (Index size : {15, 61, 253})
    for (Index n = 256; n <= largest; n *= 2) print_cost(n, size);
  fmt::print("\n# N\tK\tdirect\tdirect_spread\ttransform\ttransform_spread\tratio\tmodel\n");
  for (Index n : {64, 128, 512})
    for (Index size : {1, 3, 5, 7, 9, 13, 17, 25})
      if (n <= largest) print_crossing(n, size);
  fmt::print("\n# N\tc\tK\terror\tkernel\tkernel_spread\tsurface\tsurface_spread\n");
  for (double c : {3.0, 4.6, 6.0, 7.0, 9.0, 11.5, 14.0}) print_exactness(std::min<Index>(largest, 512), c);
  return 0;
}
