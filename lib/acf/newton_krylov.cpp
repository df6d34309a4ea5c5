#include "acf/newton_krylov.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>

#include <Eigen/Core>
#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.hpp>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include "grid/field.hpp"
#include "grid/stopwatch.hpp"

namespace asperity {
namespace {

struct FreeVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct FreeSolver {
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
struct FreeKinsol {
  void operator()(void* memory) const { KINFree(&memory); }
};
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreeSolver>;
using Kinsol = std::unique_ptr<void, FreeKinsol>;

void check(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(std::string(call) + " failed with " + std::to_string(flag));
}

template <class Pointer>
Pointer made(Pointer pointer, const char* call) {
  if (!pointer) throw std::runtime_error(std::string(call) + " failed");
  return pointer;
}

std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<std::size_t>(N_VGetLength(v))};
}

using Array = Eigen::Map<Eigen::ArrayXd>;
Array array(N_Vector v) { return {N_VGetArrayPointer(v), static_cast<Index>(N_VGetLength(v))}; }

// SUNDIALS' serial vector over `values`, with the operations of GMRES by vector instructions: as the library
// is packaged they would take as long as the transforms.
Vector vector_of(std::span<double> values, sundials::Context& context) {
  Vector v = made(Vector(N_VMake_Serial(static_cast<sunindextype>(values.size()), values.data(), context)),
                  "N_VMake_Serial");
  auto* operation = v->ops;
  operation->nvdotprod = [](N_Vector x, N_Vector y) { return (array(x) * array(y)).sum(); };
  operation->nvprod = [](N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) * array(y); };
  operation->nvdiv = [](N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) / array(y); };
  operation->nvabs = [](N_Vector x, N_Vector z) { array(z) = array(x).abs(); };
  operation->nvinv = [](N_Vector x, N_Vector z) { array(z) = array(x).inverse(); };
  operation->nvconst = [](sunrealtype c, N_Vector z) { array(z) = c; };
  operation->nvscale = [](sunrealtype c, N_Vector x, N_Vector z) { array(z) = c * array(x); };
  operation->nvlinearsum = [](sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z) {
    array(z) = a * array(x) + b * array(y);
  };
  operation->nvwl2norm = [](N_Vector x, N_Vector w) {
    return std::sqrt((array(x) * array(w)).square().sum());
  };
  operation->nvmaxnorm = [](N_Vector x) { return array(x).abs().maxCoeff<Eigen::PropagateNaN>(); };
  return v;
}
std::span<double> unchanged(const std::vector<double>& v) {
  return {const_cast<double*>(v.data()), v.size()};
}

// Adds the seconds of its life to a sum.
class Timer {
 public:
  explicit Timer(double& sum) : sum_(sum) {}
  ~Timer() { sum_ += watch_.seconds(); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  double& sum_;
  Stopwatch watch_;
};

// Refusals of ever shorter steps after which the iteration ends. KINSOL itself gives up at the fifth.
constexpr int most_refusals = 4;

// What the C callbacks share: the system, the iterate of the present step, and what ends the iteration.
//
// KINSOL announces on stderr that an iteration has failed, and what would silence it differs from version to
// version. An iteration that has used up its means is therefore ended in peace: its next residual is zero,
// KINSOL takes itself for converged, and the last true iterate is put back.
class Callbacks {
 public:
  Callbacks(const NonlinearSystem& system, const NewtonOptions& options)
      : system_(system), options_(options) {}

  int residual(std::span<const double> u, std::span<double> f) {
    if (!stopped() && !evaluate(u, f)) {
      if (++refusals_ < most_refusals) return 1;  // a recoverable error, in KINSOL's convention
      stop("every shorter step leaves the domain of the equations");
    }
    refusals_ = 0;
    if (stopped()) std::fill(f.begin(), f.end(), 0.0);
    return 0;
  }
  int linearize(std::span<const double> u) {
    iterate_.assign(u.begin(), u.end());
    if (steps_ == options_.max_steps) stop("not solved in " + std::to_string(steps_) + " Newton steps");
    if (products_ >= options_.max_products)
      stop("not solved with " + std::to_string(products_) + " Jacobian products");
    if (stopped()) return 0;
    ++steps_;
    const Timer timer(system_seconds_);
    system_.linearize(u);
    return 0;
  }
  int precondition(std::span<double> v) {
    if (stopped()) return 0;
    ++preconditionings_;
    const Timer timer(system_seconds_);
    system_.precondition(v);
    return 0;
  }
  int jacobian(std::span<const double> v, std::span<double> out) {
    if (stopped()) return std::copy(v.begin(), v.end(), out.begin()), 0;
    ++products_;
    const Timer timer(system_seconds_);
    system_.jacobian(v, out);
    return 0;
  }

