#include "contact/stiffness.hpp"

#include <memory>
#include <utility>

#include "contact/calibration.hpp"
#include "contact/subspace_cg.hpp"

namespace asperity {
namespace {

constexpr double no_answer = 1e-9;  // of K₀₀: round-off of K 1 = 0
bool answers_constant(ElasticOperator& body, Shape own) {
  Field u = Field::Ones(own.nx, own.ny);
  body.apply(u, u);
  return largest(body.slabs().ranks(), u.abs().maxCoeff()) > no_answer * body.self_influence();
}

// Where it pays.
std::unique_ptr<TwoLevel> two_level_on(const FreeSet& free, ElasticOperator& body, int threads) {
  if (!TwoLevel::suits(body.shape())) return nullptr;
  auto out = std::make_unique<TwoLevel>(body, threads);
  out->set(free.mask);
  return out->raggedness() > contact::ragged_for_blocks ? std::move(out) : nullptr;
}

}  // namespace

Stiffness contact_stiffness(ElasticOperator& body, const Field& pressure, double limit_pressure,
                            double cell_area, double convolutions, int threads) {
  ContactProblem problem{.influence = &body,
                         .h = Field::Zero(pressure.rows(), pressure.cols()),
                         .cap = limit_pressure,
                         .threads = threads};
  const Field& none = problem.h;
  const FreeSet free(problem, pressure, none, 0);  // C: no gap drives a cell off its bound
  if (free.cells == 0) return {.value = 0, .residual = 0};
  const bool full = free.cells == static_cast<double>(body.shape().cells());
  const int asked = full ? 1 : 0;
  if (full && !answers_constant(body, shape_of(pressure)))
    return {.value = std::numeric_limits<double>::infinity(),
            .residual = 0,
            .convolutions = static_cast<double>(asked)};

  problem.approach = 1;  // of K q
  Trial trial;
  const auto two_level = two_level_on(free, body, threads);
  // K of the steps is in single precision, which near full contact is too little for all of q at once: then
  // again from what the exact K leaves, while that helps.
  Stiffness out{.residual = std::numeric_limits<double>::infinity(),
                .convolutions = static_cast<double>(asked)};
  Field p, g;
  for (bool first = true;; first = false, p = trial.p, g = trial.g) {
    if (two_level) two_level->set(free.mask);
    SubspaceCG cg(problem, free, first ? none : p, first ? none : g, trial, two_level.get());
    while (cg.residual().largest > stiffness_tolerance / 2 &&
           out.convolutions + cg.applications() < convolutions && cg.step()) {
    }
    out.convolutions += cg.applications() + 1;
    out.preconditionings += cg.applications();
    body.apply(trial.p, trial.g);
    const SubspaceCG fresh(problem, free, trial.p, trial.g, trial);
    const double before = std::exchange(out.residual, fresh.residual().largest);
    const bool helps = out.residual < before / 2 && out.convolutions < convolutions;
    if (out.residual <= stiffness_tolerance || !helps) break;
  }
  if (out.residual <= stiffness_tolerance)
    out.value = cell_area *
                problem.blocks().sum([&](Block b) { return (b.of(trial.p) * (2 - b.of(trial.g))).sum(); });
  return out;
}

}  // namespace asperity
