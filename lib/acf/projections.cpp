#include "acf/projections.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "acf/equations.hpp"
#include "transform/zero_phase.hpp"

namespace asperity {
namespace {

constexpr int look_every = 10;   // steps between two reports
constexpr int most_steps = 100;  // to a mean of 1

using Spectrum = Eigen::ArrayXd;

class Projections {
 public:
  Projections(const Target& target, Shape lags, bool oriented, Index torus) {
    auto half = [torus](Index n) { return fast_length(std::max<Index>(torus * n, 8), 2) / 2; };
    const Shape reach{half(lags.nx), half(lags.ny)};
    transform_ = zero_phase_transform(reach, {2 * reach.nx, 2 * reach.ny}, oriented);
    spectrum_.resize(size(transform_->spectrum_size()));
    const std::vector<double> multiplicity = transform_->spectrum_multiplicity();
    weight_ = Eigen::Map<const Spectrum>(multiplicity.data(), static_cast<Index>(multiplicity.size()));
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
    Eigen::Map<Spectrum> spectrum(spectrum_.data(), static_cast<Index>(spectrum_.size()));
    if (!(spectrum > theta_).any())
      theta_ = spectrum.minCoeff() - 1;  // that of another spectrum is above all of this
    double former = 0, active = -1;
    for (int i = 0; i < most_steps && active != former; ++i) {
      former = active;
      active = (spectrum > theta_).select(weight_, 0).sum();
      theta_ += (((spectrum - theta_).max(0.0) * weight_).sum() - cells_) / active;
    }
    spectrum = (spectrum - theta_).max(0.0);
  }

  std::unique_ptr<ZeroPhaseTransform> transform_;
  Spectrum weight_;
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

}  // namespace asperity
