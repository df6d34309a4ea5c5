/// Standard errors of what depends on slopes, curvatures and summits, whatever heights and correlation are.
///
/// Products of derivatives, z², and counts and products at summits are local functions of the field: their
/// means have the errors of stats/uncertainty/long_waves.hpp, and a parameter is a function of these means.
///
/// Products of slopes are those of cells, each shared by its four corners, with the mean slopes of its sides
/// in x and in y for the mixed product.
///
/// Means over the points that have the neighbours they need are ratios of two means over the measured ones.
/// A function of n such points holds n - 1 orthonormal waves and its mean, which have its whole variance:
/// of n > 10 K of them the K longest are a tenth or less. Of fewer points there is no error; of one it would
/// be that of the step of a difference.
///
/// Accuracy  docs/accuracy/asperity-stats.md
/// Cost      one pass, 200 operations a point.
#pragma once

#include <functional>
#include <string>

#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/uncertainty/long_waves.hpp"

namespace asperity {

/// What parameters are functions of.
struct Derivatives {
  SlopeParameters slopes = {};
  SpectralMoments moments = {};
  CountedSummits summits = {};
};

/// Why means over the points that have some neighbours have no error, of `points` in all; "" where they have
/// one. The mean number `there` says which points have them.
std::string too_few_points(const LocalMeans& means, double points, Index there, const char* neighbours);

class DerivativeErrors {
 public:
  using Function = std::function<double(const Derivatives&)>;

  DerivativeErrors(const Field& z, const Grid& grid, const FieldExtent& extent, int threads = 1);

  WaveError operator()(const Function& parameter) const;
  /// Why what rests on slopes, or on curvatures and summits, has no error; "" where it has one.
  std::string too_few_slopes() const;
  std::string too_few_curvatures() const;
  /// The factor by which a form that took this share of the variance of the heights changed a parameter.
  double left(const Function& parameter, double taken) const;

 private:
  Grid grid_;
  LocalMeans means_ = {};
  double points_ = 0;
};

}  // namespace asperity
