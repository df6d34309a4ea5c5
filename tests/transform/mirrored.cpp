#include "transform/mirrored.hpp"

#include <numbers>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

// The transform of n points adds ε log2 n, at most 8 ε here, of Σ|x|; Σ|x| is at most twice that of the
// points given.
TEST_CASE("mirrored sequences have the cosine or sine sums of their whole period as spectrum",
          "[transform][exact]") {
  constexpr Index width = MirroredTransform::width;
  for (Index period : {2, 6, 16, 30, 250})
    for (Parity parity : {Parity::even, Parity::odd})
      for (Index given : {Index{1}, period / 4 + 1, period / 2}) {
        Field x = random_field({given, width}, 5);
        if (parity == Parity::odd) x.row(0) = 0;
        const MirroredTransform transform(period);
        AlignedVector<Complex> in(static_cast<std::size_t>(transform.size()), 99.0), out(in);
        for (Index q = 0; q < width; q += 2)
          for (Index j = 0; j < given; ++j)
            in[static_cast<std::size_t>(q / 2 * transform.stride() + j)] = {x(j, q), x(j, q + 1)};
        transform.apply(parity, in.data(), given, out.data());
        double error = 0;
        for (Index k = 0; k <= period / 2; ++k)
          for (Index q = 0; q < width; ++q) {
            double sum = parity == Parity::even ? x(0, q) : 0;
            for (Index j = 1; j < given; ++j) {
              const double angle =
                  2 * std::numbers::pi * static_cast<double>(j * k % period) / static_cast<double>(period);
              sum += 2 * x(j, q) * (parity == Parity::even ? std::cos(angle) : std::sin(angle));
            }
            const Complex pair = out[static_cast<std::size_t>(q / 2 * transform.stride() + k)];
            error = std::max(error, std::abs(sum - (q % 2 == 0 ? pair.real() : pair.imag())));
          }
        CAPTURE(period, given, parity == Parity::odd);
        CHECK(error <= 8 * epsilon * 2 * x.abs().sum());
      }
}
