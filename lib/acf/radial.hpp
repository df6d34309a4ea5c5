/// What tabulated radial correlations share: interpolation from derivatives, the radius of a level.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace asperity {

/// A function on equal steps h as the quintic that takes its value and its first two derivatives at both ends
/// of each step. The error is h⁶ max|f⁽⁶⁾|/46080. Outside the nodes the first and the last quintic go on.
class QuinticTable {
 public:
  using Node = std::array<double, 3>;  ///< f, f', f''

  QuinticTable() = default;
  QuinticTable(double first, double step, const std::vector<Node>& nodes);

  double operator()(double x) const {
    const double u = (x - first_) / step_;
    const double last = static_cast<double>(pieces_.size() - 1);
    const double piece = u < 0 ? 0 : u < last ? static_cast<double>(static_cast<std::size_t>(u)) : last;
    const double t = u - piece;
    const Coefficients& c = pieces_[static_cast<std::size_t>(piece)];
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
  }

 private:
  using Coefficients = std::array<double, 6>;
  double first_ = 0, step_ = 1;
  std::vector<Coefficients> pieces_;
};

/// The least r at which ρ, falling from ρ(0) = 1, is t; 0 when that is below 1e-300. Needs ρ to fall without
/// a turn until it has passed t, and to stay below t for a tenth of that radius.
double falls_to(const std::function<double(double)>& correlation, double t);

}  // namespace asperity
