/// Tests whether surfaces have the prescribed rms height, skewness, kurtosis, slopes, autocorrelation and
/// lengths.
///
/// The means of seven quantities over M surfaces are compared with those of surfaces that are drawn from the
/// prescription (stats/hypothesis/random_fields.hpp; if heights are not to be Gaussian, by Johnson's
/// translation with the prescribed correlation ρ), lose the same points, and are measured alike:
///     Sq²           if σ is prescribed
///     Ssk, Sku
///     Sdq²          if σ is prescribed; differences between neighbours (stats/hybrid/slopes.hpp)
///     summits       points above their eight neighbours (stats/hybrid/summits.hpp), per point
///     R(h)/Sq²      stats/spatial/acf.hpp
///     stretches     of lengths (stats/uncertainty/length_stretch.hpp), over Sq²
/// Biases and errors are those of the drawn surfaces: what subtracting a field's own mean and dividing by its
/// own Sq takes needs no theory, however short the field. 200 are drawn, of more than 250 000 points fewer,
/// 100 at least; and four for each surface that is tested: their own error is half of that of its mean, for
/// which Student's t allows.
///
/// Of a large surface a part is drawn, if half of its points are enough: 500 independent points, 128 × 128
/// points, and along a side 64 points and four times the reach of ρ (|ρ| > 0.001). The surface is worth as
/// many parts as the ratio of N_eff; for R(h), times that of the overlaps at h; for a stretch, as the ratio
/// of the variances (3) of stats/uncertainty/length_stretch.hpp. Its bias is smaller by as much. Limits of
/// endless surfaces are those of the correlation and the translation that are drawn; that of summits is not
/// known. Where more than 1 % of the points are missing, whole surfaces are drawn.
///
/// The p-values follow from stats/hypothesis/simulated_law.hpp: of Sq², Sdq², Sku and summits by a power of
/// them, of Ssk by Ssk/√Sku, which hardly is skewed and varies less, of lags and stretches by the largest. If
/// all lengths are wrong, each R(h) is by little; the stretches collect it. Sdq and summits rest on ρ at the
/// first two lags alone, to which R(h) is blind on a smooth surface: there 1 - ρ(1,0) is less than an error
/// of R. They are tested where the table has these lags, summits where there are enough. No limit of a small
/// spacing is needed:
///     E[Sdq²] = 2σ² [(1 - ρ(1,0))/Δx² + (1 - ρ(0,1))/Δy²].                                           (1)
/// By Bonferroni over the K quantities, the surfaces differ if the least p is below significance/K.
///
/// Of heights on steps Sdq is left out where steps exceed 1.5 rms differences of neighbours, summits where
/// one in a thousand is a plateau; both where no surface of the table can be drawn, as of few lags across a
/// strip, to 1 % of (1). Surfaces may miss different points. A lag counts if all surfaces have a
/// tenth of its pairs or more.
///
/// Symbols   ρ  correlation    σ  rms height [m]    R  autocorrelation [m²]    Δx, Δy  spacings [m]
///           N_eff = N/S_2     stats/uncertainty/effective_size.hpp
/// Scope     N_eff = 5 and more. Drawn surfaces are translations; averages of skewed noise scatter less in
///           Sq, Ssk and Sku: of 300 such surfaces of skewness -0.6 and 0.5 0.3 and 0 % differed at 1 %, 3
///           and 0.3 % at 5 %.
/// Lags      of the prescribed table up to a quarter of what is drawn, thinned to at most 9 × 17 over the
///           half-plane.
/// Accuracy  docs/accuracy/asperity-validate.md. For the faults that are seen see
///           validation/prescription_power.
/// Cost      A transform of the field and its inverse a surface, and 60 ns for each point of the drawn ones:
///           0.2 s of a core for 128 × 128 points or parts; with many missing points 6 s for 1024 × 1024.
/// Memory    one surface, its transform, and a table over the lags; while surfaces are drawn 70 to 110 bytes
///           a point of these for each thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "stats/hypothesis/simulated_law.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/length_stretch.hpp"
#include "stats/hypothesis/random_fields.hpp"

