#include "stress_stability.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "stress/layers.hpp"

namespace asperity {
namespace {

using Long = long double;
using LongTensor = std::array<Long, 6>;

constexpr Index n = 16;

// stress/influence.hpp (2), (3), above or below a corner but not on an edge.
LongTensor corner(Long X, Long Y, Long z, Long nu, stress::Traction load) {
  if (load == stress::shear_y) {
    const LongTensor t = corner(Y, X, z, nu, stress::shear_x);
    return {t[1], t[0], t[2], t[3], t[5], t[4]};
  }
  const Long hx = X * X + z * z, hy = Y * Y + z * z, r = std::sqrt(X * X + hy), T = std::atan2(X * Y, z * r);
  const Long F = z * X * Y / (r * hx), G = z * z * Y / (r * hx), u = z / (r * (r + z));
  if (load == stress::shear_x) {
    const Long L = std::asinh(Y / std::sqrt(hx)), turned = std::asinh(X / std::sqrt(hy));
    return {2 * L + 2 * nu * Y / (r + z) + Y * u - G,
            2 * nu * L - 2 * nu * Y / (r + z) - Y * u,
            G,
            turned - 2 * nu * X / (r + z) - X * u,
            F - T,
            -z / r};
  }
  const Long A = std::atan2(X * Y * (X * X + Y * Y) / (r + z), X * X * r + z * Y * Y), k = 1 - 2 * nu;
  const Long turned_F = z * X * Y / (r * hy);
  return {-2 * nu * T + F - k * A,
          -2 * nu * T + turned_F - k * (T - A),
          -T - F - turned_F,
          -z / r - k * std::log(r + z),
          G,
          z * z * X / (r * hy)};
}

LongTensor rectangle(Long x, Long y, Long z, Long a, Long b, Long nu, const std::array<double, 3>& weights) {
  LongTensor sum{};
  for (stress::Traction t : stress::tractions)
    for (int sx : {-1, 1})
      for (int sy : {-1, 1}) {
        if (weights[t] == 0) continue;
        const LongTensor f = corner(x + sx * a, y + sy * b, z, nu, t);
        for (auto c : stress::components)
          sum[c] += sx * sy * weights[t] * f[c] / (2 * std::numbers::pi_v<Long>);
      }
  return sum;
}

struct Worst {
  double error = 0, largest = 0;  ///< in a layer
};

Worst compare(const Grid& grid, const Field& p, double z, double nu, const Friction& friction) {
  const StressSolver solver({grid, p, nu, friction});
  StressSolver::Workspace work;
  Worst out;
  solver.layer(z, stress::all, work, [&](Index i, const StressRow& row) {
    for (Index j = 0; j < n; ++j) {
      LongTensor exact{};
      for (Index k = 0; k < n; ++k)
        for (Index l = 0; l < n; ++l) {
          if (p(k, l) == 0) continue;
          const LongTensor s =
              rectangle(static_cast<Long>(i - k) * grid.dx, static_cast<Long>(j - l) * grid.dy, z,
                        Long{grid.dx} / 2, Long{grid.dy} / 2, nu, friction.weights());
          for (auto c : stress::components) exact[c] += p(k, l) * s[c];
        }
      for (auto c : stress::components) {
        out.error = std::max(out.error,
                             static_cast<double>(std::abs(row[c][static_cast<std::size_t>(j)] - exact[c])));
        out.largest = std::max(out.largest, static_cast<double>(std::abs(exact[c])));
      }
    }
  });
  return out;
}

void print_row(const char* name, double aspect, double depth, const Field& p) {
  const double dx = std::sqrt(aspect);
  const Grid grid{{n, n}, dx, 1 / dx};
  double error = 0, relative = 0;
  for (double nu : {0.0, 0.3, 0.5})
    for (Friction friction : {Friction{}, Friction{0.5, 0.6}}) {
      const Worst w = compare(grid, p, depth, nu, friction);
      error = std::max(error, w.error / p.maxCoeff()), relative = std::max(relative, w.error / w.largest);
    }
  fmt::print("{}\t{}\t{:g}\t{:.1e}\t{:.1e}\n", name, aspect, depth, error, relative);
}

}  // namespace

void print_stability() {
  fmt::print("# case\taspect\tdepth\terror_over_pressure\terror_over_stress\n");
  Field one = Field::Zero(n, n);
  one(n / 2 - 1, n / 2) = 1;
  for (double aspect : {0.02, 0.2, 1.0, 5.0, 50.0})
    for (double depth : {1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1000.0})
      print_row("one_cell", aspect, depth, one);
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> exponent(-6, 6);
  const Field decades =
      Field::NullaryExpr(n, n, [&](Index, Index) { return std::pow(10, exponent(generator)); });
  for (double depth : {1e-3, 1.0, 10.0}) print_row("twelve_decades", 1, depth, decades);
}

}  // namespace asperity
