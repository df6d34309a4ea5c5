#include "stats/feature/features.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/hybrid/summits.hpp"

namespace asperity {
namespace {

// Columns of LocalSums, less the first, of hills; those of dales follow, and 1 at points with all neighbours.
enum Local { peaks, curvature, closed, area, volume, local, inside = 2 * local, columns };

using Flags = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// At edges that are not periodic, and beside missing points.
Flags edge_of(const Field& z, const Grid& grid) {
  const Index nx = z.rows(), ny = z.cols();
  Flags out(nx, ny);
  const auto missing = [&](Index i, Index j) {
    if ((!grid.periodic.x && (i < 0 || i >= nx)) || (!grid.periodic.y && (j < 0 || j >= ny))) return true;
    return std::isnan(z((i + nx) % nx, (j + ny) % ny));
  };
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j) {
      out(i, j) = false;
      for (Index k = 0; k < 9 && !out(i, j); ++k) out(i, j) = missing(i + k / 3 - 1, j + k % 3 - 1);
    }
  return out;
}

// A peak with all its neighbours is a summit; a plateau need not have its first point in common with it.
void set_curvatures(Features::Kind& kind, const Field& z, const Grid& grid, double rounding) {
  const SummitRows rows = find_summits(z, grid, rounding);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const FoundSummit& s : rows[i]) {
      const HillNumber of =
          kind.hills.of_point((static_cast<Index>(i) + 1) % z.rows(), (s.column + 1) % z.cols());
      if (of == no_hill) continue;
      Feature& f = kind.all[static_cast<std::size_t>(of)];
      if (f.height - s.height <= rounding) f.curvature = s.curvature;
    }
}

// Of heights above their mean, and c.
Features::Kind kind_of(const Field& z, const Grid& grid, const Flags& edge, double c, double least,
                       double rounding) {
  Features::Kind out;
  Hills all = hills_of(z, grid.periodic);
  out.unpruned = all.all.size();
  out.hills = pruned(std::move(all), least);
  for (const Hill& h : out.hills.all)
    out.all.push_back({.i = h.peak / z.cols(), .j = h.peak % z.cols(), .height = h.height, .closed = true});
  set_curvatures(out, z, grid, rounding);
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      const HillNumber of = out.hills.of_point(i, j);
      if (of == no_hill || !(z(i, j) > c)) continue;
      Feature& f = out.all[static_cast<std::size_t>(of)];
      f.closed = f.closed && !edge(i, j);
      f.area += grid.cell_area(), f.volume += (z(i, j) - c) * grid.cell_area();
    }
  for (Feature& f : out.all) f.closed = f.closed && f.area > 0;
  return out;
}

Eigen::Vector<double, local> local_of(const Feature& f) {
  Eigen::Vector<double, local> out;
  out << f.is_peak(), f.is_peak() ? f.curvature : 0, f.closed, f.closed * f.area, f.closed * f.volume;
  return out;
}

template <class Sums>
FeatureFigures figures_of(const Sums& of, double area_inside) {
  return {of(peaks) / area_inside, of(curvature) / of(peaks), of(area) / of(closed), of(volume) / of(closed)};
}

}  // namespace

Features::Features(const Field& z, const Grid& grid, const Pruning& pruning, double rounding, int threads)
    : grid_(grid), there_(z.isNaN().select(z, 1)) {
  if (std::min(z.rows(), z.cols()) < 3)
    throw DataError("heights", "features need 3 x 3 points, found " + text(shape_of(z)));
  const double n = static_cast<double>(z.isFinite().count()), mean = z.isFinite().select(z, 0).sum() / n,
               highest = z.isFinite().select(z, mean).maxCoeff(),
               lowest = z.isFinite().select(z, mean).minCoeff();
  if (!(highest > lowest)) throw DataError("heights", "all are the same: there is no hill");
  const Flags edge = edge_of(z, grid);
  inside_ = !edge;
  const double c = MaterialRatioCurve(z).height(0.5) - mean, least = pruning.height(highest - lowest);
  parallel_ranges(2, threads, [&](Index begin, Index end, int) {
    for (Index dales = begin; dales < end; ++dales)
      (dales ? dales_ : hills_) =
          kind_of(dales ? mean - z : Field(z - mean), grid, edge, dales ? -c : c, least, rounding);
  });
}

FeatureFigures Features::Kind::figures(double area_of_all) const {
  Eigen::Vector<double, local> sums = Eigen::Vector<double, local>::Zero();
  for (const Feature& f : all) sums += local_of(f);
  return figures_of(sums, area_of_all);
}

double Features::Kind::five() const {
  std::vector<double> heights;
  for (const Feature& f : all)
    if (f.is_peak()) heights.push_back(f.height);
  const auto last = heights.begin() + std::min<std::ptrdiff_t>(5, std::ssize(heights));
  std::ranges::partial_sort(heights, last, std::ranges::greater());
  double sum = 0;
  for (auto h = heights.begin(); h != last; ++h) sum += *h;
  return sum / static_cast<double>(last - heights.begin());
}

std::size_t Features::Kind::peaks() const {
  return static_cast<std::size_t>(std::ranges::count_if(all, &Feature::is_peak));
}

std::size_t Features::Kind::closed() const {
  return static_cast<std::size_t>(std::ranges::count_if(all, &Feature::closed));
}

LocalMeans Features::means(const FieldExtent& extent, int threads) const {
  LocalSums sums(grid_, columns);
  std::vector<std::vector<std::pair<const Feature*, Index>>> rows(static_cast<std::size_t>(grid_.shape.nx));
  for (const auto& [kind, first] : {std::pair{&hills_, Index{1}}, {&dales_, Index{1} + local}})
    for (const Feature& f : kind->all) rows[static_cast<std::size_t>(f.i)].emplace_back(&f, first);
  sums.add_rows(grid_.shape.nx, threads, [&](Index i, LocalSums::Values& values) {
    const Eigen::VectorXd there = there_.row(i).matrix().transpose() * 0;
    for (Index column = 1; column <= columns; ++column) values.col(column) = there;
    values.col(1 + inside) += inside_.row(i).cast<double>().matrix().transpose();
    for (const auto& [f, first] : rows[static_cast<std::size_t>(i)])
      values.row(f->j).segment(first, local) += local_of(*f).transpose();
  });
  return sums.means(extent);
}

FeatureFigures Features::figures(const Eigen::VectorXd& means, bool of_dales) const {
  return figures_of(means.segment(of_dales ? local : 0, local), means(inside) * grid_.cell_area());
}

}  // namespace asperity
