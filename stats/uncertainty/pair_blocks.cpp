#include "stats/uncertainty/pair_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {
namespace {

// Much longer than the lags: less memory, where these are short.
Index piece(Index points, Index lag) { return std::min(points, std::max<Index>(64, 16 * lag)); }

Index inside(Index i, Index n, bool periodic) { return periodic ? ((i % n) + n) % n : i; }

}  // namespace

PairBlocks::PairBlocks(const Field& d, const Grid& grid, Shape max_lag, Index along_x, Index along_y)
    : d_(d),
      grid_(grid),
      max_lag_(max_lag),
      along_x_(along_x),
      along_y_(along_y),
      complete_(!d.isNaN().any()),
      piece_{piece(largest(along_x, grid.shape.nx), max_lag.nx),
             piece(largest(along_y, grid.shape.ny), max_lag.ny)},
      torus_{fast_length(piece_.nx + 2 * max_lag.nx), fast_length(piece_.ny + 2 * max_lag.ny)},
      transform_(torus_) {}

AxisProducts PairBlocks::waves(Index b, const std::vector<LongWaves::Wave>& all) const {
  auto along = [](Range block, Index n, bool periodic, Index most) {
    const double middle = 0.5 * static_cast<double>(block.first + block.last),
                 half = 0.5 * static_cast<double>(most);
    const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(2 * most + 1, middle - half, middle + half);
    return axis_waves(std::numbers::pi / static_cast<double>(n) * at, periodic, AxisWaves::most);
  };
  const auto [nx, ny] = grid_.shape;
  return {along(block(x_of(b), along_x_, nx), nx, grid_.periodic.x, max_lag_.nx),
          along(block(y_of(b), along_y_, ny), ny, grid_.periodic.y, max_lag_.ny), all};
}

Eigen::VectorXd PairBlocks::points(Index row) const {
  const Range x = block(row, along_x_, grid_.shape.nx);
  Eigen::VectorXd out(along_y_);
  for (Index b = 0; b < along_y_; ++b) {
    const Range y = block(b, along_y_, grid_.shape.ny);
    out(b) = validity(d_.block(x.first, y.first, x.length(), y.length())).sum();
  }
  return out;
}

std::vector<PairSums> PairBlocks::sums(Extent some, int threads) const {
  std::vector<PairSums> out(size(some.count));
  parallel_ranges(some.count, threads, [&](Index first, Index last, int) {
    for (Index k = first; k < last; ++k) {
      const Range x = block(x_of(some.first + k), along_x_, grid_.shape.nx),
                  y = block(y_of(some.first + k), along_y_, grid_.shape.ny);
      for (Index i = x.first; i < x.last; i += piece_.nx)
        for (Index j = y.first; j < y.last; j += piece_.ny)
          out[size(k)].add(
              sums(Range{i, std::min(i + piece_.nx, x.last)}, Range{j, std::min(j + piece_.ny, y.last)}));
    }
  });
  return out;
}

// Transforms of a piece and of its surroundings.
struct PairBlocks::Spectrum {
  AlignedVector<Complex> near, far;

  Spectrum(const PairBlocks& blocks, const Field& surroundings, Range x, Range y)
      : near(blocks.transformed(
            surroundings.block(blocks.max_lag_.nx, blocks.max_lag_.ny, x.length(), y.length()))),
        far(blocks.transformed(surroundings)) {}
};

PairBlocks::Range PairBlocks::block(Index b, Index blocks, Index n) {
  auto end = [&](Index k) { return 2 * k <= blocks ? k * n / blocks : n - (blocks - k) * n / blocks; };
  return {end(b), end(b + 1)};
}

// Points of the largest block: one in the middle takes what both halves round off.
Index PairBlocks::largest(Index blocks, Index n) {
  Index out = 0;
  for (Index b = 0; b < blocks; ++b) out = std::max(out, block(b, blocks, n).length());
  return out;
}

