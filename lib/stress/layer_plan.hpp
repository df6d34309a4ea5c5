/// How the layers of one resolution are computed: a plan that is made once, and the work of one thread on it.
#pragma once

#include <memory>

#include "stress/layer_influence.hpp"
#include "stress/load.hpp"
#include "stress/resolution.hpp"

namespace asperity {

struct Plane {
  bool along_x = true;  ///< y = y_index; else x = x_index
  Index index = 0;
};

/// One layer after the other, in buffers of its own.
class LayerWork {
 public:
  virtual ~LayerWork() = default;
  /// Goes to depth z [m] for the components asked.
  virtual void set_depth(double z, stress::Set asked) = 0;
  /// Row i of the layer, good until the next; to be called for i = 0, 1, 2 …
  virtual StressRow row(Index i) = 0;
};

/// The load as cells s times as wide see it (stress/resolution.hpp).
struct LayerPlan {
  LayerPlan(const LoadedBody& body, Index s, int threads)
      : shape(body.grid.shape),
        resolution(body.grid, body.pressure, s, threads),
        poisson(body.poisson),
        weights(body.friction.weights()) {}
  virtual ~LayerPlan() = default;
  virtual std::unique_ptr<LayerWork> work() const = 0;

  std::unique_ptr<LayerInfluence> influence() const {
    return make_layer_influence(resolution, poisson, acting(weights));
  }

  const Shape shape;  ///< of a layer
  const Resolution resolution;
  const double poisson;
  const LoadWeights weights;
};

/// Whole layers (stress/layers.hpp), and the one row of each in a plane (stress/section.cpp).
std::unique_ptr<const LayerPlan> plan_volume(const LoadedBody& body, Index s, int threads);
std::unique_ptr<const LayerPlan> plan_section(const LoadedBody& body, const Plane& plane, Index s,
                                              int threads);

}  // namespace asperity
