/// A surface to be measured, with what several parameters need. Derivatives and errors are computed when
/// they are asked for.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "stats/height/height_error.hpp"
#include "stats/height/material_error.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/hybrid/derivative_error.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/hypothesis/gaussianity.hpp"
#include "stats/measure/surface.hpp"
#include "stats/profile/profile.hpp"
#include "stats/uncertainty/size_error.hpp"

namespace asperity {

class Sample {
 public:
  /// Of a prepared surface.
  explicit Sample(Surface surface, int threads = 1);
  /// Of a prepared surface of this basis and size, whose parameters need no errors.
  Sample(Surface surface, ErrorBasis basis, const EffectiveSampleSize& size);

  const Surface& surface() const { return surface_; }
  const Grid& grid() const { return surface_.grid; }
  int threads() const { return threads_; }
  const Moments& moments() const { return moments_; }
  const ErrorBasis& basis() const { return basis_; }
  const EffectiveSampleSize& size() const { return size_; }

  /// Derivatives, here and below, are of a surface: fields of a row or a column have none.
  SlopeParameters slopes() const { return slope_parameters(surface_.heights, grid(), threads_); }
  /// Zero where derivatives are the round-off of the heights, as those along grooves.
  const SpectralMoments& spectral_moments() const;
  /// None of a surface without slopes in x or in y: along that axis all is round-off.
  const CountedSummits& summits() const;
  /// The distribution that the field was drawn with or evidently has; none if that is a Gaussian's.
  std::optional<Translation> distribution() const;
  /// Whether local amplitudes may vary: not of heights that were drawn from a Gaussian field.
  bool amplitudes_may_vary() const { return basis().estimated || distribution(); }
  /// Whether the errors of moments follow from the correlation: where it is known, and Σ ρ > 0.
  bool correlation_gives_errors() const { return !basis().estimated && size_.sum(1) > 0; }

  /// By the correlation that errors rest on.
  const FieldExtent& extent() const;

  /// Errors from the field's own long waves; none if parameters need no errors.
  bool needs_errors() const { return errors_; }
  void need_errors(bool needed) { errors_ = needed; }
  const std::optional<HeightErrors>& height_errors() const;
  /// The share of the variance of the heights that their form took.
  double taken_by_form() const;
  double error_of_taken() const;
  std::optional<DerivativeErrors> derivative_errors() const;
  /// None either of too small a size, or by a known correlation: that is exact.
  std::optional<SizeErrors> size_errors() const;
  std::optional<QuantileErrors> quantile_errors(const std::vector<double>& heights) const;
  std::optional<MaterialErrors> material_errors(const MaterialRatioCurve& curve,
                                                const std::array<double, 2>& ratios) const;
  /// Heights below which these shares of the surface lie.
  std::vector<double> quantiles(const std::vector<double>& shares) const;
  MaterialRatioCurve material_ratio() const;
  std::array<GoodnessOfFit, 4> goodness_of_fit() const;
  ProfileAverages profiles(Axis1D along, double section, const std::array<double, 2>& ratios) const;
  /// What subtraction may leave of neighbours that are equal.
  double round_off() const;

 private:
  bool taken_from_waves() const { return errors_ && !correlation_gives_errors(); }

  Surface surface_;
  Moments moments_;
  ErrorBasis basis_;
  EffectiveSampleSize size_;
  int threads_;
  bool errors_ = true;
  mutable std::optional<SpectralMoments> spectral_ = {};
  mutable std::optional<CountedSummits> summits_ = {};
  mutable std::optional<FieldExtent> extent_ = {};
  mutable std::optional<HeightErrors> height_errors_ = {};
};

}  // namespace asperity
