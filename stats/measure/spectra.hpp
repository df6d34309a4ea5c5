/// Spectra of profiles and over rings of a surface, with errors and 95 % intervals, or a reason for none.
///
/// Degrees of freedom come from the power that wave numbers share and from neighbouring points
/// (stats/spectrum/shared_power.hpp, pooled_degrees.hpp); unless heights were drawn Gaussian, what local
/// amplitudes that vary add comes from the field's own long waves (power_excess.hpp); what the window
/// smooths and leaks, and what missing points spread, lengthens intervals or leaves none (resolution.hpp,
/// holes.hpp).
///
/// Accuracy  stated over true error and coverage of the 95 % intervals, the least and the most of eleven
///           textures, Gaussian and not, without a known correlation, at wave numbers 2 to 40 where more than
///           half of the fields have an error (validation/error_coverage):
///           0.83 to 1.25, 91 to 99 % at N_eff 290 to 1230; 0.88 to 1.24, 91 to 99 % at 33 to 140;
///           0.84 to 1.41, 88 to 99 % at 8 to 35. Intervals rather cover too much, for chance leaves an
///           excess of Gaussian heights too.
/// Cost      at 2048 × 2048 points three times that of a spectrum alone, half as much again where heights
///           were drawn Gaussian.
#pragma once

#include <vector>

#include "stats/measure/sample.hpp"
#include "stats/spectrum/spectrum.hpp"

namespace asperity {

/// The wave of two points has half its density, as at either sign.
std::vector<SpectrumPoint> profile_spectrum(const Sample& sample, Axis1D axis, DataWindow window);
std::vector<SpectrumPoint> radial_spectrum(const Sample& sample, DataWindows windows);

// ---- of several maps ----

/// Classes of wave numbers that spectra of maps of several grids have in common.
///
/// Spectra of one step are those of each map. Where spectra of several steps overlap, a class has the width
/// and the place of a wave number of the coarsest; a finer one has its mean over this class, of points k of
/// widths as their steps, weighted by their parts in it and their numbers of wave numbers. Below and above
/// stand classes of the next finer. A map has no mean where it does not reach over all of a class, and where
/// a point has a bias that leaves it without an error.
///
/// Near its shortest wave a map has those that it folds back. Beside a map of a finer spacing it counts to a
/// third of π/Δ: there they add 3 % to C ~ q⁻³ of a field, and 10 %, (π/6)²/sin²(π/6) - 1, to its profiles'
/// C ~ q⁻², as of an exponential correlation; less of smoother ones, and below.
class CommonWaveNumbers {
 public:
  struct Reach {
    double step, last;  ///< of the wave numbers of a spectrum [rad/m]
    /// Of a map of n points of this spacing; `finest` is that of all.
    static Reach of(double step, double spacing, double finest);
  };
  explicit CommonWaveNumbers(std::vector<Reach> maps);

  /// NaN without a mean; of more than one point, which share power, there is no error.
  std::vector<SpectrumPoint> means(const std::vector<SpectrumPoint>& points, const Reach& of) const;

 private:
  struct Class {
    double from, to;
  };
  std::vector<Class> classes_ = {};
};

}  // namespace asperity
