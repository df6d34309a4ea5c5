#include "acf/wider_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "acf/equations.hpp"
#include "transform/zero_phase.hpp"

namespace asperity {
namespace {

using Coefficients = Eigen::ArrayXd;

constexpr int look_every = 10;    // steps between two reports
constexpr int most_shifts = 100;  // of θ, to a mean of 1

class Projections {
 public:
  Projections(const Target& target, Shape lags, bool oriented, Index torus) {
    auto half = [torus](Index n) { return fast_length(std::max<Index>(torus * n, 8), 2) / 2; };
    const Shape reach{half(lags.nx), half(lags.ny)};
    transform_ = zero_phase_transform(reach, {2 * reach.nx, 2 * reach.ny}, oriented);
    spectrum_.resize(size(transform_->spectrum_size()));
    const std::vector<double> multiplicity = transform_->spectrum_multiplicity();
    weight_ = Eigen::Map<const Coefficients>(multiplicity.data(), static_cast<Index>(multiplicity.size()));
    cells_ = weight_.sum();
    const Shape known = target.known.value_or(transform_->torus());
    auto within = [](Index p, Index q, Shape box) { return p < box.nx && std::abs(q) < box.ny; };
    std::size_t place = 0;
    present_ = transform_->part([&](Index p, Index q) {
      const double value = within(p, q, known) ? target(static_cast<double>(p), static_cast<double>(q)) : 0.0;
      if (within(p, q, lags)) prescribed_.push_back({place, value});
      ++place;
      return value;
    });
    projected_ = present_;
  }

  // P_B of what stands in projected_. Returns how far it is from the target.
  double project() {
    transform_->forward(projected_, spectrum_);
    give_mean_of_one();
    transform_->inverse(spectrum_, projected_);
    double largest = 0;
    for (const auto& [place, value] : prescribed_)
      largest = std::max(largest, std::abs(projected_[place] - value));
    return largest;
  }

  // (1). What is free is its own projection onto A.
  double step() {
    projected_ = present_;
    for (const auto& [place, value] : prescribed_) projected_[place] = 2 * value - present_[place];
    const double change = project();
    std::swap(present_, projected_);
    for (const auto& [place, value] : prescribed_) present_[place] += projected_[place] - value;
    return change;
  }

  Field root() {
    for (double& s : spectrum_) s = std::sqrt(s);
    transform_->inverse(spectrum_, projected_);
    normalise(projected_, transform_->multiplicity(), 1);
    return transform_->whole(projected_);
  }

 private:
  struct Prescribed {
    std::size_t place;
    double value;
  };

  // max(S - θ, 0): θ by Newton's iteration on a convex, piecewise linear function, in some five steps.
  void give_mean_of_one() {
    Eigen::Map<Coefficients> spectrum(spectrum_.data(), static_cast<Index>(spectrum_.size()));
    if (!(spectrum > theta_).any())
      theta_ = spectrum.minCoeff() - 1;  // that of another spectrum is above all of this
    double former = 0, active = -1;
    for (int i = 0; i < most_shifts && active != former; ++i) {
      former = active;
      active = (spectrum > theta_).select(weight_, 0).sum();
      theta_ += (((spectrum - theta_).max(0.0) * weight_).sum() - cells_) / active;
    }
    spectrum = (spectrum - theta_).max(0.0);
  }

