#include "stats/filter/outliers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/SparseCholesky>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

constexpr double deviation_of_median = 1.4826;                   // of Gaussian numbers, 1/Φ⁻¹(3/4)
constexpr double beyond_both = 0.75, nearby = 0.7, usual = 1.1;  // of (2), (3) and g
constexpr Index tile = 16;
constexpr Index directions = 8, others = 3;
constexpr double infinite = std::numeric_limits<double>::infinity();
using Mask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// 1.4826 of the median; 0 of none.
double robust_deviation(std::vector<double>& sizes) {
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + std::ssize(sizes) / 2;
  std::ranges::nth_element(sizes, middle);
  return deviation_of_median * *middle;
}

// The middle of three; of two that are there their mean; of fewer, missing.
double middle_of(double a, double b, double c) {
  if (!std::isnan(a + b + c)) return std::max(std::min(a, b), std::min(std::max(a, b), c));
  return std::isnan(a) ? (b + c) / 2 : std::isnan(b) ? (a + c) / 2 : (a + b) / 2;
}

// A field with what lies about it: images of a period, otherwise nothing.
Field framed(const Field& z, Periodic periodic, Shape frame) {
  const auto [nx, ny] = shape_of(z);
  Field out = Field::Constant(nx + 2 * frame.nx, ny + 2 * frame.ny, NAN);
  out.block(frame.nx, frame.ny, nx, ny) = z;
  // No point is met on both sides.
  if (periodic.y && ny > 2 * frame.ny) {
    out.leftCols(frame.ny) = out.middleCols(ny, frame.ny).eval();
    out.rightCols(frame.ny) = out.middleCols(frame.ny, frame.ny).eval();
  }
  if (periodic.x && nx > 2 * frame.nx) {
    out.topRows(frame.nx) = out.middleRows(nx, frame.nx).eval();
    out.bottomRows(frame.nx) = out.middleRows(frame.nx, frame.nx).eval();
  }
  return out;
}

// The points and their neighbours.
Mask grown(const Mask& points, Periodic periodic) {
  const Index nx = points.rows(), ny = points.cols();
  Mask out = points;
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j)
      for (Index k = i - 1; points(i, j) && k <= i + 1; ++k)
        for (Index l = j - 1; l <= j + 1; ++l)
          if ((periodic.x || (k >= 0 && k < nx)) && (periodic.y || (l >= 0 && l < ny)))
            out((k + nx) % nx, (l + ny) % ny) = true;
  return out;
}

// Heights judged against a surface, for one width.
class Judgement {
 public:
  Judgement(const Field& own, const Field& surface, const Grid& grid, const OutlierRule& rule, Shape width,
            int threads)
      : own_(own),
        surface_(surface),
        periodic_(grid.periodic),
        frame_{width.nx + others - 1, width.ny + others - 1},
        around_(framed(surface, periodic_, frame_)),
        bound_(rule.bound),
        tiles_(Field::Constant(std::max<Index>(1, own.rows() / tile), std::max<Index>(1, own.cols() / tile),
                               NAN)) {
    set_offsets(width);
    set_deviations(rule, threads);
    set_verdicts(threads);
  }

  Mask judged, far, nearly;
  /// The middle one of the s_d; NaN: no point is judged.
  double deviation() const {
    std::vector<double> there;
    for (const double s : deviations_)
      if (!std::isnan(s)) there.push_back(s);
    std::ranges::sort(there);
    return there.empty() ? NAN : (there[(there.size() - 1) / 2] + there[there.size() / 2]) / 2;
  }
  /// (3), next to what is taken.
  Mask outliers(const Mask& taken) const { return far || (grown(taken || far, periodic_) && nearly); }

