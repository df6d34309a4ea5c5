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

}  // namespace asperity
