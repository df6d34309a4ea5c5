#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "stress/corner.hpp"
#include "stress/equivalent.hpp"
#include "stress/search.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Tensor;
using stress::Traction;

constexpr double all_near = 6;  // cells: w = 1
constexpr int most_steps = 40;
constexpr Index far_reach = 4;  // wide cells
// Depths [cells].
constexpr double far_depths[] = {0, 3, 7, 12};

// w of (1) at a distance in cells.
double weight(double cells) {
  const double t = (std::abs(cells) - all_near) / (near_reach + 1 - all_near);
  if (t <= 0) return 1;
  if (t >= 1) return 0;
  const double c = std::cos(0.5 * std::numbers::pi * t);
  return c * c;
}

// ∂f/∂σ, of a shear component both its halves.
Tensor gradient(Criterion of, const Tensor& s) {
  using namespace stress;
  if (of == Criterion::von_mises) {
    const double m = (s[xx] + s[yy] + s[zz]) / 3;
    return {s[xx] - m, s[yy] - m, s[zz] - m, 2 * s[xy], 2 * s[xz], 2 * s[yz]};
  }
  const PrincipalStress p = principal_stress(s);
  auto outer = [](const std::array<double, 3>& n) {
    return Tensor{n[0] * n[0], n[1] * n[1], n[2] * n[2], 2 * n[0] * n[1], 2 * n[0] * n[2], 2 * n[1] * n[2]};
  };
  Tensor out = outer(p.direction[0]);
  if (of == Criterion::max_shear) {
    const Tensor last = outer(p.direction[2]);
    for (Component c : components) out[c] -= last[c];
  }
  return out;
}

}  // namespace

NearKernel::NearKernel(const LoadedBody& body, Index s, Index lags_each_way, double z) : n(lags_each_way) {
  constexpr Index lanes = corner_lanes;
  const LoadWeights weights = body.friction.weights();
  const double dx = static_cast<double>(s) * body.grid.dx, dy = static_cast<double>(s) * body.grid.dy;
  lags.resize(size((2 * n + 1) * (2 * n + 1)));
  const Index rows = n + 1, groups = (rows + lanes - 1) / lanes;
  std::vector<double> corners(size(3 * 6 * groups * lanes * rows));
  auto of = [&](Traction t, Component c, Index g) {
    return corners.data() + ((static_cast<Index>(6 * t + c)) * groups + g) * lanes * rows;
  };
  for (Index g = 0; g < groups; ++g) {
    double* out[3][6];
    for (Traction t : stress::tractions)
      for (Component c : stress::components) out[t][c] = weights[t] == 0 ? nullptr : of(t, c, g);
    corner_tile(static_cast<double>(g * lanes) + 0.5, dy / dx, rows, z / dx, body.poisson, out);
  }
  for (Traction t : stress::tractions)
    for (Component c : stress::components) {
      if (weights[t] == 0) continue;
      const double sx = odd_in_x(c, t) ? 1 : -1, sy = odd_in_y(c, t) ? 1 : -1;  // of corner functions
      auto f = [&](Index i, Index j) {                                          // at X = i + ½, Y = j + ½
        const double sign = (i < 0 ? sx : 1) * (j < 0 ? sy : 1);
        i = i < 0 ? -1 - i : i, j = j < 0 ? -1 - j : j;
        return sign * of(t, c, i / lanes)[j * lanes + i % lanes];
      };
      for (Index i = 0; i <= n; ++i)
        for (Index j = 0; j <= n; ++j) {
          const double k = weights[t] * weight(static_cast<double>(s * i)) *
                           weight(static_cast<double>(s * j)) *
                           (f(i, j) - f(i - 1, j) - f(i, j - 1) + f(i - 1, j - 1)) / (2 * std::numbers::pi);
          for (int p = i > 0 ? -1 : 1; p <= 1; p += 2)
            for (int q = j > 0 ? -1 : 1; q <= 1; q += 2)
              lags[size((n + p * i) * (2 * n + 1) + n + q * j)][c] +=
                  k * (p < 0 ? -sx : 1) * (q < 0 ? -sy : 1);
        }
    }
}

Tensor NearKernel::sum() const {
  Tensor out{};
  for (const Tensor& k : lags)
    for (Component c : stress::components) out[c] += k[c];
  return out;
}

double NearKernel::largest(Criterion of) const {
  constexpr Tensor starts[] = {{0, 0, -1, 0, 0, 0}, {1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0},
                               {0, 0, 0, 0, 1, 0},  {0, 0, 0, 0, 0, 1}, {1, -1, 0, 0, 0, 0}};
  double bound = 0;
  for (Tensor s : starts) {
    double last = 0;
    for (int step = 0; step < most_steps; ++step) {
      const Tensor d = gradient(of, s);
      s = {};
      for (const Tensor& lag : lags) {
        double product = 0;
        for (Component c : stress::components) product += lag[c] * d[c];
        if (product > 0)
          for (Component c : stress::components) s[c] += lag[c];
      }
      const double v = equivalent_stress(of, s);
      if (!(v > last * (1 + 1e-9))) break;
      last = v;
    }
    bound = std::max(bound, last);
  }
  return bound;
}

FarStress::FarStress(const LoadedBody& body, int threads) {
  const double h = std::max(body.grid.dx, body.grid.dy);
  for (std::size_t l = 0; l < depths_.size(); ++l) depths_[l] = h * far_depths[l];

  const WiderCells wider = wider_cells(body, wide, wide);
  const StressSolver solver(wider.body, threads);
  const Index nx = wider.body.grid.shape.nx, ny = wider.body.grid.shape.ny;
  // The mean pressures, with those within reach around the domain.
  const Field p = Field::NullaryExpr(nx + 2 * far_reach, ny + 2 * far_reach, [&](Index i, Index j) {
    return wider.body.at(i - far_reach, j - far_reach);
  });
  StressSolver::Workspace work;
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    auto& layer = layers_[l];
    for (Field& f : layer) f.resize(nx, ny);
    solver.layer(depths_[l], stress::all, work, [&](Index i, const StressRow& row) {
      for (Component c : stress::components) std::ranges::copy(row[c], layer[c].row(i).data());
    });
    const NearKernel near(body, wide, far_reach, depths_[l]);
    parallel_ranges(nx, threads, [&](Index begin, Index end, int) {
      for (Index i = begin; i < end; ++i)
        for (Index k = -far_reach; k <= far_reach; ++k) {
          const auto row = p.row(i + k + far_reach);
          if ((row == 0).all()) continue;
          for (Index q = -far_reach; q <= far_reach; ++q) {
            const Tensor& lag = near.at(-k, -q);
            for (Component c : stress::components)
              if (lag[c] != 0) layer[c].row(i) -= lag[c] * row.segment(q + far_reach, ny);
          }
        }
    });
  }
}

FarStress::Weights FarStress::weights(double z) const {
  Weights out;
  for (std::size_t l = 0; l < out.size(); ++l) {
    out[l] = 1;
    for (std::size_t k = 0; k < out.size(); ++k)
      if (k != l) out[l] *= (z - depths_[k]) / (depths_[l] - depths_[k]);
  }
  return out;
}

Tensor FarStress::at(const Weights& weights, Index i, Index j) const {
  Tensor out{};
  for (std::size_t l = 0; l < weights.size(); ++l)
    for (Component c : stress::components) out[c] += weights[l] * layers_[l][c](i, j);
  return out;
}

}  // namespace asperity
