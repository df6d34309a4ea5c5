#include "contact/nested.hpp"

#include <algorithm>

#include "core/calibration.hpp"
#include "core/halved.hpp"
#include "core/parallel.hpp"

namespace asperity {
namespace {

bool can_coarsen(Shape shape) {
  return shape.nx % 2 == 0 && shape.ny % 2 == 0 &&
         std::min(shape.nx, shape.ny) / 2 >= calibration::contact::least_side;
}

// On a quarter of the cells.
ContactProblem coarsened(const ContactProblem& problem, ElasticOperator& body) {
  ContactProblem coarse = problem.on(body, halved(problem.h, problem.threads));
  coarse.sum /= 4;
  coarse.self_influence = body.self_influence();
  return coarse;
}

}  // namespace

std::vector<CoarseLevel> coarser_levels(const ContactProblem& problem) {
  std::vector<CoarseLevel> levels;
  for (const ContactProblem* finer = &problem; can_coarsen(shape_of(finer->h));
       finer = &levels.back().problem) {
    auto body = finer->influence->coarsened(2);
    ContactProblem coarse = coarsened(*finer, *body);
    levels.push_back({std::move(body), std::move(coarse)});
  }
  return levels;
}

Field prolonged(const Field& coarse, Periodic periodic, int threads) {
  auto beyond = [](Index i, Index n, bool around) {
    return around ? (i + n) % n : std::clamp<Index>(i, 0, n - 1);
  };
  Field fine(2 * coarse.rows(), 2 * coarse.cols());
  parallel_ranges(fine.rows(), threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i) {
      const Index I = i / 2, beside = beyond(i % 2 ? I + 1 : I - 1, coarse.rows(), periodic.x);
      for (Index J = 0; J < coarse.cols(); ++J) {
        const Index left = beyond(J - 1, coarse.cols(), periodic.y),
                    right = beyond(J + 1, coarse.cols(), periodic.y);
        auto blend = [&](Index j) {
          return (9 * coarse(I, J) + 3 * (coarse(beside, J) + coarse(I, j)) + coarse(beside, j)) / 16;
        };
        const bool touches = coarse(I, J) > 0;
        fine(i, 2 * J) = touches ? blend(left) : 0;
        fine(i, 2 * J + 1) = touches ? blend(right) : 0;
      }
    }
  });
  return fine;
}

}  // namespace asperity
