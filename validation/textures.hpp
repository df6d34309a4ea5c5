/// Random fields of many textures, by a way that shares nothing with the library's: Gaussian noise of a given
/// spectrum on a torus at least four times the field and its correlation, cropped, and heights by translation.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"
#include "transform/plan.hpp"

namespace asperity::textures {

struct Texture {
  std::string name;
  std::function<double(double, double)> correlation;  ///< of unit variance; of the Gaussian field
  std::function<double(double)> heights = {};  ///< of a Gaussian height of unit variance; empty: itself
  std::function<Field(Shape, std::mt19937_64&)> make = {};  ///< instead of both, for made_textures.hpp
};

/// Of correlation length l samples along y, and some times more along x:
///
///     exponential, gaussian        lengths 2:1, turned by 30°
///     self-affine                  H = 0.3 and 0.8, flat below the roll-off, as a sum of waves
///     lay along, lay across        exp(-r) cos(2π x'/3), lengths 4:1
///     two scales                   half white noise, the rest exponential
///     lognormal, Weibull, plateau, bimodal    heights of an exponential field
///     crossed                      two lays at right angles
///     chi_squared, levels          squares of an exponential field; its heights in eight steps
std::vector<Texture> all(double length);

/// Of the heights, at lags up to `reach` along each axis and zero beyond: by the Hermite series of the
/// translation, 40 terms.
LagField correlation_of_heights(const Texture& texture, Shape max_lag, Index reach);

/// The sum of ρ² over all lags: N/N_eff of a long field.
double correlated_points(const Texture& texture, Index reach);

class Draw {
 public:
  /// The torus holds `shape` and twice `reach` samples at least, and four times the field.
  Draw(const Texture& texture, Shape shape, Index reach);
  /// The next field.
  Field operator()(std::mt19937_64& random) const;

 private:
  Shape shape_, torus_;
  std::function<double(double)> heights_;
  RealTransform2D transform_;
  AlignedVector<double> root_;  ///< of the power, over the half spectrum
};

}  // namespace asperity::textures
