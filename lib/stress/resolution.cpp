#include "stress/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "transform/convolution.hpp"

namespace asperity {
namespace {

constexpr Index around = Interpolation::taps / 2;
constexpr double depth_of_wide_cells =
    5;                            // in sides: tests/stress/layers.cpp, validation/stress_request_time
constexpr Index least_taper = 8;  // lags over which a kernel decays to 0

Index points(Index cells, Index s) { return (cells + s - 1) / s; }

// Lags that the kernel must have whole: from any cell to any point around which values are interpolated.
Index whole_lags(Index cells, Index s) { return s == 1 ? cells : points(cells, s) + around; }

Index period(Index cells, Index s, bool periodic) {
  if (periodic) return cells / s;
  return s == 1 ? padded_torus({cells, cells}).nx : fast_length(2 * (whole_lags(cells, s) + least_taper), 2);
}

Shape torus_of(const Grid& grid, Index s) {
  return {period(grid.shape.nx, s, grid.periodic.x), period(grid.shape.ny, s, grid.periodic.y)};
}

// 1 for the first lags, then down to 0 at `lags`.
std::vector<double> tapered(Index kept, Index lags) {
  constexpr int steps = 16;
  std::vector<double> out(size(lags), 1.0);
  const Index taper = lags - kept;
  const double beta = 0.5 * std::numbers::pi * static_cast<double>(taper);
  double sum = 0;
  for (Index i = lags - 1; i >= kept; --i) {
    for (int k = 0; k < steps; ++k) {
      const double u =
          2 * (static_cast<double>(i - kept) + (k + 0.5) / steps) / static_cast<double>(taper) - 1;
      sum += std::exp(beta * (std::sqrt(1 - u * u) - 1));
    }
    out[size(i)] = sum;
  }
  for (Index i = kept; i < lags; ++i) out[size(i)] /= sum;
  return out;
}

// What a mode is multiplied with: (1), unless the load is one of modes; and the preparation for the
// interpolation.
std::vector<double> factors(Index s, Index period, bool modes) {
  std::vector<double> out(size(period / 2 + 1), 1.0);
  if (s == 1) return out;
  for (Index m = 0; m < period / 2 + 1; ++m) {
    const double k = 2 * std::numbers::pi * static_cast<double>(m) / static_cast<double>(period), a = k / 2;
    const double ratio =
        m == 0 || modes ? 1 : static_cast<double>(s) * std::sin(a / static_cast<double>(s)) / std::sin(a);
    out[size(m)] = 2 * m < period ? ratio * Interpolation::prepared(k) : 0;
  }
  return out;
}

// The modes of the pressure that `transform` has: the lower ones of a torus of s px × s py narrow cells.
AlignedVector<Complex> transformed(const LoadedBody& body, Index s, const PrunedTransform& transform,
                                   int threads) {
  const Grid& grid = body.grid;
  const auto [px, py] = transform.torus();
  const PrunedTransform fine(grid.shape, {s * px, s * py}, Ways::forward_only, *body.ranks);
  HalfSpectrum half = fine.half_spectrum();
  fine.forward_rows(body.pressure / static_cast<double>(fine.torus().cells()), half, threads);
  const std::vector<double> along_x = factors(s, px, grid.periodic.both()),
                            along_y = factors(s, py, grid.periodic.both());
  const Extent own = transform.own_blocks();
  AlignedVector<Complex> spectrum(size(own.count * transform.block_size()));
  fine.each_block(half, transform.blocks(), threads, [&, px = px](Index b, const Complex* block) {
    for (Index q = 0; q < block_columns && b * block_columns + q < transform.columns(); ++q) {
      const Complex* p = block + q * fine.stride();
      Complex* out = spectrum.data() + (b - own.first) * transform.block_size() + q * transform.stride();
      for (Index k = 0; k < px; ++k)
        out[k] = p[2 * k < px ? k : k + (s - 1) * px] *
                 (along_x[size(std::min(k, px - k))] * along_y[size(b * block_columns + q)]);
    }
  });
  return spectrum;
}

}  // namespace

double Resolution::least_depth(const Grid& grid, Index s) {
  return s == 1 ? 0 : depth_of_wide_cells * static_cast<double>(s) * std::max(grid.dx, grid.dy);
}

bool Resolution::possible(const Grid& grid, Index s) {
  const auto [nx, ny] = grid.shape;
  return std::min(nx, ny) >= least_cells * s && !(grid.periodic.x && nx % s != 0) &&
         !(grid.periodic.y && ny % s != 0);
}

Resolution::Resolution(const LoadedBody& body, Index wide, int threads)
    : s(wide),
      transform(s == 1 ? body.grid.shape : torus_of(body.grid, s), torus_of(body.grid, s), Ways::both,
                *body.ranks),
      cells(body.grid),
      interpolation(s),
      spectrum(transformed(body, s, transform, threads)) {
  const Grid& grid = body.grid;
  const auto [px, py] = transform.torus();
  const double f = static_cast<double>(s);
  cells.dx *= f, cells.dy *= f;
  auto lags = [&](Index own, Index period, bool repeats) {
    if (grid.periodic.both()) return period;
    return repeats ? period / 2 + 1 : s > 1 ? period / 2 : own;
  };
  cells.shape = {lags(grid.shape.nx, px, grid.periodic.x), lags(grid.shape.ny, py, grid.periodic.y)};
  taper = {tapered(whole_lags(grid.shape.nx, s), cells.shape.nx),
           tapered(whole_lags(grid.shape.ny, s), cells.shape.ny)};
}

void Resolution::wrap(std::span<double> row) const {
  const std::size_t period = size(transform.torus().ny), before = size(Interpolation::before);
  std::copy_n(row.data() + period, before, row.data());
  for (std::size_t j = period + before; j < row.size(); ++j) row[j] = row[j - period];
}

}  // namespace asperity
