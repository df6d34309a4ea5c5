#include "acf/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "acf/guarded_call.hpp"
#include "acf/kinsol.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

using namespace kinsol;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_growth = 1e6;  // of the residual over its least: beyond it the iteration diverges

// Vectors that KINSOL clones beside the earlier iterates, their images and a basis of them.
constexpr std::size_t beside_earlier = 7;

// What a callback returns to KINSOL.
constexpr int done = 0, give_up = -1;

// G(u) = u - M F(u), and the best iterate.
class FixedPoint {
 public:
  FixedPoint(Equations& equations, const FixedPointOptions& options)
      : equations_(equations), options_(options) {}

  static int map(N_Vector u, N_Vector g, void* data) {
    auto& self = *static_cast<FixedPoint*>(data);
    return self.guarded_(give_up, [&] { return self.map(values(u), values(g)); });
  }

  IterationResult finish(std::span<double> u) const {
    guarded_.rethrow();
    std::ranges::copy(best_, u.begin());
    IterationResult out;
    out.steps = out.preconditionings = steps_;
    out.converged = least_ <= options_.tolerance;
    out.reason = out.converged ? "solved" : reason_;
    return out;
  }

 private:
  // KINSOL is told to give up where the iteration has ended, well or badly.
  int map(std::span<const double> u, std::span<double> g) {
    equations_.residual(u, g);
    const double largest = largest_absolute(g);
    if (largest < least_) {
      least_ = largest;
      best_.assign(u.begin(), u.end());
    }
    if (options_.on_step)
      options_.on_step({steps_, 0, largest, static_cast<double>(steps_) / options_.max_iterations});
    reason_ = ending(largest);
    if (!reason_.empty()) return give_up;
    ++steps_;
    equations_.linearize(u);
    equations_.precondition(g);
    for (std::size_t i = 0; i < g.size(); ++i) g[i] = u[i] - g[i];
    return done;
  }

  std::string ending(double largest) const {
    if (largest <= options_.tolerance) return "solved";
    if (!(largest <= most_growth * least_ && largest < infinity)) return "the iteration diverges";
    return steps_ == options_.max_iterations ? "not solved in " + counted(steps_, "iteration") : "";
  }

  Equations& equations_;
  const FixedPointOptions& options_;
  GuardedCall guarded_;
  std::vector<double> best_;
  double least_ = infinity;
  long steps_ = 0;
  std::string reason_;
};

}  // namespace

IterationResult solve_fixed_point(Equations& equations, std::span<double> u,
                                  const FixedPointOptions& options) {
  FixedPoint iteration(equations, options);
  std::vector<double> scales = equations.scale();
  const long depth = std::min<long>(options.depth, static_cast<long>(u.size()));
  VectorStore store(u.size(), static_cast<std::size_t>(3 * depth) + beside_earlier);
  sundials::Context context;
  const Vector iterate = vector_of(u, context, store), scale = vector_of(scales, context, store);
  const Kinsol kinsol = made(Kinsol(KINCreate(context)));
  silence(kinsol.get(), context);
  check(KINSetMAA(kinsol.get(), depth), "KINSetMAA");
  check(KINInit(kinsol.get(), FixedPoint::map, iterate.get()), "KINInit");
  check(KINSetUserData(kinsol.get(), &iteration), "KINSetUserData");
  check(KINSetNumMaxIters(kinsol.get(), options.max_iterations + 2), "KINSetNumMaxIters");
  // FixedPoint decides on convergence: here it is G(u) = u to the last bit.
  check(KINSetFuncNormTol(kinsol.get(), std::numeric_limits<double>::min()), "KINSetFuncNormTol");
  const int flag = KINSol(kinsol.get(), iterate.get(), KIN_FP, scale.get(), scale.get());
  if (flag != KIN_SYSFUNC_FAIL && flag != KIN_FIRST_SYSFUNC_ERR) check(flag, "KINSol");
  IterationResult result = iteration.finish(u);
  result.residuals = counter(kinsol.get(), KINGetNumFuncEvals);
  return result;
}

}  // namespace asperity
