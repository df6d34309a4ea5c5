/// The largest von Mises stress below a loaded surface and where it lies.
///
/// A smooth contact yields first at about half its radius below the surface, a rough one a few cells deep,
/// and the layers of a volume may miss both. The search looks at the surface and at geometric depths,
///     z_k = ¼ h 1.5^k,  h = min(Δx, Δy),  down to half the longer side of the loaded region,            (1)
/// and refines each maximum of the layers' maxima m(z) that may be the largest by parabolas through three
/// points in ln z, inside their bracket. Within a layer the peak between the cell centres comes from a
/// parabola in x and one in y; neighbours of a periodic grid's edge are those of the next period, and beyond
/// the edge of a free one nothing is looked at. The surface bears most at the trailing edge of a sliding
/// contact (Hertz, ν = 0.3, from μ = 0.305 on), at a long cylinder's or a wave's middle where ν is small
/// (below 0.19 and 0.15), and at the edge of a Hertz contact where ν < -0.34.
///
/// Accuracy  of the search: 8e-5 of the value for a smooth contact, 4e-3 for rough ones.
/// Cost      about 16 layers of all components at 128 cells, one more each time the side grows by half, and a
///           few.
#pragma once

#include <functional>

#include "stress/layers.hpp"

namespace asperity {

struct StressMaximum {
  double von_mises = 0;            ///< [Pa]
  double x = 0, y = 0, depth = 0;  ///< [m]
  Index layers = 0;                ///< layers computed to find it
};

/// A layer of the search.
struct StressProbe {
  Index done = 0, expected = 0;  ///< layers so far, and in all by what is known by now
  double depth = 0;              ///< [m]
  double von_mises = 0;          ///< the largest of the layer [Pa]
};

/// All zero where nothing is loaded. `on_layer` is called for every layer, one at a time, in any order.
StressMaximum maximum_von_mises(const StressSolver& solver,
                                const std::function<void(const StressProbe&)>& on_layer = {});

}  // namespace asperity
