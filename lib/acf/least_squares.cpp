#include "acf/least_squares.hpp"

#include <algorithm>
#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multilarge_nlinear.h>

#include "acf/guarded_call.hpp"

namespace asperity {
namespace {

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
  // J v, or J*v: their weighted forms are d J d⁻¹ and d J* d⁻¹.
  void product(bool adjoint, std::span<const double> x, std::span<const double> v, std::span<double> out) {
    ++products;
    if (!std::ranges::equal(x, at_)) {
      at_.assign(x.begin(), x.end());
      unscale(x, work_);
      equations_.linearize(work_);
    }
    unscale(v, work_);
    adjoint ? equations_.adjoint(work_, out) : equations_.jacobian(work_, out);
    scale(out, out);
  }

  // max |F| of a residual in GSL's norm.
  double largest(std::span<const double> f) const {
    double out = 0;
    for (std::size_t i = 0; i < f.size(); ++i) out = std::max(out, std::abs(f[i] / d_[i]));
    return out;
  }

  GuardedCall guarded;
  long products = 0;

 private:
  Equations& equations_;
  std::vector<double> d_, work_, at_;
};

std::span<const double> span(const gsl_vector* v) { return {v->data, v->size}; }
std::span<double> span(gsl_vector* v) { return {v->data, v->size}; }

int residual(const gsl_vector* x, void* data, gsl_vector* f) {
  auto& problem = *static_cast<Weighted*>(data);
  return problem.guarded(GSL_EFAILED, [&] { return problem.residual(span(x), span(f)), GSL_SUCCESS; });
}

int product(CBLAS_TRANSPOSE_t transposed, const gsl_vector* x, const gsl_vector* v, void* data,
            gsl_vector* out, gsl_matrix*) {
  auto& problem = *static_cast<Weighted*>(data);
  if (out == nullptr) return GSL_SUCCESS;
  return problem.guarded(GSL_EFAILED, [&] {
    problem.product(transposed == CblasTrans, span(x), span(v), span(out));
    return GSL_SUCCESS;
  });
}

constexpr std::size_t most_inner = 200;  // of Steihaug's conjugate gradients, a step

struct FreeWorkspace {
  void operator()(gsl_multilarge_nlinear_workspace* w) const { gsl_multilarge_nlinear_free(w); }
};

}  // namespace

IterationResult minimise_squares(Equations& equations, std::span<double> u,
                                 const LeastSquaresOptions& options) {
  Weighted problem(equations);
  gsl_multilarge_nlinear_parameters parameters = gsl_multilarge_nlinear_default_parameters();
  parameters.trs = gsl_multilarge_nlinear_trs_cgst;
  parameters.solver = gsl_multilarge_nlinear_solver_none;
  parameters.scale = gsl_multilarge_nlinear_scale_levenberg;
  parameters.max_iter = std::min<std::size_t>(u.size(), most_inner);
  const std::unique_ptr<gsl_multilarge_nlinear_workspace, FreeWorkspace> workspace(
      gsl_multilarge_nlinear_alloc(gsl_multilarge_nlinear_trust, &parameters, u.size(), u.size()));
  if (!workspace) throw std::bad_alloc();
  gsl_multilarge_nlinear_fdf system{residual, product, nullptr, u.size(), u.size(), &problem, 0, 0, 0, 0};
  problem.scale(u, u);
  const gsl_vector_const_view start = gsl_vector_const_view_array(u.data(), u.size());
  int status = gsl_multilarge_nlinear_init(&start.vector, &system, workspace.get());
  int found = 0;
  auto tell = [&] {
    if (options.on_step)
      options.on_step({static_cast<long>(gsl_multilarge_nlinear_niter(workspace.get())), problem.products,
                       problem.largest(span(gsl_multilarge_nlinear_residual(workspace.get()))),
                       static_cast<double>(problem.products) / static_cast<double>(options.max_products)});
  };
  tell();
  for (int i = 0; status == GSL_SUCCESS && found == 0 && i < options.max_iterations; ++i) {
    status = gsl_multilarge_nlinear_iterate(workspace.get());
    gsl_multilarge_nlinear_test(options.step_tolerance, options.gradient_tolerance, 0, &found,
                                workspace.get());
    tell();
    if (problem.products >= options.max_products) break;
  }
  problem.guarded.rethrow();
  problem.unscale(span(gsl_multilarge_nlinear_position(workspace.get())), u);
  IterationResult result;
  result.converged = found != 0 || status == GSL_ENOPROG;
  result.reason = result.converged ? "least squares" : "least squares, stopped by the budget";
  result.steps = static_cast<long>(gsl_multilarge_nlinear_niter(workspace.get()));
  result.jacobian_products = problem.products;
  result.residuals = static_cast<long>(system.nevalf);
  return result;
}

}  // namespace asperity
