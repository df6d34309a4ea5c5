#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"
#include "stress/search.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Tensor;
using stress::Traction;

constexpr Index wide = FarStress::wide, reach = near_reach, tile_side = 32, torus = 64;
constexpr double bound_margin = 1.02;  // of B, an ascent's
constexpr Index batch = 16;            // tiles between two looks at the largest value

constexpr double none = -std::numeric_limits<double>::infinity();

// Precomputed for one depth.
struct Depth {
  double z;
  std::array<AlignedVector<Complex>, 6> near;  // spectra of w K
  Tensor whole;                                // U
  double bound;                                // B
  FarStress::Weights far;                      // of the far layers
};

// The largest of the nine about a cell; -∞ of a layer that was left out.
double value_about(const Field& f, Index i, Index j) {
  return f.size() == 0 ? none : f.block<3, 3>(i - 1, j - 1).maxCoeff();
}

// By how much the parabola through three values at equal steps exceeds the middle one.
double rise_between(double before, double top, double behind) {
  if (!std::isfinite(before) || !std::isfinite(behind)) return 0;
  const double slope = 0.5 * (behind - before), bend = before - 2 * top + behind;
  return bend < 0 ? -0.5 * slope * slope / bend : 0;
}

class Tiles {
 public:
  Tiles(const LoadedBody& body, Criterion of, const std::vector<double>& depths, int threads)
      : body_(body), of_(of), threads_(threads), transform_({torus, torus}), far_(body, threads) {
    for (double z : depths) depths_.push_back(depth(z));
  }

  std::vector<LayerMaximum> search(double known);

 private:
  struct Tile {
    Index i, j;        // first cell
    double low, high;  // m, M of (2)
    double top = 0;    // that a maximum from here may reach
  };
  struct Work {
    AlignedVector<double> cells = AlignedVector<double>(torus * torus), values = cells;
    AlignedVector<Complex> load, product;
    std::array<AlignedVector<double>, 6> stress;
    std::vector<LayerMaximum> found;
  };

  Depth depth(double z);
  std::vector<Tile> tiles() const;
  double bound(const Tile& tile, const Depth& d) const;
  double start(const Depth& d, double top) const { return least_start(of_, body_.grid, d.z, top); }
  void look(const Tile& tile, double least, Work& work) const;
  void add_summits(const Tile& tile, const std::vector<Field>& layers, std::size_t k, double least,
                   std::vector<LayerMaximum>& out) const;
  void add_far(const Tile& tile, const Depth& d, Work& work) const;
  void load(const Tile& tile, Work& work) const;
  void layer_of(const Tile& tile, const Depth& d, Work& work, Field& values) const;

  const LoadedBody& body_;
  const Criterion of_;
  const int threads_;
  const RealTransform2D transform_;
  const FarStress far_;
  std::vector<Depth> depths_;
};

Depth Tiles::depth(double z) {
  const NearKernel kernel(body_, 1, reach, z);
  Depth out{z, {}, kernel.sum(), bound_margin * kernel.largest(of_), far_.weights(z)};
  AlignedVector<double> real(size(torus * torus));
  for (Component c : stress::components) {
    std::ranges::fill(real, 0.0);
    for (Index i = -reach; i <= reach; ++i)
      for (Index j = -reach; j <= reach; ++j)
        real[size(wrapped(i, torus) * torus + wrapped(j, torus))] =
            kernel.at(i, j)[c] / static_cast<double>(torus * torus);
    out.near[c].resize(size(transform_.spectrum_size()));
    transform_.forward(real.data(), out.near[c].data());
  }
  return out;
}

std::vector<Tiles::Tile> Tiles::tiles() const {
  const Index nx = body_.grid.shape.nx, ny = body_.grid.shape.ny;
  const auto rows = (nx + tile_side - 1) / tile_side, columns = (ny + tile_side - 1) / tile_side;
  std::vector<Tile> out(size(rows * columns));
  parallel_ranges(rows, threads_, [&](Index begin, Index end, int) {
    for (Index r = begin; r < end; ++r)
      for (Index s = 0; s < columns; ++s) {
        Tile t{r * tile_side, s * tile_side, std::numeric_limits<double>::infinity(),
               -std::numeric_limits<double>::infinity()};
        const Index i0 = t.i - reach, j0 = t.j - reach, window = tile_side + 2 * reach;
        if (i0 >= 0 && j0 >= 0 && i0 + window <= nx && j0 + window <= ny) {
          const auto cells = body_.pressure.block(i0, j0, window, window);
          t.low = cells.minCoeff(), t.high = cells.maxCoeff();
        } else
          for (Index i = t.i - reach; i < t.i + tile_side + reach; ++i)
            for (Index j = t.j - reach; j < t.j + tile_side + reach; ++j) {
              const double p = body_.at(i, j);
              t.low = std::min(t.low, p), t.high = std::max(t.high, p);
            }
        for (const Depth& d : depths_) t.top = std::max(t.top, bound(t, d) / start(d, 1));
        out[size(r * columns + s)] = t;
      }
  });
  std::ranges::stable_sort(out, std::ranges::greater{}, &Tile::top);
  return out;
}

