/// The areal material ratio curve (Abbott and Firestone's bearing curve) and its parameters.
///
/// c(p), the inverse material ratio, is the height above which the share p of the surface lies: the k-th
/// highest of N heights, missing ones left out, at p = k/(N-1), k = 0 … N-1, with straight lines between,
///     c(0) = Sp,   c(1) = -Sv,   Smc(p) = c(p),   Smr = c⁻¹.                                          (1)
/// The core is the interval [p₀, p₀ + 0.4] over which c falls least; its least-squares line, extended to
/// p = 0 and p = 1, has the heights u and v there,
///     Sk = u - v,   Smr1 = Smr(u + 0),   Smr2 = Smr(v - 0),                                            (2)
/// the shares of heights above u and of heights not below v: what lies at u or v belongs to the core.
/// Where several intervals fall equally, as of a sine or of heights in steps, the core is the first of them,
/// that of the highest heights, as the standard has it: z and -z then have different Sk.
/// Triangles of the same area on the same base replace the hills above u and the dales below v,
///     Spk = 2/Smr1 ∫₀^{Smr1} (c - u) dp,   Svk = 2/(1-Smr2) ∫_{Smr2}¹ (v - c) dp,                       (3)
/// zero if the base is. The areas of these triangles, and what reaches beyond the core, 0 where nothing does,
///     Sak1 = Smr1 Spk/2,   Sak2 = (1-Smr2) Svk/2,   Spkx = Sp - u,   Svkx = Sv + v.                    (3a)
/// Differences of heights, of which the second has fixed shares,
///     Sdc = Smc(p) - Smc(q),   Sxp = Smc(2.5 %) - Smc(50 %).                                           (3b)
/// Volumes per area, of material above a height and of void below it,
///     Vm(p) = ∫₀ᵖ [c(t) - c(p)] dt,   Vv(p) = ∫ₚ¹ [c(p) - c(t)] dt,                                     (4)
///     Vmp = Vm(p),  Vmc = Vm(q) - Vm(p),  Vvc = Vv(p) - Vv(q),  Vvv = Vv(q),  p = 10 %, q = 80 %.
///
/// By Bahadur, c(p) of a Gaussian field varies as the share of heights below it does. That is the mean of an
/// indicator with the Hermite coefficients He_{k-1}(a) φ(a), the first of which drops out because heights are
/// measured from the field's own mean; with the sums S_k of the correlation
/// (stats/uncertainty/effective_size.hpp)
///     Var[c(p)] = σ²/N Σ_{k≥2} He_{k-1}(a)²/k! S_k,   a = Φ⁻¹(1-p),                                     (5)
/// which is σ² [p(1-p)/φ(a)² - 1]/N for independent heights.
///
/// Q–Q plot: for the shares s_i = (i - ½)/n, i = 1 … n (Hazen), the height c_i below which the share lies is
/// plotted against x_i = Φ⁻¹(s_i). The deviation of Gaussian heights from the line z̄ + Sq x of their own
/// mean and Sq has the variance (5) without the term k = 2. Errors of neighbouring quantiles are correlated.
///
/// Symbols   z  heights [m]      p, q, Smr  shares of the area      c, Sk, Spk, Svk  [m]
///           Vm, Vv, Sak1, Sak2  volumes per area [m³/m²]      φ, Φ  the Gaussian's density and distribution
/// Accuracy  Exact for the piecewise straight curve (1) to round-off; for the smooth curve of a population
///           the bias is O(1/N). (5) to first order in 1/N. Falls and levels count as equal within
///           256 ε max |z|; lengths below that are 0.
/// Cost      a sort, N log N, in threads; then four passes for (2), one for (3) and (4).
///
/// ISO 25178-2:2021, its text unseen for (3a), (3b): they are as other programs have them, one of which
/// gives Sak1 and Sak2 in µm %, a hundred times the number. ISO 13565-2:1996 for (2), (3).
/// E. J. Abbott, F. A. Firestone, Mechanical Engineering 55 (1933) 569-572. R. R. Bahadur, A note on
/// quantiles in large samples, Ann. Math. Statist. 37 (1966) 577-580. M. B. Wilk, R. Gnanadesikan,
/// Probability plotting methods for the analysis of data, Biometrika 55 (1968) 1-17; A. Hazen, Trans. Am.
/// Soc. Civ. Eng. 77 (1914) 1539-1640.
#pragma once

