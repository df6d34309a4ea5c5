#include "contact/windowed.hpp"

#include <algorithm>

#include "contact/projection.hpp"

namespace asperity {
namespace {

constexpr Index least_margin = 4;
constexpr double spare_cells = 1.25;  // of those that the limit pressure needs for the load

ContactProblem on_window(const ContactProblem& problem, const Window& window) {
  ContactProblem part = problem.without_gap();
  part.h = window.of(problem.h);
  return part;
}

// Under a given approach a contact lies where the undeformed bodies overlap: a start for want of one that they
// push back.
void overlap(const ContactProblem& problem, Field& p) {
  if (!problem.approach || ((*problem.approach - problem.h) * p).sum() > 0) return;
  p = ((*problem.approach - problem.h) / problem.self_influence).max(0.0);
}

}  // namespace

ContactStop WindowedGradients::solve(Field start, bool near, const Observer& observe) {
  p_ = std::move(start);
  p_ = p_.max(0.0);
  overlap(problem_, p_);
  choose(contact_window(p_));
  while (true) {
    const ContactStop stop = minimise(near, observe);
    if (is_whole() && !limits_.confirm) return stop;
    confirm();
    if (residual_.epsilon <= limits_.tolerance) return ContactStop::converged;
    if (stop == ContactStop::convolution_limit) return stop;
    const Window before = window_;
    choose(united(contact_, overlap_window(g_, residual_.approach)));
    if (at_round_off(stop) && window_ == before) return ContactStop::round_off;
    near = true;
  }
}

// W for a contact of this extent.
void WindowedGradients::choose(const Window& contact) {
  const Shape domain = influence_.shape();
  if (!window_.empty() && united(window_, contact) == window_) return;
  contact_ = contact;
  on_window_.reset();
  window_ = whole(domain);
  if (contact.empty()) return;
  const Index margin = least_margin + std::max(contact.shape.nx, contact.shape.ny) / limits_.margin_part;
  const Window least = widened(contact, margin, domain);
  const bool carries = problem_.approach ||
                       spare_cells * problem_.sum < problem_.cap * static_cast<double>(least.shape.cells());
  if (carries) on_window_ = influence_.windowed(least.shape);
  if (on_window_) window_ = enlarged(least, on_window_->shape(), domain);
}

ContactStop WindowedGradients::minimise(bool near, const Observer& observe) {
  if (is_whole()) return minimise(influence_, problem_, p_, g_, near, observe);
  ContactProblem problem = on_window(problem_, window_);
  Field p = window_.of(p_), g = g_.size() > 0 ? window_.of(g_) : Field();
  const ContactStop stop = minimise(*on_window_, problem, p, g, near, observe);
  window_.put(p, p_);
  if (problem.datum != problem_.datum) problem_.shift(problem.datum - problem_.datum);
  fresh_ = false;
  return stop;
}

ContactStop WindowedGradients::minimise(ElasticOperator& influence, ContactProblem& problem, Field& p,
                                        Field& g, bool near, const Observer& observe) {
  const double share = static_cast<double>(p.size()) / static_cast<double>(problem_.h.size());
  const double limit = (limits_.convolutions - convolutions_) / share;
  GuardedGradients gradients(influence, problem, {limits_.tolerance, limit});
  const ContactStop stop = gradients.solve(std::move(p), std::move(g), near,
                                           [&](const ContactResidual& residual, const CountedOperator& work) {
                                             if (observe)
                                               observe(residual, convolutions_ + share * work.convolutions);
                                           });
  convolutions_ += share * gradients.work().convolutions;
  preconditionings_ += share * gradients.work().preconditionings;
  fresh_ = gradients.gap_is_fresh();
  residual_ = gradients.residual();
  p = std::move(gradients.pressure());
  g = std::move(gradients.gap());
  return stop;
}

// ε of g = h + K p on the whole grid, the load restored to round-off.
void WindowedGradients::confirm() {
  if (fresh_) return;
  clip_and_rescale(problem_, p_);
  influence_.apply(p_, g_);
  g_ += problem_.h;
  ++convolutions_;
  residual_ = contact_residual(problem_, p_, g_);
  fresh_ = true;
}

// ε of the grid is there, and the window says so or some rounds have not lowered it. At round-off the iteration may
// end far from its best: then it goes on.
bool WindowedGradients::at_round_off(ContactStop on_window) {
  rounds_without_gain_ = residual_.epsilon < best_ ? 0 : rounds_without_gain_ + 1;
  best_ = std::min(best_, residual_.epsilon);
  return residual_.epsilon < round_off_floor &&
         (on_window == ContactStop::round_off || rounds_without_gain_ > 3);
}

}  // namespace asperity
