#include "contact/problem.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What one pass over p and g collects.
struct Totals {
  double sum = 0;                                 // Σp
  double free_gap = 0;                            // Σ g over the free cells
  double lowest_open = infinity;                  // min g over p = 0
  double highest_plastic = -infinity;             // max g over p = c
  double lowest = infinity, highest = -infinity;  // of u
  double max_pressure = 0;
  double free = 0, plastic = 0;  // cells

  void operator+=(const Totals& other) {
    sum += other.sum;
    free_gap += other.free_gap;
    lowest_open = std::min(lowest_open, other.lowest_open);
    highest_plastic = std::max(highest_plastic, other.highest_plastic);
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
    max_pressure = std::max(max_pressure, other.max_pressure);
    free += other.free;
    plastic += other.plastic;
  }

  double approach() const {
    if (free > 0) return free_gap / free;
    if (plastic == 0) return lowest_open;
    return std::isfinite(lowest_open) ? (highest_plastic + lowest_open) / 2 : highest_plastic;
  }
};

Totals totals(const ContactProblem& problem, const Field& p, const Field& g) {
  return problem.blocks().sum([&, cap = problem.cap](Block block) {
    const auto pb = block.of(p), gb = block.of(g), hb = block.of(problem.h);
    double sum = 0, free_gap = 0, free = 0, plastic = 0, max_pressure = 0;
    double lowest_open = infinity, highest_plastic = -infinity, lowest = infinity, highest = -infinity;
#pragma omp simd reduction(+ : sum, free_gap, free, plastic) reduction(min : lowest, lowest_open) \
    reduction(max : max_pressure, highest, highest_plastic)
    for (Index i = 0; i < block.size; ++i) {
      const double pi = pb[i], gi = gb[i], u = gi - hb[i];
      const int open = pi <= 0, at_cap = pi >= cap, is_free = (open | at_cap) ^ 1;
      sum += pi;
      free += is_free;
      plastic += at_cap;
      free_gap += is_free * gi;
      lowest_open = std::min(lowest_open, open != 0 ? gi : infinity);
      highest_plastic = std::max(highest_plastic, at_cap != 0 ? gi : -infinity);
      lowest = std::min(lowest, u);
      highest = std::max(highest, u);
      max_pressure = std::max(max_pressure, pi);
    }
    return Totals{sum, free_gap, lowest_open, highest_plastic, lowest, highest, max_pressure, free, plastic};
  });
}

struct Largest {
  double value = 0;
  void operator+=(Largest other) { value = std::max(value, other.value); }
};

// max|w| of (3).
double largest_violation(const ContactProblem& problem, const Field& p, const Field& g, double approach) {
  const double k = problem.self_influence, limit = std::isinf(problem.cap) ? infinity : k * problem.cap;
  const auto largest = problem.blocks().sum([&](Block block) {
    const auto kp = k * block.of(p);
    return Largest{(kp - (kp - block.of(g) + approach).max(0.0).min(limit)).abs().maxCoeff()};
  });
  return largest.value;
}

}  // namespace

void ContactProblem::shift(double by) {
  h -= by;
  datum += by;
  if (approach) *approach -= by;
}

void check_carried(const char* name, double load, const Grid& grid, double cap) {
  constexpr double round_off = 1e-12;
  const double largest = cap * grid.size_x() * grid.size_y();
  if (load > largest * (1 + round_off))
    throw ParameterError(
        name, fmt::format("{} N is more than the limit pressure carries on the whole domain, {:.6g} N", load,
                          largest));
}

ContactResidual contact_residual(const ContactProblem& problem, const Field& p, const Field& g) {
  const Totals found = totals(problem, p, g);
  ContactResidual out;
  out.approach = problem.approach ? *problem.approach : found.approach();
  out.scale = std::max(found.highest - found.lowest,
                       problem.self_influence * found.sum / static_cast<double>(problem.shape().cells()));
  out.sum = found.sum;
  out.max_pressure = found.max_pressure;
  out.free = static_cast<Index>(found.free);
  out.plastic = static_cast<Index>(found.plastic);
  const double w = largest_violation(problem, p, g, out.approach);
  out.epsilon = w > 0 ? w / out.scale : 0;
  return out;
}

}  // namespace asperity
