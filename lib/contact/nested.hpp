/// From a grid to one twice as coarse and back, for a start that is nearly the solution.
///
/// The gap is averaged over 2 × 2 cells; pressures return with the weights 9-3-3-1 of the four nearest coarse
/// cells, where the coarse cell that holds the fine one is in contact, and are 0 elsewhere.
#pragma once

#include "contact/problem.hpp"

namespace asperity {

/// Even sides, and no half below 32 cells.
bool can_coarsen(Shape shape);
/// The same load, or approach, on a quarter of the cells; K₀₀ is doubled, as it is of cells twice the size.
ContactProblem coarsened(const ContactProblem& problem);
/// Pressures on the grid twice as fine; `periodic` tells what lies beyond the edge.
Field prolonged(const Field& coarse, bool periodic, int threads = 1);

}  // namespace asperity
