/// Grids twice as coarse and back, for a start that is nearly the solution.
///
/// The gap is averaged over 2 × 2 cells; pressures return with the weights 9-3-3-1 of the four nearest coarse
/// cells, where the coarse cell that holds the fine one is in contact, and are 0 elsewhere.
#pragma once

#include "contact/problem.hpp"

namespace asperity {

/// The problem on coarser cells, and the body there.
struct CoarseLevel {
  std::unique_ptr<ElasticOperator> body;
  ContactProblem problem;
};

/// Under the same load or approach, from the second finest grid on: sides are even, no half below 32.
std::vector<CoarseLevel> coarser_levels(const ContactProblem& problem);
/// Pressures on the grid twice as fine, dealt as `to`; `periodic` tells what lies beyond the edge.
Field prolonged(const Field& coarse, const Slabs& from, const Slabs& to, Periodic periodic, int threads);

}  // namespace asperity