 private:
  struct Sides {
    double p, q;
  };
  // Along the axes, the diagonals, and halfway between.
  void set_offsets(Shape width) {
    constexpr std::array<std::array<int, 2>, directions> halves{
        {{2, 0}, {0, 2}, {2, 2}, {2, -2}, {2, 1}, {2, -1}, {1, 2}, {1, -2}}};
    const auto along = [](int share, Index w) {
      return share == 0 ? 0 : std::abs(share) == 2 ? share / 2 * w : share * std::max<Index>(1, w / 2);
    };
    for (std::size_t d = 0; d < directions; ++d)
      for (Index k = 0; k < others; ++k)
        offsets_[d][size(k)] =
            along(halves[d][0], width.nx + k) * around_.cols() + along(halves[d][1], width.ny + k);
  }
  Sides sides(Index d, Index i, Index j) const {
    const double* at = &around_(i + frame_.nx, j + frame_.ny);
    const auto& [a, b, c] = offsets_[size(d)];
    return {middle_of(at[a], at[b], at[c]), middle_of(at[-a], at[-b], at[-c])};
  }
  // |r_d| of the points that are there, of a part of the field.
  void add_sizes(std::vector<double>& sizes, Index d, Index i, Index j) const {
    const auto [p, q] = sides(d, i, j);
    if (const double r = surface_(i, j) - (p + q) / 2; !std::isnan(r)) sizes.push_back(std::abs(r));
  }
  void set_deviations(const OutlierRule& rule, int threads) {
    const double round_off = 4 * std::numeric_limits<double>::epsilon() *
                             own_.isNaN().select(0, own_).abs().maxCoeff(),
                 least = std::max(rule.step / std::sqrt(12.0), round_off);
    parallel_ranges(directions, threads, [&](Index begin, Index end, int) {
      std::vector<double> sizes;
      for (Index d = begin; d < end; ++d) {
        sizes.clear();
        for (Index i = 0; i < own_.rows(); ++i)
          for (Index j = 0; j < own_.cols(); ++j) add_sizes(sizes, d, i, j);
        deviations_[size(d)] = sizes.empty() ? NAN : std::max(robust_deviation(sizes), least);
      }
    });
  }
  // (2); infinite of a point that is not judged.
  double standing_out(Index i, Index j) const {
    const double z = own_(i, j);
    double least = infinite;
    int sign = 0;
    bool stands = true, judged_here = false;
    for (Index d = 0; d < directions; ++d) {
      const auto [p, q] = sides(d, i, j);
      const bool no_p = std::isnan(p), no_q = std::isnan(q), both = !no_p && !no_q;
      if (std::isnan(z) || std::isnan(deviations_[size(d)]) || (no_p && no_q)) continue;
      const double s = deviations_[size(d)], a = z - (no_p ? q : p), b = z - (no_q ? p : q);
      stands = stands && std::min(std::abs(a), std::abs(b)) > beyond_both * bound_ * s && a * b > 0 &&
               (sign == 0 || (a > 0) == (sign > 0));
      if (both) judged_here = true, least = std::min(least, std::abs(a + b) / 2 / s);
      if (!stands && judged_here) return 0;
      sign = a > 0 ? 1 : -1;
    }
    return judged_here ? least : infinite;
  }
  void set_verdicts(int threads) {
    Field excess(own_.rows(), own_.cols());
    parallel_ranges(own_.rows(), threads, [&](Index begin, Index end, int) {
      for (Index i = begin; i < end; ++i)
        for (Index j = 0; j < own_.cols(); ++j) excess(i, j) = standing_out(i, j) / bound_;
    });
    judged = excess < infinite;
    far = nearly = Mask::Constant(own_.rows(), own_.cols(), false);
    for (Index i = 0; i < own_.rows(); ++i)
      for (Index j = 0; j < own_.cols(); ++j)
        if (judged(i, j) && excess(i, j) > nearby) {
          const double g = roughness(i, j);
          far(i, j) = excess(i, j) > g;
          nearly(i, j) = excess(i, j) > nearby * g;
        }
  }
  // g, of which few places are asked.
  double roughness(Index i, Index j) {
    const Index a = std::min(i / tile, tiles_.rows() - 1), b = std::min(j / tile, tiles_.cols() - 1);
    double most = usual;
    for (Index k = std::max<Index>(a - 1, 0); k < std::min(a + 2, tiles_.rows()); ++k)
      for (Index l = std::max<Index>(b - 1, 0); l < std::min(b + 2, tiles_.cols()); ++l) {
        if (std::isnan(tiles_(k, l))) tiles_(k, l) = roughness_of_tile(k, l);
        most = std::max(most, tiles_(k, l));
      }
    return most / usual;
  }
  // The last tile has the rest.
  double roughness_of_tile(Index k, Index l) const {
    const Index rows = k + 1 < tiles_.rows() ? (k + 1) * tile : own_.rows(),
                columns = l + 1 < tiles_.cols() ? (l + 1) * tile : own_.cols();
    std::vector<double> all;
    for (Index d = 0; d < directions; ++d) {
      const Index before = std::ssize(all);
      for (Index i = k * tile; i < rows; ++i)
        for (Index j = l * tile; j < columns; ++j) add_sizes(all, d, i, j);
      for (auto at = all.begin() + before; at != all.end(); ++at) *at /= deviations_[size(d)];
    }
    return robust_deviation(all);
  }

  const Field &own_, &surface_;
  Periodic periodic_;
  Shape frame_;
  Field around_;
  double bound_;
  std::array<std::array<Index, others>, directions> offsets_ = {};
  std::array<double, directions> deviations_ = {};
  Field tiles_;  ///< 1.4826 median |r_d|/s_d; NaN: not known yet
};

// 1, 3, 7, … and the width itself, but not beyond the map.
std::vector<Shape> widths(Shape most, Shape map) {
  const Shape last{std::min(most.nx, map.nx), std::min(most.ny, map.ny)};
  std::vector<Shape> out;
  for (Index w = 1; out.empty() || !(out.back() == last); w = 2 * w + 1)
    out.push_back({std::min(w, last.nx), std::min(w, last.ny)});
  return out;
}

