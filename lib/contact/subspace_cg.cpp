#include "contact/subspace_cg.hpp"

#include <limits>
#include <utility>

#include "contact/calibration.hpp"

namespace asperity {

template <class In>
void FreeSet::choose(const ContactProblem& problem, const Field& p, const Field& g, In in) {
  const Eigen::Array2d sums = problem.blocks().sum([&](Block block) {
    const auto pb = block.of(p), gb = block.of(g);
    auto in_set = block.of(mask);
    double count = 0, gap = 0;
#pragma omp simd reduction(+ : count, gap)
    for (Index i = 0; i < block.size; ++i) {
      const bool chosen = in(pb[i], gb[i], in_set[i] != 0);
      in_set[i] = static_cast<std::int8_t>(chosen);
      count += chosen ? 1.0 : 0.0;
      gap += chosen ? gb[i] : 0.0;
    }
    return Eigen::Array2d(count, gap);
  });
  cells = sums[0];
  gap_sum = sums[1];
}

FreeSet::FreeSet(const ContactProblem& problem, const Field& p, const Field& g, double approach)
    : mask(static_cast<std::size_t>(p.size())) {
  choose(problem, p, g, [approach, cap = problem.cap](double pressure, double gap, bool) {
    const bool pushed = gap<approach, pulled = gap> approach;
    return pressure <= 0 ? pushed : pressure < cap || pulled;
  });
}

namespace {

// Residuals g - δ of free cells and of those that the gap drives off a bound.
struct Drive {
  double free = 0, bound = 0, largest_free = 0;  // Σr², Σr², max|r|
  void operator+=(const Drive& other) {
    free += other.free;
    bound += other.bound;
    largest_free = std::max(largest_free, other.largest_free);
  }
};

}  // namespace

void FreeSet::proportion(const ContactProblem& problem, const Field& p, const Field& g, double approach) {
  using namespace contact;
  const Drive drive = problem.blocks().sum([&, cap = problem.cap](Block block) {
    const auto pb = block.of(p), gb = block.of(g);
    const auto in_set = block.of(std::as_const(mask));
    double free = 0, bound = 0, largest = 0;
#pragma omp simd reduction(+ : free, bound) reduction(max : largest)
    for (Index i = 0; i < block.size; ++i) {
      const double r = in_set[i] * (gb[i] - approach);
      const bool is_free = pb[i] > 0 && pb[i] < cap;
      free += is_free ? r * r : 0;
      bound += is_free ? 0 : r * r;
      largest = std::max(largest, is_free ? std::abs(r) : 0);
    }
    return Drive{free, bound, largest};
  });
  const bool calm = drive.bound < calm_bounds * calm_bounds * drive.free;
  const double least = calm ? std::numeric_limits<double>::infinity() : least_drive * drive.largest_free;
  choose(problem, p, g, [approach, least, cap = problem.cap](double pressure, double gap, bool in) {
    const bool is_free = pressure > 0 && pressure < cap;
    return in && (is_free || std::abs(gap - approach) > least);
  });
}

SubspaceCG::SubspaceCG(const ContactProblem& problem, const FreeSet& free, const Field& p, const Field& g,
                       Trial& trial, TwoLevel* two_level)
    : problem_(problem),
      free_(free),
      trial_(trial),
      two_level_(two_level),
      mean_gap_(problem.approach ? *problem.approach : mean(free.gap_sum)) {
  for (Field* field : {&trial_.p, &trial_.g, &trial_.d, &trial_.q}) field->resize(p.rows(), p.cols());
  residual_ = problem_.blocks().sum([&](Block b) {
    b.of(trial_.p) = b.of(p);
    b.of(trial_.g) = b.of(g);
    b.of(trial_.d).setZero();
    return residual(b);
  });
  first_largest_ = residual_.largest > 0 ? residual_.largest : 1;
}

// r = P_F (-g), in the place of q.
SubspaceResidual SubspaceCG::residual(Block b) {
  const auto in_set = b.of(free_.mask);
  const auto g = b.of(std::as_const(trial_.g));
  auto r = b.of(trial_.q);
  const double level = mean_gap_;
  double squared = 0, largest = 0;
#pragma omp simd reduction(+ : squared) reduction(max : largest)
  for (Index i = 0; i < b.size; ++i) {
    const double ri = in_set[i] * (level - g[i]);
    r[i] = ri;
    squared += ri * ri;
    largest = std::max(largest, std::abs(ri));
  }
  return {squared, largest};
}

bool SubspaceCG::step() {
  ++applications_;
  precondition();
  const auto [zr, sum_z, zr_before] = sums_of_z();
  turn(mean(sum_z), steps_ > 0 ? std::max(0.0, zr - zr_before) / zr_old_ : 0);
  problem_.influence->apply_single(trial_.d, trial_.q);
  const auto [curvature, sum_q, none] = sums_of_q();
  if (!(curvature > 0 && zr > 0)) return false;
  zr_old_ = zr;
  advance(zr / curvature, mean(sum_q));
  ++steps_;
  return true;
}

// z in the place of r.
void SubspaceCG::precondition() {
  if (two_level_ == nullptr) return problem_.influence->precondition(trial_.q, trial_.q);
  two_level_->apply(trial_.q, trial_.q);
}

// r follows from g.
SubspaceCG::Sums SubspaceCG::sums_of_z() {
  const bool varies = two_level_ != nullptr;
  if (varies && steps_ == 0) trial_.before.assign(size(trial_.q.size()), 0.0F);
  return problem_.blocks().sum([&, level = mean_gap_, scale = 1 / first_largest_](Block b) {
    const auto in_set = b.of(free_.mask);
    const auto z = b.of(std::as_const(trial_.q)), g = b.of(std::as_const(trial_.g));
    double zr = 0, sum = 0, zr_before = 0;
#pragma omp simd reduction(+ : sum, zr)
    for (Index i = 0; i < b.size; ++i) {
      const double zi = in_set[i] * z[i];
      sum += zi;
      zr += zi * (level - g[i]);
    }
    if (varies) {
      auto before = b.of(trial_.before);
#pragma omp simd reduction(+ : zr_before)
      for (Index i = 0; i < b.size; ++i) {
        zr_before += z[i] * static_cast<double>(before[i]);
        before[i] = static_cast<float>(in_set[i] * (level - g[i]) * scale);
      }
    }
    return Sums{zr, sum, zr_before / scale};
  });
}

SubspaceCG::Sums SubspaceCG::sums_of_q() const {
  return problem_.blocks().sum([&](Block b) {
    const auto in_set = b.of(free_.mask);
    const auto d = b.of(std::as_const(trial_.d)), q = b.of(std::as_const(trial_.q));
    double dq = 0, sum = 0;
#pragma omp simd reduction(+ : dq, sum)
    for (Index i = 0; i < b.size; ++i) {
      dq += d[i] * q[i];
      sum += in_set[i] * q[i];
    }
    return Sums{dq, sum, 0};
  });
}

// d = P_F z + β d.
void SubspaceCG::turn(double mean_z, double beta) {
  problem_.blocks().each([&](Block b) {
    const auto in_set = b.of(free_.mask);
    const auto z = b.of(std::as_const(trial_.q));
    auto d = b.of(trial_.d);
#pragma omp simd
    for (Index i = 0; i < b.size; ++i) d[i] = in_set[i] * (z[i] - mean_z) + beta * d[i];
  });
}

// p += a d, g += a q, r = P_F (r - a q).
void SubspaceCG::advance(double a, double mean_q) {
  mean_gap_ += a * mean_q;
  residual_ = problem_.blocks().sum([&](Block b) {
    b.of(trial_.p) += a * b.of(trial_.d);
    b.of(trial_.g) += a * b.of(trial_.q);
    return residual(b);
  });
}

bool SubspaceCG::out_of_bounds() const {
  return problem_.blocks().sum([&](Block b) {
    const auto p = b.of(trial_.p);
    return static_cast<int>(p.minCoeff() < 0 || (problem_.capped() && p.maxCoeff() > problem_.cap));
  }) > 0;
}

bool SubspaceCG::set_too_small() const {
  return problem_.blocks().sum([&, cap = problem_.cap, level = mean_gap_](Block b) {
    const auto in_set = b.of(free_.mask);
    const auto p = b.of(std::as_const(trial_.p)), g = b.of(std::as_const(trial_.g));
    int driven = 0;
#pragma omp simd reduction(+ : driven)
    for (Index i = 0; i < b.size; ++i) {
      const int none = p[i] <= 0, full = p[i] >= cap;
      const int pulled = g[i] < level;
      const int pushed = level < g[i];
      const int off_zero = none & pulled, off_cap = full & pushed;
      driven += (in_set[i] ^ 1) & (off_zero | off_cap);
    }
    return driven;
  }) > 0;
}

}  // namespace asperity
