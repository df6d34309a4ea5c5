#include "acf/newton_krylov.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <memory>

#include "acf/kinsol.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

using namespace kinsol;

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

// What a callback returns to KINSOL.
constexpr int done = 0, shorten_step = 1, give_up = -1;

// What the C callbacks share: the system, the iterate of the present step, and what ends the iteration.
class Callbacks {
 public:
  Callbacks(const NonlinearSystem& system, const NewtonOptions& options)
      : system_(system), options_(options) {}

  int residual(std::span<const double> u, std::span<double> f) {
    const Timer timer(system_seconds_);
    if (system_.residual(u, f)) return refusals_ = 0, done;
    if (steps_ == 0) return stop("the start lies outside the domain of the equations");
    if (++refusals_ < most_refusals) return shorten_step;
    return stop("every shorter step leaves the domain of the equations");
  }
  int linearize(std::span<const double> u) {
    iterate_.assign(u.begin(), u.end());
    if (steps_ == options_.max_steps) return stop("not solved in " + counted(steps_, "Newton step"));
    if (products_ >= options_.max_products)
      return stop("not solved with " + counted(products_, "Jacobian product"));
    ++steps_;
    const Timer timer(system_seconds_);
    system_.linearize(u);
    return done;
  }
  int precondition(std::span<double> v) {
    ++preconditionings_;
    const Timer timer(system_seconds_);
    system_.precondition(v);
    return done;
  }
  int jacobian(std::span<const double> v, std::span<double> out) {
    ++products_;
    const Timer timer(system_seconds_);
    system_.jacobian(v, out);
    return done;
  }

  template <class Work>
  static int guarded(void* data, Work work) {
    auto& self = *static_cast<Callbacks*>(data);
    try {
      return work(self);
    } catch (...) {
      self.failure_ = std::current_exception();
      return give_up;
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
  int stop(std::string reason) {
    reason_ = std::move(reason);
    return give_up;
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

std::string flag_name(int flag) {
  const std::unique_ptr<char, decltype(&std::free)> name(KINGetReturnFlagName(flag), &std::free);
  return name ? name.get() : std::to_string(flag);
}

// Vectors that are cloned beside the directions of GMRES: one direction more, its two of work, KINSOL's five.
constexpr std::size_t beside_directions = 8;

// KINSOL with its context, vectors and linear solver, destroyed in the reverse order.
class Iteration {
 public:
  Iteration(std::span<double> u, Callbacks& callbacks, const NewtonOptions& options)
      : callbacks_(callbacks),
        store_(u.size(), static_cast<std::size_t>(options.krylov_dimension) + beside_directions),
        u_(vector_of(u, context_, store_)),
        scale_(vector_of(unchanged(callbacks.scale()), context_, store_)),
        gmres_(made(
            LinearSolver(SUNLinSol_SPGMR(u_.get(), SUN_PREC_RIGHT, options.krylov_dimension, context_)))),
        kinsol_(made(Kinsol(KINCreate(context_)))) {
    check(SUNLinSol_SPGMRSetMaxRestarts(gmres_.get(), options.restarts), "SUNLinSol_SPGMRSetMaxRestarts");
    silence(memory(), context_);
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
  VectorStore store_;
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

}  // namespace asperity
