#include "contact/windowed.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "contact/problem.hpp"

namespace asperity {

Field ContactWindow::of(const Field& f, const Slabs& field, const Slabs& part) const {
  const Extent wanted{x.first + part.own().first, part.own().count};
  const auto columns = f.middleCols(y.first, y.count);
  return field.shared() ? rows_of(columns, field, wanted)
                        : Field(columns.middleRows(wanted.first, wanted.count));
}

void ContactWindow::put(const Field& values, const Slabs& part, Field& f, const Slabs& field) const {
  const Extent own = field.own();
  const Index first = std::max(own.first, x.first),
              count = std::max<Index>(0, std::min(own.end(), x.end()) - first);
  f.block(count > 0 ? first - own.first : 0, y.first, count, y.count) =
      rows_of(values, part, Extent{first - x.first, count});
}

ContactWindow least_of_all(const Ranks& ranks, const ContactWindow& own) {
  ContactWindow out;
  for (const ContactWindow& one : gathered(ranks, std::vector{own})) out = united(out, one);
  return out;
}

namespace {

using namespace contact;

double share_of(Shape part, const ContactProblem& problem) {
  return static_cast<double>(part.cells()) / static_cast<double>(problem.shape().cells());
}

// Under a given approach, where nothing is pushed back, the contact of the undeformed bodies.
Field pushed_back(const ContactProblem& problem, Field p) {
  p = p.max(0.0);
  if (!problem.approach) return p;
  const double work = problem.blocks().sum(
      [&](Block b) { return ((*problem.approach - b.of(problem.h)) * b.of(std::as_const(p))).sum(); });
  if (work > 0) return p;
  return ((*problem.approach - problem.h) / problem.self_influence).max(0.0);
}

// The least window of a contact that is worth a body of its own, else the whole.
WindowBody body_around(const ContactWindow& contact, const ContactProblem& problem, Index margin_part) {
  const Shape domain = problem.shape();
  WindowBody body{contact, whole(domain), nullptr};
  if (contact.empty()) return body;
  const Index margin = least_margin + std::max(contact.x.count, contact.y.count) / margin_part;
  const ContactWindow least = widened(contact, margin, domain);
  const bool carries = problem.approach ||
                       spare_cells * problem.sum < problem.cap * static_cast<double>(least.shape().cells());
  if (carries) body.influence = problem.influence->windowed(least.shape());
  if (body.influence) body.window = enlarged(least, body.influence->shape(), domain);
  return body;
}

// On some of the cells; adds to x what it took, by their share.
void minimise_on(ContactProblem& problem, ContactStart start, double share, const WindowedLimits& limits,
                 const ContactObserver& observe, ContactSolution& x) {
  const double convolutions = x.convolutions, preconditionings = x.preconditionings;
  ContactObserver shared;
  if (observe)
    shared = [&](const ContactResidual& residual, double done) {
      observe(residual, convolutions + share * done);
    };
  x = minimise(problem, std::move(start), limits.tolerance, (limits.convolutions - convolutions) / share,
               shared);
  x.convolutions = convolutions + share * x.convolutions;
  x.preconditionings = preconditionings + share * x.preconditionings;
}

void minimise_on_body(ContactProblem& problem, bool near, const WindowedLimits& limits,
                      const ContactObserver& observe, WindowedSolution& x) {
  ContactStart start{std::move(x.p), std::move(x.g), near};
  if (!x.body.influence) return minimise_on(problem, std::move(start), 1, limits, observe, x);

  const ContactWindow& window = x.body.window;
  const Slabs all = problem.slabs(), within = x.body.influence->slabs();
  auto inside = [&](const Field& f) { return f.size() > 0 ? window.of(f, all, within) : Field(); };
  ContactProblem part = problem.on(*x.body.influence, inside(problem.h));
  minimise_on(part, {inside(start.p), inside(start.g), near}, share_of(part.shape(), problem), limits,
              observe, x);
  window.put(x.p, within, start.p, all);
  x.p = std::move(start.p);
  x.g = std::move(start.g);
  if (part.datum != problem.datum) problem.shift(part.datum - problem.datum);
  x.fresh = false;
}

// ε of g = h + K p on the whole grid, the load restored to round-off.
void confirm(const ContactProblem& problem, ContactSolution& x) {
  if (x.fresh) return;
  clip_and_rescale(problem, x.p);
  problem.influence->apply(x.p, x.g);
  x.g += problem.h;
  ++x.convolutions;
  x.residual = contact_residual(problem, x.p, x.g);
  x.fresh = true;
}

}  // namespace

WindowedSolution minimise_on_window(ContactProblem& problem, Field start, bool near,
                                    const WindowedLimits& limits, const ContactObserver& observe) {
  WindowedSolution x;
  x.p = pushed_back(problem, std::move(start));
  x.body = body_around(window_of(x.p, problem.slabs(), [](double p) { return p > 0; }), problem,
                       limits.margin_part);
  Stagnation gain(1);
  for (;; near = true) {
    minimise_on_body(problem, near, limits, observe, x);
    if (!x.body.influence && !limits.confirm) return x;
    confirm(problem, x);
    const double epsilon = x.residual.epsilon;
    if (epsilon <= limits.tolerance) x.stop = ContactStop::converged;
    if (epsilon <= limits.tolerance || x.stop == ContactStop::convolution_limit) return x;

    // At round-off the iteration may end far from its best: then it goes on for some rounds.
    const bool no_gain = gain.add(epsilon) > grid_rounds_without_gain;
    const bool exhausted = epsilon < round_off_floor && (x.stop == ContactStop::round_off || no_gain);
    const auto overlaps = [approach = x.residual.approach](double g) { return g < approach; };
    const ContactWindow contact = united(x.body.contact, window_of(x.g, problem.slabs(), overlaps));
    if (united(x.body.window, contact) != x.body.window) {
      x.body = body_around(contact, problem, limits.margin_part);
    } else if (exhausted) {
      x.stop = ContactStop::round_off;
      return x;
    }
  }
}

}  // namespace asperity
