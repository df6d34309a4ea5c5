#include "stats/spectrum/texture_direction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stats/spatial/pairs.hpp"

namespace asperity {
namespace {

constexpr Index sectors = 360;  // of π
// Wave numbers lie on the bounds, whatever the unit of length.
constexpr double round_off = 1e-12;
constexpr double sector = std::numbers::pi / sectors, narrowest = 2 * std::numbers::pi / 180;

// F of (1) on sectors from -π/2 on.
class AngularSpectrum {
 public:
  void add(double angle, double half_width, double power) {
    const auto first = static_cast<Index>(std::ceil((angle - half_width) / sector)),
               last = static_cast<Index>(std::floor((angle + half_width) / sector));
    for (Index s = first; s <= last; ++s) {
      const double distance = std::abs(static_cast<double>(s) * sector - angle) / half_width;
      values_((s + 5 * sectors / 2) % sectors) += power * (1 - distance) / half_width;
    }
  }
  // The vertex of the parabola through the largest value and its neighbours.
  TextureDirection largest() const {
    Index top = 0;
    const double highest = values_.maxCoeff(&top);
    if (!(highest > 0)) return {std::nan(""), std::nan("")};
    const double before = values_((top + sectors - 1) % sectors), after = values_((top + 1) % sectors);
    const double bend = before - 2 * highest + after, shift = bend < 0 ? 0.5 * (before - after) / bend : 0;
    const double angle = (static_cast<double>(top) + shift) * sector - std::numbers::pi / 2;
    return {angle > -std::numbers::pi / 2 ? angle : angle + std::numbers::pi, highest / values_.mean()};
  }

 private:
  Eigen::ArrayXd values_ = Eigen::ArrayXd::Zero(sectors);
};

}  // namespace

TextureDirection texture_direction(const LagField& psd, const Grid& grid) {
  const double step_x = 2 * std::numbers::pi / grid.size_x(), step_y = 2 * std::numbers::pi / grid.size_y();
  const double step = std::max(step_x, step_y), last = std::numbers::pi / std::max(grid.dx, grid.dy);
  Grid torus = grid;
  torus.periodic = true;
  AngularSpectrum spectrum;
  for_each_lag(psd, torus, [&](Index p, Index q, double weight) {
    const double qx = static_cast<double>(p) * step_x, qy = static_cast<double>(q) * step_y,
                 length = std::hypot(qx, qy);
    if (length < 4 * step * (1 - round_off) || length > last * (1 + round_off)) return;
    spectrum.add(std::atan2(qy, qx), std::max(narrowest, step / length), weight * psd(p, q));
  });
  return spectrum.largest();
}

}  // namespace asperity
