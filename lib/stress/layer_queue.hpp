/// Layers on several threads, handed over in order.
#pragma once

#include <functional>

#include "core/field.hpp"

namespace asperity {

/// compute(layer, worker), where worker < threads tells the threads apart.
using ComputeLayer = std::function<void(Index layer, int worker)>;
/// finished(begin, end): the layers before `end` are complete.
using LayersFinished = std::function<void(Index begin, Index end)>;

/// Computes each layer < count. finished() is called from the calling thread; where there is one, no layer
/// `threads` or more beyond the last that it knows is begun, so that as many buffers will do.
void in_layers(Index count, int threads, const ComputeLayer& compute, const LayersFinished& finished);

}  // namespace asperity
