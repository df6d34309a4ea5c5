#include "contact/face.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// Pairs of sums over a block.
using Sums = Eigen::Array2d;

}  // namespace

void Face::set(const ContactProblem& problem, const Field& p, const Field& g, double approach) {
  mask.resize(static_cast<std::size_t>(p.size()));
  const Sums sums = problem.blocks().sum([&, cap = problem.cap](Block block) {
    const double *pb = block.of(p).data(), *gb = block.of(g).data();
    std::int8_t* in_face = mask.data() + block.begin;
    double count = 0, gap = 0;
#pragma omp simd reduction(+ : count, gap)
    for (Index i = 0; i < block.size; ++i) {
      const bool pushed = gb[i] < approach;
      const bool pulled = gb[i] > approach;
      const bool in = pb[i] <= 0 ? pushed : pb[i] < cap || pulled;
      in_face[i] = static_cast<std::int8_t>(in);
      count += in ? 1.0 : 0.0;
      gap += in ? gb[i] : 0.0;
    }
    return Sums(count, gap);
  });
  cells = sums[0];
  gap_sum = sums[1];
}

void FaceGradients::begin(const Face& face, const Field& p, const Field& g) {
  face_ = &face;
  for (Field* field : {&trial_.p, &trial_.g, &trial_.d, &trial_.q}) field->resize(p.rows(), p.cols());
  steps_ = 0;
  mean_gap_ = problem_.approach ? *problem_.approach : mean(face.gap_sum);
  keep(problem_.blocks().sum([&](Block b) {
    b.of(trial_.p) = b.of(p);
    b.of(trial_.g) = b.of(g);
    b.of(trial_.d).setZero();
    return residual(b);
  }));
}

// r = P_F (-g), in the place of q.
FaceResidual FaceGradients::residual(Block b) {
  const std::int8_t* in_face = mask(b);
  const double *g = b.of(trial_.g).data(), level = mean_gap_;
  double *r = b.of(trial_.q).data(), squared = 0, largest = 0;
#pragma omp simd reduction(+ : squared) reduction(max : largest)
  for (Index i = 0; i < b.size; ++i) {
    const double ri = in_face[i] * (level - g[i]);
    r[i] = ri;
    squared += ri * ri;
    largest = std::max(largest, std::abs(ri));
  }
  return {squared, largest};
}

void FaceGradients::keep(const FaceResidual& residual) {
  norm_ = std::sqrt(residual.squared);
  largest_ = residual.largest;
}

bool FaceGradients::step() {
  const Blocks blocks = problem_.blocks();
  influence_.precondition(trial_.q, trial_.q);
  const Sums z = blocks.sum([&](Block b) {
    const std::int8_t* in_face = mask(b);
    const double *zb = b.of(trial_.q).data(), *g = b.of(trial_.g).data(), level = mean_gap_;
    double sum = 0, zr = 0;
#pragma omp simd reduction(+ : sum, zr)
    for (Index i = 0; i < b.size; ++i) {
      const double zi = in_face[i] * zb[i];
      sum += zi;
      zr += zi * (level - g[i]);
    }
    return Sums(sum, zr);
  });
  const double zr = z[1];
  turn(mean(z[0]), steps_ > 0 ? zr / zr_old_ : 0);

  influence_.apply(trial_.d, trial_.q);
  const Sums q = blocks.sum([&](Block b) {
    const std::int8_t* in_face = mask(b);
    const double *d = b.of(trial_.d).data(), *qb = b.of(trial_.q).data();
    double curvature = 0, sum = 0;
#pragma omp simd reduction(+ : curvature, sum)
    for (Index i = 0; i < b.size; ++i) {
      curvature += d[i] * qb[i];
      sum += in_face[i] * qb[i];
    }
    return Sums(curvature, sum);
  });
  if (!(q[0] > 0 && zr > 0)) return false;
  zr_old_ = zr;
  advance(zr / q[0], mean(q[1]));
  ++steps_;
  return true;
}

// d = P_F z + β d.
void FaceGradients::turn(double mean_z, double beta) {
  problem_.blocks().each([&](Block b) {
    const std::int8_t* in_face = mask(b);
    const double* z = b.of(trial_.q).data();
    double* d = b.of(trial_.d).data();
#pragma omp simd
    for (Index i = 0; i < b.size; ++i) d[i] = in_face[i] * (z[i] - mean_z) + beta * d[i];
  });
}

// p += a d, g += a q, r = P_F (r - a q).
void FaceGradients::advance(double a, double mean_q) {
  mean_gap_ += a * mean_q;
  keep(problem_.blocks().sum([&](Block b) {
    b.of(trial_.p) += a * b.of(trial_.d);
    b.of(trial_.g) += a * b.of(trial_.q);
    return residual(b);
  }));
}

bool FaceGradients::out_of_bounds() const {
  return problem_.blocks().sum([&](Block b) {
    const auto p = b.of(trial_.p);
    return static_cast<int>(p.minCoeff() < 0 || (problem_.capped() && p.maxCoeff() > problem_.cap));
  }) > 0;
}

bool FaceGradients::face_too_small() const {
  return problem_.blocks().sum([&, cap = problem_.cap, level = mean_gap_](Block b) {
    const std::int8_t* in_face = mask(b);
    const double *p = b.of(trial_.p).data(), *g = b.of(trial_.g).data();
    int driven = 0;
#pragma omp simd reduction(+ : driven)
    for (Index i = 0; i < b.size; ++i) {
      const int off_zero = (p[i] <= 0) & (g[i] < level), off_cap = (p[i] >= cap) & (g[i] > level);
      driven += (in_face[i] ^ 1) & (off_zero | off_cap);
    }
    return driven;
  }) > 0;
}

}  // namespace asperity
