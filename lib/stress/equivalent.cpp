#include "stress/equivalent.hpp"

#include <algorithm>

#include "core/memory.hpp"

namespace asperity {
namespace {

// Without a branch, and unrolled, so that a row is solved in vectors.

using stress::Tensor;
using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// a u + b v.
inline Vector combined(double a, const Vector& u, double b, const Vector& v) {
  return {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
}

inline Vector scaled(double f, const Vector& v) { return {f * v[0], f * v[1], f * v[2]}; }
inline Vector unit(const Vector& v) { return scaled(1 / std::sqrt(dot(v, v)), v); }

inline Vector either(bool first, const Vector& a, const Vector& b) {
  return {first ? a[0] : b[0], first ? a[1] : b[1], first ? a[2] : b[2]};
}
inline Vector longer(const Vector& a, const Vector& b) { return either(dot(a, a) >= dot(b, b), a, b); }

// The three rows of s, less x on the diagonal.
struct TensorRows {
  Vector a, b, c;
  explicit TensorRows(const Tensor& s, double x = 0)
      : a{s[stress::xx] - x, s[stress::xy], s[stress::xz]},
        b{s[stress::xy], s[stress::yy] - x, s[stress::yz]},
        c{s[stress::xz], s[stress::yz], s[stress::zz] - x} {}

  double determinant() const { return dot(a, cross(b, c)); }
  Vector adjugate_column() const { return longer(longer(cross(b, c), cross(c, a)), cross(a, b)); }
  Vector times(const Vector& v) const { return {dot(a, v), dot(b, v), dot(c, v)}; }
};

// The root of x³ - 3x = 2h in [√3, 2], 0 ≤ h ≤ 1, from a parabola that is 3.3e-3 off at most.
inline double lone_root(double h) {
  constexpr double start = std::numbers::sqrt3, slope = 1.0 / 3;
  double x = start + h * (slope - h * (start + slope - 2));
  for (int step = 0; step < 3; ++step) x -= (x * (x * x - 3) - 2 * h) / (3 * (x * x - 1));
  return x;
}

// A unit vector across v: near the axis x, unless v is.
inline Vector across(const Vector& v) {
  const bool x = std::abs(v[0]) < 0.9;
  return unit(combined(1, either(x, {1, 0, 0}, {0, 1, 0}), -(x ? v[0] : v[1]), v));
}

// The two principal values in the plane of u and w, the larger first, and their directions.
struct PrincipalPlane {
  double larger, smaller;
  Vector first, second;

  PrincipalPlane(const TensorRows& s, const Vector& u, const Vector& w) {
    const Vector su = s.times(u), sw = s.times(w);
    const double uu = dot(u, su), ww = dot(w, sw), uw = dot(u, sw);
    const double middle = 0.5 * (uu + ww), half = 0.5 * (uu - ww), radius = std::sqrt(half * half + uw * uw);
    larger = middle + radius, smaller = middle - radius;
    // Half the angle 2θ of (half, uw), or none: the larger of |cos θ| and |sin θ| first.
    const bool apart = radius > 1e-100;
    const double over = apart ? 1 / radius : 0,
                 big = std::sqrt(0.5 * (1 + (apart ? std::abs(half) * over : 1)));
    const double small = 0.5 * uw * over / big;
    const double cosine = half >= 0 ? big : std::abs(small),
                 sine = half >= 0 ? small : std::copysign(big, uw);
    first = combined(cosine, u, sine, w), second = combined(-sine, u, cosine, w);
  }
};

inline Vector into_the_body(const Vector& v) {
  constexpr double least = 1e-8;
  const double in_plane = std::abs(v[0]) > least ? v[0] : v[1];
  return scaled(std::copysign(1.0, std::abs(v[2]) > least ? v[2] : in_plane), v);
}

[[gnu::always_inline]] inline PrincipalStress solve(Tensor s) {
  using namespace stress;
  const double mean = (s[xx] + s[yy] + s[zz]) / 3;
  s[xx] -= mean, s[yy] -= mean, s[zz] -= mean;
  const double size = std::sqrt((s[xx] * s[xx] + s[yy] * s[yy] + s[zz] * s[zz]) / 6 +
                                (s[xy] * s[xy] + s[xz] * s[xz] + s[yz] * s[yz]) / 3);
  const double over = 1 / (size > 0 ? size : 1);
  for (double& c : s) c *= over;

  const double h = 0.5 * TensorRows(s).determinant(),
               x = std::copysign(lone_root(std::min(std::abs(h), 1.0)), h);
  const Vector v = unit(TensorRows(s, x).adjugate_column()), u = across(v);
  const PrincipalPlane plane(TensorRows(s), u, cross(v, u));
  const double lone = mean + size * x, larger = mean + size * plane.larger,
               smaller = mean + size * plane.smaller;
  const bool above = x > 0;
  return {
      {above ? lone : larger, above ? larger : smaller, above ? smaller : lone},
      {into_the_body(either(above, v, plane.first)), into_the_body(either(above, plane.first, plane.second)),
       into_the_body(either(above, plane.second, v))}};
}

// take(p, to) puts number k of a point to to(k).
template <std::size_t outputs, class Take>
inline void along_row(const StressRow& s, RowOutputs out, Take take) {
  constexpr std::size_t lanes = 8;
  double in[6][lanes] = {}, solved[outputs][lanes];
  for (std::size_t begin = 0; begin < s[0].size(); begin += lanes) {
    const std::size_t points = std::min(lanes, s[0].size() - begin);
    for (std::size_t c = 0; c < 6; ++c) std::copy_n(s[c].data() + begin, points, in[c]);
    for (std::size_t l = 0; l < lanes; ++l)
      take(solve({in[0][l], in[1][l], in[2][l], in[3][l], in[4][l], in[5][l]}),
           [&](std::size_t k) -> double& { return solved[k][l]; });
    for (std::size_t k = 0; k < outputs; ++k) std::copy_n(solved[k], points, out[k].data() + begin);
  }
}

double differences(double xx, double yy, double zz) {
  const double a = xx - yy, b = yy - zz, c = zz - xx;
  return a * a + b * b + c * c;
}

}  // namespace

void von_mises(const StressRow& s, std::span<double> out) {
  for (std::size_t j = 0; j < out.size(); ++j)
    out[j] = von_mises(s[0][j], s[1][j], s[2][j], s[3][j], s[4][j], s[5][j]);
}

void max_shear_stress(const StressRow& s, std::span<double> out) {
  for (std::size_t j = 0; j < out.size(); ++j)
    out[j] = max_shear_stress({s[0][j], s[1][j], s[2][j], s[3][j], s[4][j], s[5][j]});
}

void octahedral_shear(const StressRow& s, std::span<double> out) {
  von_mises(s, out);
  for (double& value : out) value *= octahedral_over_von_mises;
}

void largest_principal_stress(const StressRow& s, std::span<double> out) {
  const std::span<double> only[] = {out};
  along_row<1>(s, only, [](const PrincipalStress& p, auto to) { to(0) = p.value[0]; });
}

PrincipalStress principal_stress(const Tensor& s) { return solve(s); }

void principal_stress(const StressRow& s, RowOutputs out) {
  along_row<3>(s, out, [](const PrincipalStress& p, auto to) {
    to(0) = p.value[0], to(1) = p.value[1], to(2) = p.value[2];
  });
}

void principal_directions(const StressRow& s, RowOutputs out) {
  along_row<9>(s, out, [](const PrincipalStress& p, auto to) {
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k)
#pragma GCC unroll 3
      for (std::size_t i = 0; i < 3; ++i) to(3 * k + i) = p.direction[k][i];
  });
}

MisesLayer::MisesLayer(Shape layer) : a_(large_field(layer)), b_(large_field(layer)) {}

void MisesLayer::add(stress::Component c, Index i, std::span<const double> values) {
  const auto s = Eigen::Map<const Eigen::Array<double, 1, Eigen::Dynamic>>(values.data(), a_.cols());
  switch (c) {
    case stress::xx:
      a_.row(i) = s;
      break;
    case stress::yy:
      b_.row(i) = s;
      break;
    case stress::zz:
      for (Index j = 0; j < s.size(); ++j) a_(i, j) = differences(a_(i, j), b_(i, j), s(j));
      break;
    case stress::xy:
      b_.row(i) = s;
      break;
    case stress::xz:  // the first square waits, for a compiler may fuse it with this sum
      for (Index j = 0; j < s.size(); ++j) b_(i, j) = b_(i, j) * b_(i, j) + s(j) * s(j);
      break;
    case stress::yz:
      for (Index j = 0; j < s.size(); ++j) b_(i, j) = b_(i, j) + s(j) * s(j);
  }
}

void MisesLayer::row(Index i, double factor, std::span<double> out) const {
  for (Index j = 0; j < a_.cols(); ++j) out[size(j)] = factor * std::sqrt(0.5 * a_(i, j) + 3 * b_(i, j));
}

}  // namespace asperity
