/// One of the two axes of a field.
#pragma once

namespace asperity {

enum class Axis1D { x, y };

}  // namespace asperity
