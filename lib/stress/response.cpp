#include "stress/response.hpp"

namespace asperity {
namespace {

using stress::Component;

using Symbols = std::array<LayerInfluence::Symbol, 3>;

// -i a z.
Complex turn(double a, const Complex& z) { return {a * z.imag(), -a * z.real()}; }

// S and T of a column ky. In -kx what is odd in x changes sign.
class Column {
 public:
  Column(const Symbols& symbols, const std::array<double, 3>& weights, Component c, Index q)
      : weights_{1, odd_in_x(c) ? weights[1] : -weights[1], odd_in_y(c) ? weights[2] : -weights[2]} {
    for (stress::Traction t : stress::tractions)
      if (symbols[t].pairs != nullptr)
        first_[t] = reinterpret_cast<const double*>(symbols[t].pairs + q / 2 * symbols[t].stride) + q % 2;
  }

  bool friction() const { return first_[stress::shear_x] != nullptr || first_[stress::shear_y] != nullptr; }
  double pressed(Index k) const { return first_[stress::normal][2 * k]; }
  /// side: 1 in kx, -1 in -kx.
  double sheared(Index k, int side) const {
    double sum = 0;
    if (first_[stress::shear_x]) sum += side * weights_[stress::shear_x] * first_[stress::shear_x][2 * k];
    if (first_[stress::shear_y]) sum += weights_[stress::shear_y] * first_[stress::shear_y][2 * k];
    return sum;
  }

 private:
  std::array<const double*, 3> first_{};
  std::array<double, 3> weights_;
};

void respond(Index nx, Component c, const Column& column, const Complex* p, Complex* out) {
  const bool turned = odd_in_x(c) != odd_in_y(c);
  const double ahead = odd_in_x(c) && odd_in_y(c) ? -1 : 1, back = odd_in_x(c) ? -ahead : ahead;
  auto each_mode = [&](auto response) {
    for (Index k = 0; k <= nx / 2; ++k) out[k] = response(k, 1, ahead, p[k]);
    for (Index k = nx / 2 + 1; k < nx; ++k) out[k] = response(nx - k, -1, back, p[k]);
  };
  auto S = [&](Index k, double factor) { return factor * column.pressed(k); };
  auto T = [&](Index k, int side, double factor) { return factor * column.sheared(k, side); };
  if (!column.friction() && !turned)
    each_mode([&](Index k, int, double f, const Complex& z) { return S(k, f) * z; });
  else if (!column.friction())
    each_mode([&](Index k, int, double f, const Complex& z) { return turn(S(k, f), z); });
  else if (!turned)
    each_mode(
        [&](Index k, int side, double f, const Complex& z) { return S(k, f) * z - turn(T(k, side, f), z); });
  else
    each_mode(
        [&](Index k, int side, double f, const Complex& z) { return turn(S(k, f), z) + T(k, side, f) * z; });
}

}  // namespace

void respond(LayerInfluence& influence, const std::array<double, 3>& weights, Component c, Index b,
             const PrunedTransform& transform, const Complex* pressure, Complex* product) {
  Symbols symbols{};
  for (stress::Traction t : stress::tractions)
    if (weights[t] != 0) symbols[t] = influence.symbol(t, c, b);
  for (Index q = 0; q < LayerInfluence::width; ++q)
    respond(transform.torus().nx, c, Column(symbols, weights, c, q), pressure + q * transform.stride(),
            product + q * transform.stride());
}

}  // namespace asperity