// (2), at the corners and the middle of the tile's wide cells.
double Tiles::bound(const Tile& t, const Depth& d) const {
  const Shape shape = far_.shape();
  const Index i0 = t.i / wide, j0 = t.j / wide, i1 = std::min(i0 + tile_side / wide, shape.nx) - 1,
              j1 = std::min(j0 + tile_side / wide, shape.ny) - 1;
  double top = -std::numeric_limits<double>::infinity();
  for (Index i = i0; i <= i1; i += 1)
    for (Index j = j0; j <= j1; j += 1) {
      Tensor s = far_.at(d.far, i, j);
      for (Component c : stress::components) s[c] += t.low * d.whole[c];
      top = std::max(top, equivalent_stress(of_, s));
    }
  return top + (t.high - t.low) * d.bound;
}

void Tiles::add_far(const Tile& t, const Depth& d, Work& work) const {
  constexpr Index side = tile_side + 2;
  // The far part between the middles of wide cells, the same from every tile.
  const auto [wx, wy] = far_.shape();
  constexpr Index blocks = tile_side / wide + 2;
  std::array<std::array<Tensor, blocks>, blocks> far;
  auto beside = [](Index k, Index n, bool repeats) {
    return repeats ? wrapped(k, n) : std::clamp<Index>(k, 0, n - 1);
  };
  for (Index i = 0; i < blocks; ++i)
    for (Index j = 0; j < blocks; ++j)
      far[size(i)][size(j)] = far_.at(d.far, beside(t.i / wide + i - 1, wx, body_.grid.periodic.x),
                                      beside(t.j / wide + j - 1, wy, body_.grid.periodic.y));
  auto place = [](Index cell, Index& block, double& share) {  // of a cell from one before the tile on
    const double u = (static_cast<double>(cell) - 0.5) / static_cast<double>(wide) + 0.5;
    block = static_cast<Index>(std::floor(u));
    share = u - static_cast<double>(block);
  };
  std::array<Index, size(side)> block;
  std::array<double, size(side)> share;
  for (Index j = 0; j < side; ++j) place(j, block[size(j)], share[size(j)]);
  for (Component c : stress::components)
    for (Index i = 0; i < side; ++i) {
      const auto &before = far[size(block[size(i)])], &behind = far[size(block[size(i)] + 1)];
      std::array<double, blocks> row;
      for (std::size_t k = 0; k < row.size(); ++k)
        row[k] = (1 - share[size(i)]) * before[k][c] + share[size(i)] * behind[k][c];
      double* s = work.stress[c].data() + i * side;
      for (std::size_t j = 0; j < share.size(); ++j)
        s[j] += row[size(block[j])] + share[j] * (row[size(block[j] + 1)] - row[size(block[j])]);
    }
}

// The criterion on the tile and one cell around it.
void Tiles::layer_of(const Tile& t, const Depth& d, Work& work, Field& values) const {
  constexpr Index side = tile_side + 2;
  for (Component c : stress::components) {
    for (std::size_t k = 0; k < work.product.size(); ++k) {
      const Complex &p = work.load[k], &w = d.near[c][k];
      work.product[k] = {p.real() * w.real() - p.imag() * w.imag(),
                         p.real() * w.imag() + p.imag() * w.real()};
    }
    transform_.inverse(work.product.data(), work.values.data());
    AlignedVector<double>& s = work.stress[c];
    s.resize(size(side * side));
    for (Index i = 0; i < side; ++i)
      std::copy_n(work.values.data() + (reach + i) * torus + reach, side, s.data() + i * side);
  }
  add_far(t, d, work);
  StressRow rows;
  for (Component c : stress::components) rows[c] = {work.stress[c].data(), work.stress[c].size()};
  values.resize(side, side);
  equivalent_stress(of_, rows, {values.data(), size(side * side)});
}

