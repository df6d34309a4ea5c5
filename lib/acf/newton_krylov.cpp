#include "acf/newton_krylov.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "math/kinsol.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

using namespace kinsol;

// Refusals of ever shorter steps after which the iteration ends. KINSOL itself gives up at the fifth.
constexpr int most_refusals = 4;

// What a callback returns to KINSOL.
constexpr int done = 0, shorten_step = 1, give_up = -1;

// Vectors that are cloned in addition to the directions of GMRES: one more direction, two for its work, five
// of KINSOL.
constexpr std::size_t more_than_directions = 8;

std::string flag_name(int flag) {
  const std::unique_ptr<char, decltype(&std::free)> name(KINGetReturnFlagName(flag), &std::free);
  return name ? name.get() : std::to_string(flag);
}

// KINSOL with its context, vectors and linear solver, and what it calls back.
class Iteration {
 public:
  Iteration(Equations& equations, std::span<double> u, const NewtonOptions& options)
      : equations_(equations),
        options_(options),
        unknowns_(u),
        scales_(equations.scale()),
        u_(vector_of(u, context_)),
        scale_(vector_of(scales_, context_)),
        gmres_(made(
            LinearSolver(SUNLinSol_SPGMR(u_.get(), SUN_PREC_RIGHT, options.krylov_dimension, context_)))),
        kinsol_(made(Kinsol(KINCreate(context_)))) {
    check(SUNLinSol_SPGMRSetMaxRestarts(gmres_.get(), options.restarts), "SUNLinSol_SPGMRSetMaxRestarts");
    silence(memory(), context_);
    check(KINInit(memory(), residual, u_.get()), "KINInit");
    // Before the linear solver is set, which copies it.
    check(KINSetUserData(memory(), this), "KINSetUserData");
    check(KINSetFuncNormTol(memory(), options.tolerance), "KINSetFuncNormTol");
    check(KINSetScaledStepTol(memory(), options.step_tolerance), "KINSetScaledStepTol");
    check(KINSetNumMaxIters(memory(), options.max_steps), "KINSetNumMaxIters");
    set_linear_solver();
  }
  Iteration(const Iteration&) = delete;
  Iteration& operator=(const Iteration&) = delete;

  IterationResult run() {
    const int flag = KINSol(memory(), u_.get(), KIN_LINESEARCH, scale_.get(), scale_.get());
    guarded_.rethrow();
    for (int misuse : {KIN_MEM_NULL, KIN_ILL_INPUT, KIN_NO_MALLOC, KIN_MEM_FAIL, KIN_LINIT_FAIL})
      if (flag == misuse) check(flag, "KINSol");
    if (!stopped_.empty()) std::ranges::copy(iterate_, unknowns_.begin());
    IterationResult out;
    out.steps = counter(KINGetNumNonlinSolvIters) - (flag == KIN_LSETUP_FAIL ? 1 : 0);  // the last not taken
    out.residuals = counter(KINGetNumFuncEvals);
    out.jacobian_products = counter(KINGetNumJtimesEvals);
    out.preconditionings = counter(KINGetNumPrecSolves);
    out.equation_seconds = seconds_;
    out.converged = stopped_.empty() && (flag == KIN_SUCCESS || flag == KIN_INITIAL_GUESS_OK);
    out.reason = out.converged ? "solved" : stopped_.empty() ? ending(flag, out.steps) : stopped_;
    if (out.steps > 0) tell(out.steps);
    return out;
  }

