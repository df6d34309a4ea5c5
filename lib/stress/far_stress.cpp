#include "stress/far_stress.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "stress/layer_maxima.hpp"
#include "stress/near_kernel.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Tensor;

constexpr Index reach = 4;  // wide cells
// Depths [cells].
constexpr double far_depths[] = {0, 3, 7, 12}, far_depths_of_waves[] = {2, 4, 8, 12};

Index wrapped(Index i, Index n) { return (i % n + n) % n; }

}  // namespace

FarStress::FarStress(const LoadedBody& body, int threads) {
  const double h = std::max(body.grid.dx, body.grid.dy);
  for (std::size_t l = 0; l < depths_.size(); ++l)
    depths_[l] = h * (body.grid.periodic.both() ? far_depths_of_waves : far_depths)[l];

  const WiderCells wider = wider_cells(body, wide, wide);
  const StressSolver solver(wider.body, threads);
  const auto [nx, ny] = wider.body.grid.shape;
  const Periodic repeats = body.grid.periodic;
  // The mean pressures with those beside them that act.
  Field p = Field::Zero(nx + 2 * reach, ny + 2 * reach);
  for (Index i = 0; i < p.rows(); ++i)
    for (Index j = 0; j < p.cols(); ++j) {
      Index m = i - reach, n = j - reach;
      if (repeats.x) m = wrapped(m, nx);
      if (repeats.y) n = wrapped(n, ny);
      if (m >= 0 && n >= 0 && m < nx && n < ny) p(i, j) = wider.body.pressure(m, n);
    }
  StressSolver::Workspace work;
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    auto& layer = layers_[l];
    for (Field& f : layer) f.resize(nx, ny);
    solver.layer(depths_[l], stress::all, work, [&](Index i, const StressRow& row) {
      for (Component c : stress::components) std::ranges::copy(row[c], layer[c].row(i).data());
    });
    const NearKernel near(body, wide, reach, depths_[l]);
    parallel_ranges(nx, threads, [&](Index begin, Index end, int) {
      for (Index i = begin; i < end; ++i)
        for (Index k = -reach; k <= reach; ++k) {
          const auto row = p.row(i + k + reach);
          if ((row == 0).all()) continue;
          for (Index q = -reach; q <= reach; ++q) {
            const Tensor& lag = near.at(-k, -q);
            for (Component c : stress::components)
              if (lag[c] != 0) layer[c].row(i) -= lag[c] * row.segment(q + reach, ny);
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
