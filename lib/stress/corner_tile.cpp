// Compiled with finite-math-only arithmetic where that gives vectors: keep shared inline code out of this
// file.
#include "stress/corner_tile.hpp"

#include <cmath>

#include "stress/corner.hpp"

namespace asperity {
namespace {

enum { xx, yy, zz, xy, xz, yz };
constexpr int lanes = static_cast<int>(corner_lanes);
using Lanes = double[lanes];

template <class Function>
inline void each_lane(double* out, Function f) {
  if (out == nullptr) return;
#pragma GCC unroll 1
  for (int l = 0; l < lanes; ++l) out[l] = f(l);
}

}  // namespace

void corner_tile(double first, double height, std::ptrdiff_t rows, double depth, double nu,
                 double* const out[6]) {
  const bool in_plane = out[xx] != nullptr || out[yy] != nullptr, normal = in_plane || out[zz] != nullptr;
  const double z = depth > 1e-30 ? depth : 1e-30;
  alignas(64) Lanes X, r, T, A;
  each_lane(X, [&](int l) { return first + l; });
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    const double Y = (static_cast<double>(j) + 0.5) * height;
    auto row = [&](int c) { return out[c] == nullptr ? nullptr : out[c] + j * lanes; };
    each_lane(r, [&](int l) { return std::sqrt(X[l] * X[l] + Y * Y + z * z); });
    each_lane(normal ? T : nullptr, [&](int l) { return std::atan(X[l] * Y / (z * r[l])); });
    each_lane(in_plane ? A : nullptr, [&](int l) {
      const double X2 = X[l] * X[l];
      return std::atan(X[l] * Y * (X2 + Y * Y) / ((r[l] + z) * (X2 * r[l] + z * Y * Y)));
    });
    each_lane(row(xx), [&](int l) { return corner::xx(X[l], Y, z, r[l], T[l], A[l], nu); });
    each_lane(row(yy), [&](int l) { return corner::yy(X[l], Y, z, r[l], T[l], A[l], nu); });
    each_lane(row(zz), [&](int l) { return corner::zz(X[l], Y, z, r[l], T[l]); });
    each_lane(row(xy), [&](int l) { return corner::xy(z, r[l], nu); });
    each_lane(row(xz), [&](int l) { return corner::xz(X[l], Y, z, r[l]); });
    each_lane(row(yz), [&](int l) { return corner::yz(X[l], Y, z, r[l]); });
  }
}

}  // namespace asperity
