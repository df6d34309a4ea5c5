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

}  // namespace

Face::Face(const ContactProblem& problem, const Field& p, const Field& g, double approach)
    : mask(p.rows(), p.cols()) {
  cells = problem.blocks().sum([&](Block block) {
    const auto pb = block.of(p), gb = block.of(g);
    auto in_face = block.of(mask);
    in_face = (pb <= 0).select(gb < approach, (pb < problem.cap) || (gb > approach)).template cast<double>();
    return in_face.sum();
  });
}

FaceGradients::FaceGradients(ElasticOperator& influence, const ContactProblem& problem)
    : influence_(influence), problem_(problem), r_old_(problem.h.rows(), problem.h.cols()) {}

void FaceGradients::begin(const Face& face, const Field& p, const Field& g) {
  face_ = &face;
  p_ = p;
  g_ = g;
  d_ = Field::Zero(p.rows(), p.cols());
  steps_ = 0;
  set_residual();
}

void FaceGradients::set_residual() {
  const Blocks blocks = problem_.blocks();
  mean_gap_ = problem_.approach
                  ? *problem_.approach
                  : mean(blocks.sum([&](Block b) { return (b.of(face_->mask) * b.of(g_)).sum(); }));
  r_.resize(p_.rows(), p_.cols());
  const Size size = blocks.sum([&](Block b) {
    auto r = b.of(r_);
    r = b.of(face_->mask) * (mean_gap_ - b.of(g_));
    return Size{r.square().sum(), r.abs().maxCoeff()};
  });
  norm_ = std::sqrt(size.squared);
  largest_ = size.largest;
}

bool FaceGradients::step() {
  const Blocks blocks = problem_.blocks();
  influence_.precondition(r_, z_);
  const Eigen::Array3d sums = blocks.sum([&](Block b) {
    const auto z = b.of(z_), r = b.of(r_), old = b.of(r_old_);
    return Eigen::Array3d((b.of(face_->mask) * z).sum(), (z * r).sum(), steps_ > 0 ? (z * old).sum() : 0);
  });
  const double beta = steps_ > 0 ? std::max(0.0, (sums[1] - sums[2]) / zr_old_) : 0;
  const double rd = turn(mean(sums[0]), beta);

  influence_.apply(d_, q_);
  const Eigen::Array2d q = blocks.sum([&](Block b) {
    return Eigen::Array2d((b.of(d_) * b.of(q_)).sum(), (b.of(face_->mask) * b.of(q_)).sum());
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
    auto d = b.of(d_);
    d = b.of(face_->mask) * (b.of(z_) - mean_z) + beta * d;
    return (b.of(r_) * d).sum();
  });
}

// p += a d, g += a q, r = P_F (r - a q).
void FaceGradients::advance(double a, double mean_q) {
  std::swap(r_, r_old_);
  const Size size = problem_.blocks().sum([&](Block b) {
    auto r = b.of(r_);
    b.of(p_) += a * b.of(d_);
    b.of(g_) += a * b.of(q_);
    r = b.of(face_->mask) * (b.of(r_old_) - a * (b.of(q_) - mean_q));
    return Size{r.square().sum(), r.abs().maxCoeff()};
  });
  mean_gap_ += a * mean_q;
  norm_ = std::sqrt(size.squared);
  largest_ = size.largest;
}

bool FaceGradients::out_of_bounds() const {
  return problem_.blocks().sum(
             [&](Block b) { return static_cast<int>((b.of(p_) < 0 || b.of(p_) > problem_.cap).any()); }) > 0;
}

bool FaceGradients::face_too_small() const {
  return problem_.blocks().sum([&](Block b) {
    const auto p = b.of(p_), g = b.of(g_);
    const auto driven = (p <= 0 && g < mean_gap_) || (p >= problem_.cap && g > mean_gap_);
    return static_cast<int>((b.of(face_->mask) == 0 && driven).any());
  }) > 0;
}

}  // namespace asperity
