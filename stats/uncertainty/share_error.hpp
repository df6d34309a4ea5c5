/// Standard errors of shares of a field, such as that of the heights in a bin or below a quantile, and of
/// the means of functions of the height that are constant on classes of heights.
///
/// The field's points are sorted into classes. The share f_b of class b is the mean of a local function, 1
/// in the class and 0 elsewhere, and so is Σ g_b f_b: their errors are those of
/// stats/uncertainty/long_waves.hpp, from the waves Σ_i u_k(i) of the points i of each class, whatever the
/// correlation and the distribution. Heights are measured from the field's own mean z̄. Values at fixed
/// distances from it move with it, and
///     Σ g_b f_b has the error of the mean of g + s z,     s = -E[g'] = d(Σ g_b f_b)/dz̄,             (1)
/// s = φ(q) for the share below q, φ(b) - φ(a) for that of the bin from a to b, with the density φ.
///
/// A share is not below 0, and the error of a rare one is poorly known. Its interval is the score interval:
/// of the two ends p, each is t errors of its own away from f,
///     (p - f)² = t² p (1 - p)/n',     n' = f (1 - f)/e²,                                             (2)
/// with the error e of (1), n' independent points, and Student's t of its degrees of freedom. As n' hardly
/// differs between neighbouring rows, but its estimate does, 1/n' and the degrees are means over the rows
/// within a quarter of the standard deviation of the distribution, and errors follow from them. Of a density,
/// there is no 1 that bounds it: p for p (1 - p). Where fewer than ten points are in the class, n' and t are
/// those of the nearest class towards the most frequent one that has more, and e follows from n'. Where fewer
/// than two independent heights tell of a class, n' f < 2, it has its interval, but no error.
///
/// Symbols   f  share      e  its error      u_k  long waves      z  height [unit of the field]
/// Scope     of a part of a field, such as its cells in contact, the other points are NaN: the share is
///           then a ratio of two sums, both random.
/// Accuracy  of densities and shares of heights docs/accuracy/asperity-stats.md. Of 200
///           periodic contacts of 128 × 128 cells under one load, with correlation lengths of 1/32 and 1/16
///           of the side and some 15 % of the cells in contact, intervals of the quartiles of the pressure
///           cover 93 to 99 %, stated over true error 0.94 to 1.05, those of the gap 92 to 98 %, 0.94 to
///           1.25. Under one approach (80 contacts) the errors are
///           0.62 to 0.69 and 0.30 to 0.33 of the true ones: the bodies follow long waves, and so hide them,
///           but not the mean height, which moves both.
/// Cost      one pass of K + 3 operations a point, K ≤ 24; K numbers a class.
///
/// R. S. Woodruff, Confidence intervals for medians and other position measures, J. Am. Stat. Assoc. 47
/// (1952) 635-646, for shares of a sample of clusters; E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209-212,
/// for (2).
#pragma once

#include <functional>
#include <vector>

#include "stats/uncertainty/interval.hpp"
#include "stats/uncertainty/long_waves.hpp"

namespace asperity {

class ShareErrors {
 public:
  ShareErrors(const Grid& grid, const FieldExtent& extent, Index classes);
  /// Of a field whose values that are not NaN belong to the classes 0, 1, …
  void add(const Field& z, const std::function<Index(double value)>& class_of);
  /// From now on class b holds those below it too.
  void accumulate();

  double points() const { return at_all_(0); }
  double share(Index b) const { return waves_(0, b) / points(); }
  double mean_of(Index b) const { return values_(b) / waves_(0, b); }  ///< of the values in class b

  /// A function of the height: so much in some classes, 0 in others.
  class Function {
   public:
    explicit Function(const ShareErrors& of);
    void add(Index b, double value);
    double mean() const { return sums_(0) / of_.points(); }
    WaveError error(double slope = 0) const;  ///< (1)

   private:
    const ShareErrors& of_;
    Eigen::VectorXd sums_;  // over the points, Σ u_k g; the first is Σ g
  };

 private:
  LongWaves long_waves_;
  AxisWaves along_;
  AxisWaves::Squares of_points_ = AxisWaves::none();
  Eigen::MatrixXd directions_ = {};
  WaveSpectra spectra_ = {};
  Eigen::MatrixXd x_, y_;               // a column a point of that axis, a row a wave; the first is 1
  Eigen::MatrixXd waves_;               // Σ u_k over a class, a column each
  Eigen::VectorXd at_all_, of_values_;  // over all points: Σ u_k, Σ u_k z
  Eigen::VectorXd values_;              // Σ z over a class
};

/// A share or a density.
struct Frequency {
  double value = 0;
  double error = 0;   ///< (1); NaN where too few heights tell of it
  double points = 0;  ///< that it rests on
  Interval interval = {};
  /// What the error of the mean adds at the ends besides (1) (stats/height/distribution.hpp).
  double fall = 0, rise = 0;
  double degrees = 1;  ///< of freedom that the error is known to
};

/// Sets the intervals (2), and the errors; `most` is 1 for shares, ∞ for densities.
void set_intervals(std::vector<Frequency>& frequencies, double most);

}  // namespace asperity
