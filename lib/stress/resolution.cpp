#include "stress/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/calibration.hpp"
#include "core/parallel.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

constexpr Index width = PrunedTransform::width, around = Interpolation::taps / 2;
using calibration::stress::least_taper;

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

Index points(Index cells, Index s) { return (cells + s - 1) / s; }

// Lags that the kernel must have whole: from any cell to any point around which values are interpolated.
Index whole_lags(Index cells, Index s) { return s == 1 ? cells : points(cells, s) + around; }

Index period(Index cells, Index s, bool periodic) {
  if (periodic) return cells / s;
  return s == 1 ? padded_torus({cells, cells}).nx : fast_length(2 * (whole_lags(cells, s) + least_taper), 2);
}

Shape torus_of(const Grid& grid, Index s) {
  return {period(grid.shape.nx, s, grid.periodic), period(grid.shape.ny, s, grid.periodic)};
}

// 1 for the first lags, then down to 0 at `lags`.
std::vector<double> tapered(Index whole, Index lags) {
  constexpr int steps = 16;
  std::vector<double> out(size(lags), 1.0);
  const Index taper = lags - whole;
  const double beta = 0.5 * std::numbers::pi * static_cast<double>(taper);
  double sum = 0;
  for (Index i = lags - 1; i >= whole; --i) {
    for (int k = 0; k < steps; ++k) {
      const double u =
          2 * (static_cast<double>(i - whole) + (k + 0.5) / steps) / static_cast<double>(taper) - 1;
      sum += std::exp(beta * (std::sqrt(1 - u * u) - 1));
    }
    out[size(i)] = sum;
  }
  for (Index i = whole; i < lags; ++i) out[size(i)] /= sum;
  return out;
}

// What a mode is multiplied with: (1), unless periodic, and the preparation for the interpolation.
std::vector<double> factors(Index s, Index period, bool periodic) {
  std::vector<double> out(size(period / 2 + 1), 1.0);
  if (s == 1) return out;
  for (Index m = 0; m < period / 2 + 1; ++m) {
    const double k = 2 * std::numbers::pi * static_cast<double>(m) / static_cast<double>(period), a = k / 2;
    const double ratio =
        m == 0 || periodic ? 1 : static_cast<double>(s) * std::sin(a / static_cast<double>(s)) / std::sin(a);
    out[size(m)] = 2 * m < period ? ratio * Interpolation::prepared(k) : 0;
  }
  return out;
}

}  // namespace

double Resolution::least_depth(const Grid& grid, Index s) {
  return s == 1
             ? 0
             : calibration::stress::depth_of_wide_cells * static_cast<double>(s) * std::max(grid.dx, grid.dy);
}

bool Resolution::possible(const Grid& grid, Index s) {
  const auto [nx, ny] = grid.shape;
  return std::min(nx, ny) >= calibration::stress::least_wide_cells * s &&
         (!grid.periodic || (nx % s == 0 && ny % s == 0));
}

Resolution::Resolution(const Grid& grid, const Field& pressure, Index s, int threads)
    : s_(s),
      periodic_(grid.periodic),
      transform_(s == 1 ? grid.shape : torus_of(grid, s), torus_of(grid, s)),
      cells_(grid),
      interpolation_(s),
      spectrum_(size(transform_.blocks() * transform_.block_size())) {
  const auto [px, py] = transform_.torus();
  const double f = static_cast<double>(s);
  cells_.dx *= f, cells_.dy *= f;
  if (grid.periodic)
    cells_.shape = {px, py};
  else if (s > 1)
    cells_.shape = {px / 2, py / 2};
  taper_ = {tapered(whole_lags(grid.shape.nx, s), cells_.shape.nx),
            tapered(whole_lags(grid.shape.ny, s), cells_.shape.ny)};
  transform_pressure(pressure, threads);
}

void Resolution::wrap(std::span<double> row) const {
  const std::size_t period = size(transform_.torus().ny), before = size(Interpolation::before);
  std::copy_n(row.data() + period, before, row.data());
  for (std::size_t j = period + before; j < row.size(); ++j) row[j] = row[j - period];
}

// On a torus of s px × s py narrow cells, of whose modes the lower ones are taken.
void Resolution::transform_pressure(const Field& pressure, int threads) {
  const auto [px, py] = transform_.torus();
  const PrunedTransform fine(shape_of(pressure), {s_ * px, s_ * py}, ColumnTransform::Ways::forward_only);
  HalfSpectrum half = fine.half_spectrum();
  fine.forward_rows(pressure / static_cast<double>(fine.torus().cells()), half, threads);
  const std::vector<double> along_x = factors(s_, px, periodic_), along_y = factors(s_, py, periodic_);
  parallel_ranges(transform_.blocks(), threads, [&, px = px](Index begin, Index end, int) {
    AlignedVector<Complex> block(size(fine.block_size())), work(block.size());
    for (Index b = begin; b < end; ++b) {
      fine.forward_block(half, b, block.data(), work.data());
      for (Index q = 0; q < width && b * width + q < transform_.columns(); ++q) {
        const Complex* p = block.data() + q * fine.stride();
        Complex* out = spectrum_.data() + b * transform_.block_size() + q * transform_.stride();
        for (Index k = 0; k < px; ++k)
          out[k] = p[2 * k < px ? k : k + (s_ - 1) * px] *
                   (along_x[size(std::min(k, px - k))] * along_y[size(b * width + q)]);
      }
    }
  });
}

}  // namespace asperity
