/// Surfaces that are no function of one Gaussian field: patches, marks of tools, particles, several processes.
///
///     patchy           exponential roughness of length l/3, its amplitude exp(0.7 y), y Gaussian of length 3l
///     strong_patches   the same of exp(1.2 y): a tenth of the surface has seven eighths of the power
///     hatch            honed: a plateau of fine roughness, crossed by grooves at ±30°, one in 5l
///     turned           feed marks, 3l apart, whose phase wanders along and across, and fine roughness
///     milled           the same on arcs, with every fourth mark deeper: their lay turns over the field
///     scratches, dust  exponential roughness with scratches in all directions, or particles, high and apart
///     t                Student's t of 5 degrees of freedom: Gaussian over the root of χ²/5
///     two_processes    the lower of a coarse and a fine surface at every point
#pragma once

#include "textures.hpp"

namespace asperity::textures {

std::vector<Texture> made(double length);

}  // namespace asperity::textures