// First points x.first ≤ i < x.last whose partners a lag apart lie in the field; from x.first on.
PairBlocks::Range PairBlocks::partnered(Range x, Index lag, Index n, bool periodic) {
  if (periodic) return {0, x.length()};
  const Index first = std::clamp(-lag - x.first, Index{0}, x.length());
  return {first, std::max(first, std::clamp(n - lag - x.first, Index{0}, x.length()))};
}

// value(z) of a piece and of all partners of its points, z NaN beyond the field.
template <class Value>
Field PairBlocks::surroundings(Range x, Range y, Value value) const {
  Field out(x.length() + 2 * max_lag_.nx, y.length() + 2 * max_lag_.ny);
  for (Index i = 0; i < out.rows(); ++i) {
    const Index row = inside(x.first + i - max_lag_.nx, grid_.shape.nx, grid_.periodic.x);
    const bool held = row >= 0 && row < grid_.shape.nx;
    for (Index j = 0; j < out.cols(); ++j) {
      const Index column = inside(y.first + j - max_lag_.ny, grid_.shape.ny, grid_.periodic.y);
      out(i, j) = value(held && column >= 0 && column < grid_.shape.ny ? d_(row, column) : NAN);
    }
  }
  return out;
}

PairSums PairBlocks::sums(Range x, Range y) const {
  const Field far = surroundings(x, y, [](double z) { return std::isnan(z) ? 0 : z; });
  PairSums out;
  const Spectrum of_heights(*this, far, x, y);
  out.products = correlated(of_heights, of_heights);
  if (complete_) {
    squares_of_rectangles(far, x, y, out);
  } else {
    const Field valid = surroundings(x, y, [](double z) { return std::isnan(z) ? 0.0 : 1.0; });
    const Spectrum of_squares(*this, far.square(), x, y), of_valid(*this, valid, x, y);
    out.squares = 0.5 * (correlated(of_squares, of_valid) + correlated(of_valid, of_squares));
    out.pairs = correlated(of_valid, of_valid).round();
  }
  return out;
}

AlignedVector<Complex> PairBlocks::transformed(const Field& f) const {
  AlignedVector<double> padded(static_cast<std::size_t>(torus_.cells()), 0.0);
  Eigen::Map<Field>(padded.data(), torus_.nx, torus_.ny).topLeftCorner(f.rows(), f.cols()) = f;
  AlignedVector<Complex> out(static_cast<std::size_t>(transform_.spectrum_size()));
  transform_.forward(padded.data(), out.data());
  return out;
}

// Σ f(i,j) g(i+p, j+q), f of the block.
Field PairBlocks::correlated(const Spectrum& f, const Spectrum& g) const {
  AlignedVector<Complex> product(f.near.size());
  for (std::size_t k = 0; k < product.size(); ++k) product[k] = std::conj(f.near[k]) * g.far[k];
  AlignedVector<double> out(static_cast<std::size_t>(torus_.cells()));
  transform_.inverse(product.data(), out.data());
  return Eigen::Map<const Field>(out.data(), torus_.nx, torus_.ny)
             .topLeftCorner(2 * max_lag_.nx + 1, 2 * max_lag_.ny + 1) /
         static_cast<double>(torus_.cells());
}

// Pairs and squares of a complete field.
void PairBlocks::squares_of_rectangles(const Field& far, Range x, Range y, PairSums& out) const {
  const auto [nx, ny] = grid_.shape;
  const auto [P, Q] = max_lag_;
  const RectangleSums squares(far.square());
  out.pairs = out.squares = Field::Zero(2 * P + 1, 2 * Q + 1);
  for (Index p = -P; p <= P; ++p)
    for (Index q = -Q; q <= Q; ++q) {
      const Range i = partnered(x, p, nx, grid_.periodic.x), j = partnered(y, q, ny, grid_.periodic.y);
      const Index rows = i.length(), columns = j.length(), row = P + i.first, column = Q + j.first;
      out.pairs(P + p, Q + q) = static_cast<double>(rows * columns);
      if (rows * columns == 0) continue;
      out.squares(P + p, Q + q) =
          0.5 * (squares(row, column, rows, columns) + squares(row + p, column + q, rows, columns));
    }
}

}  // namespace asperity
