#include "contact/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "contact/calibration.hpp"
#include "core/error.hpp"
#include "core/halved.hpp"
#include "core/parallel.hpp"

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
      const double p_i = pb[i], g_i = gb[i], u = g_i - hb[i];
      const int open = p_i <= 0, at_cap = p_i >= cap, is_free = (open | at_cap) ^ 1;
      sum += p_i;
      free += is_free;
      plastic += at_cap;
      free_gap += is_free * g_i;
      lowest_open = std::min(lowest_open, open != 0 ? g_i : infinity);
      highest_plastic = std::max(highest_plastic, at_cap != 0 ? g_i : -infinity);
      lowest = std::min(lowest, u);
      highest = std::max(highest, u);
      max_pressure = std::max(max_pressure, p_i);
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

bool can_coarsen(Shape shape) {
  return shape.nx % 2 == 0 && shape.ny % 2 == 0 && std::min(shape.nx, shape.ny) / 2 >= contact::least_side;
}

// On a quarter of the cells.
ContactProblem coarsened(const ContactProblem& problem, ElasticOperator& body) {
  const Slabs slabs = problem.slabs();
  Field h = halved(problem.h, problem.threads);
  if (slabs.shared()) h = rows_of(h, slabs.coarsened(2), body.slabs().own());
  ContactProblem coarse = problem.on(body, std::move(h));
  coarse.sum /= 4;
  coarse.self_influence = body.self_influence();
  return coarse;
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

void project(const ContactProblem& problem, Field& p) {
  clip(problem, p, problem.approach ? 0 : shift_to_load(problem, p));
}

bool clip_and_rescale(const ContactProblem& problem, Field& p) {
  if (problem.approach) return clip(problem, p, 0), true;
  return problem.capped() ? rescale_capped(problem, p) : rescale_uncapped(problem, p);
}

std::vector<CoarseLevel> coarser_levels(const ContactProblem& problem) {
  std::vector<CoarseLevel> levels;
  for (const ContactProblem* finer = &problem; can_coarsen(finer->shape()); finer = &levels.back().problem) {
    auto body = finer->influence->coarsened(2);
    ContactProblem coarse = coarsened(*finer, *body);
    levels.push_back({std::move(body), std::move(coarse)});
  }
  return levels;
}

Field prolonged(const Field& coarse, const Slabs& from, const Slabs& to, Periodic periodic, int threads) {
  auto beyond = [](Index i, Index n, bool around) {
    return around ? (i + n) % n : std::clamp<Index>(i, 0, n - 1);
  };
  const Extent own = to.own();
  const Index before = own.first / 2 - 1;
  std::vector<Index> wanted;
  for (Index I = before; I <= (own.end() + 1) / 2; ++I) wanted.push_back(beyond(I, from.rows(), periodic.x));
  const Field rows = rows_of(coarse, from, wanted);
  Field fine(own.count, 2 * coarse.cols());
  parallel_ranges(fine.rows(), threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i) {
      const Index I = (own.first + i) / 2 - before, beside = i % 2 ? I + 1 : I - 1;
      for (Index J = 0; J < rows.cols(); ++J) {
        const Index left = beyond(J - 1, rows.cols(), periodic.y),
                    right = beyond(J + 1, rows.cols(), periodic.y);
        auto blend = [&](Index j) {
          return (9 * rows(I, J) + 3 * (rows(beside, J) + rows(I, j)) + rows(beside, j)) / 16;
        };
        const bool touches = rows(I, J) > 0;
        fine(i, 2 * J) = touches ? blend(left) : 0;
        fine(i, 2 * J + 1) = touches ? blend(right) : 0;
      }
    }
  });
  return fine;
}

}  // namespace asperity
