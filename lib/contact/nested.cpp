#include "contact/nested.hpp"

#include <algorithm>

namespace asperity {

bool can_coarsen(Shape shape) {
  constexpr Index least = 32;
  return shape.nx % 2 == 0 && shape.ny % 2 == 0 && std::min(shape.nx, shape.ny) / 2 >= least;
}

ContactProblem coarsened(const ContactProblem& problem) {
  const Field& h = problem.h;
  ContactProblem coarse{Field(h.rows() / 2, h.cols() / 2),
                        problem.sum / 4,
                        problem.cap,
                        2 * problem.self_influence,
                        problem.approach,
                        problem.threads,
                        problem.datum};
  for (Index i = 0; i < coarse.h.rows(); ++i)
    for (Index j = 0; j < coarse.h.cols(); ++j) coarse.h(i, j) = h.block<2, 2>(2 * i, 2 * j).mean();
  return coarse;
}

Field prolonged(const Field& coarse, bool periodic) {
  auto beyond = [periodic](Index i, Index n) {
    return periodic ? (i + n) % n : std::clamp<Index>(i, 0, n - 1);
  };
  Field fine(2 * coarse.rows(), 2 * coarse.cols());
  for (Index i = 0; i < fine.rows(); ++i)
    for (Index j = 0; j < fine.cols(); ++j) {
      const Index I = i / 2, J = j / 2;
      const Index near_i = beyond(i % 2 ? I + 1 : I - 1, coarse.rows());
      const Index near_j = beyond(j % 2 ? J + 1 : J - 1, coarse.cols());
      const double here = coarse(I, J);
      fine(i, j) =
          here > 0 ? (9 * here + 3 * coarse(near_i, J) + 3 * coarse(I, near_j) + coarse(near_i, near_j)) / 16
                   : 0;
    }
  return fine;
}

}  // namespace asperity
