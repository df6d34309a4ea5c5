/// Labels of the construction of Sk, Spk and Svk in the panel of a material ratio curve.
///
/// The lengths Spk, Sk, Svk stand right of the panel, each at the middle of its arrow, or where they would
/// touch so far off that they are clear. The ratios Smr1 and Smr2 stand beside their lines: on the inner side
/// above the axis, else on the outer side or higher, where the text crosses the fewest lines of the curve. A
/// label without a place is left out, and a note says so.
///
/// Cost      for each ratio, the points of the curve times the places tried: below a millisecond.
#pragma once

#include "stats/height/material_ratio.hpp"
#include "tools/plot/layout.hpp"

namespace asperity::plot {

struct Construction {
  CoreParameters core;
  Field curve;  ///< share [%] and height

  /// The tips of the triangles.
  double peak() const { return core.upper + core.spk; }
  double dale() const { return core.lower - core.svk; }
};

/// Adds them to a panel whose y axis shows these heights [SI]; the ratios only where it is the only one.
void add_labels(Figure& figure, std::size_t panel, const Construction& of, Range heights,
                const Layout& layout);

}  // namespace asperity::plot
