#include "transform/mirrored.hpp"

#include <algorithm>

namespace asperity {
namespace {

constexpr Index width = MirroredTransform::width;

void mirror(Parity parity, double* x, Index given, Index period) {
  if (2 * given <= period) std::fill(x + given * width, x + (period - given + 1) * width, 0.0);
  const double sign = parity == Parity::even ? 1 : -1;
  for (Index j = 1; j < std::min(given, (period + 1) / 2); ++j)
    for (Index q = 0; q < width; ++q) x[(period - j) * width + q] = sign * x[j * width + q];
}

}  // namespace

void MirroredTransform::apply(Parity parity, double* x, Index given) const {
  mirror(parity, x, given, period());
  auto* z = reinterpret_cast<Complex*>(x);
  complex_.forward(z);
  if (parity == Parity::even) return;
  for (Index k = 0; k < (period() / 2 + 1) * width / 2; ++k) z[k] = {-z[k].imag(), z[k].real()};
}

}  // namespace asperity
