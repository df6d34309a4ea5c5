// Compiled with finite-math-only arithmetic where that gives vectors: shared inline code stays out.
#include "stress/corner.hpp"

namespace asperity {
namespace {

enum { xx, yy, zz, xy, xz, yz };
enum { normal, shear_x, shear_y };
constexpr int lanes = static_cast<int>(corner_lanes);
using Lanes = double[lanes];

template <class Function>
inline void each_lane(double* out, Function f) {
  if (out == nullptr) return;
#pragma GCC unroll 1
  for (int l = 0; l < lanes; ++l) out[l] = f(l);
}

// Eight corners in a row, and what their functions share.
struct Corners {
  alignas(64) Lanes X, r, T, A, L, L_turned;
  double Y, z, nu;

  void place(double y) {
    Y = y;
    each_lane(r, [&](int l) { return std::sqrt(X[l] * X[l] + Y * Y + z * z); });
  }
  void arc(bool wanted) {
    each_lane(wanted ? T : nullptr, [&](int l) { return std::atan(X[l] * Y / (z * r[l])); });
  }

  void pressed(double* const out[6]) {
    each_lane(out[xx] || out[yy] ? A : nullptr, [&](int l) {
      const double X2 = X[l] * X[l];
      return std::atan(X[l] * Y * (X2 + Y * Y) / ((r[l] + z) * (X2 * r[l] + z * Y * Y)));
    });
    using namespace corner;
    each_lane(out[xx], [&](int l) { return normal::xx(X[l], Y, z, r[l], T[l], A[l], nu); });
    each_lane(out[yy], [&](int l) { return normal::yy(X[l], Y, z, r[l], T[l], A[l], nu); });
    each_lane(out[zz], [&](int l) { return normal::zz(X[l], Y, z, r[l], T[l]); });
    each_lane(out[xy], [&](int l) { return normal::xy(z, r[l], nu); });
    each_lane(out[xz], [&](int l) { return G(X[l], Y, z, r[l]); });
    each_lane(out[yz], [&](int l) { return G(Y, X[l], z, r[l]); });
  }

  void logarithms(bool straight, bool turned) {
    each_lane(straight ? L : nullptr,
              [&](int l) { return std::log((Y + r[l]) / std::sqrt(X[l] * X[l] + z * z)); });
    each_lane(turned ? L_turned : nullptr,
              [&](int l) { return std::log((X[l] + r[l]) / std::sqrt(Y * Y + z * z)); });
  }

  void sheared_along_x(double* const out[6]) {
    logarithms(out[xx] || out[yy], out[xy]);
    using namespace corner;
    each_lane(out[xx], [&](int l) { return shear::xx(X[l], Y, z, r[l], L[l], nu); });
    each_lane(out[yy], [&](int l) { return shear::yy(Y, z, r[l], L[l], nu); });
    each_lane(out[zz], [&](int l) { return G(X[l], Y, z, r[l]); });
    each_lane(out[xy], [&](int l) { return shear::xy(X[l], z, r[l], L_turned[l], nu); });
    each_lane(out[xz], [&](int l) { return shear::xz(X[l], Y, z, r[l], T[l]); });
    each_lane(out[yz], [&](int l) { return shear::yz(z, r[l]); });
  }

  void sheared_along_y(double* const out[6]) {
    logarithms(out[xy], out[xx] || out[yy]);
    using namespace corner;
    each_lane(out[xx], [&](int l) { return shear::yy(X[l], z, r[l], L_turned[l], nu); });
    each_lane(out[yy], [&](int l) { return shear::xx(Y, X[l], z, r[l], L_turned[l], nu); });
    each_lane(out[zz], [&](int l) { return G(Y, X[l], z, r[l]); });
    each_lane(out[xy], [&](int l) { return shear::xy(Y, z, r[l], L[l], nu); });
    each_lane(out[xz], [&](int l) { return shear::yz(z, r[l]); });
    each_lane(out[yz], [&](int l) { return shear::xz(Y, X[l], z, r[l], T[l]); });
  }
};

bool wanted(double* const out[6]) { return out[0] || out[1] || out[2] || out[3] || out[4] || out[5]; }

// The rows j of six arrays.
struct Rows {
  double* out[6];
  Rows(double* const from[6], std::ptrdiff_t j) {
    for (int c = 0; c < 6; ++c) out[c] = from[c] == nullptr ? nullptr : from[c] + j * lanes;
  }
};

template <class Place>
void each_row(Corners& corners, std::ptrdiff_t rows, double depth, double nu, double* const out[3][6],
              Place y) {
  corners.z = depth > 1e-30 ? depth : 1e-30, corners.nu = nu;
  const bool arcs =
      out[normal][xx] || out[normal][yy] || out[normal][zz] || out[shear_x][xz] || out[shear_y][yz];
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    corners.place(y(j));
    corners.arc(arcs);
    if (wanted(out[normal])) corners.pressed(Rows(out[normal], j).out);
    if (wanted(out[shear_x])) corners.sheared_along_x(Rows(out[shear_x], j).out);
    if (wanted(out[shear_y])) corners.sheared_along_y(Rows(out[shear_y], j).out);
  }
}

}  // namespace

void corner_tile(double first, double height, std::ptrdiff_t rows, double depth, double nu,
                 double* const out[3][6]) {
  Corners corners;
  each_lane(corners.X, [&](int l) { return first + l; });
  each_row(corners, rows, depth, nu, out,
           [&](std::ptrdiff_t j) { return (static_cast<double>(j) + 0.5) * height; });
}

void corner_tile(const double* x, const double* y, std::ptrdiff_t rows, double depth, double nu,
                 double* const out[3][6]) {
  Corners corners;
  each_lane(corners.X, [&](int l) { return x[l]; });
  each_row(corners, rows, depth, nu, out, [&](std::ptrdiff_t j) { return y[j]; });
}

}  // namespace asperity
