/// A function of one number, applied to many in place.
#pragma once

#include <functional>
#include <span>

namespace asperity {

/// What a value becomes does not depend on its neighbours. For several threads at once.
using Pointwise = std::function<void(std::span<double>)>;

}  // namespace asperity
