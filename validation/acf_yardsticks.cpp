#include "acf_yardsticks.hpp"

#include <Eigen/QR>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multilarge_nlinear.h>
#include <gsl/gsl_poly.h>

#include "acf/equations.hpp"
#include "acf/kernel_evaluation.hpp"
#include "core/stopwatch.hpp"

namespace asperity {
namespace {

std::span<double> span(Eigen::VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }
std::span<double> span(Eigen::ArrayXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

// ---- Anderson's fixed point ----

constexpr Index depth = 5;  // earlier iterates that are combined
constexpr long most_steps = 200;
constexpr double most_growth = 1e6;  // of the residual over its least: beyond it the iteration diverges

// The last differences of a sequence, the oldest overwritten.
struct Differences {
  Eigen::MatrixXd columns;
  Eigen::VectorXd former;

  void add(const Eigen::VectorXd& next, Index k) {
    if (k > 0) columns.col((k - 1) % columns.cols()) = next - former;
    former = next;
  }
};

// From `best`, the start, to the iterate of the least max |F|.
void accelerate(Equations& equations, Eigen::VectorXd& best, double tolerance, KernelReport& report) {
  Eigen::VectorXd u = best, f(u.size());
  Differences images{Eigen::MatrixXd(u.size(), std::min(depth, u.size())), u}, steps = images;
  double least = std::numeric_limits<double>::infinity();
  while (true) {
    equations.residual(span(u), span(f));
    ++report.residuals;
    const double largest = largest_absolute(span(f));
    if (largest < least) {
      least = largest;
      best = u;
    }
    if (largest <= tolerance || !(largest <= most_growth * least && std::isfinite(largest)) ||
        report.steps == most_steps)
      return;
    equations.linearize(span(u));
    equations.precondition(span(f));
    const Index k = report.steps++, earlier = std::min(k, images.columns.cols());
    u -= f;
    images.add(u, k);
    steps.add(-f, k);
    if (earlier > 0)
      u -= images.columns.leftCols(earlier) * steps.columns.leftCols(earlier).householderQr().solve(-f);
  }
}

// ---- conjugate gradients ----

using Vector = Eigen::ArrayXd;

constexpr long most_descents = 3000;

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
    equations_.jacobian(span(f_), span(g_));
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
    // A root close to 0 among large ones has lost its digits.
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

void descend(Equations& equations, Eigen::VectorXd& u, double tolerance, KernelReport& report) {
  Descent descent(equations, span(u));
  while (!(descent.largest() <= tolerance) && report.steps < most_descents) {
    ++report.steps;
    if (!descent.step()) break;
  }
  report.residuals = report.jacobian_products = 2 * report.steps + 1;
}

// ---- least squares ----

constexpr std::size_t most_inner = 200;  // of Steihaug's conjugate gradients, a step
constexpr int most_regions = 60;         // steps

// In GSL's unweighted norm the unknowns and equations are those of the problem times d = √w.
class Weighted {
 public:
  explicit Weighted(Equations& equations) : equations_(equations), d_(equations.scale()), work_(d_.size()) {}

  void scale(std::span<const double> from, std::span<double> to) const {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] * d_[i];
  }
  void unscale(std::span<const double> from, std::span<double> to) const {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] / d_[i];
  }
  void residual(std::span<const double> x, std::span<double> f) {
    unscale(x, work_);
    equations_.residual(work_, f);
    scale(f, f);
  }
  // d J d⁻¹ v, which is its own transpose.
  void product(std::span<const double> x, std::span<const double> v, std::span<double> out) {
    ++products;
    if (!std::ranges::equal(x, at_)) {
      at_.assign(x.begin(), x.end());
      unscale(x, work_);
      equations_.linearize(work_);
    }
    unscale(v, work_);
    equations_.jacobian(work_, out);
    scale(out, out);
  }

  long products = 0;

