/// The largest stress below a loaded surface and where it lies.
///
/// A smooth contact yields first at about half its radius below the surface, a rough one a few cells deep,
/// and the layers of a volume may miss both. The search begins at a given depth z_0, by default the surface,
/// and scans the geometric depths
///     z_k = max(¼ h, z_0) √2^k,  h = min(Δx, Δy),  down to half the longer side of the loaded region,  (1)
/// for the local maxima of the layers: where z < 12 Δ, Δ = max(Δx, Δy), in the tiles of cells whose bound
/// exceeds the largest value found so far, deeper on cells as wide as a third of the depth. Maxima that may
/// lead above the largest (least_start) are refined at points of the field (all in stress/search.hpp). From
/// one longer side of a cell on, the maximum is that of the field at any place; above it, where the field
/// shows the steps between the cells, that at their centres. In a free domain the search ends at the centres
/// of the outermost cells.
///
/// The surface bears most at the trailing edge of a sliding contact (von Mises, Hertz, ν = 0.3, from μ =
/// 0.305 on), at a long cylinder's or a wave's middle where ν is small (below 0.19 and 0.15), and at the
/// edge of a Hertz contact where ν < -0.34; the largest tension lies there, too, with friction or without.
///
/// Accuracy  of the search, for the problem of the cells: 1e-6 of the value, seen in 420 random bodies (caps,
///           rough patches, single cells; 24 to 128 cells a side, cells 1 : 20 to 20 : 1 long, free and
///           periodic, all criteria, with friction and limit pressures). What least_start allows is
///           experience, not a bound.
/// Cost      one thread: below a rough contact (exponential, 0.4 μm, 3 mm) about the contact's time, at a
///           limit pressure, with its many nearly equal maxima, twice that. Memory: 6 doubles a cell, the
///           pressure's among them; 14 where whole layers are scanned: below 64 cells a side, for cells
///           longer than twice their width, for a load that repeats along both axes, and for one that
///           repeats along one by no multiple of four. Above 6 Δ these are layers of the full cells. Where
///           cells repeat along one axis a point takes 20 μs a loaded cell (stress/points.hpp); along both 4
///           ms at 1024² cells, and many nearly equal maxima, as at a limit pressure, take 3 s there, five
///           times the contact (1.9 s at 512², 14 times). Maxima that recur are refined once.
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

double equivalent_stress(Criterion of, const stress::Tensor& stress);
/// At every point of a row.
void equivalent_stress(Criterion of, const StressRow& stress, std::span<double> out);

struct StressSearch {
  Criterion of = Criterion::von_mises;
  double below = 0;  ///< depth from which on the search looks [m]

  static constexpr double deepest = 0.1 * farthest;
  static constexpr double shallowest = 0.25;  ///< of a cell: the first layer below the surface

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

/// All zero where nothing is loaded. `on_layer` is called for every layer, one at a time, in any order. Runs
/// on one rank. Throws ParameterError("section") for the solver of a section.
StressMaximum maximum_stress(const StressSolver& solver, const StressSearch& search = {},
                             const std::function<void(const StressProbe&)>& on_layer = {});

/// The largest stress in the layer at each of these depths; the peak between the centres is that of the
/// quadratic through nine values about the largest.
std::vector<StressMaximum> maximum_by_depth(const StressSolver& solver, Criterion of,
                                            const std::vector<double>& depths,
                                            const std::function<void(const StressProbe&)>& on_layer = {});

}  // namespace asperity
