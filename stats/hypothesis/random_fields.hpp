/// Random fields of a known correlation and distribution of heights, for what is simulated.
///
/// White noise on a torus is filtered to the correlation and cropped, and its heights are translated
/// (marginal/translation.hpp). The Gaussian field then has the correlation that gives the heights the
/// prescribed one (marginal/correlation_map.hpp), the nearest where there is none, as asperity-generate
/// draws them. The torus is longer than the field by the reach of the correlation, at most three times.
/// Lags that the field does not have are free: beyond a table that reaches so far they keep its last values.
/// Waves of negative power, which no field has, get none (acf/periodic.hpp).
///
/// Cost      a transform of the torus a field, 8 ns a point for its noise.
/// Memory    32 bytes a point of the torus for each field that is drawn at once, 8 more for all.
///
/// C. R. Dietrich, G. N. Newsam, SIAM J. Sci. Comput. 18 (1997) 1088-1107.
#pragma once

#include <cstdint>
#include <optional>

#include "acf/periodic.hpp"
#include "marginal/translation.hpp"
#include "stats/spatial/pairs.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// What the fields are to be like.
struct FieldModel {
  Grid grid;
  LagField correlation;                         ///< of the heights, normalised
  std::optional<Translation> translation = {};  ///< none for Gaussian heights
  double negligible = 1e-3;                     ///< the torus may end where the correlation is less
};

/// The longest lags at which it is more than negligible.
Shape reach_of(const FieldModel& model);

class RandomFields {
 public:
  RandomFields(const FieldModel& model, std::uint64_t seed);

  /// Field k, the same in any order and on any thread; of mean 0 and variance 1.
  Field heights(Index k) const;
  /// Of all of them, at lags up to half the torus: `correlation` where a field has it.
  LagField correlation(Shape max_lag) const;
  HeightMoments moments() const { return translation_ ? height_moments(*translation_) : HeightMoments{}; }

 private:
  Shape shape_;
  std::optional<Translation> translation_;
  std::uint64_t seed_;
  RealTransform2D transform_;  ///< on the torus
  SpectralRoot root_;
};

}  // namespace asperity
