#include "acf/projections.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "acf/normalise.hpp"
#include "transform/zero_phase.hpp"

namespace asperity {
namespace {

// Steps between two looks at what has been achieved, each of which costs half a step.
constexpr int look_every = 10;

class Projections {
 public:
  Projections(const Target& target, Shape lags, bool oriented) {
    auto half = [](Index n) { return fast_length(std::max<Index>(4 * n, 8), 2) / 2; };
    const Shape reach{half(lags.nx), half(lags.ny)};
    transform_ = zero_phase_transform(reach, {2 * reach.nx, 2 * reach.ny}, oriented);
    const Shape torus = transform_->torus();
    const Shape known = target.known.value_or(torus);
    scale_ = 1 / static_cast<double>(torus.cells());
    auto within = [](Index p, Index q, Shape box) { return p < box.nx && std::abs(q) < box.ny; };
    std::size_t place = 0;
    present_ = transform_->part([&](Index p, Index q) {
      const double value = within(p, q, known) ? target(static_cast<double>(p), static_cast<double>(q)) : 0.0;
      if (within(p, q, lags)) prescribed_.push_back({place, value});
      ++place;
      return value;
    });
    projected_.resize(present_.size());
  }

  void step(double relaxation) {
    transform_->filter(present_, present_, [&](Index, std::span<double> block) {
      for (double& s : block) s *= s < 0 ? (1 - relaxation) * scale_ : scale_;
    });
    for (const auto& [place, value] : prescribed_) present_[place] = value;
  }

  // How far the autocorrelation of spectrum max(S, 0), scaled to unit variance, is from the target.
  double change() {
    transform_->filter(present_, projected_, [&](Index, std::span<double> block) {
      for (double& s : block) s = std::max(s, 0.0) * scale_;
    });
    double largest = 0;
    for (const auto& [place, value] : prescribed_)
      largest = std::max(largest, std::abs(projected_[place] / projected_[0] - value));
    return largest;
  }

  Field root() {
    transform_->filter(present_, projected_, [&](Index, std::span<double> block) {
      for (double& s : block) s = std::sqrt(std::max(s, 0.0)) * scale_;
    });
    normalise(projected_, transform_->multiplicity(), 1);
    return transform_->whole(projected_);
  }

 private:
  struct Prescribed {
    std::size_t place;
    double value;
  };
  std::unique_ptr<ZeroPhaseTransform> transform_;
  std::vector<Prescribed> prescribed_;
  std::vector<double> present_, projected_;
  double scale_ = 1;
};

}  // namespace

NearestKernel nearest_kernel(const Target& target, Shape lags, bool oriented,
                             const ProjectionOptions& options) {
  Projections projections(target, lags, oriented);
  NearestKernel out;
  auto look = [&] {
    out.change = projections.change();
    if (options.told)
      options.told({out.iterations, out.iterations, out.change,
                    static_cast<double>(out.iterations) / options.max_iterations});
  };
  look();
  while (out.change > options.tolerance && out.iterations < options.max_iterations) {
    for (int i = 0; i < look_every; ++i) projections.step(options.relaxation);
    out.iterations += look_every;
    look();
  }
  out.values = projections.root();
  return out;
}

}  // namespace asperity