  std::unique_ptr<ZeroPhaseTransform> transform_;
  Coefficients weight_;
  double cells_, theta_ = 0;
  std::vector<Prescribed> prescribed_;
  std::vector<double> present_, projected_;
  AlignedVector<double> spectrum_;
};

}  // namespace

NearestKernel nearest_kernel(const Target& target, Shape lags, bool oriented,
                             const ProjectionOptions& options) {
  Projections projections(target, lags, oriented, options.torus);
  NearestKernel out;
  auto tell = [&] {
    if (options.on_step && out.iterations % look_every == 0)
      options.on_step({out.iterations, out.iterations, out.change,
                       static_cast<double>(out.iterations) / options.max_iterations});
  };
  out.change = projections.project();
  tell();
  while (out.change > options.tolerance && out.iterations < options.max_iterations) {
    out.change = projections.step();
    ++out.iterations;
    tell();
  }
  out.values = projections.root();
  return out;
}

// ---- the least change ----

namespace {

constexpr int most_changes = 12, most_inner = 60;  // steps, and inner iterations of each
// Of the preconditioner, over the rms of the spectrum: inverses of less would amplify errors.
constexpr double minimum_norm_floor = 1e-2;

std::span<double> span(Coefficients& v) { return {v.data(), size(v.size())}; }
std::span<const double> constant(const Coefficients& v) { return {v.data(), size(v.size())}; }

// R of the kernel reaches to 2K - 2 and must not wrap around into the lags below n.
Shape torus_of(Shape kernel, Shape lags) { return {2 * kernel.nx + lags.nx, 2 * kernel.ny + lags.ny}; }

Shape half_of(const Field& kernel) { return {kernel.rows() / 2 + 1, kernel.cols() / 2 + 1}; }

// Vectors are parts of the kernel; those of equations are zero beyond the lags prescribed.
class LeastChange {
 public:
  LeastChange(const Field& kernel, const Target& target, Shape lags, bool oriented)
      : transform_(zero_phase_transform(half_of(kernel), torus_of(half_of(kernel), lags), oriented)),
        scale_(1 / static_cast<double>(transform_->torus().cells())),
        transfer_(size(transform_->spectrum_size())) {
    const Index middle_x = kernel.rows() / 2, middle_y = kernel.cols() / 2;
    auto vector = [&](auto f) {
      const std::vector<double> part = transform_->part(f);
      return Coefficients(Eigen::Map<const Coefficients>(part.data(), static_cast<Index>(part.size())));
    };
    auto inside = [&](Index p, Index q) { return p < lags.nx && std::abs(q) < lags.ny; };
    u = vector([&](Index k, Index l) { return kernel(middle_x + k, middle_y + l); });
    inside_ = vector([&](Index p, Index q) { return inside(p, q) ? 1.0 : 0.0; });
    target_ = vector([&](Index p, Index q) {
      return inside(p, q) ? target(static_cast<double>(p), static_cast<double>(q)) : 0.0;
    });
    const std::vector<double> w = transform_->multiplicity();
    weight_ = Eigen::Map<const Coefficients>(w.data(), static_cast<Index>(w.size()));
  }

  double dot(const Coefficients& a, const Coefficients& b) const { return (weight_ * a * b).sum(); }

  Coefficients residual(const Coefficients& at) {
    Coefficients f(at.size());
    transform_->autocorrelate(constant(at), span(f));
    return f * inside_ - target_;
  }
  void linearize() {
    transform_->forward(constant(u), transfer_);
    double square = 0;
    for (double a : transfer_) square += a * a;
    floor_ = minimum_norm_floor * minimum_norm_floor * square / static_cast<double>(transfer_.size());
  }
  /// 2 Q (α^ v^): J without its restriction, and J*.
  Coefficients product(const Coefficients& v) {
    ++products;
    return filtered(v, [](double a) { return 2 * a; });
  }
  Coefficients image(const Coefficients& y) { return product(product(y)) * inside_; }
  Coefficients preconditioned(const Coefficients& v) {
    return filtered(v, [this](double a) { return 0.25 / std::max(a * a, floor_); }) * inside_;
  }
  Field whole() const { return transform_->whole(constant(u)); }

  Coefficients u;
  long products = 0;

 private:
  template <class Factor>
  Coefficients filtered(const Coefficients& v, Factor factor) {
    Coefficients out(v.size());
    transform_->filter(constant(v), span(out), [&](Index offset, std::span<double> block) {
      const double* transfer = transfer_.data() + offset;
      for (std::size_t i = 0; i < block.size(); ++i) block[i] *= scale_ * factor(transfer[i]);
    });
    return out;
  }

  std::unique_ptr<ZeroPhaseTransform> transform_;
  double scale_, floor_ = 0;
  AlignedVector<double> transfer_;
  Coefficients inside_, target_, weight_;
};

// J J*y = b to a hundredth, or as far as it goes.
Coefficients conjugate_gradients(LeastChange& problem, const Coefficients& b) {
  Coefficients y = Coefficients::Zero(b.size()), r = b, z = problem.preconditioned(r), d = z;
  double rz = problem.dot(r, z);
  const double enough = 1e-4 * problem.dot(b, b);
  for (int i = 0; i < most_inner && problem.dot(r, r) > enough; ++i) {
    const Coefficients image = problem.image(d);
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
bool advance(LeastChange& problem, Coefficients& f, const Coefficients& step) {
  const double present = problem.dot(f, f);
  double length = 1;
  for (int i = 0; i < 6; ++i, length /= 2) {
    const Coefficients next = problem.residual(problem.u + length * step);
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
  LeastChange problem(kernel, target, lags, oriented);
  Coefficients f = problem.residual(problem.u);
  auto tell = [&](int step) {
    if (on_step)
      on_step({step, problem.products, f.abs().maxCoeff(), static_cast<double>(step) / most_changes});
  };
  tell(0);
  for (int i = 0; i < most_changes && f.abs().maxCoeff() > tolerance; ++i) {
    const double former = problem.dot(f, f);
    problem.linearize();
    const Coefficients y = conjugate_gradients(problem, -f);
    const bool advanced = advance(problem, f, problem.product(y));
    tell(i + 1);
    if (!advanced || problem.dot(f, f) > 0.5 * former) break;
  }
  return problem.whole();
}

}  // namespace asperity