 private:
  template <class Work>
  static int guarded(void* data, Work work) {
    auto& self = *static_cast<Iteration*>(data);
    const Stopwatch watch;
    const int result = self.guarded_(give_up, [&] { return work(self); });
    self.seconds_ += watch.seconds();
    return result;
  }
  static int residual(N_Vector u, N_Vector f, void* data) {
    return guarded(data, [&](Iteration& i) { return i.residual(values(u), values(f)); });
  }
  static int linearize(N_Vector u, N_Vector, N_Vector, N_Vector, void* data) {
    return guarded(data, [&](Iteration& i) { return i.linearize(values(u)); });
  }
  static int precondition(N_Vector, N_Vector, N_Vector, N_Vector, N_Vector v, void* data) {
    return guarded(data, [&](Iteration& i) {
      i.equations_.precondition(values(v));
      return done;
    });
  }
  template <class Boolean>  // booleantype in SUNDIALS 6, sunbooleantype in 7
  static int jacobian(N_Vector v, N_Vector out, N_Vector, Boolean*, void* data) {
    return guarded(data, [&](Iteration& i) {
      i.equations_.jacobian(values(v), values(out));
      return done;
    });
  }

  int residual(std::span<const double> u, std::span<double> f) {
    const bool inside = equations_.residual(u, f);
    if (options_.on_step) largest_ = largest_absolute(f);
    if (inside) return refusals_ = 0, done;
    if (counter(KINGetNumNonlinSolvIters) == 0)
      return stop("the start lies outside the domain of the equations");
    if (++refusals_ < most_refusals) return shorten_step;
    return stop("every shorter step leaves the domain of the equations");
  }

  int linearize(std::span<const double> u) {
    iterate_.assign(u.begin(), u.end());
    const long products = counter(KINGetNumJtimesEvals);
    if (products >= options_.max_products)
      return stop("not solved with " + counted(products, "Jacobian product"));
    tell(counter(KINGetNumNonlinSolvIters) - 1);
    equations_.linearize(u);
    return done;
  }

  int stop(std::string reason) {
    stopped_ = std::move(reason);
    return give_up;
  }

  void tell(long step) {
    if (options_.on_step)
      options_.on_step(
          {step, counter(KINGetNumJtimesEvals), largest_, static_cast<double>(step) / options_.max_steps});
  }

  std::string ending(int flag, long steps) const {
    return flag == KIN_MAXITER_REACHED ? "not solved in " + counted(steps, "Newton step") : flag_name(flag);
  }

  void set_linear_solver() {
    check(KINSetLinearSolver(memory(), gmres_.get(), nullptr), "KINSetLinearSolver");
    check(KINSetJacTimesVecFn(memory(), jacobian), "KINSetJacTimesVecFn");
    check(KINSetPreconditioner(memory(), linearize, precondition), "KINSetPreconditioner");
    // A preconditioner for every step: keeping one for ten, the default, nearly doubles the products.
    check(KINSetMaxSetupCalls(memory(), 1), "KINSetMaxSetupCalls");
    check(KINSetEtaForm(memory(), KIN_ETACONSTANT), "KINSetEtaForm");
    check(KINSetEtaConstValue(memory(), options_.forcing), "KINSetEtaConstValue");
  }

  void* memory() const { return kinsol_.get(); }
  // KINGetNumFuncEvals and its like.
  long counter(int (*get)(void*, long*)) const {
    long count = 0;
    check(get(memory(), &count), "a counter of KINSOL");
    return count;
  }

  Equations& equations_;
  const NewtonOptions& options_;
  std::span<double> unknowns_;
  std::vector<double> scales_;
  sundials::Context context_;
  Vector u_, scale_;
  LinearSolver gmres_;
  Kinsol kinsol_;

  GuardedCall guarded_;
  std::vector<double> iterate_;  // of the present step
  std::string stopped_;          // why, where a callback has ended the iteration
  int refusals_ = 0;
  double seconds_ = 0, largest_ = 0;
};

}  // namespace

IterationResult solve_newton_krylov(Equations& equations, std::span<double> u, const NewtonOptions& options) {
  require_vectors(u.size(), static_cast<std::size_t>(options.krylov_dimension) + more_than_directions);
  return Iteration(equations, u, options).run();
}

std::string sundials_version() { return std::string("SUNDIALS ") + SUNDIALS_VERSION; }

}  // namespace asperity
