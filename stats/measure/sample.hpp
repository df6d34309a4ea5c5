/// A surface to be measured, whole in memory or in strips, with the sums that the parameters need.
///
/// A whole surface is a single strip. Strips give approximations of two things: the correlation, from the
/// pairs of points within a strip (stats/spatial/strip_acf.hpp), and the order of the heights
/// (stats/height/order.hpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "stats/height/material_ratio.hpp"
#include "stats/height/order.hpp"
#include "stats/hybrid/derivative_error.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/hypothesis/gaussianity.hpp"
#include "stats/measure/strips.hpp"
#include "stats/measure/surface.hpp"
#include "stats/profile/profile.hpp"

namespace asperity {

struct DerivativeSums {
  SlopeSums slopes = {};
  SpectralMomentSums spectral = {};
  SummitSums summits = {};

  void add(const Strip& strip, double level, int threads);
};

/// The sums of one pass over a surface; derivatives only if requested.
struct SurfaceSums {
  Moments moments;
  DerivativeSums derivatives;
  ErrorBasis basis;
  bool reaches_beyond = false;  ///< the correlation that errors rest on is longer than a strip
};

class Sample {
 public:
  /// Of a prepared surface; `derivatives` are slopes, spectral moments and summits.
  explicit Sample(Surface surface, bool derivatives = true, int threads = 1);
  /// Of a prepared surface whose errors rest on a known basis, of this size.
  Sample(Surface surface, ErrorBasis basis, const EffectiveSampleSize& size, bool derivatives = true);
  /// In strips; `surface` holds everything but the heights and their level.
  Sample(const StripReader& reader, Surface surface, bool derivatives = true, int threads = 1);

  const Surface& surface() const { return surface_; }
  const Grid& grid() const { return surface_.grid; }
  bool whole() const { return !reader_; }  ///< not in strips
  int threads() const { return threads_; }
  const Moments& moments() const { return sums_.moments; }
  const ErrorBasis& basis() const { return sums_.basis; }
  const EffectiveSampleSize& size() const { return size_; }
  /// Whether errors rest on a correlation that is longer than the strips.
  bool correlation_reaches_beyond() const { return sums_.reaches_beyond; }

  SlopeParameters slopes() const { return sums_.derivatives.slopes.parameters(grid()); }
  SpectralMoments spectral_moments() const { return sums_.derivatives.spectral.moments(grid()); }
  CountedSummits summits() const { return sums_.derivatives.summits.summits(grid()); }
  /// For strips, as many differences of each kind as heights are assumed.
  DerivativeErrors derivative_errors() const;
  /// Heights below which these shares of the surface lie.
  std::vector<double> quantiles(const std::vector<double>& shares) const;
  MaterialRatioCurve material_ratio() const;
  std::array<GoodnessOfFit, 4> goodness_of_fit() const;
  ProfileAverages profiles(Axis1D along, double section) const;

 private:
  const std::vector<HeightBin>& bins() const;
  std::vector<double> selected(const std::vector<double>& shares) const;

  Surface surface_;
  std::optional<StripReader> reader_ = {};  ///< none: the surface is whole
  SurfaceSums sums_;
  EffectiveSampleSize size_;
  int threads_;
  mutable std::optional<std::vector<HeightBin>> bins_ = {};
};

}  // namespace asperity
