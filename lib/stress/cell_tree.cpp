#include "stress/cell_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/gauss_legendre.hpp"
#include "stress/corner_tile.hpp"
#include "stress/point_loads.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Tensor;
using stress::Traction;

constexpr Index q = lattice_side, around = 2;  // blocks beside the middle one that are summed by cells
constexpr double far = 1.7;                    // sides, from a block's middle
constexpr double beside = 1e-30;               // of a corner: on it an arc tangent is that of 0/0
constexpr double cells_of_block = 8;           // along a side of a square one

using Points = std::array<double, q>;

// On [-1, 1].
Points chebyshev() {
  Points out;
  for (Index m = 0; m < q; ++m)
    out[size(m)] = std::cos(std::numbers::pi * (static_cast<double>(m) + 0.5) / static_cast<double>(q));
  return out;
}
const Points nodes = chebyshev();

double lagrange(Index m, double x) {
  double out = 1;
  for (Index n = 0; n < q; ++n)
    if (n != m) out *= (x - nodes[size(n)]) / (nodes[size(m)] - nodes[size(n)]);
  return out;
}

// The mean of l_m over each of `cells` equal parts of [-1, 1], exactly.
Eigen::ArrayXXd cell_weights(Index cells) {
  Eigen::ArrayXXd out(q, cells);
  for (Index m = 0; m < q; ++m)
    for (Index i = 0; i < cells; ++i) {
      const double half = 1 / static_cast<double>(cells),
                   middle = (2 * static_cast<double>(i) + 1) * half - 1;
      out(m, i) = 0;
      for (std::size_t k = 0; k < 4; ++k)
        out(m, i) += 0.5 * gauss4.weights[k] * lagrange(m, middle + half * gauss4.nodes[k]);
    }
  return out;
}

// l_m of a block at the points n of its lower or upper half.
Eigen::ArrayXXd half_weights(int upper) {
  Eigen::ArrayXXd out(q, q);
  for (Index m = 0; m < q; ++m)
    for (Index n = 0; n < q; ++n) out(m, n) = lagrange(m, 0.5 * (nodes[size(n)] + (upper ? 1 : -1)));
  return out;
}

using Square = Eigen::Map<Eigen::Array<double, q, q, Eigen::RowMajor>>;
using ConstSquare = Eigen::Map<const Eigen::Array<double, q, q, Eigen::RowMajor>>;

// How many cells of this spacing make a block's side, beside cells as wide as `other`.
Index block_side(double own, double other) {
  const double cells = cells_of_block * std::sqrt(other / own);
  return Index{1} << std::clamp(static_cast<int>(std::lround(std::log2(cells))), 0, 6);
}

Index groups(Index n, Index of) { return (n + of - 1) / of; }

double distance_of(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }

// Corner functions times the twists with their signs.
void add_products(const LoadWeights& weights, double* const out[3][6], Index count,
                  const std::array<Eigen::VectorXd, 4>& twists, double* sum) {
  for (Traction s : stress::tractions) {
    if (weights[s] == 0) continue;
    for (Component c : stress::components)
      sum[c] += weights[s] * Eigen::Map<const Eigen::VectorXd>(out[s][c], count)
                                 .dot(twists[size(2 * !odd_in_x(c, s) + !odd_in_y(c, s))]);
  }
}

}  // namespace

struct CellTree::Target {
  double x, y, z;  // from the corner of the first cell
  bool by_cells;
  Near near;
  double sum[6] = {};

  // Whether a block `s` of the first ones long holds any that are summed by cells.
  bool holds(Index i, Index j, Index s) const {
    return by_cells && i * s < near.i1 && (i + 1) * s > near.i0 && j * s < near.j1 && (j + 1) * s > near.j0;
  }
};

CellTree::CellTree(const LoadedBody& body)
    : body_(body),
      weights_(body.friction.weights()),
      bx_(block_side(body.grid.dx, body.grid.dy)),
      by_(64 / bx_),
      x0_(-0.5 * body.grid.size_x()),
      y0_(-0.5 * body.grid.size_y()) {
  gather_cells();
  while (levels_.back().nx > 1 || levels_.back().ny > 1) gather_blocks();
}

void CellTree::gather_cells() {
  const auto [nx, ny] = body_.grid.shape;
  Level level{groups(nx, bx_),
              groups(ny, by_),
              static_cast<double>(bx_) * body_.grid.dx,
              static_cast<double>(by_) * body_.grid.dy,
              {},
              {}};
  level.weights.resize(size(level.nx * level.ny * q * q));
  level.loaded.resize(size(level.nx * level.ny));
  const Eigen::MatrixXd along_x = cell_weights(bx_).matrix(),
                        along_y = cell_weights(by_).matrix().transpose();
  Eigen::MatrixXd half(q, by_);
  for (Index i = 0; i < level.nx; ++i)
    for (Index j = 0; j < level.ny; ++j) {
      const Index rows = std::min(bx_, nx - i * bx_), columns = std::min(by_, ny - j * by_);
      const auto cells = body_.pressure.block(i * bx_, j * by_, rows, columns);
      const bool loaded = (cells != 0).any();
      level.loaded[size(i * level.ny + j)] = loaded;
      if (!loaded) continue;
      half.leftCols(columns).noalias() = along_x.leftCols(rows) * cells.matrix();
      Square(level.weights.data() + (i * level.ny + j) * q * q).matrix().noalias() =
          body_.grid.cell_area() * half.leftCols(columns) * along_y.topRows(columns);
    }
  levels_.push_back(std::move(level));
}

