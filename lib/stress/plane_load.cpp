#include "stress/plane_load.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"

namespace asperity {
namespace {

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

// From row i to the farthest one that is loaded.
Index farthest(const Field& pressure, Index i) {
  Index lags = 0;
  for (Index row = 0; row < pressure.rows(); ++row)
    if ((pressure.row(row) != 0).any()) lags = std::max(lags, std::abs(row - i) + 1);
  return lags;
}

// exp(i kx x_i) for every mode; what the modes are prepared with for an interpolation in x is undone, as the row
// between the points is computed itself.
AlignedVector<Complex> wave(const Resolution& r, Index i) {
  const Index n = r.transform().torus().nx, period = n * r.s();
  AlignedVector<Complex> out(size(n));
  for (Index k = 0; k < n; ++k) {
    const Index mode = 2 * k < n ? k : k - n;
    const double turn = 2 * std::numbers::pi / static_cast<double>(period);
    const double prepared = r.s() == 1 || 2 * k == n
                                ? 1
                                : Interpolation::prepared(turn * static_cast<double>(r.s() * std::abs(mode)));
    out[size(k)] = std::polar(1 / prepared, turn * static_cast<double>(mode * i % period));
  }
  return out;
}

}  // namespace

PlaneLoad::PlaneLoad(const Grid& grid, const Field& pressure, Index i, Index s, int threads)
    : resolution_(grid, pressure, s, threads) {
  const PrunedTransform& t = resolution_.transform();
  const Index px = t.torus().nx, stride = t.stride();
  terms_ = grid.periodic ? px / 2 + 1 : s > 1 ? resolution_.cells().shape.nx : farthest(pressure, i);
  for (Terms& terms : terms_of_) terms.resize(size(t.blocks() * terms_ * 2 * width));
  const AlignedVector<Complex> phases = wave(resolution_, i);
  const ColumnTransform columns(px, width, ColumnTransform::Ways::forward_only);
  parallel_ranges(t.blocks(), threads, [&](Index begin, Index end, int) {
    AlignedVector<Complex> modes(size(t.block_size())), lags(modes.size());
    for (Index b = begin; b < end; ++b) {
      for (Index q = 0; q < width; ++q)
        for (Index k = 0; k < px; ++k)
          modes[size(q * stride + k)] = resolution_.pressure(b)[q * stride + k] * phases[size(k)];
      if (grid.periodic) {
        fold_modes(modes.data(), stride, b);
      } else {
        columns.forward(modes.data(), lags.data());
        fold_lags(lags.data(), stride, b);
      }
    }
  });
}

void PlaneLoad::set(bool odd, Index b, Index m, Index q, Complex value) {
  double* to = terms_of_[odd].data() + (b * terms_ + m) * 2 * width + q;
  to[0] = value.real(), to[width] = value.imag();
}

void PlaneLoad::fold_modes(const Complex* modes, Index stride, Index b) {
  const Index n = resolution_.transform().torus().nx;
  for (Index q = 0; q < width; ++q, modes += stride)
    for (Index k = 0; k < terms_; ++k) {
      const bool alone = k == 0 || 2 * k == n;
      const Complex ahead = modes[k], back = alone ? Complex{} : modes[n - k], difference = ahead - back;
      set(false, b, k, q, ahead + back);
      set(true, b, k, q, alone ? Complex{} : Complex{difference.imag(), -difference.real()});
    }
}

void PlaneLoad::fold_lags(const Complex* lags, Index stride, Index b) {
  const Index n = resolution_.transform().torus().nx;
  const std::vector<double>& taper = resolution_.taper()[0];
  for (Index q = 0; q < width; ++q, lags += stride)
    for (double sign : {1.0, -1.0}) {
      auto seen = [&](Index m) {
        return m < terms_ ? taper[size(m)] * (lags[m] + sign * lags[n - m]) : Complex{};
      };
      for (Index m = 0; m < terms_; ++m)
        set(sign < 0, b, m, q, (m > 0 ? seen(m) : (1 + sign) * lags[0]) - seen(m + 1));
    }
}

void PlaneLoad::add(const double* f, bool odd, Index b, double* sum) const {
  using Lanes = Eigen::Array<double, width, 1>;
  using Given = Eigen::Map<const Lanes>;
  Eigen::Map<Lanes> to_re(sum), to_im(sum + width);
  Lanes re = to_re, im = to_im;
  const double* d = terms_of_[odd].data() + b * terms_ * 2 * width;
  for (Index m = 0; m < terms_; ++m, f += width, d += 2 * width) {
    const Lanes value = Given(f);
    re += value * Given(d), im += value * Given(d + width);
  }
  to_re = re, to_im = im;
}

}  // namespace asperity
