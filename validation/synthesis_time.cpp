/// Cost of drawing a surface, and where the direct sum crosses the transform.
///
/// `ratio_to_transform` is the time of one surface, noise and all, over that of one real transform there and
/// back of the padded size (N+K-1)², measured in the same run on one thread. In the second table `direct` and
/// `transform` are seconds of the two summations, the noise included; `model` is the ratio direct/transform
/// that the cost model predicts, which decides at 1.
///
///     synthesis_time [LARGEST_N]
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

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

double drawn(Index size, Index n, Summation summation, int threads) {
  const Synthesis synthesis(kernel(size), {n, n}, {false, summation, threads});
  const WhiteNoise noise(1);
  return seconds_of([&] { synthesis.surface(noise); });
}

double padded_transform(Index n) {
  const Index side = fast_length(n, 2);
  const RealTransform2D transform({side, side});
  AlignedVector<double> field(static_cast<std::size_t>(side * side));
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  return seconds_of([&] {
    transform.forward(field.data(), spectrum.data());
    transform.inverse(spectrum.data(), field.data());
  });
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 1024;
  fmt::print("# N\tK\tseconds\tseconds_2_threads\tratio_to_transform\n");
  for (Index n = 128; n <= largest; n *= 2) {
    const double seconds = drawn(61, n, Summation::transform, 1);
    fmt::print("{}\t{}\t{:.3e}\t{:.3e}\t{:.2f}\n", n, 61, seconds, drawn(61, n, Summation::transform, 2),
               seconds / padded_transform(n + 60));
  }
  fmt::print("\n# N\tK\tdirect\ttransform\tratio\tmodel\n");
  for (Index n : {64, 128, 512})
    for (Index size : {1, 3, 5, 7, 9, 13, 17, 25}) {
      const double direct = drawn(size, n, Summation::direct, 1),
                   fast = drawn(size, n, Summation::transform, 1);
      const SynthesisCost model = synthesis_cost({size, size}, {n, n});
      fmt::print("{}\t{}\t{:.3e}\t{:.3e}\t{:.2f}\t{:.2f}\n", n, size, direct, fast, direct / fast,
                 model.direct / model.transform);
    }
  return 0;
}
