/// The largest von Mises stress and its place: searched for, recorded, and doubted where that is due.
#pragma once

#include "stress/maximum.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// By the scene's solver, unless that is of a section; into its attributes. Warns of a place less deep than accurate_depth, or at the edge of a free domain.
StressMaximum search_maximum(const Tool& tool, StressScene& scene, const StressSolver& solver);

}  // namespace asperity::cli
