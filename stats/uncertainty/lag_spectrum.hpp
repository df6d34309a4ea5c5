/// Spectra of even functions of the lag, such as correlations, on a torus.
///
/// Real, because f(-p,-q) = f(p,q). A product of spectra is the convolution of their functions, without
/// overlap if the torus is longer than the sum of their lags and of those that are asked for.
///
/// Accuracy  round-off, ε log2(P) for P points of the torus.
/// Cost      a transform of the torus each.
#pragma once

#include <Eigen/Core>

#include "core/extent.hpp"
#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"
#include "transform/plan.hpp"

namespace asperity {

class LagSpectrum {
 public:
  explicit LagSpectrum(Shape torus) : transform_(torus) {}
  /// On a torus that holds this sum of lags in both signs, and lag zero.
  static LagSpectrum holding(Shape lags) {
    return LagSpectrum({fast_length(2 * lags.nx + 1), fast_length(2 * lags.ny + 1)});
  }

  Shape torus() const { return transform_.shape(); }
  /// Over the half spectrum.
  Eigen::ArrayXd of(const LagField& f) const;
  /// The function with this spectrum, at any lag modulo the torus.
  Field function(const Eigen::ArrayXd& spectrum) const;
  /// The mean over the whole torus of values over the half spectrum.
  double mean(const Eigen::ArrayXd& values) const;

 private:
  RealTransform2D transform_;
};

/// f at all lags of a torus. At half a period, where p and -p are one, a table may hold either or both.
Field unfolded(const LagField& f, Shape torus);

}  // namespace asperity
