#include "acf/conjugate_gradient.hpp"

#include <array>
#include <cmath>

#include <Eigen/Core>
#include <gsl/gsl_poly.h>

#include "core/words.hpp"

namespace asperity {
namespace {

using Vector = Eigen::ArrayXd;

constexpr int most_iterations = 3000;

std::span<double> span(Vector& v) { return {v.data(), size(v.size())}; }

// One descent: the iterate, its residual and gradient, and the direction.
class Descent {
 public:
  Descent(Equations& equations, std::span<double> u)
      : equations_(equations),
        weight_(Eigen::Map<const Vector>(equations.multiplicity().data(), equations.count())),
        target_(Eigen::Map<const Vector>(equations.target().data(), equations.count())),
        u_(u.data(), equations.count()),
        f_(u_.size()),
        g_(u_.size()),
        image_(u_.size()),
        square_(u_.size()) {
    refresh();
    direction_ = -g_;
  }

  double largest() const { return f_.abs().maxCoeff(); }

  // To the least sum of squares along the direction, then on to the next; false when nothing is gained.
  bool step() {
    // Of unit length, or Q would drown in the rounding of R.
    unit_ = direction_ / std::sqrt(dot(direction_, direction_));
    equations_.jacobian(span(unit_), span(image_));
    equations_.residual(span(unit_), span(square_));
    square_ += target_;
    const double t = least_along();
    if (!(std::abs(t) > 0)) return false;
    u_ += t * unit_;
    const Vector before = g_;
    const double former = dot(before, before);
    refresh();
    const double beta = std::max(0.0, dot(g_, g_ - before) / former);
    direction_ = -g_ + beta * direction_;
    if (!(dot(direction_, g_) < 0)) direction_ = -g_;
    return std::isfinite(former) && former > 0;
  }

 private:
  double dot(const Vector& a, const Vector& b) const { return (weight_ * a * b).sum(); }

  void refresh() {
    const std::span<const double> u{u_.data(), size(u_.size())};
    equations_.residual(u, span(f_));
    equations_.linearize(u);
    equations_.adjoint(span(f_), span(g_));
  }

  // The t of the least ½‖F + t J d + t² Q‖², 0 when none is below the present.
  double least_along() const {
    const double c1 = dot(f_, image_), c2 = dot(image_, image_) + 2 * dot(f_, square_),
                 c3 = 3 * dot(image_, square_), c4 = 2 * dot(square_, square_);  // of the derivative
    if (!(c4 > 0)) return 0;
    std::array<double, 3> roots{};
    const int count = gsl_poly_solve_cubic(c3 / c4, c2 / c4, c1 / c4, &roots[0], &roots[1], &roots[2]);
    auto gain = [&](double t) { return t * (c1 + t * (c2 / 2 + t * (c3 / 3 + t * c4 / 4))); };
    double best = 0;
    for (double root : std::span(roots).first(size(count)))
      if (gain(root) < gain(best)) best = root;
    // A root close to 0 beside large ones has lost its digits.
    if (best == 0 && c1 < 0 && c2 > 0) best = -c1 / c2;
    for (int i = 0; i < 2; ++i)
      best -= (c1 + best * (c2 + best * (c3 + best * c4))) / (c2 + best * (2 * c3 + best * 3 * c4));
    return best;
  }

  Equations& equations_;
  const Vector weight_, target_;
  Eigen::Map<Vector> u_;
  Vector f_, g_, image_, square_, direction_, unit_;
};

}  // namespace

IterationResult solve_conjugate_gradient(Equations& equations, std::span<double> u, double tolerance,
                                         const IterationObserver& on_step) {
  Descent descent(equations, u);
  IterationResult result;
  auto tell = [&] {
    if (on_step)
      on_step({result.steps, 2 * result.steps + 1, descent.largest(),
               static_cast<double>(result.steps) / most_iterations});
  };
  result.reason = "solved";
  tell();
  while (!(descent.largest() <= tolerance)) {
    if (result.steps == most_iterations) {
      result.reason = "not solved in " + counted(result.steps, "iteration");
      break;
    }
    ++result.steps;
    if (!descent.step()) {
      result.reason = "no further descent after " + counted(result.steps, "iteration");
      break;
    }
    tell();
  }
  result.converged = descent.largest() <= tolerance;
  result.residuals = result.jacobian_products = 2 * result.steps + 1;
  return result;
}

}  // namespace asperity
