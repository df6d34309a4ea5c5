/// What an iteration tells of each of its steps while it runs.
#pragma once

#include <functional>

namespace asperity {

struct IterationStep {
  long step = 0;        ///< 0: the start
  long products = 0;    ///< with the Jacobian, or transforms there and back where there is none
  double residual = 0;  ///< max |R - target| over the equations [σ²]
  double spent = 0;     ///< the share used up of the steps or products that it may take
};

using IterationObserver = std::function<void(const IterationStep&)>;

}  // namespace asperity
