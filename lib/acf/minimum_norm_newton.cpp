#include "acf/minimum_norm_newton.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/calibration.hpp"
#include "transform/zero_phase.hpp"

namespace asperity {
namespace {

using Vector = Eigen::ArrayXd;

constexpr int most_steps = 12, most_inner = 60;  // inner iterations a step

std::span<double> span(Vector& v) { return {v.data(), size(v.size())}; }
std::span<const double> constant(const Vector& v) { return {v.data(), size(v.size())}; }

// R of the kernel reaches to 2K - 2 and must not wrap around into the lags below n.
Shape least_torus(Shape kernel, Shape lags) { return {2 * kernel.nx + lags.nx, 2 * kernel.ny + lags.ny}; }

Shape half_of(const Field& kernel) { return {kernel.rows() / 2 + 1, kernel.cols() / 2 + 1}; }

// Vectors are parts of the kernel; those of equations are zero beyond the lags prescribed.
class Problem {
 public:
  Problem(const Field& kernel, const Target& target, Shape lags, bool oriented)
      : transform_(zero_phase_transform(half_of(kernel), least_torus(half_of(kernel), lags), oriented)),
        scale_(1 / static_cast<double>(transform_->torus().cells())),
        transfer_(size(transform_->spectrum_size())) {
    const Index middle_x = kernel.rows() / 2, middle_y = kernel.cols() / 2;
    auto vector = [&](auto f) {
      const std::vector<double> part = transform_->part(f);
      return Vector(Eigen::Map<const Vector>(part.data(), static_cast<Index>(part.size())));
    };
    auto inside = [&](Index p, Index q) { return p < lags.nx && std::abs(q) < lags.ny; };
    u = vector([&](Index k, Index l) { return kernel(middle_x + k, middle_y + l); });
    inside_ = vector([&](Index p, Index q) { return inside(p, q) ? 1.0 : 0.0; });
    target_ = vector([&](Index p, Index q) {
      return inside(p, q) ? target(static_cast<double>(p), static_cast<double>(q)) : 0.0;
    });
    const std::vector<double> w = transform_->multiplicity();
    weight_ = Eigen::Map<const Vector>(w.data(), static_cast<Index>(w.size()));
  }

  double dot(const Vector& a, const Vector& b) const { return (weight_ * a * b).sum(); }

  Vector residual(const Vector& at) {
    Vector f(at.size());
    transform_->autocorrelate(constant(at), span(f));
    return f * inside_ - target_;
  }
  void linearize() {
    transform_->forward(constant(u), transfer_);
    double square = 0;
    for (double a : transfer_) square += a * a;
    floor_ = calibration::acf::minimum_norm_floor * calibration::acf::minimum_norm_floor * square /
             static_cast<double>(transfer_.size());
  }
  /// 2 Q (α^ v^): J without its restriction, and J*.
  Vector product(const Vector& v) {
    ++products;
    return filtered(v, [](double a) { return 2 * a; });
  }
  Vector image(const Vector& y) { return product(product(y)) * inside_; }
  Vector preconditioned(const Vector& v) {
    return filtered(v, [this](double a) { return 0.25 / std::max(a * a, floor_); }) * inside_;
  }
  Field whole() const { return transform_->whole(constant(u)); }

  Vector u;
  long products = 0;

 private:
  template <class Factor>
  Vector filtered(const Vector& v, Factor factor) {
    Vector out(v.size());
    transform_->filter(constant(v), span(out), [&](Index offset, std::span<double> block) {
      const double* transfer = transfer_.data() + offset;
      for (std::size_t i = 0; i < block.size(); ++i) block[i] *= scale_ * factor(transfer[i]);
    });
    return out;
  }

  std::unique_ptr<ZeroPhaseTransform> transform_;
  double scale_, floor_ = 0;
  AlignedVector<double> transfer_;
  Vector inside_, target_, weight_;
};

// J J*y = b to a hundredth, or as far as it goes.
Vector conjugate_gradients(Problem& problem, const Vector& b) {
  Vector y = Vector::Zero(b.size()), r = b, z = problem.preconditioned(r), d = z;
  double rz = problem.dot(r, z);
  const double enough = 1e-4 * problem.dot(b, b);
  for (int i = 0; i < most_inner && problem.dot(r, r) > enough; ++i) {
    const Vector image = problem.image(d);
    const double curvature = problem.dot(d, image);
    if (!(curvature > 0)) break;
    y += rz / curvature * d;
    r -= rz / curvature * image;
    z = problem.preconditioned(r);
    const double next = problem.dot(r, z);
    d = z + next / rz * d;
    rz = next;
  }
  return y;
}

// The step, halved until ‖F‖ falls; false when five halvings do not help.
bool advance(Problem& problem, Vector& f, const Vector& step) {
  const double present = problem.dot(f, f);
  double length = 1;
  for (int i = 0; i < 6; ++i, length /= 2) {
    const Vector next = problem.residual(problem.u + length * step);
    if (!(problem.dot(next, next) < present)) continue;
    problem.u += length * step;
    f = next;
    return true;
  }
  return false;
}

}  // namespace

Field minimum_norm_newton(const Field& kernel, const Target& target, Shape lags, bool oriented,
                          double tolerance, const IterationObserver& on_step) {
  Problem problem(kernel, target, lags, oriented);
  Vector f = problem.residual(problem.u);
  auto tell = [&](int step) {
    if (on_step)
      on_step({step, problem.products, f.abs().maxCoeff(), static_cast<double>(step) / most_steps});
  };
  tell(0);
  for (int i = 0; i < most_steps && f.abs().maxCoeff() > tolerance; ++i) {
    const double former = problem.dot(f, f);
    problem.linearize();
    const Vector y = conjugate_gradients(problem, -f);
    const bool advanced = advance(problem, f, problem.product(y));
    tell(i + 1);
    if (!advanced || problem.dot(f, f) > 0.5 * former) break;
  }
  return problem.whole();
}

}  // namespace asperity
