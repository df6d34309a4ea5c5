#include "acf/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "acf/kinsol.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

using namespace kinsol;

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
    if (steps_ == options_.max_iterations) return end("not solved in " + counted(steps_, "iteration"));
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

// Vectors that KINSOL clones beside the earlier iterates, their images and a basis of them.
constexpr std::size_t beside_earlier = 7;

int fixed_point(N_Vector u, N_Vector g, void* data) {
  return static_cast<FixedPoint*>(data)->map(values(u), values(g));
}

}  // namespace

IterationResult solve_fixed_point(const NonlinearSystem& system, std::span<double> u,
                                  const FixedPointOptions& options) {
  const Stopwatch watch;
  FixedPoint iteration(system, options);
  const long depth = std::min<long>(options.depth, static_cast<long>(u.size()));
  VectorStore store(u.size(), static_cast<std::size_t>(3 * depth) + beside_earlier);
  sundials::Context context;
  const Vector iterate = vector_of(u, context, store),
               scale = vector_of(unchanged(system.scale), context, store);
  const Kinsol kinsol = made(Kinsol(KINCreate(context)));
  silence(kinsol.get(), context);
  check(KINSetMAA(kinsol.get(), depth), "KINSetMAA");
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

}  // namespace asperity