  template <class Work>
  static int guarded(void* data, Work work) {
    auto& self = *static_cast<Callbacks*>(data);
    try {
      return work(self);
    } catch (...) {
      self.failure_ = std::current_exception();
      self.stop("exception");
      return work(self);
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  bool stopped() const { return !reason_.empty(); }
  const std::string& reason() const { return reason_; }
  const std::vector<double>& iterate() const { return iterate_; }
  const std::vector<double>& scale() const { return system_.scale; }
  void count(IterationResult& result) const {
    result.steps = steps_;
    result.jacobian_products = products_;
    result.preconditionings = preconditionings_;
    result.system_seconds = system_seconds_;
  }

 private:
  bool evaluate(std::span<const double> u, std::span<double> f) {
    const Timer timer(system_seconds_);
    return system_.residual(u, f);
  }
  void stop(std::string reason) {
    if (!stopped()) reason_ = std::move(reason);
  }

  const NonlinearSystem& system_;
  const NewtonOptions& options_;
  std::vector<double> iterate_;
  int refusals_ = 0, steps_ = 0, products_ = 0, preconditionings_ = 0;
  double system_seconds_ = 0;
  std::string reason_;
  std::exception_ptr failure_;
};

int residual(N_Vector u, N_Vector f, void* data) {
  return Callbacks::guarded(data, [&](Callbacks& c) { return c.residual(values(u), values(f)); });
}

int linearize(N_Vector u, N_Vector, N_Vector, N_Vector, void* data) {
  return Callbacks::guarded(data, [&](Callbacks& c) { return c.linearize(values(u)); });
}

int precondition(N_Vector, N_Vector, N_Vector, N_Vector, N_Vector v, void* data) {
  return Callbacks::guarded(data, [&](Callbacks& c) { return c.precondition(values(v)); });
}

template <class Boolean>  // booleantype in SUNDIALS 6, sunbooleantype in 7
int jacobian(N_Vector v, N_Vector out, N_Vector, Boolean*, void* data) {
  return Callbacks::guarded(data, [&](Callbacks& c) { return c.jacobian(values(v), values(out)); });
}

// G(u) = u - M F(u) for KINSOL's fixed point, with the best iterate. An iteration that has ended, well or
// badly, is given G(u) = u and takes itself for converged.
class FixedPoint {
 public:
  FixedPoint(const NonlinearSystem& system, const FixedPointOptions& options)
      : system_(system), options_(options) {}

  int map(std::span<const double> u, std::span<double> g) try {
    if (reason_.empty()) advance(u, g);
    if (!reason_.empty()) std::copy(u.begin(), u.end(), g.begin());
    return 0;
  } catch (...) {
    failure_ = std::current_exception();
    reason_ = "exception";
    std::copy(u.begin(), u.end(), g.begin());
    return 0;
  }

  void finish(std::span<double> u, IterationResult& result) const {
    if (failure_) std::rethrow_exception(failure_);
    if (!best_.empty()) std::copy(best_.begin(), best_.end(), u.begin());
    result.steps = result.preconditionings = steps_;
    result.converged = least_ <= options_.tolerance;
    result.reason = result.converged ? "solved" : reason_;
  }

 private:
  void advance(std::span<const double> u, std::span<double> g) {
    if (!system_.residual(u, g)) return end("an iterate left the domain of the equations");
    double largest = 0;
    for (double f : g) largest = std::max(largest, std::isfinite(f) ? std::abs(f) : infinity);
    if (largest < least_) {
      least_ = largest;
      best_.assign(u.begin(), u.end());
    }
    if (largest <= options_.tolerance) return end("solved");
    if (!(largest <= 1e6 * least_ && largest < infinity)) return end("the iteration diverges");
    if (steps_ == options_.max_iterations)
      return end("not solved in " + std::to_string(steps_) + " iterations");
    ++steps_;
    system_.linearize(u);
    system_.precondition(g);
    for (std::size_t i = 0; i < g.size(); ++i) g[i] = u[i] - g[i];
  }
  void end(std::string reason) { reason_ = std::move(reason); }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const NonlinearSystem& system_;
  const FixedPointOptions& options_;
  std::vector<double> best_;
  double least_ = infinity;
  long steps_ = 0;
  std::string reason_;
  std::exception_ptr failure_;
};

int fixed_point(N_Vector u, N_Vector g, void* data) {
  return static_cast<FixedPoint*>(data)->map(values(u), values(g));
}

std::string flag_name(int flag) {
  const std::unique_ptr<char, decltype(&std::free)> name(KINGetReturnFlagName(flag), &std::free);
  return name ? name.get() : std::to_string(flag);
}

// KINSOL with its context, vectors and linear solver, destroyed in the reverse order.
class Iteration {
 public:
  Iteration(std::span<double> u, Callbacks& callbacks, const NewtonOptions& options)
      : callbacks_(callbacks),
        u_(vector_of(u, context_)),
        scale_(vector_of(unchanged(callbacks.scale()), context_)),
        gmres_(
            made(LinearSolver(SUNLinSol_SPGMR(u_.get(), SUN_PREC_RIGHT, options.krylov_dimension, context_)),
                 "SUNLinSol_SPGMR")),
        kinsol_(made(Kinsol(KINCreate(context_)), "KINCreate")) {
    check(SUNLinSol_SPGMRSetMaxRestarts(gmres_.get(), options.restarts), "SUNLinSol_SPGMRSetMaxRestarts");
    check(KINInit(memory(), residual, u_.get()), "KINInit");
    // Before the linear solver is set, which copies it.
    check(KINSetUserData(memory(), &callbacks_), "KINSetUserData");
    set_tolerances(options);
    set_linear_solver(options);
  }

  int run() {
    const int flag = KINSol(memory(), u_.get(), KIN_LINESEARCH, scale_.get(), scale_.get());
    callbacks_.rethrow();
    for (int misuse : {KIN_MEM_NULL, KIN_ILL_INPUT, KIN_NO_MALLOC, KIN_MEM_FAIL, KIN_LINIT_FAIL})
      if (flag == misuse) check(flag, "KINSol");
    return flag;
  }

  long residuals() {
    long count = 0;
    check(KINGetNumFuncEvals(memory(), &count), "KINGetNumFuncEvals");
    return count;
  }

 private:
  void* memory() { return kinsol_.get(); }

  void set_tolerances(const NewtonOptions& options) {
    check(KINSetFuncNormTol(memory(), options.tolerance), "KINSetFuncNormTol");
    check(KINSetScaledStepTol(memory(), options.step_tolerance), "KINSetScaledStepTol");
    check(KINSetNumMaxIters(memory(), options.max_steps + 2), "KINSetNumMaxIters");  // Callbacks count
  }

  void set_linear_solver(const NewtonOptions& options) {
    check(KINSetLinearSolver(memory(), gmres_.get(), nullptr), "KINSetLinearSolver");
    check(KINSetJacTimesVecFn(memory(), jacobian), "KINSetJacTimesVecFn");
    check(KINSetPreconditioner(memory(), linearize, precondition), "KINSetPreconditioner");
    // A preconditioner for every step: keeping one for ten, the default, nearly doubles the products.
    check(KINSetMaxSetupCalls(memory(), 1), "KINSetMaxSetupCalls");
    check(KINSetEtaForm(memory(), KIN_ETACONSTANT), "KINSetEtaForm");
    check(KINSetEtaConstValue(memory(), options.forcing), "KINSetEtaConstValue");
  }

  Callbacks& callbacks_;
  sundials::Context context_;
  Vector u_, scale_;
  LinearSolver gmres_;
  Kinsol kinsol_;
};

}  // namespace

IterationResult solve_newton_krylov(const NonlinearSystem& system, std::span<double> u,
                                    const NewtonOptions& options) {
  const Stopwatch watch;
  Callbacks callbacks(system, options);
  Iteration iteration(u, callbacks, options);
  const int flag = iteration.run();
  if (callbacks.stopped() && !callbacks.iterate().empty())
    std::copy(callbacks.iterate().begin(), callbacks.iterate().end(), u.begin());
  IterationResult result;
  callbacks.count(result);
  result.residuals = iteration.residuals();
  result.converged = !callbacks.stopped() && (flag == KIN_SUCCESS || flag == KIN_INITIAL_GUESS_OK);
  result.reason = result.converged ? "solved" : callbacks.stopped() ? callbacks.reason() : flag_name(flag);
  result.seconds = watch.seconds();
  return result;
}

IterationResult solve_fixed_point(const NonlinearSystem& system, std::span<double> u,
                                  const FixedPointOptions& options) {
  const Stopwatch watch;
  FixedPoint iteration(system, options);
  sundials::Context context;
  const Vector iterate = vector_of(u, context), scale = vector_of(unchanged(system.scale), context);
  const Kinsol kinsol = made(Kinsol(KINCreate(context)), "KINCreate");
  check(KINSetMAA(kinsol.get(), std::min<long>(options.depth, static_cast<long>(u.size()))), "KINSetMAA");
  check(KINInit(kinsol.get(), fixed_point, iterate.get()), "KINInit");
  check(KINSetUserData(kinsol.get(), &iteration), "KINSetUserData");
  check(KINSetNumMaxIters(kinsol.get(), options.max_iterations + 2), "KINSetNumMaxIters");
  // FixedPoint decides on convergence: here it is G(u) = u to the last bit.
  check(KINSetFuncNormTol(kinsol.get(), std::numeric_limits<double>::min()), "KINSetFuncNormTol");
  check(KINSol(kinsol.get(), iterate.get(), KIN_FP, scale.get(), scale.get()), "KINSol");
  IterationResult result;
  iteration.finish(u, result);
  check(KINGetNumFuncEvals(kinsol.get(), &result.residuals), "KINGetNumFuncEvals");
  result.seconds = watch.seconds();
  return result;
}

std::string sundials_version() { return std::string("SUNDIALS ") + SUNDIALS_VERSION; }

}  // namespace asperity