void CellTree::gather_blocks() {
  static const std::array halves{Eigen::MatrixXd(half_weights(0).matrix()),
                                 Eigen::MatrixXd(half_weights(1).matrix())};
  const Level& from = levels_.back();
  Level level{groups(from.nx, 2), groups(from.ny, 2), 2 * from.sx, 2 * from.sy, {}, {}};
  level.weights.resize(size(level.nx * level.ny * q * q));
  level.loaded.resize(size(level.nx * level.ny));
  for (Index i = 0; i < from.nx; ++i)
    for (Index j = 0; j < from.ny; ++j) {
      if (!from.loaded[size(i * from.ny + j)]) continue;
      const Index to = i / 2 * level.ny + j / 2;
      level.loaded[size(to)] = 1;
      Square(level.weights.data() + to * q * q).matrix() +=
          halves[size(i % 2)] * ConstSquare(from.weights.data() + (i * from.ny + j) * q * q).matrix() *
          halves[size(j % 2)].transpose();
    }
  levels_.push_back(std::move(level));
}

void CellTree::add_block(Target& t, std::size_t level, Index i, Index j) const {
  const Level& l = levels_[level];
  if (!l.loaded[size(i * l.ny + j)]) return;
  const bool holds = t.holds(i, j, Index{1} << level);
  if (level == 0 && holds) return;
  const double x = t.x - (static_cast<double>(i) + 0.5) * l.sx,
               y = t.y - (static_cast<double>(j) + 0.5) * l.sy;
  if (level == 0 || (!holds && distance_of(x, y, t.z) >= far * std::max(l.sx, l.sy))) {
    Points px, py;
    for (std::size_t m = 0; m < px.size(); ++m)
      px[m] = x - 0.5 * l.sx * nodes[m], py[m] = y - 0.5 * l.sy * nodes[m];
    add_point_loads(px.data(), py.data(), l.weights.data() + (i * l.ny + j) * q * q, t.z, body_.poisson,
                    weights_.data(), t.sum);
    return;
  }
  const Level& finer = levels_[level - 1];
  for (Index m = 2 * i; m < std::min(2 * i + 2, finer.nx); ++m)
    for (Index n = 2 * j; n < std::min(2 * j + 2, finer.ny); ++n) add_block(t, level - 1, m, n);
}

// Each corner function times the twist of the pressures about its corner.
void CellTree::add_cells(Target& t) const {
  const auto& [shape, dx, dy, periodic] = body_.grid;
  const Index i0 = t.near.i0 * bx_, i1 = std::min(t.near.i1 * bx_, shape.nx), j0 = t.near.j0 * by_,
              j1 = std::min(t.near.j1 * by_, shape.ny), rows = j1 - j0 + 1;
  constexpr Index lanes = corner_lanes;
  std::vector<double> y(size(rows)), values(size(3 * 6 * lanes * rows)), beyond(size(rows));
  for (Index j = 0; j < rows; ++j) {
    const double Y = (t.y - static_cast<double>(j0 + j) * dy) / dx;
    y[size(j)] = std::abs(Y), beyond[size(j)] = Y < 0;
  }
  double* out[3][6];
  for (Traction s : stress::tractions)
    for (Component c : stress::components)
      out[s][c] = weights_[s] == 0 ? nullptr : values.data() + static_cast<Index>(6 * s + c) * lanes * rows;
  std::array<Eigen::VectorXd, 4> twists;
  twists.fill(Eigen::VectorXd(lanes * rows));
  auto p = [&](Index i, Index j) {
    return i >= i0 && i < i1 && j >= j0 && j < j1 ? body_.pressure(i, j) : 0.0;
  };
  for (Index i = i0; i <= i1; i += lanes) {
    double x[lanes];
    bool before[lanes];
    for (Index l = 0; l < lanes; ++l) {
      const double X = (t.x - static_cast<double>(i + l) * dx) / dx;
      x[l] = std::max(std::abs(X), beside), before[l] = X < 0;
    }
    corner_tile(x, y.data(), rows, t.z / dx, body_.poisson, out);
    // Twists by what turns the sign of a function: neither axis, y, x, both.
    for (Index j = 0; j < rows; ++j)
      for (Index l = 0; l < lanes; ++l) {
        const Index m = i + l, n = j0 + j;
        const double twist = p(m, n) - p(m - 1, n) - p(m, n - 1) + p(m - 1, n - 1),
                     x_sign = before[l] ? -twist : twist;
        twists[0](j * lanes + l) = twist, twists[2](j * lanes + l) = x_sign;
        twists[1](j * lanes + l) = beyond[size(j)] != 0 ? -twist : twist;
        twists[3](j * lanes + l) = beyond[size(j)] != 0 ? -x_sign : x_sign;
      }
    add_products(weights_, out, lanes * rows, twists, t.sum);
  }
}

Tensor CellTree::at(double x, double y, double z) const {
  const Level& cells = levels_.front();
  Target t{x - x0_, y - y0_, z, z < 2 * std::max(cells.sx, cells.sy), {}};
  auto block = [](double place, double side, Index count) {
    return std::clamp(static_cast<Index>(std::floor(place / side)), Index{0}, count - 1);
  };
  if (t.by_cells) {
    const Index i = block(t.x, cells.sx, cells.nx), j = block(t.y, cells.sy, cells.ny);
    t.near = {std::max(i - around, Index{0}), std::min(i + around + 1, cells.nx),
              std::max(j - around, Index{0}), std::min(j + around + 1, cells.ny)};
    add_cells(t);
  }
  const Level& top = levels_.back();
  for (Index i = 0; i < top.nx; ++i)
    for (Index j = 0; j < top.ny; ++j) add_block(t, levels_.size() - 1, i, j);
  Tensor out;
  for (Component c : stress::components) out[c] = t.sum[c] / (2 * std::numbers::pi);
  return out;
}

}  // namespace asperity