#include <array>
#include <vector>

#include "core/field.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/effective_size.hpp"

namespace asperity {

/// (2), (3), (3a).
struct CoreParameters {
  double sk = 0, spk = 0, svk = 0;  ///< unit of the field
  double spkx = 0, svkx = 0, sak1 = 0, sak2 = 0;
  double smr1 = 0, smr2 = 0;    ///< shares, 0 … 1
  double upper = 0, lower = 0;  ///< u, v; unit of the field
  double begin = 0;             ///< p₀
};

/// (4), in the unit of the field: m³/m².
struct VolumeParameters {
  double vmp = 0, vmc = 0, vvc = 0, vvv = 0;
};

inline constexpr std::array<double, 2> sxp_ratios{0.025, 0.5};

class MaterialRatioCurve {
 public:
  /// Throws DataError("heights", …) for fewer than two heights.
  explicit MaterialRatioCurve(const Field& z, int threads = 1);

  /// c(p), 0 ≤ p ≤ 1; throws ParameterError("material-ratio", …) outside.
  double height(double ratio) const;
  /// The share of the surface above a height, 0 above the highest point.
  double ratio(double height) const;
  /// (3b). Throws ParameterError("material-ratio", …) unless 0 ≤ p ≤ q ≤ 1, as volumes do.
  double fall(const std::array<double, 2>& ratios) const;
  /// The height below which a share of the surface lies; the median is quantile(0.5).
  double quantile(double share) const { return height(1 - share); }

  CoreParameters core() const;
  VolumeParameters volumes(double p = 0.1, double q = 0.8) const;

 private:
  /// u, v.
  struct Line {
    double upper, lower;
  };

  static double rank_of(std::size_t k) { return static_cast<double>(k); }
  double last() const { return rank_of(descending_.size() - 1); }
  std::size_t piece_at(double rank) const;          ///< the k of the corners k, k + 1 around it
  double within(std::size_t k, double rank) const;  ///< c(rank/(N-1)) on that piece
  double at(double rank) const { return within(piece_at(rank), rank); }
  double round_off() const;  ///< of heights; more than that of the line
  double core_span() const;  ///< 0.4 (N-1)
  template <class Visit>
  void falls(Visit visit) const;
  double flattest() const;
  Line line_from(double start) const;
  template <class Visit>
  void segments(double begin, double stop, Visit visit) const;  ///< ranks
  double area(double from, double to, double level) const;

  std::vector<double> descending_;
};

/// The estimates that heights are measured with.
enum class Fitted { mean, mean_and_sq };

/// √(5), infinite at p = 0 and 1; if both are fitted, that of c(p) - z̄ - Sq Φ⁻¹(1-p), without the term k =
/// 2.
double material_height_error(double ratio, const Moments& moments, const EffectiveSampleSize& size,
                             Fitted fitted = Fitted::mean);

/// Heights in the unit of the field.
struct QuantilePoint {
  double share = 0;         ///< s
  double normal = 0;        ///< x
  double height = 0;        ///< c
  double height_error = 0;  ///< √(5)
  double gaussian = 0;      ///< the line
  double misfit_error = 0;  ///< of height - gaussian
};

/// At `rows` shares; throws ParameterError("rows", …) below 1.
std::vector<QuantilePoint> quantile_plot(const MaterialRatioCurve& curve, const Moments& moments,
                                         const EffectiveSampleSize& size, int rows);

}  // namespace asperity
