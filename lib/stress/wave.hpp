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
    switch (c) {
      case xx:
        return -(2 * nu + qx * qx * bend) * e;
      case yy:
        return -(2 * nu + qy * qy * bend) * e;
      case zz:
        return -(1 + q * z) * e;
      case xy:
        return qx * qy * bend * e;
      case xz:
        return -qx * z * e;
      case yz:
        return -qy * z * e;
    }
    return 0;
  }

  // By a traction along the axis of `along`.
  double sheared(double along, double across, Component c) const {
    const double k = z + 2 * nu / q, w = e / q;
    switch (c) {
      case xx:
        return -along * (2 + 2 * nu - k * along * along / q) * w;
      case yy:
        return -along * (2 * nu - k * across * across / q) * w;
      case zz:
        return -along * q * z * w;
      case xy:
        return -across * (1 - k * along * along / q) * w;
      case xz:
        return -(q - z * along * along) * w;
      case yz:
        return -along * across * z * w;
    }
    return 0;
  }
};

}  // namespace asperity::stress
