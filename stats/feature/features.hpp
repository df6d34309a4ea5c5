/// Features of a surface: its hills and dales, pruned, with their peaks and pits.
///
///     Spd, Svd   peaks, pits per area
///     Spc, Svc   mean curvature at peaks, pits, positive for both (stats/hybrid/summits.hpp, (1), (2))
///     S5p, S5v   mean height of the five highest peaks above the mean, depth of the five deepest pits
///     S10z       S5p + S5v
///     Sha, Shv   mean area, and volume above the height c, of closed hills: of their points above c
///     Sda, Sdv   the same of dales below c
/// Hills are pruned below a height or a share of Sz (stats/feature/hills.hpp), dales too. A hill is closed if
/// none of its points above c, the median of the heights, lies at an edge or beside a missing point.
///
/// Peaks and pits are points, or plateaus, with all their neighbours (stats/hybrid/summits.hpp): what is
/// highest at an edge or beside a missing point is no peak, and the area of such points does not count
/// either. Programs differ: some count what touches an edge, others leave out whole hills there.
///
/// Errors    Counts, and sums over features, are local functions of the field at peaks and pits, and have the
///           errors of stats/uncertainty/long_waves.hpp, where they are pruned below a height; of fewer than
///           ten features there are none. Sz grows with the field: features pruned at its share have no
///           error, for of a larger field they are others. S5p, S5v and S10z rest on five features each.
/// Cost      1.5 times that of two hills_of(…), side by side by two threads; errors, one pass.
///
/// ISO 25178-2:2021; ISO 16610-85:2013.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stats/feature/hills.hpp"
#include "stats/uncertainty/long_waves.hpp"

namespace asperity {

/// The least local height of hills and dales.
struct Pruning {
  double value = 0.05;
  bool of_sz = true;  ///< a share of Sz, or a height

  double height(double sz) const { return of_sz ? value * sz : value; }
};

struct Feature {
  Index i = 0, j = 0;      ///< of its peak or pit
  double height = 0;       ///< above the mean, or depth below it [m]
  double curvature = NAN;  ///< [1/m]
  bool closed = false;
  double area = 0, volume = 0;  ///< beyond c [m²], [m³]

  bool is_peak() const { return std::isfinite(curvature); }  ///< or a pit
};

struct FeatureFigures {
  double density = NAN, curvature = NAN, area = NAN, volume = NAN;
};

class Features {
 public:
  Features() = default;  ///< none
  /// Heights are equal where they round to the same multiple of
  /// `rounding`. Throws DataError("heights", …) for a field without a hill or a dale: of one height, or of
  /// fewer than 3 × 3 points.
  Features(const Field& z, const Grid& grid, const Pruning& pruning, double rounding = 0, int threads = 1);

  struct Kind {
    std::vector<Feature> all = {};
    std::size_t unpruned = 0;  ///< before
    Hills hills = {};          ///< of z, or of -z

    FeatureFigures figures(double area) const;
    /// Of the five highest peaks; of all of fewer.
    double five() const;
    std::size_t peaks() const;
    std::size_t closed() const;
  };
  const Kind& hills() const { return hills_; }
  const Kind& dales() const { return dales_; }
  /// Of the points with all neighbours.
  double area() const { return static_cast<double>(inside_.count()) * grid_.cell_area(); }

  /// Standard errors of figures.
  LocalMeans means(const FieldExtent& extent, int threads) const;
  using Figure = double FeatureFigures::*;
  /// Of hills or of dales, from these means.
  FeatureFigures figures(const Eigen::VectorXd& means, bool of_dales) const;

 private:
  Grid grid_;
  Field there_;  ///< 1, or NaN of missing points
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> inside_;
  Kind hills_ = {}, dales_ = {};
};

}  // namespace asperity
