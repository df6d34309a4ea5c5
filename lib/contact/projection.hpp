/// Pressures onto the bounds and the load: 0 ≤ p ≤ c, Σp = S.
///
/// Both return pressures that keep the bounds exactly and the load to round-off; S ≤ n c is presupposed.
/// Where the approach is given in place of the load, both only clip.
/// Cost: a few passes over the cells.
#pragma once

#include "contact/problem.hpp"

namespace asperity {

/// The nearest pressure in the Euclidean norm: p = clip(x + s, 0, c), s by safeguarded Newton steps.
void project(const ContactProblem& problem, Field& p);

/// Clips, then multiplies the free cells by the factor that restores the load, again while some of them reach
/// c. Cells at 0 or at c stay there. False if no positive factor does it; then p is only clipped.
bool clip_and_rescale(const ContactProblem& problem, Field& p);

}  // namespace asperity
