#include "contact/nested.hpp"

#include <algorithm>
#include <utility>
#include <vector>

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
  const Slabs slabs = problem.slabs();
  Field h = halved(problem.h, problem.threads);
  if (slabs.shared()) h = rows_of(h, slabs.coarsened(2), body.slabs().own());
  ContactProblem coarse = problem.on(body, std::move(h));
  coarse.sum /= 4;
  coarse.self_influence = body.self_influence();
  return coarse;
}

}  // namespace

std::vector<CoarseLevel> coarser_levels(const ContactProblem& problem) {
  std::vector<CoarseLevel> levels;
  for (const ContactProblem* finer = &problem; can_coarsen(finer->shape()); finer = &levels.back().problem) {
    auto body = finer->influence->coarsened(2);
    ContactProblem coarse = coarsened(*finer, *body);
    levels.push_back({std::move(body), std::move(coarse)});
  }
  return levels;
}

Field prolonged(const Field& coarse, const Slabs& from, const Slabs& to, Periodic periodic, int threads) {
  auto beyond = [](Index i, Index n, bool around) {
    return around ? (i + n) % n : std::clamp<Index>(i, 0, n - 1);
  };
  const Extent own = to.own();
  const Index before = own.first / 2 - 1;
  std::vector<Index> wanted;
  for (Index I = before; I <= (own.end() + 1) / 2; ++I) wanted.push_back(beyond(I, from.rows(), periodic.x));
  const Field rows = rows_of(coarse, from, wanted);
  Field fine(own.count, 2 * coarse.cols());
  parallel_ranges(fine.rows(), threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i) {
      const Index I = (own.first + i) / 2 - before, beside = i % 2 ? I + 1 : I - 1;
      for (Index J = 0; J < rows.cols(); ++J) {
        const Index left = beyond(J - 1, rows.cols(), periodic.y),
                    right = beyond(J + 1, rows.cols(), periodic.y);
        auto blend = [&](Index j) {
          return (9 * rows(I, J) + 3 * (rows(beside, J) + rows(I, j)) + rows(beside, j)) / 16;
        };
        const bool touches = rows(I, J) > 0;
        fine(i, 2 * J) = touches ? blend(left) : 0;
        fine(i, 2 * J + 1) = touches ? blend(right) : 0;
      }
    }
  });
  return fine;
}

}  // namespace asperity
