/// A field seen from above, as maps and states of contact draw it: a panel a case, both axes to one scale.
#pragma once

#include "tools/plot/figure.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {

/// The panel of this case, its axes in `length`; returns where its cells lie, in the same unit.
inline Lattice plan_view(Figure& figure, const Patch& patch, const Unit& length, std::size_t number,
                         const std::string& label) {
  const double unit = length.factor;
  figure.panel(number, label);
  figure.x_axis({patch.x.low / unit, patch.x.high / unit}, length.label("x"));
  figure.y_axis({patch.y.low / unit, patch.y.high / unit}, length.label("y"));
  return {patch.x_at(0) / unit, patch.y_at(0) / unit, patch.dx() / unit, patch.dy() / unit};
}

}  // namespace asperity::plot
