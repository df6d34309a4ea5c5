#include "contact/face.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// |r|² and max|r|.
struct Size {
  double squared = 0, largest = 0;
  void operator+=(const Size& other) {
    squared += other.squared;
    largest = std::max(largest, other.largest);
  }
};

template <class Values>
Size size_of(const Values& r) {
  return {r.square().sum(), r.abs().maxCoeff()};
}

}  // namespace

void Face::set(const ContactProblem& problem, const Field& p, const Field& g, double approach) {
  mask.resize(p.rows(), p.cols());
  cells = problem.blocks().sum([&](Block block) {
    const auto pb = block.of(p), gb = block.of(g);
    auto in_face = block.of(mask);
    if (problem.capped())
      in_face =
          (pb <= 0).select(gb < approach, (pb < problem.cap) || (gb > approach)).template cast<double>();
    else
      in_face = (pb > 0 || gb < approach).template cast<double>();
    return in_face.sum();
  });
}

void FaceGradients::begin(const Face& face, const Field& p, const Field& g) {
  face_ = &face;
  trial_.p = p;
  trial_.g = g;
  trial_.d = Field::Zero(p.rows(), p.cols());
  trial_.q.resize(p.rows(), p.cols());
  steps_ = 0;
  set_residual();
}

void FaceGradients::set_residual() {
  const Blocks blocks = problem_.blocks();
  mean_gap_ = problem_.approach
                  ? *problem_.approach
                  : mean(blocks.sum([&](Block b) { return (b.of(face_->mask) * b.of(trial_.g)).sum(); }));
  const Size size = blocks.sum([&](Block b) {
    auto r = b.of(trial_.q);
    r = b.of(face_->mask) * (mean_gap_ - b.of(trial_.g));
    return size_of(r);
  });
  norm_ = std::sqrt(size.squared);
  largest_ = size.largest;
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
  const double rd = turn(mean(sums[0]), steps_ > 0 ? sums[1] / zr_old_ : 0);

  influence_.apply(trial_.d, trial_.q);
  const Eigen::Array2d q = blocks.sum([&](Block b) {
    const auto qb = b.of(trial_.q);
    return Eigen::Array2d((b.of(trial_.d) * qb).sum(), (b.of(face_->mask) * qb).sum());
  });
  if (!(q[0] > 0 && rd > 0)) return false;
  zr_old_ = sums[1];
  advance(rd / q[0], mean(q[1]));
  ++steps_;
  return true;
}

// d = P_F z + β d; returns r·d.
double FaceGradients::turn(double mean_z, double beta) {
  return problem_.blocks().sum([&](Block b) {
    const auto mask = b.of(face_->mask);
    auto d = b.of(trial_.d);
    d = mask * (b.of(trial_.q) - mean_z) + beta * d;
    return (d * (mean_gap_ - b.of(trial_.g))).sum();
  });
}

// p += a d, g += a q, r = P_F (r - a q).
void FaceGradients::advance(double a, double mean_q) {
  mean_gap_ += a * mean_q;
  const Size size = problem_.blocks().sum([&](Block b) {
    auto r = b.of(trial_.q), g = b.of(trial_.g);
    b.of(trial_.p) += a * b.of(trial_.d);
    g += a * r;
    r = b.of(face_->mask) * (mean_gap_ - g);
    return size_of(r);
  });
  norm_ = std::sqrt(size.squared);
  largest_ = size.largest;
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
