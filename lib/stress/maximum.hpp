/// The largest stress below a loaded surface and where it lies.
///
/// A smooth contact yields first at about half its radius below the surface, a rough one a few cells deep,
/// and the layers of a volume may miss both. The search looks at the depth z_0 from which on it is asked, the
/// surface unless told otherwise, and at geometric depths,
///     z_k = max(¼ h, z_0) 1.5^k,  h = min(Δx, Δy),  down to half the longer side of the loaded region,  (1)
/// and refines each maximum of the layers' maxima m(z) that may be the largest by cubics through four points
/// in ln z, inside their bracket. Within a layer the peak between the cell centres is that of the quadratic
/// through nine values; neighbours of a periodic grid's edge are those of the next period, and beyond the
/// edge of a free one nothing is looked at. The surface bears most at the trailing edge of a sliding
/// contact (von Mises, Hertz, ν = 0.3, from μ = 0.305 on), at a long cylinder's or a wave's middle where ν is
/// small (below 0.19 and 0.15), and at the edge of a Hertz contact where ν < -0.34; the largest tension lies
/// there, too, with friction or without.
///
/// Accuracy  of the search, against sums over the cells at points about the place (stress/points.hpp), in
///           196 contacts of validation/contact_grid_scenes.hpp on 96 and 128 cells a side: 7e-5 of the value
///           at depths of 6 h and more, 5e-4 from 3 h on, 1.1e-3 from 1.5 h on, 2.3 % above. At 6 h and more
///           nine of ten depths are right to 1.2e-3; the worst, where m(z) is flat, is off by 4 %, and by 9 %
///           above 1.5 h.
/// Cost      about 16 layers of all components at 128 cells, one more each time the side grows by half, and a
///           few.
#pragma once

#include <functional>
#include <vector>

#include "stress/layers.hpp"

namespace asperity {

/// What is searched for (stress/equivalent.hpp).
enum class Criterion {
  von_mises,  ///< a ductile body yields
  max_shear,  ///< the same by Tresca: half the difference of the outer principal stresses
  principal,  ///< a brittle body cracks: the largest principal stress, positive in tension
};

/// At every point of a row.
void equivalent_stress(Criterion of, const StressRow& stress, std::span<double> out);

struct StressSearch {
  Criterion of = Criterion::von_mises;
  double below = 0;  ///< nothing above this depth is looked at [m]

  static constexpr double deepest = 0.1 * farthest;

  /// Throws ParameterError("below") unless 0 ≤ below ≤ deepest.
  void check() const;
};

struct StressMaximum {
  double value = 0;                ///< [Pa]
  double x = 0, y = 0, depth = 0;  ///< [m]
  Index layers = 0;                ///< layers computed to find it
};

/// A layer of the search.
struct StressProbe {
  Index done = 0, expected = 0;  ///< layers so far, and in all by what is known by now
  double depth = 0;              ///< [m]
  double value = 0;              ///< the largest of the layer [Pa]
};

/// All zero where nothing is loaded. `on_layer` is called for every layer, one at a time, in any order. The
/// solver is one of whole layers.
StressMaximum maximum_stress(const StressSolver& solver, const StressSearch& search = {},
                             const std::function<void(const StressProbe&)>& on_layer = {});

/// The largest stress in the layer at each of these depths, with the peak between the cell centres as above.
std::vector<StressMaximum> maximum_by_depth(const StressSolver& solver, Criterion of,
                                            const std::vector<double>& depths,
                                            const std::function<void(const StressProbe&)>& on_layer = {});

}  // namespace asperity
