/// How the layers of one resolution are computed: a plan that is made once, and the work on one layer.
#pragma once

#include <functional>
#include <memory>

#include "stress/layer_influence.hpp"
#include "stress/load.hpp"
#include "stress/resolution.hpp"

namespace asperity {

struct Plane {
  bool along_x = true;  ///< y = y_index; else x = x_index
  Index index = 0;      ///< from 0 to n - 1
};

using StressRowSink = std::function<void(Index i, const StressRow& values)>;
/// What several ranks do together after some of their rows, those from `begin` on.
using BehindRows = std::function<void(Index begin)>;

/// One layer after the other, in buffers of its own.
class LayerWork {
 public:
  virtual ~LayerWork() = default;
  /// Hands over the rows of the layer at depth z [m] with the requested components: in order on one thread,
  /// on several in any order and at the same time. Each of several ranks gets its own rows, and all call
  /// `behind`, if there is one, after each `rows_at_a_time` of them.
  virtual void layer(double z, stress::Set asked, const StressRowSink& row, const BehindRows& behind) = 0;

  static constexpr Index rows_at_a_time = 64;
};

/// The load as cells s times as wide see it (stress/resolution.hpp).
struct LayerPlan {
  LayerPlan(const LoadedBody& body, Index s, int threads)
      : shape(body.grid.shape),
        rows(body.rows()),
        resolution(body, s, threads),
        poisson(body.poisson),
        weights(body.friction.weights()) {}
  virtual ~LayerPlan() = default;
  /// On so many threads; for no longer than the plan lives.
  virtual std::unique_ptr<LayerWork> work(int threads) const = 0;

  std::unique_ptr<LayerInfluence> influence(int threads) const {
    return make_layer_influence(resolution, poisson, acting(weights), threads);
  }

  const Shape shape;  ///< of a layer
  const Slabs rows;   ///< likewise
  const Resolution resolution;
  const double poisson;
  const LoadWeights weights;
};

/// Whole layers (stress/layers.hpp), and the one row of each in a plane (stress/section.cpp).
std::unique_ptr<const LayerPlan> plan_volume(const LoadedBody& body, Index s, int threads);
std::unique_ptr<const LayerPlan> plan_section(const LoadedBody& body, const Plane& plane, Index s,
                                              int threads);

}  // namespace asperity
