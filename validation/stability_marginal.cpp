#include "stability.hpp"

namespace asperity {

void marginal_stability() {}

}  // namespace asperity