namespace asperity {

/// The prescribed properties.
struct Specification {
  LagField correlation;  ///< normalised or not
  double sq = 0;         ///< rms height [m]; not finite if none is prescribed
  double ssk = 0, sku = 3;
  int threads = 1;
  std::uint64_t seed = 1;                                    ///< of the surfaces that are drawn
  std::function<void(Index done, Index of)> simulated = {};  ///< called while they are
};

/// The result for one quantity.
struct TestResult {
  std::string quantity;
  double prescribed = 0;
  double mean = 0;            ///< of the ensemble, corrected for bias
  double standard_error = 0;  ///< of the mean
  double z = 0;               ///< (mean - prescribed)/standard_error
  double p = 0;               ///< of this quantity alone; of all lags of the ACF, of all stretches of lengths
  Index lag_x = 0, lag_y = 0;  ///< for the ACF: lag of the largest deviation [samples]
};

class SpecificationTest {
 public:
  /// Throws ParameterError("kurtosis", …) if it is too small for the skewness, and DataError("acf_target", …)
  /// if the correlation is too long for the field.
  SpecificationTest(const Specification& asked, const Grid& grid);

  /// Throws DataError("heights", …) if the grid differs from the first, or if heights stand on steps of more
  /// than 1.25 Sq.
  void add(const Field& z, const Grid& grid);
  int surfaces() const { return static_cast<int>(observed_.size()); }
  int lags() const { return static_cast<int>(lags_.size()); }
  /// Simulated surfaces that the last results rest on.
  int drawn() const { return static_cast<int>(simulation_->values.rows()); }
  /// Of those that results will rest on.
  Shape drawn_shape() const { return draws_whole() ? grid_.shape : part_.shape; }
  /// Sq (where prescribed), Ssk, Sku, ACF, and the length, or ratio of lengths, that deviates most, where
  /// one surface tells a length from its double. Surfaces are drawn once for a test and its copies.
  std::vector<TestResult> results() const;

 private:
  /// The missing points of some surfaces.
  struct Missing {
    std::vector<bool> points;  ///< empty: none
    int surfaces = 1;
    bool operator==(const Missing&) const = default;
    Field field(Shape shape) const;  ///< NaN where a point is missing, else 0
  };
  /// Surfaces as prescribed that miss these points.
  struct Simulation {
    std::vector<Missing> missing = {};
    Eigen::ArrayXXd values = {};             ///< as of `observed_`, one row a surface
    Eigen::ArrayXd worth = {}, limits = {};  ///< of each quantity
  };
  void choose_lags();
  void check_reach(const Pairs& pairs) const;
  /// Places of what is measured; before the lags and the stretches.
  enum Measured : Index { at_variance, at_ssk, at_sku, at_sdq, at_summits, at_shapes };
  /// Sq², Ssk, Sku, Sdq², the share of summits, R(h)/Sq² and the stretches; NaN if there are too few pairs or
  /// points. Of heights that stand on steps, those before they were rounded
  /// (stats/hypothesis/gaussianity.hpp).
  Eigen::ArrayXd measured(const Field& z, const Pairs& pairs, const std::vector<LagField>& stretches,
                          int threads, double step = 0) const;
  Eigen::ArrayXd shapes(const LagField& acf, const Pairs& pairs,
                        const std::vector<LagField>& stretches) const;
  /// Of what is measured of endless surfaces; not of summits.
  Eigen::ArrayXd limits(const RandomFields& fields) const;
  /// Of a surface in surfaces of `part_`.
  Eigen::ArrayXd worth() const;
  void count_missing(const Field& z);
  bool draws_whole() const;
  const Simulation& simulated() const;
  Compared compared(Index quantity) const;
  Compared compared_square(Index quantity) const;  ///< per prescribed Sq²
  std::vector<TestResult> slopes() const;

  Specification asked_;
  Grid grid_, part_;  ///< of the surfaces that are tested, and of those drawn if few points are missing
  std::shared_ptr<Simulation> simulation_ = {};
  std::vector<Missing> missing_ = {};          ///< of the surfaces added
  std::vector<Eigen::ArrayXd> observed_ = {};  ///< the same
  std::optional<LengthStretch> stretch_;
  std::vector<TestResult> lags_, lengths_;  ///< name, prescribed value and lag
  double square_ = 0;                       ///< (1) per σ²; NaN where the table does not tell it
  bool summits_ = false;                    ///< the table tells them
};

/// The p-value of all results together, Bonferroni's.
double joint_p(const std::vector<TestResult>& results);

}  // namespace asperity