 private:
  Equations& equations_;
  std::vector<double> d_, work_, at_;
};

std::span<const double> span(const gsl_vector* v) { return {v->data, v->size}; }
std::span<double> span(gsl_vector* v) { return {v->data, v->size}; }

int weighted_residual(const gsl_vector* x, void* data, gsl_vector* f) {
  static_cast<Weighted*>(data)->residual(span(x), span(f));
  return GSL_SUCCESS;
}

int weighted_product(CBLAS_TRANSPOSE_t, const gsl_vector* x, const gsl_vector* v, void* data, gsl_vector* out,
                     gsl_matrix*) {
  if (out != nullptr) static_cast<Weighted*>(data)->product(span(x), span(v), span(out));
  return GSL_SUCCESS;
}

// Products after which the minimisation ends: seconds at any size.
long budget(std::size_t unknowns) {
  return std::clamp<long>(100'000'000 / static_cast<long>(unknowns), 500, 20000);
}

void minimise(Equations& equations, Eigen::VectorXd& u, double, KernelReport& report) {
  const std::size_t n = span(u).size();
  Weighted problem(equations);
  gsl_multilarge_nlinear_parameters parameters = gsl_multilarge_nlinear_default_parameters();
  parameters.trs = gsl_multilarge_nlinear_trs_cgst;
  parameters.solver = gsl_multilarge_nlinear_solver_none;
  parameters.scale = gsl_multilarge_nlinear_scale_levenberg;
  parameters.max_iter = std::min(n, most_inner);
  const std::unique_ptr<gsl_multilarge_nlinear_workspace, decltype(&gsl_multilarge_nlinear_free)> workspace(
      gsl_multilarge_nlinear_alloc(gsl_multilarge_nlinear_trust, &parameters, n, n),
      gsl_multilarge_nlinear_free);
  gsl_multilarge_nlinear_fdf system{weighted_residual, weighted_product, nullptr, n, n, &problem, 0, 0, 0, 0};
  problem.scale(span(u), span(u));
  const gsl_vector_const_view start = gsl_vector_const_view_array(u.data(), n);
  int status = gsl_multilarge_nlinear_init(&start.vector, &system, workspace.get()), found = 0;
  for (int i = 0; status == GSL_SUCCESS && found == 0 && i < most_regions; ++i) {
    status = gsl_multilarge_nlinear_iterate(workspace.get());
    gsl_multilarge_nlinear_test(1e-8, 1e-9, 0, &found, workspace.get());  // of the step, of the gradient
    if (problem.products >= budget(n)) break;
  }
  problem.unscale(span(gsl_multilarge_nlinear_position(workspace.get())), span(u));
  report.steps = static_cast<long>(gsl_multilarge_nlinear_niter(workspace.get()));
  report.residuals = static_cast<long>(system.nevalf);
  report.jacobian_products = problem.products;
}

// ---- what they share ----

std::unique_ptr<Equations> equations_of(const KernelRequest& request) {
  if (request.formulation == Formulation::patir)
    return std::make_unique<PatirEquations>(request.target, request.lags);
  return std::make_unique<ZeroPhaseEquations>(request.target, request.lags,
                                              request.formulation == Formulation::oriented);
}

template <class Iterate>
KernelReport solved_by(const KernelRequest& request, Iterate iterate) {
  const Stopwatch watch;
  KernelReport report;
  const std::unique_ptr<Equations> equations = equations_of(request);
  const std::vector<double> start = equations->start();
  Eigen::VectorXd u = Eigen::Map<const Eigen::VectorXd>(start.data(), equations->count());
  iterate(*equations, u, request.tolerance / 2, report);
  Field values = equations->kernel(span(u));
  auto measured = [&] {
    return evaluate_kernel(request.target, request.lags, *request.formulation, values).value().report;
  };
  KernelReport errors = measured();
  if (!(errors.residual <= request.tolerance)) {
    values /= std::sqrt(values.square().sum());
    errors = measured();
  }
  static_cast<IterationResult&>(errors) = report;
  errors.converged = errors.residual <= request.tolerance;
  errors.seconds = watch.seconds();
  return errors;
}

}  // namespace

KernelReport anderson_fixed_point(const KernelRequest& request) { return solved_by(request, accelerate); }
KernelReport conjugate_gradient(const KernelRequest& request) { return solved_by(request, descend); }
KernelReport least_squares(const KernelRequest& request) { return solved_by(request, minimise); }

}  // namespace asperity