// The pressures about a tile, transformed.
void Tiles::load(const Tile& t, Work& work) const {
  for (Index i = 0; i < torus; ++i)
    for (Index j = 0; j < torus; ++j)
      work.cells[size(i * torus + j)] = body_.at(t.i + i - reach - 1, t.j + j - reach - 1);
  work.load.resize(size(transform_.spectrum_size()));
  work.product.resize(work.load.size());
  transform_.forward(work.cells.data(), work.load.data());
}

void Tiles::look(const Tile& t, double least, Work& work) const {
  const auto [nx, ny] = body_.grid.shape;
  const Periodic repeats = body_.grid.periodic;
  load(t, work);
  const Index rows = std::min(tile_side, nx - t.i), columns = std::min(tile_side, ny - t.j);
  constexpr Index side = tile_side + 2;
  // Empty where the bound leaves a layer out.
  std::vector<Field> layers(depths_.size());
  for (std::size_t k = 0; k < depths_.size(); ++k) {
    if (bound(t, depths_[k]) < start(depths_[k], least)) continue;
    Field& values = layers[k];
    layer_of(t, depths_[k], work, values);
    // The outermost cells of a free domain have no neighbours outside.
    if (!repeats.x && t.i == 0) values.row(0) = none;
    if (!repeats.y && t.j == 0) values.col(0) = none;
    if (!repeats.x && t.i + rows == nx) values.bottomRows(side - 1 - rows) = none;
    if (!repeats.y && t.j + columns == ny) values.rightCols(side - 1 - columns) = none;
    least = std::max(least, values.block(1, 1, rows, columns).maxCoeff());
  }
  for (std::size_t k = 0; k < depths_.size(); ++k)
    if (layers[k].size() > 0) add_summits(t, layers, k, least, work.found);
}

// Of layer k, where the layers above and below are not higher.
void Tiles::add_summits(const Tile& t, const std::vector<Field>& layers, std::size_t k, double least,
                        std::vector<LayerMaximum>& out) const {
  const Grid& g = body_.grid;
  const double z = depths_[k].z;
  const bool first_of_field = k > 0 && at_centres(g, depths_[k - 1].z) && !at_centres(g, z);
  std::vector<LayerMaximum> all;
  add_maxima(layers[k], g, 1, std::min(tile_side, g.shape.nx - t.i) + 1, 1,
             std::min(tile_side, g.shape.ny - t.j) + 1, start(depths_[k], least), z, all);
  for (LayerMaximum& m : all) {
    const double above = k > 0 ? value_about(layers[k - 1], m.i, m.j) : m.value,
                 under = k + 1 < layers.size() ? value_about(layers[k + 1], m.i, m.j) : none;
    if ((above > m.value && !first_of_field) || under > m.value) continue;
    m.rise = rise_between(above, m.value, under);
    m.x += static_cast<double>(t.i - 1) * g.dx, m.y += static_cast<double>(t.j - 1) * g.dy;
    out.push_back(m);
  }
}

std::vector<LayerMaximum> Tiles::search(double known) {
  const std::vector<Tile> order = tiles();
  std::vector<LayerMaximum> out;
  std::vector<Work> work(batch);
  for (std::size_t first = 0; first < order.size(); first += batch) {
    if (order[first].top < known) break;
    const auto count = static_cast<Index>(std::min<std::size_t>(batch, order.size() - first));
    parallel_ranges(count, threads_, [&](Index begin, Index end, int) {
      for (Index k = begin; k < end; ++k) look(order[first + size(k)], known, work[size(k)]);
    });
    for (Work& w : work) {
      for (const LayerMaximum& m : w.found) known = std::max(known, m.value), out.push_back(m);
      w.found.clear();
    }
  }
  return out;
}

}  // namespace

bool ShallowSearch::possible(const Grid& g) {
  const auto [nx, ny] = g.shape;
  return std::max(g.dx, g.dy) <= 2 * std::min(g.dx, g.dy) && std::min(nx, ny) >= 64 && !g.periodic.both() &&
         !(g.periodic.x && nx % wide != 0) && !(g.periodic.y && ny % wide != 0);
}

double ShallowSearch::deepest(const Grid& g) { return 12 * std::max(g.dx, g.dy); }

std::vector<LayerMaximum> ShallowSearch::maxima(const LoadedBody& body, Criterion of,
                                                const std::vector<double>& depths, double known,
                                                int threads) {
  return Tiles(body, of, depths, threads).search(known);
}

}  // namespace asperity
