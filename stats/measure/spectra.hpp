/// Spectra of profiles and over rings of a surface, with errors and 95 % intervals, or a reason for none.
///
/// Degrees of freedom come from the power that wave numbers share and from neighbouring points
/// (stats/spectrum/shared_power.hpp, pooled_degrees.hpp); unless heights were drawn Gaussian, what local
/// amplitudes that stray add comes from the field's own long waves (power_excess.hpp); what the window
/// smooths and leaks, and what missing points spread, lengthens intervals or leaves none (resolution.hpp,
/// holes.hpp).
///
/// Accuracy  of fields of eleven textures, Gaussian and not, without a known correlation
///           (validation/error_coverage.cpp), at wave numbers 3, 5, 12, 40 where more than half of the
///           fields have an error. Covered, in per cent, and the stated over the true error:
///
///           points      N_eff        fields   covered     error
///           32 × 32     8 to 35      200      90 to 99    0.85 to 1.34
///           37 × 37     43 to 174    200      92 to 100   0.88 to 1.34
///           64 × 64     33 to 141    200      90 to 99    0.81 to 1.31
///           60 × 200    214 to 899   100      89 to 100   0.86 to 1.25
///           128 × 128   131 to 564   100      89 to 100   0.82 to 1.40
///
///           A coverage is known to 1.5 % of 200 fields and to 2.2 % of 100, an error to 5 and 7 %. At
///           wave number 2, 85 to 100 %, 0.84 to 1.46. Intervals rather cover too much, for chance leaves an
///           excess of Gaussian heights too.
/// Cost      at 2048 × 2048 points three times that of a spectrum alone, half as much again where heights
///           were drawn Gaussian.
#pragma once

#include <vector>

#include "stats/measure/sample.hpp"
#include "stats/spectrum/spectrum.hpp"

namespace asperity {

/// Of a sample that is whole.
std::vector<SpectrumPoint> profile_spectrum(const Sample& sample, Axis1D axis, DataWindow window);
std::vector<SpectrumPoint> radial_spectrum(const Sample& sample, DataWindows windows);

}  // namespace asperity
