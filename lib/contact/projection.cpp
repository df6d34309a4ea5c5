#include "contact/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double load_round_off = 1e-15;
constexpr double saturation = 1e-12;  // a load this close to n c leaves no cell free

void clip(const ContactProblem& problem, Field& p, double shift) {
  problem.blocks().each([&](Block block) { block.of(p) = (block.of(p) + shift).max(0.0).min(problem.cap); });
}

// Σ of the free cells, of those at the limit, and the number of free cells, were p shifted and clipped.
Eigen::Array3d shares(const ContactProblem& problem, const Field& p, double shift) {
  return problem.blocks().sum([&](Block block) {
    Eigen::Array3d part = Eigen::Array3d::Zero();
    for (double x : block.of(p)) {
      const double v = x + shift;
      if (problem.is_free(v))
        part += Eigen::Array3d(v, 0, 1);
      else if (v > 0)
        part[1] += problem.cap;
    }
    return part;
  });
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  void operator+=(const Range& other) {
    least = std::min(least, other.least);
    largest = std::max(largest, other.largest);
  }
};

double shift_to_load(const ContactProblem& problem, const Field& p) {
  const double mean = problem.sum / static_cast<double>(problem.shape().cells());
  const Range range = problem.blocks().sum([&](Block b) {
    return Range{b.of(p).minCoeff(), b.of(p).maxCoeff()};
  });
  double low = -range.largest, high = mean - range.least, shift = std::min(0.0, high);
  for (int i = 0; i < 200; ++i) {
    if (!(shift > low && shift < high)) shift = (low + high) / 2;
    const Eigen::Array3d share = shares(problem, p, shift);
    const double excess = share[0] + share[1] - problem.sum, free_cells = share[2];
    (excess > 0 ? high : low) = shift;
    if (std::abs(excess) <= load_round_off * problem.sum || high - low <= load_round_off * std::abs(high))
      break;
    shift = free_cells > 0 ? shift - excess / free_cells : low;  // low: bisect
  }
  return shift;
}

// Without a limit pressure one factor does it.
bool rescale_uncapped(const ContactProblem& problem, Field& p) {
  const double sum = problem.blocks().sum([&](Block b) { return b.of(p).max(0.0).sum(); });
  const double factor = sum > 0 ? problem.sum / sum : 1;
  problem.blocks().each([&](Block b) { b.of(p) = factor * b.of(p).max(0.0); });
  return sum > 0;
}

bool rescale_capped(const ContactProblem& problem, Field& p) {
  if (problem.sum >= (1 - saturation) * problem.cap * static_cast<double>(problem.shape().cells())) {
    p.setConstant(problem.cap);
    return true;
  }
  clip(problem, p, 0);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Array3d share = shares(problem, p, 0);
    const double wanted = problem.sum - share[1];
    if (std::abs(share[0] - wanted) <= load_round_off * problem.sum) return true;
    if (!(share[0] > 0 && wanted > 0)) return false;
    const double factor = wanted / share[0];
    if (factor == 1) return true;
    problem.blocks().each([&](Block block) {
      auto cells = block.of(p);
      cells = (cells < problem.cap).select((cells * factor).min(problem.cap), cells);
    });
  }
  return true;
}

}  // namespace

void project(const ContactProblem& problem, Field& p) {
  clip(problem, p, problem.approach ? 0 : shift_to_load(problem, p));
}

bool clip_and_rescale(const ContactProblem& problem, Field& p) {
  if (problem.approach) return clip(problem, p, 0), true;
  return problem.capped() ? rescale_capped(problem, p) : rescale_uncapped(problem, p);
}

}  // namespace asperity
