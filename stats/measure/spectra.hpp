/// Spectra of profiles and over rings of a surface. Where its heights are evidently not Gaussian, or were
/// drawn so, errors hold what this adds (stats/spectrum/power_excess.hpp).
///
/// Cost      at 2048 × 2048 points half as much again as a spectrum alone where the correlation is estimated,
///           and three times as much where heights are not Gaussian.
#pragma once

#include <vector>

#include "stats/measure/sample.hpp"
#include "stats/spectrum/spectrum.hpp"

namespace asperity {

/// Of a sample that is whole.
std::vector<SpectrumPoint> profile_spectrum(const Sample& sample, Axis1D axis, DataWindow window);
std::vector<SpectrumPoint> radial_spectrum(const Sample& sample, DataWindows windows);

}  // namespace asperity
