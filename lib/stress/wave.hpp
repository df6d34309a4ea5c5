/// One mode of a periodic load: (3), (4) of stress/layer_influence.hpp, and its mean.
#pragma once

#include <cmath>

#include "stress/component.hpp"

namespace asperity::stress {

/// The wave numbers may be negative; both zero are the mean load.
struct Wave {
  double qx, qy, z, nu;
  double q = std::hypot(qx, qy), e = std::exp(-q * z);

  /// S of component c under traction t.
  double operator()(Traction t, Component c) const {
    if (q == 0) return mean(t, c);
    if (t == normal) return pressed(c);
    return t == shear_x ? sheared(qx, qy, c) : sheared(qy, qx, exchanged(c));
  }

 private:
  double mean(Traction t, Component c) const {
    if (t == shear_x) return c == xz ? -1 : 0;
    if (t == shear_y) return c == yz ? -1 : 0;
    if (c == zz) return -1;
    return c == xx || c == yy ? -nu / (1 - nu) : 0;
  }

  double pressed(Component c) const {
    const double bend = ((1 - 2 * nu) / q - z) / q;
    if (c == xx) return -(2 * nu + qx * qx * bend) * e;
    if (c == yy) return -(2 * nu + qy * qy * bend) * e;
    if (c == zz) return -(1 + q * z) * e;
    if (c == xy) return qx * qy * bend * e;
    if (c == xz) return -qx * z * e;
    return -qy * z * e;
  }

  // By a traction along the axis of `along`.
  double sheared(double along, double across, Component c) const {
    const double k = z + 2 * nu / q, w = e / q;
    if (c == xx) return -along * (2 + 2 * nu - k * along * along / q) * w;
    if (c == yy) return -along * (2 * nu - k * across * across / q) * w;
    if (c == zz) return -along * q * z * w;
    if (c == xy) return -across * (1 - k * along * along / q) * w;
    if (c == xz) return -(q - z * along * along) * w;
    return -along * across * z * w;
  }
};

}  // namespace asperity::stress