double share_beyond(const Field& z, const OutlierRule& rule) {
  std::vector<double> there;
  for (const double value : z.reshaped<Eigen::RowMajor>())
    if (!std::isnan(value)) there.push_back(value);
  if (there.empty()) return 0;
  const auto middle = there.begin() + std::ssize(there) / 2;
  std::ranges::nth_element(there, middle);
  for (const double median = *middle; double& value : there) value = std::abs(value - median);
  const double far = rule.bound * std::max(robust_deviation(there), rule.step / std::sqrt(12.0));
  return static_cast<double>(std::ranges::count_if(there, [far](double size) { return size > far; })) /
         static_cast<double>(there.size());
}

}  // namespace

Outliers without_outliers(const Field& z, const Grid& grid, const OutlierRule& rule, int threads) {
  check_parameter(rule.bound > 0 && std::isfinite(rule.bound), "outliers",
                  "'" + shortest(rule.bound) + "' is not above zero and finite");
  check_parameter(rule.width.nx > 0 && rule.width.ny > 0, "outliers",
                  "a width of " + text(rule.width) + " points is not above zero");
  Outliers out{.heights = z};
  Mask taken = Mask::Constant(z.rows(), z.cols(), false), stays = taken, judged = taken;
  auto judge = [&](Shape width) { return Judgement(z, out.heights, grid, rule, width, threads); };
  const std::vector<Shape> all = widths(rule.width, grid.shape);
  for (const Shape width : all)
    for (;;) {
      const Mask more = judge(width).outliers(taken) && !out.heights.isNaN();
      if (!more.any()) break;
      taken = taken || more;
      out.heights = more.select(NAN, out.heights);
    }
  for (const Shape width : all) {
    const Judgement last = judge(width);
    stays = stays || last.outliers(last.far);
    judged = judged || last.judged;
    out.scales.push_back({width, last.deviation()});
  }
  check_parameter(judged.any() || z.isNaN().all(), "outliers",
                  "no point of a map of " + text(grid.shape) + " has points on both sides to judge it by");
  out.heights = (taken && judged && !stays).select(z, out.heights);
  out.removed = out.heights.isNaN().count() - z.isNaN().count();
  out.spiky = share_beyond(z, rule);
  return out;
}

// ---- missing points filled ----

namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Across the seam of a periodic axis; -1 beyond the edge of another.
Index place(Index k, Index n, bool periodic) {
  if (k >= 0 && k < n) return k;
  return periodic ? (k + n) % n : -1;
}

// Solves (1) for the missing points, in the order of the field.
Eigen::VectorXd membrane(const Field& z, const Grid& grid) {
  constexpr std::array<std::array<Index, 2>, 4> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const std::array<double, 2> weights{1 / (grid.dx * grid.dx), 1 / (grid.dy * grid.dy)};
  Eigen::Array<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> number(z.rows(), z.cols());
  Index count = 0;
  for (Index k = 0; k < z.size(); ++k) number(k) = std::isnan(z(k)) ? count++ : -1;
  std::vector<Eigen::Triplet<double>> terms;
  Eigen::VectorXd known = Eigen::VectorXd::Zero(count);
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      const Index row = number(i, j);
      if (row < 0) continue;
      double sum = 0;
      for (const auto& [di, dj] : steps) {
        const Index p = place(i + di, z.rows(), grid.periodic.x),
                    q = place(j + dj, z.cols(), grid.periodic.y);
        if (p < 0 || q < 0) continue;
        const double weight = weights[di == 0];
        sum += weight;
        if (number(p, q) >= 0)
          terms.emplace_back(row, number(p, q), -weight);
        else
          known(row) += weight * z(p, q);
      }
      terms.emplace_back(row, row, sum);
    }
  Matrix matrix(count, count);
  matrix.setFromTriplets(terms.begin(), terms.end());
  return Eigen::SimplicialLDLT<Matrix>(matrix).solve(known);
}

}  // namespace

Field filled(Field z, const Grid& grid, Filling filling) {
  if (!z.hasNaN()) return z;
  const Field there = z.isNaN().select(0, z);
  const auto points = static_cast<double>((!z.isNaN()).count());
  if (points == 0) throw DataError("heights", "all points are missing");
  if (filling == Filling::laplace) {
    const Eigen::VectorXd values = membrane(z, grid);
    for (Index k = 0, next = 0; k < z.size(); ++k)
      if (std::isnan(z(k))) z(k) = values(next++);
    return z;
  }
  const double value =
      filling == Filling::mean ? there.sum() / points : z.minCoeff<Eigen::PropagateNumbers>();
  return z.isNaN().select(value, z);
}

}  // namespace asperity
