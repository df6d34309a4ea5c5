/// What a stress is not to be trusted for, each in one line with its figures.
#pragma once

#include <array>
#include <vector>

#include "stress/maximum.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// That this largest von Mises stress [Pa] is above the yield stress, where the contact had a limit pressure.
void warn_of_yield(const Tool& tool, const Attributes& contact, double von_mises);

/// That points (x, y, depth) lie less deep than accurate_depth.
void warn_of_points(const Tool& tool, const StressScene& scene,
                    const std::vector<std::array<double, 3>>& points);

/// That the place of the maximum is less deep than accurate_depth, or at the edge of a free domain.
void warn_of_place(const Tool& tool, const StressScene& scene, const StressMaximum& maximum);

}  // namespace asperity::cli
