#include "stress/layers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "grid/error.hpp"
#include "grid/parallel.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

using stress::Component;

constexpr Index width = PrunedTransform::width;
static_assert(width == LayerInfluence::width);

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

Shape torus_of(const Grid& grid) { return grid.periodic ? grid.shape : padded_torus(grid.shape); }

void check(const Grid& grid, const Field& pressure, double poisson) {
  if (!(poisson >= 0 && poisson <= 0.5))
    throw ParameterError("poisson", fmt::format("{} is not between 0 and 0.5", poisson));
  if (shape_of(pressure) != grid.shape) throw DataError("pressure", "its shape is not that of the grid");
  if (!pressure.isFinite().all()) throw DataError("pressure", "holds a value that is not a finite number");
}

}  // namespace

StressSolver::StressSolver(const Grid& grid, const Field& pressure, double poisson, int threads)
    : grid_(grid),
      pressure_(pressure),
      poisson_(poisson),
      threads_(threads),
      transform_(grid.shape, torus_of(grid)),
      pressure_spectrum_(size(transform_.blocks() * transform_.block_size())) {
  check(grid, pressure, poisson);
  HalfSpectrum half = transform_.half_spectrum();
  transform_.forward_rows(pressure_ / static_cast<double>(transform_.torus().cells()), half, threads);
  AlignedVector<Complex> work(size(transform_.block_size()));
  for (Index b = 0; b < transform_.blocks(); ++b)
    transform_.forward_block(half, b, pressure_spectrum_.data() + b * transform_.block_size(), work.data());
}

StressSolver::Workspace::Workspace(const StressSolver& solver)
    : influence_(make_layer_influence(solver.grid_, solver.transform_.torus(), solver.poisson_)),
      block_(size(solver.transform_.block_size())),
      work_(block_.size()),
      row_spectrum_(size(solver.transform_.blocks() * width)) {}

void StressSolver::layers(const std::vector<double>& depths, stress::Set asked,
                          const LayerRowSink& row) const {
  parallel_ranges(static_cast<Index>(depths.size()), threads_, [&](Index begin, Index end, int) {
    Workspace work(*this);
    for (Index l = begin; l < end; ++l)
      layer(depths[size(l)], asked, work, [&](Index i, const StressRow& values) { row(l, i, values); });
  });
}

void StressSolver::transform_layer(double z, stress::Set asked, Workspace& work) const {
  if (!(z >= 0 && std::isfinite(z)))
    throw ParameterError("depth", fmt::format("{} m is not a depth, 0 or more", z));
  work.influence_->descend(z, asked);
  for (Component c : stress::components)
    if (asked[c] && work.half_[c].empty()) work.half_[c] = transform_.half_spectrum();
  for (Index b = 0; b < transform_.blocks(); ++b)
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      multiply(c, b, work.influence_->symbol(c, b), work.block_.data());
      transform_.inverse_block(work.block_.data(), b, work.half_[c], work.work_.data());
    }
}

// product = (-i)^m S p^, where S(-kx) = ±S(kx); -i (a + ib) = b - ia.
void StressSolver::multiply(Component c, Index b, LayerInfluence::Symbol symbol, Complex* product) const {
  const Index nx = transform_.torus().nx;
  const double sign = odd_in_x(c) && odd_in_y(c) ? -1 : 1, mirrored = odd_in_x(c) ? -sign : sign;
  for (Index q = 0; q < width; ++q) {
    const Complex* p = pressure_spectrum_.data() + b * transform_.block_size() + q * transform_.stride();
    Complex* out = product + q * transform_.stride();
    const auto* s = reinterpret_cast<const double*>(symbol.pairs + q / 2 * symbol.stride) + q % 2;
    auto times = [&](auto factor) {
      for (Index k = 0; 2 * k <= nx; ++k) out[k] = factor(sign * s[2 * k], p[k]);
      for (Index k = nx / 2 + 1; k < nx; ++k) out[k] = factor(mirrored * s[2 * (nx - k)], p[k]);
    };
    if (odd_in_x(c) != odd_in_y(c))
      times([](double f, const Complex& x) { return Complex{f * x.imag(), -f * x.real()}; });
    else
      times([](double f, const Complex& x) { return f * x; });
  }
}

StressRow StressSolver::inverse_row(Index i, stress::Set asked, Workspace& work) const {
  StressRow values{};
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    work.row_[c].resize(size(transform_.torus().ny + 2));
    transform_.inverse_row(work.half_[c], i, work.row_spectrum_.data(), work.row_[c].data());
    values[c] = work.row_[c].data();
  }
  return values;
}

double accurate_depth(const Grid& grid) { return 2 * std::max(grid.dx, grid.dy); }

}  // namespace asperity
