#include "contact/stiffness.hpp"

#include "contact/subspace_cg.hpp"

namespace asperity {
namespace {

constexpr double no_answer = 1e-9;  // of K₀₀: round-off of K 1 = 0
constexpr double infinity = std::numeric_limits<double>::infinity();

bool answers_constant(ElasticOperator& body, Shape shape) {
  Field u = Field::Ones(shape.nx, shape.ny);
  body.apply(u, u);
  return u.abs().maxCoeff() > no_answer * body.self_influence();
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
  const bool full = free.cells == static_cast<double>(pressure.size());
  const int asked = full ? 1 : 0;
  if (full && !answers_constant(body, shape_of(pressure)))
    return {.value = infinity, .residual = 0, .convolutions = static_cast<double>(asked)};

  problem.approach = 1;  // of K q
  Trial trial;
  SubspaceCG cg(problem, free, none, none, trial);
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
