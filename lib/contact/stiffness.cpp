#include "contact/stiffness.hpp"

#include <memory>

#include "contact/subspace_cg.hpp"
#include "core/calibration.hpp"

namespace asperity {
namespace {

constexpr double no_answer = 1e-9;  // of K₀₀: round-off of K 1 = 0
constexpr double infinity = std::numeric_limits<double>::infinity();

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
  return out->raggedness() > calibration::contact::ragged_for_blocks ? std::move(out) : nullptr;
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
    return {.value = infinity, .residual = 0, .convolutions = static_cast<double>(asked)};

  problem.approach = 1;  // of K q
  Trial trial;
  const auto two_level = two_level_on(free, body, threads);
  SubspaceCG cg(problem, free, none, none, trial, two_level.get());
  while (cg.residual().largest > stiffness_tolerance / 2 && asked + cg.applications() < convolutions &&
         cg.step()) {
  }
  body.apply(trial.p, trial.g);
  const SubspaceCG fresh(problem, free, trial.p, trial.g, trial);
  Stiffness out{.residual = fresh.residual().largest,
                .convolutions = asked + cg.applications() + 1,
                .preconditionings = cg.applications()};
  if (out.residual <= stiffness_tolerance)
    out.value = cell_area *
                problem.blocks().sum([&](Block b) { return (b.of(trial.p) * (2 - b.of(trial.g))).sum(); });
  return out;
}

}  // namespace asperity
