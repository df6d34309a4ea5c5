#include "transform/mirrored.hpp"

#include <algorithm>

namespace asperity {
namespace {

void mirror(Parity parity, Complex* x, Index given, Index period) {
  if (2 * given <= period) std::fill(x + given, x + period - given + 1, Complex{});
  const double sign = parity == Parity::even ? 1 : -1;
  for (Index j = 1; j < std::min(given, (period + 1) / 2); ++j) x[period - j] = sign * x[j];
}

}  // namespace

void MirroredTransform::apply(Parity parity, Complex* x, Index given, Complex* out) const {
  for (Index c = 0; c < pairs; ++c) mirror(parity, x + c * stride(), given, period());
  columns_.forward(x, out);
  if (parity == Parity::even) return;
  for (Index c = 0; c < pairs; ++c)
    for (Complex* z = out + c * stride(); z <= out + c * stride() + period() / 2; ++z)
      *z = {-z->imag(), z->real()};
}

}  // namespace asperity
