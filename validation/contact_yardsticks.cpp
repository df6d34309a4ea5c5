#include "contact_yardsticks.hpp"

#include <cmath>

#include "contact/problem.hpp"

namespace asperity {
namespace {

constexpr int steps_before_refresh = 50;

Field even_start(const ContactProblem& problem) {
  return Field::Constant(problem.h.rows(), problem.h.cols(),
                         problem.sum / static_cast<double>(problem.h.size()));
}

Field gap_under(const ContactProblem& problem, const Field& p) {
  Field g;
  problem.influence->apply(p, g);
  return g + problem.h;
}

// Lets cells at a bound that overlap, or gape at the limit, move by `step` of that; whether there were any.
bool release(const ContactProblem& problem, const Field& r, double step, Field& p) {
  bool any = false;
  for (Index i = 0; i < p.size(); ++i) {
    double& x = p.data()[i];
    const double driven = r.data()[i];
    if (!((x <= 0 && driven < 0) || (x >= problem.cap && driven > 0))) continue;
    x -= step * driven;
    any = true;
  }
  return any;
}

}  // namespace

void polonsky_keer(const ContactProblem& problem, const Watch& watch) {
  Field p = even_start(problem), g = gap_under(problem, p), t = 0 * p, q;
  double norm_old = 1;
  int convolutions = 1, since_refresh = 0;
  bool conjugate = false;
  while (true) {
    const ContactResidual residual = contact_residual(problem, p, g);
    if (!watch(residual, convolutions)) return;
    const Field free = (p > 0 && p < problem.cap).cast<double>(), r = g - residual.approach;
    const double norm = (free * r.square()).sum();
    t = free * (r + (conjugate ? norm / norm_old : 0) * t);
    norm_old = norm;
    problem.influence->apply(t, q);
    ++convolutions;
    const double step = (r * t).sum() / ((q - (free * q).sum() / free.sum()) * t).sum();
    const Field wanted = p - step * t;
    p = wanted.max(0.0).min(problem.cap);
    const bool cut = (p != wanted).any(), released = release(problem, r, step, p);
    conjugate = !released;
    if (!clip_and_rescale(problem, p)) project(problem, p);
    g -= step * q;
    if (!cut && !released && ++since_refresh < steps_before_refresh) continue;
    g = gap_under(problem, p);
    ++convolutions;
    since_refresh = 0;
  }
}

void projected_gradient(const ContactProblem& problem, const Watch& watch) {
  Field p = even_start(problem), g = gap_under(problem, p), q;
  double alpha = 0.5 / problem.self_influence;
  int convolutions = 1;
  for (int step = 0;; ++step) {
    const ContactResidual residual = contact_residual(problem, p, g);
    if (!watch(residual, convolutions)) return;
    Field target = p - alpha * (g - residual.approach);
    project(problem, target);
    const Field d = target - p;
    problem.influence->apply(d, q);
    ++convolutions;
    const double slope = ((g - residual.approach) * d).sum(), curvature = (d * q).sum();
    if (!(slope < 0 && curvature > 0)) return;
    const double lambda = std::min(1.0, -slope / curvature);
    p = (p + lambda * d).max(0.0).min(problem.cap);
    g += lambda * q;
    alpha = step % 2 == 1 ? d.square().sum() / curvature : curvature / q.square().sum();
    if (step % steps_before_refresh != steps_before_refresh - 1) continue;
    g = gap_under(problem, p);
    ++convolutions;
  }
}

}  // namespace asperity
