#include "stress/influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/asinh_difference.hpp"
#include "math/gauss_legendre.hpp"
#include "stress/corner.hpp"

namespace asperity {
namespace {

using stress::Tensor;

double arc(double X, double Y, double z, double r) { return X * Y == 0 ? 0 : std::atan2(X * Y, z * r); }

// `distance` stands for 0 at the corner itself.
Tensor pressed_corner(double X, double Y, double z, double nu, double distance) {
  using namespace corner::normal;
  const double r = std::sqrt(X * X + Y * Y + z * z), XY = X * Y, T = arc(X, Y, z, r);
  const double A = XY == 0 ? 0 : std::atan2(XY * (X * X + Y * Y) / (r + z), X * X * r + z * Y * Y);
  return {xx(X, Y, z, r, T, A, nu),        yy(X, Y, z, r, T, A, nu), zz(X, Y, z, r, T),
          xy(z, r > 0 ? r : distance, nu), corner::G(X, Y, z, r),    corner::G(Y, X, z, r)};
}

// All but L, whose difference between two corners is taken at once.
Tensor sheared_corner(double X, double Y, double z, double nu) {
  using namespace corner::shear;
  const double r = std::sqrt(X * X + Y * Y + z * z);
  return {xx(X, Y, z, r, 0, nu),           yy(Y, z, r, 0, nu),
          corner::G(X, Y, z, r),           xy(X, z, r, 0, nu),
          xz(X, Y, z, r, arc(X, Y, z, r)), yz(z, r)};
}

// Along an edge |y| ≤ b seen from (h, y); `distance` stands for h = 0 on the edge itself.
double edge(double h, double y, double b, double distance) {
  return asinh_difference(h == 0 && std::abs(y) <= b ? distance : h, y, b);
}

template <class Corner>
Tensor corner_sum(double x, double y, double a, double b, Corner corner) {
  Tensor sum{};
  for (int sx : {-1, 1})
    for (int sy : {-1, 1}) {
      const Tensor f = corner(x + sx * a, y + sy * b);
      for (stress::Component c : stress::components) sum[c] += sx * sy * f[c];
    }
  return sum;
}

Tensor sheared(double x, double y, double z, double a, double b, double nu) {
  Tensor sum = corner_sum(x, y, a, b, [&](double X, double Y) { return sheared_corner(X, Y, z, nu); });
  auto L = [&](double X) { return edge(std::hypot(X, z), y, b, a / std::numbers::pi); };
  auto L_turned = [&](double Y) { return edge(std::hypot(Y, z), x, a, b / std::numbers::pi); };
  const double along = L(x + a) - L(x - a);
  sum[stress::xx] += 2 * along;
  sum[stress::yy] += 2 * nu * along;
  sum[stress::xy] += L_turned(y + b) - L_turned(y - b);
  return sum;
}

Tensor boussinesq(double x, double y, double z, double nu) {
  const double r2 = x * x + y * y + z * z, r = std::sqrt(r2), r3 = r * r2, k = 1 - 2 * nu;
  const double V_z = -z / r3, slope = 1 / (r * (r + z)), bend = (2 * r + z) / (r3 * (r + z) * (r + z));
  auto V = [&](double u, double v, double same) { return (3 * u * v / r2 - same) / r3; };
  auto chi = [&](double u, double v, double same) { return slope * same - u * v * bend; };
  return {2 * nu * V_z - z * V(x, x, 1) - k * chi(x, x, 1),
          2 * nu * V_z - z * V(y, y, 1) - k * chi(y, y, 1),
          V_z - z * V(z, z, 1),
          -z * V(x, y, 0) - k * chi(x, y, 0),
          -z * V(x, z, 0),
          -z * V(y, z, 0)};
}

Tensor cerruti(double x, double y, double z, double nu) {
  const double r2 = x * x + y * y + z * z, r = std::sqrt(r2), r3 = r * r2, s = r + z, k = 1 - 2 * nu;
  const double C = 1 / (r * s * s), B = (3 * r + z) / (r3 * s * s * s), D = -3 * x / (r3 * r2);
  return {D * x * x + k * x * (1 / r3 - 3 * C + x * x * B),
          D * y * y + k * x * (1 / r3 - C + y * y * B),
          D * z * z,
          D * x * y + k * y * (x * x * B - C),
          D * x * z,
          D * y * z};
}

Tensor over_two_pi(Tensor s) {
  for (double& component : s) component /= 2 * std::numbers::pi;
  return s;
}

template <std::size_t n>
Tensor integrated(const GaussLegendre<n>& rule, double x, double y, double z, double a, double b,
                  double poisson, stress::Traction load) {
  Tensor sum{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const Tensor s = point_load_stress(x - a * rule.nodes[i], y - b * rule.nodes[j], z, poisson, load);
      const double share = rule.weights[i] * rule.weights[j] * a * b;
      for (stress::Component c : stress::components) sum[c] += share * s[c];
    }
  return sum;
}

}  // namespace

Tensor rectangle_stress(double x, double y, double z, double a, double b, double nu, stress::Traction load) {
  if (load == stress::shear_x) return over_two_pi(sheared(x, y, z, a, b, nu));
  if (load == stress::shear_y) return stress::exchanged(over_two_pi(sheared(y, x, z, b, a, nu)));
  const double distance = std::sqrt(a * b) / std::numbers::pi;
  return over_two_pi(
      corner_sum(x, y, a, b, [&](double X, double Y) { return pressed_corner(X, Y, z, nu, distance); }));
}

Tensor point_load_stress(double x, double y, double z, double nu, stress::Traction load) {
  if (load == stress::shear_x) return over_two_pi(cerruti(x, y, z, nu));
  if (load == stress::shear_y) return stress::exchanged(over_two_pi(cerruti(y, x, z, nu)));
  return over_two_pi(boussinesq(x, y, z, nu));
}

Tensor uniform_load_stress(double x, double y, double z, double a, double b, double poisson,
                           stress::Traction load) {
  // Half sides from which corner sums cancel: tests/stress/influence.cpp, twelve digits everywhere.
  constexpr double far = 5, farther = 50;
  const double distance = std::hypot(x, y, z) / std::max(a, b);
  if (distance < far) return rectangle_stress(x, y, z, a, b, poisson, load);
  return distance < farther ? integrated(gauss8, x, y, z, a, b, poisson, load)
                            : integrated(gauss4, x, y, z, a, b, poisson, load);
}

}  // namespace asperity
