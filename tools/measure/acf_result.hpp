/// What asperity-acf writes and prints, of one surface or as a mean over several.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "dataset/dataset.hpp"
#include "marginal/measured.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/measure/ensemble_parameters.hpp"
#include "stats/measure/pooled_maps.hpp"
#include "stats/sample/moments.hpp"
#include "tools/cli/ensemble_table.hpp"

namespace asperity::cli {

/// The ACF of a surface, and what --add names.
struct AcfResult {
  AcfEstimate estimate;
  Moments moments = {};                    ///< for a dataset only
  std::optional<LagField> target = {};     ///< normalised
  std::optional<LagField> structure = {};  ///< in units squared
  std::optional<MeasuredHeights> quantiles = {};
  std::optional<LagField> errors = {};  ///< of the ACF
  const char* marginal = "";            ///< "gaussian", or "measured" of heights that evidently are not
  double step = 0, rounding = 0;        ///< of the heights; its share of the mean square second difference
  double slopes = 1;                    ///< by which factor the taper raises those of twins
  /// Errors, of what prints them.
  std::optional<std::array<ProfileErrors, 2>> profiles = {};
  std::optional<LengthErrors> lengths = {};
  std::optional<MapSums> sums = {};  ///< of one of several
  double area = 0;                   ///< of its measured points
  bool enough() const { return estimate.size.gives_errors(); }
};

/// Which of them, and how.
struct AcfContent {
  std::string variable, units;  ///< the field, and its unit
  bool absolute = false;        ///< R instead of R / R(0,0)
  const char* taper = "";       ///< the window of a tapered field
  std::string squared() const;
  std::string unit() const { return absolute ? squared() : "1"; }
};

/// What twins of a surface are drawn with (stats/spatial/tapered_acf.hpp): the ACF of the tapered field, and
/// the heights.
AcfResult tapered_acf(const Surface& surface, Shape max_lag, int threads);
/// Warns where the taper raises the rms slope of twins by 5 % and more.
void warn_of_taper(const Tool& tool, const Surface& surface, const AcfResult& result);
/// "tukey", or "none" of a periodic surface.
const char* taper_of(const Grid& grid);

MeasuredHeights quantiles_of(const Field& heights);

/// Those at the lags (p,0), then at (0,q).
Eigen::ArrayXd profiles_of(const Field& half_plane);
/// R(p,0) and R(0,q), a row for each lag.
Table acf_profiles(const AcfResult& result, const AcfContent& content);

/// The variables and attributes of asperity-acf in place of former ones.
void add_acf(Dataset& data, const AcfResult& result, const Parameters& lengths, const AcfContent& content);

/// The pooled ACF of several surfaces, (2) of stats/measure/pooled_maps.hpp, at all their lags. With
/// X_i = R_i + B_i b_i and ρ = Σ X_i/Σ X_i(0), its errors are to first order
///     SE² = Σ a_i (X_i - ρ X_i(0))²/((n-1) X̄(0)²),
/// those of the mean of X_i where R is asked for, with shares a_i of the area.
class PooledAcf {
 public:
  void add(const AcfResult& result, double weight);
  /// R, or R / R(0,0).
  Field values(bool absolute) const;
  Field errors(bool absolute) const;

 private:
  double n_ = 0, weights_ = 0;
  Field mean_ = {}, squares_ = {}, products_ = {};  ///< X̄, Σ (X - X̄)², Σ (X - X̄)(X(0) - X̄(0))
  double variance() const { return mean_(0, mean_.cols() / 2); }
};

/// The same over an ensemble: pooled, and acf_error, here that of the pooled ACF.
class AcfEnsemble {
 public:
  /// `of_acf`: the lengths of a correlation.
  AcfEnsemble(AcfContent content, PooledOptions of_acf)
      : content_(std::move(content)), of_acf_(std::move(of_acf)) {}
  /// `function`: the ACF itself too, for a dataset.
  void add(const AcfResult& result, const Parameters& lengths, bool function);

  const Grid& grid() const { return pool_.grid(); }
  const AreaWeights& weights() const { return weights_; }
  int surfaces() const { return lengths_.surfaces(); }
  std::vector<EnsembleParameter> lengths() const;
  /// A dataset without heights, on the grid of the first surface.
  Dataset dataset() const;

 private:
  AcfContent content_;
  PooledOptions of_acf_;
  AreaWeights weights_ = {};
  EnsembleParameters lengths_ = {};
  PooledMaps pool_ = {};
  PooledAcf acf_ = {};
  EnsembleField structure_ = {};
  bool structured_ = false;
};

}  // namespace asperity::cli
