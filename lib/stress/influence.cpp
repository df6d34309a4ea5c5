#include "stress/influence.hpp"

#include <cmath>
#include <numbers>

#include "stress/corner.hpp"

namespace asperity {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

stress::Tensor corner_functions(double X, double Y, double z, double nu) {
  const double r = std::sqrt(X * X + Y * Y + z * z), XY = X * Y;
  const double T = XY == 0 ? 0 : std::atan2(XY, z * r);
  const double A = XY == 0 ? 0 : std::atan2(XY * (X * X + Y * Y) / (r + z), X * X * r + z * Y * Y);
  return {corner::xx(X, Y, z, r, T, A, nu), corner::yy(X, Y, z, r, T, A, nu),
          corner::zz(X, Y, z, r, T),        corner::xy(z, r, nu),
          corner::xz(X, Y, z, r),           corner::yz(X, Y, z, r)};
}

}  // namespace

stress::Tensor rectangle_stress(double x, double y, double z, double a, double b, double poisson) {
  stress::Tensor sum{};
  for (int sx : {-1, 1})
    for (int sy : {-1, 1}) {
      const stress::Tensor f = corner_functions(x + sx * a, y + sy * b, z, poisson);
      for (stress::Component c : stress::components) sum[c] += sx * sy * f[c];
    }
  for (double& s : sum) s /= two_pi;
  return sum;
}

stress::Tensor point_load_stress(double x, double y, double z, double poisson) {
  const double r2 = x * x + y * y + z * z, r = std::sqrt(r2), r3 = r * r2, k = 1 - 2 * poisson;
  const double V_z = -z / r3, slope = 1 / (r * (r + z)), bend = (2 * r + z) / (r3 * (r + z) * (r + z));
  auto V = [&](double u, double v, double same) { return (3 * u * v / r2 - same) / r3; };
  auto chi = [&](double u, double v, double same) { return slope * same - u * v * bend; };
  stress::Tensor s{2 * poisson * V_z - z * V(x, x, 1) - k * chi(x, x, 1),
                   2 * poisson * V_z - z * V(y, y, 1) - k * chi(y, y, 1),
                   V_z - z * V(z, z, 1),
                   -z * V(x, y, 0) - k * chi(x, y, 0),
                   -z * V(x, z, 0),
                   -z * V(y, z, 0)};
  for (double& component : s) component /= two_pi;
  return s;
}

stress::Tensor stress_at(const Grid& grid, const Field& pressure, double x, double y, double z,
                         double poisson) {
  stress::Tensor sum{};
  for (Index i = 0; i < grid.shape.nx; ++i)
    for (Index j = 0; j < grid.shape.ny; ++j) {
      const auto s = rectangle_stress(x - grid.x(i), y - grid.y(j), z, grid.dx / 2, grid.dy / 2, poisson);
      for (stress::Component c : stress::components) sum[c] += pressure(i, j) * s[c];
    }
  return sum;
}

}  // namespace asperity
