#include "contact/bound_constrained_cg.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "contact/calibration.hpp"
#include "contact/problem.hpp"
#include "contact/relaxation.hpp"
#include "contact/subspace_cg.hpp"

namespace asperity {
namespace {

using namespace contact;

// The iterate, and what the steps to the next one work with.
struct Iteration : ContactSolution {
  ContactProblem& problem;
  int updates = 0;  // of g by recurrence
  Trial trial = {};
  std::unique_ptr<TwoLevel> two_level = {};  // both on fine grids alone
  std::unique_ptr<Relaxation> relaxation = {};
  bool relax_next = false;

  bool is_ragged(double least) const { return two_level && two_level->raggedness() > least; }
  void apply(const Field& pressure, Field& displacement) {
    ++convolutions;
    problem.influence->apply(pressure, displacement);
  }
};

// Projected gradient steps to come.
struct GradientSteps {
  int left = 0;
  double alpha = 0;  // [Pa/m]
  bool long_step = true;
};

GradientSteps gradient_steps(const ContactProblem& problem, int count) {
  return {count, first_step / problem.self_influence};
}

// g = h + K p, the load restored to round-off first.
void refresh(Iteration& x) {
  clip_and_rescale(x.problem, x.p);
  x.apply(x.p, x.g);
  x.g += x.problem.h;
  x.updates = 0;
}

// Of the load and in the bodies, under pressures up to the largest.
struct Work {
  double done = 0, stored = 0, largest = 0;
  void operator+=(const Work& other) {
    done += other.done;
    stored += other.stored;
    largest = std::max(largest, other.largest);
  }
};

// The multiple of the start that has the least energy under a given approach.
void scale_to_least_energy(Iteration& x) {
  const Field& h = x.problem.h;
  const Work of = x.problem.blocks().sum([&](Block b) {
    const auto p = b.of(std::as_const(x.p)), hb = b.of(h);
    return Work{((*x.problem.approach - hb) * p).sum(), ((b.of(x.g) - hb) * p).sum(), p.maxCoeff()};
  });
  if (!(of.done > 0 && of.stored > 0)) return;
  const double factor = std::min(of.done / of.stored, x.problem.cap / of.largest);
  x.p = (factor * x.p).min(x.problem.cap);
  x.g = h + factor * (x.g - h);
}

Iteration first_iterate(ContactProblem& problem, ContactStart start) {
  Iteration x{{std::move(start.p), std::move(start.g)}, problem};
  if (TwoLevel::suits(problem.shape())) {
    x.two_level = std::make_unique<TwoLevel>(*problem.influence, problem.threads);
    x.relaxation = std::make_unique<Relaxation>(*problem.influence, problem.threads);
  }
  if (x.g.size() > 0) return x;
  if (!clip_and_rescale(problem, x.p)) project(problem, x.p);
  refresh(x);
  if (problem.approach) scale_to_least_energy(x);
  return x;
}

// ε, with δ near the datum.
void evaluate(Iteration& x) {
  x.residual = contact_residual(x.problem, x.p, x.g);
  const double far = x.residual.approach;
  if (!(std::abs(far) > far_from_datum * x.residual.scale && x.residual.scale > 0)) return;
  x.problem.shift(far);
  x.g -= far;
  x.residual = contact_residual(x.problem, x.p, x.g);
}

// Why the iteration ends here, if it does.
std::optional<ContactStop> end(const Iteration& x, double tolerance, double convolutions, Stagnation& gain) {
  if (x.residual.epsilon <= tolerance) return ContactStop::converged;
  const int rounds = gain.add(x.residual.epsilon);
  if (gain.mark() < round_off_floor && rounds > rounds_without_gain) return ContactStop::round_off;
  if (x.convolutions >= convolutions) return ContactStop::convolution_limit;
  return {};
}

// The energy along d = trial - p, with q = K d.
struct Line {
  double slope = 0, curvature = 0;  // (g - δ)·d, d·q
  double lowest() const { return std::min(1.0, -slope / curvature); }
};

Line line_to_trial(Iteration& x) {
  Trial& trial = x.trial;
  trial.d = trial.p - x.p;
  ++x.convolutions;
  x.problem.influence->apply_single(trial.d, trial.q);
  const Eigen::Array2d sums = x.problem.blocks().sum([&](Block b) {
    const auto d = b.of(trial.d);
    return Eigen::Array2d(((b.of(x.g) - x.residual.approach) * d).sum(), (d * b.of(trial.q)).sum());
  });
  return {sums[0], sums[1]};
}

// p += λ d, g += λ q, 0 ≤ λ ≤ 1; the trial itself for λ = 1, for p + d would miss the bounds by round-off.
void move(Iteration& x, double lambda) {
  if (lambda == 1) std::swap(x.p, x.trial.p);
  x.problem.blocks().each([&](Block b) {
    if (lambda < 1) b.of(x.p) = (b.of(x.p) + lambda * b.of(x.trial.d)).max(0.0).min(x.problem.cap);
    b.of(x.g) += lambda * b.of(x.trial.q);
  });
  ++x.updates;
}

void gradient_step(Iteration& x, GradientSteps& steps) {
  --steps.left;
  x.trial.p = x.p - steps.alpha * (x.g - x.residual.approach);
  project(x.problem, x.trial.p);
  const Line line = line_to_trial(x);
  if (!(line.slope < 0)) {
    steps.left = 0;
    return;
  }
  move(x, line.curvature > 0 ? line.lowest() : 1);
  if (!(line.curvature > 0)) return;
  // Barzilai's and Borwein's two steps in turn.
  auto squared = [&](const Field& f) {
    return x.problem.blocks().sum([&](Block b) { return b.of(f).square().sum(); });
  };
  steps.alpha = steps.long_step ? squared(x.trial.d) / line.curvature : line.curvature / squared(x.trial.q);
  steps.long_step = !steps.long_step;
}

// How many gradient steps are to follow.
int relaxation_step(Iteration& x) {
  x.trial.p = x.p;
  x.trial.g = x.g;
  x.relaxation->relax(x.trial.p, x.trial.g, x.residual.approach, x.problem.cap, sweeps_of_step);
  if (!clip_and_rescale(x.problem, x.trial.p)) return steps_after_cut;
  const Line line = line_to_trial(x);
  if (!(line.slope < 0 && line.curvature > 0)) return steps_after_cut;
  move(x, line.lowest());
  return 0;
}

// How many gradient steps are to follow. `level`: the mean gap of the free set on which the trial was found.
int guarded_step(Iteration& x, double level) {
  if (x.is_ragged(ragged_to_relax))
    x.relaxation->relax(x.trial.p, x.trial.g, level, x.problem.cap, sweeps_of_guarded_step);
  if (!clip_and_rescale(x.problem, x.trial.p)) return steps_after_cut;
  const auto [slope, curvature] = line_to_trial(x);
  if (slope < 0 && slope + curvature / 2 <= sufficient_decrease * slope) return move(x, 1), 0;
  if (slope < 0 && curvature > 0) move(x, Line{slope, curvature}.lowest());
  x.relax_next = x.is_ragged(ragged_to_relax);
  return x.relax_next ? 0 : steps_after_cut;
}

void minimise(SubspaceCG& cg, double wanted, double reduction) {
  double reference = cg.residual().norm(), least = reference;
  while (cg.steps() < subspace_steps && cg.step() && cg.residual().largest > wanted) {
    const double norm = cg.residual().norm();
    least = std::min(least, norm);
    if (norm > divergence * least) break;
    if (norm > reduction * reference) continue;
    if (cg.out_of_bounds() || cg.set_too_small()) break;
    reference = norm;
  }
}

// F, and whether it is so ragged that the two-level preconditioner pays, which is then set to it.
std::pair<FreeSet, bool> free_set(Iteration& x) {
  FreeSet free(x.problem, x.p, x.g, x.residual.approach);
  if (x.two_level) x.two_level->set(free.mask);
  if (!x.is_ragged(ragged_for_blocks)) return {std::move(free), false};
  free.proportion(x.problem, x.p, x.g, x.residual.approach);
  x.two_level->set(free.mask);
  return {std::move(free), true};
}

// How many gradient steps are to follow.
int subspace_step(Iteration& x, double tolerance) {
  const auto [free, ragged] = free_set(x);
  if (free.cells < (x.problem.approach ? 1 : 2)) return steps_at_start;
  SubspaceCG cg(x.problem, free, x.p, x.g, x.trial, ragged ? x.two_level.get() : nullptr);
  minimise(cg, goal * tolerance * x.residual.scale, ragged ? ragged_reduction : reduction);
  x.convolutions += cg.applications();
  x.preconditionings += cg.applications();
  if (cg.steps() == 0) return steps_after_failure;
  if (cg.out_of_bounds()) return guarded_step(x, cg.level());
  std::swap(x.p, x.trial.p);
  std::swap(x.g, x.trial.g);
  x.updates += cg.steps();
  return 0;
}

}  // namespace

ContactSolution minimise(ContactProblem& problem, ContactStart start, double tolerance, double convolutions,
                         const ContactObserver& observe) {
  GradientSteps gradient = gradient_steps(problem, start.near ? 0 : steps_at_start);
  Iteration x = first_iterate(problem, std::move(start));
  Stagnation gain(1), halving(0.5);
  while (true) {
    if (x.updates >= updates_of_gap) refresh(x);
    evaluate(x);
    if (observe) observe(x.residual, x.convolutions);
    if (const auto stop = end(x, tolerance, convolutions, gain)) {
      x.stop = *stop;
      x.fresh = x.updates == 0;
      return x;
    }
    if (std::exchange(x.relax_next, false)) {
      gradient = gradient_steps(problem, relaxation_step(x));
    } else if (gradient.left > 0) {
      gradient_step(x, gradient);
    } else if (halving.add(x.residual.epsilon) >= rounds_to_halve) {
      halving.restart(x.residual.epsilon);
      gradient = gradient_steps(problem, steps_after_cut);
    } else {
      gradient = gradient_steps(problem, subspace_step(x, tolerance));
    }
  }
}

}  // namespace asperity
