#include "contact/face.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

template <class Values>
FaceResidual size_of(const Values& r) {
  return {r.square().sum(), r.abs().maxCoeff()};
}

}  // namespace

void Face::set(const ContactProblem& problem, const Field& p, const Field& g, double approach) {
  mask.resize(p.rows(), p.cols());
  const Eigen::Array2d sums = problem.blocks().sum([&](Block block) {
    const auto pb = block.of(p), gb = block.of(g);
    auto in_face = block.of(mask);
    if (problem.capped())
      in_face =
          (pb <= 0).select(gb < approach, (pb < problem.cap) || (gb > approach)).template cast<double>();
    else
      in_face = (pb > 0 || gb < approach).template cast<double>();
    return Eigen::Array2d(in_face.sum(), (in_face * gb).sum());
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
    auto r = b.of(trial_.q);
    b.of(trial_.p) = b.of(p);
    b.of(trial_.g) = b.of(g);
    b.of(trial_.d).setZero();
    r = b.of(face_->mask) * (mean_gap_ - b.of(g));
    return size_of(r);
  }));
}

void FaceGradients::keep(const FaceResidual& residual) {
  norm_ = std::sqrt(residual.squared);
  largest_ = residual.largest;
}

bool FaceGradients::step() {
  const Blocks blocks = problem_.blocks();
  Field& z = trial_.q;
  influence_.precondition(trial_.q, z);
  const Eigen::Array2d sums = blocks.sum([&](Block b) {
    const auto mask = b.of(face_->mask);
    const auto zb = b.of(z);
    return Eigen::Array2d((mask * zb).sum(), (mask * zb * (mean_gap_ - b.of(trial_.g))).sum());
  });
  const double mean_z = mean(sums[0]), zr = sums[1];
  turn(mean_z, steps_ > 0 ? zr / zr_old_ : 0);

  influence_.apply(trial_.d, trial_.q);
  const Eigen::Array2d q = blocks.sum([&](Block b) {
    const auto qb = b.of(trial_.q);
    return Eigen::Array2d((b.of(trial_.d) * qb).sum(), (b.of(face_->mask) * qb).sum());
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
    auto d = b.of(trial_.d);
    d = b.of(face_->mask) * (b.of(trial_.q) - mean_z) + beta * d;
  });
}

// p += a d, g += a q, r = P_F (r - a q).
void FaceGradients::advance(double a, double mean_q) {
  mean_gap_ += a * mean_q;
  keep(problem_.blocks().sum([&](Block b) {
    auto r = b.of(trial_.q), g = b.of(trial_.g);
    b.of(trial_.p) += a * b.of(trial_.d);
    g += a * r;
    r = b.of(face_->mask) * (mean_gap_ - g);
    return size_of(r);
  }));
}

bool FaceGradients::out_of_bounds() const {
  return problem_.blocks().sum([&](Block b) {
    const auto p = b.of(trial_.p);
    return static_cast<int>(p.minCoeff() < 0 || (problem_.capped() && p.maxCoeff() > problem_.cap));
  }) > 0;
}

bool FaceGradients::face_too_small() const {
  return problem_.blocks().sum([&](Block b) {
    const auto mask = b.of(face_->mask);
    const auto p = b.of(trial_.p), g = b.of(trial_.g);
    bool found = (mask == 0 && p <= 0 && g < mean_gap_).any();
    if (problem_.capped()) found = found || (mask == 0 && p >= problem_.cap && g > mean_gap_).any();
    return static_cast<int>(found);
  }) > 0;
}

}  // namespace asperity
