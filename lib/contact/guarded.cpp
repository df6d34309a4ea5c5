#include "contact/guarded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/projection.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double sufficient_decrease = 1e-4;  // Armijo's fraction
constexpr double face_reduction = 0.25;       // of |r| before violations are looked for
constexpr double face_goal = 0.9;             // of the tolerance, for max|r| on a face
constexpr int face_steps = 200;
constexpr double divergence = 1e3;  // of |r| over its least: at round-off directions are noise, and add up
constexpr int updates_before_refresh = 50;
constexpr double far_from_datum = 100;  // displacements: round-off of g is then 1e-14 of them

}  // namespace

GuardedGradients::GuardedGradients(ElasticOperator& influence, ContactProblem& problem, Limits limits)
    : influence_(influence),
      problem_(problem),
      limits_(limits),
      face_gradients_(influence_, problem, trial_) {}

ContactStop GuardedGradients::solve(Field p, Field g, bool near, const Observer& observe) {
  begin(std::move(p), std::move(g));
  if (!near) begin_gradient_steps(3);
  while (!finished()) {
    if (observe) observe(residual_, influence_);
    if (gradient_steps_left_ > 0)
      gradient_step();
    else if (stalled())
      begin_gradient_steps(6);
    else
      face_step();
  }
  if (observe) observe(residual_, influence_);
  return stop_;
}

void GuardedGradients::begin(Field p, Field g) {
  p_ = std::move(p);
  g_ = std::move(g);
  halved_from_ = best_ = infinity;
  if (g_.size() > 0) return;
  if (!clip_and_rescale(problem_, p_)) project(problem_, p_);
  refresh();
  if (problem_.approach) scale_start();
}

// The multiple of the start that has the least energy.
void GuardedGradients::scale_start() {
  const double work = ((*problem_.approach - problem_.h) * p_).sum(), stored = ((g_ - problem_.h) * p_).sum();
  if (!(work > 0 && stored > 0)) return;
  const double factor = std::min(work / stored, problem_.cap / p_.maxCoeff());
  p_ = (factor * p_).min(problem_.cap);
  g_ = problem_.h + factor * (g_ - problem_.h);
}

// g = h + K p, the load restored to round-off first.
void GuardedGradients::refresh() {
  clip_and_rescale(problem_, p_);
  influence_.apply(p_, g_);
  g_ += problem_.h;
  updates_ = 0;
}

// ε, with δ near the datum.
void GuardedGradients::look() {
  residual_ = contact_residual(problem_, p_, g_);
  const double far = residual_.approach;
  if (!(std::abs(far) > far_from_datum * residual_.scale && residual_.scale > 0)) return;
  problem_.shift(far);
  g_ -= far;
  residual_ = contact_residual(problem_, p_, g_);
}

bool GuardedGradients::finished() {
  if (updates_ >= updates_before_refresh) refresh();
  look();
  if (residual_.epsilon <= limits_.tolerance) {
    stop_ = ContactStop::converged;
    return true;
  }
  rounds_without_gain_ = residual_.epsilon < best_ ? 0 : rounds_without_gain_ + 1;
  best_ = std::min(best_, residual_.epsilon);
  if (best_ < round_off_floor && rounds_without_gain_ > 10) {
    stop_ = ContactStop::round_off;
    return true;
  }
  stop_ = ContactStop::convolution_limit;
  return influence_.convolutions >= limits_.convolutions;
}

bool GuardedGradients::stalled() {
  if (residual_.epsilon < halved_from_ / 2) {
    halved_from_ = residual_.epsilon;
    rounds_without_half_ = 0;
  } else if (++rounds_without_half_ >= 4) {
    halved_from_ = residual_.epsilon;
    rounds_without_half_ = 0;
    return true;
  }
  return false;
}

void GuardedGradients::begin_gradient_steps(int count) {
  gradient_steps_left_ = count;
  gradient_steps_ = 0;
  alpha_ = 0.5 / problem_.self_influence;
}

void GuardedGradients::gradient_step() {
  --gradient_steps_left_;
  trial_.p = p_ - alpha_ * (g_ - residual_.approach);
  project(problem_, trial_.p);
  const Eigen::Array2d along = look_towards_trial();
  const double slope = along[0], curvature = along[1];
  if (!(slope < 0)) {
    gradient_steps_left_ = 0;
    return;
  }
  move(curvature > 0 ? std::min(1.0, -slope / curvature) : 1);
  if (!(curvature > 0)) return;
  // Barzilai's and Borwein's two steps in turn.
  const bool long_step = ++gradient_steps_ % 2 == 1;
  alpha_ = long_step ? trial_.d.square().sum() / curvature : curvature / trial_.q.square().sum();
}

void GuardedGradients::face_step() {
  face_.set(problem_, p_, g_, residual_.approach);
  if (face_.cells < (problem_.approach ? 1 : 2)) return begin_gradient_steps(3);
  minimise_on_face();
  if (face_gradients_.steps() == 0)
    begin_gradient_steps(5);
  else if (face_gradients_.out_of_bounds())
    guarded_step();
  else
    take_minimum();
}

void GuardedGradients::minimise_on_face() {
  face_gradients_.begin(face_, p_, g_);
  const double goal = face_goal * limits_.tolerance * residual_.scale;
  double reference = face_gradients_.norm(), least = reference;
  while (face_gradients_.steps() < face_steps && face_gradients_.step() && face_gradients_.largest() > goal) {
    least = std::min(least, face_gradients_.norm());
    if (face_gradients_.norm() > divergence * least) break;
    if (face_gradients_.norm() > face_reduction * reference) continue;
    if (face_gradients_.out_of_bounds() || face_gradients_.face_too_small()) break;
    reference = face_gradients_.norm();
  }
}

void GuardedGradients::take_minimum() {
  std::swap(p_, trial_.p);
  std::swap(g_, trial_.g);
  updates_ += face_gradients_.steps();
}

void GuardedGradients::guarded_step() {
  if (!clip_and_rescale(problem_, trial_.p)) return begin_gradient_steps(6);
  const Eigen::Array2d along = look_towards_trial();
  const double slope = along[0], curvature = along[1];
  if (slope < 0 && slope + curvature / 2 <= sufficient_decrease * slope) return move(1);
  if (slope < 0 && curvature > 0) move(std::min(1.0, -slope / curvature));
  begin_gradient_steps(6);
}

Eigen::Array2d GuardedGradients::look_towards_trial() {
  trial_.d = trial_.p - p_;
  influence_.apply(trial_.d, trial_.q);
  return problem_.blocks().sum([&](Block b) {
    const auto d = b.of(trial_.d);
    return Eigen::Array2d(((b.of(g_) - residual_.approach) * d).sum(), (d * b.of(trial_.q)).sum());
  });
}

void GuardedGradients::move(double lambda) {
  if (lambda == 1) std::swap(p_, trial_.p);  // p + d would miss the bounds by round-off
  problem_.blocks().each([&](Block b) {
    if (lambda < 1) b.of(p_) = (b.of(p_) + lambda * b.of(trial_.d)).max(0.0).min(problem_.cap);
    b.of(g_) += lambda * b.of(trial_.q);
  });
  ++updates_;
}

}  // namespace asperity
