#include "acf/equations.hpp"

#include <cmath>

namespace asperity {

NonlinearSystem Equations::system() {
  NonlinearSystem s;
  s.residual = [this](std::span<const double> u, std::span<double> f) { return residual(u, f); };
  s.linearize = [this](std::span<const double> u) { linearize(u); };
  s.jacobian = [this](std::span<const double> v, std::span<double> out) { jacobian(v, out); };
  s.precondition = [this](std::span<double> v) { precondition(v); };
  for (double w : multiplicity_) s.scale.push_back(std::sqrt(w));
  return s;
}

}  // namespace asperity
