#include "math/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "math/kinsol.hpp"

namespace asperity {
namespace {

using namespace kinsol;

constexpr std::size_t vectors_at_depth = 3, further_vectors = 9;

// G, and when it has been evaluated enough.
class Evaluations {
 public:
  Evaluations(const FixedPointMap& map, std::span<const double> scale, const FixedPointOptions& options)
      : map_(map), scale_(scale), options_(options) {}

  // What KINSOL calls; not 0 ends its iteration.
  static int evaluate(N_Vector u, N_Vector g, void* data) {
    auto& self = *static_cast<Evaluations*>(data);
    return self.guarded_(-1, [&] { return self.evaluate(values(u), values(g)); });
  }
  const FixedPoint& result() const {
    guarded_.rethrow();
    return result_;
  }
  const std::vector<double>& last() const { return last_; }

 private:
  int evaluate(std::span<const double> u, std::span<double> g) {
    last_.assign(u.begin(), u.end());
    map_(u, g);
    ++result_.evaluations;
    result_.residual = 0;
    for (std::size_t i = 0; i < u.size(); ++i)
      result_.residual = std::max(result_.residual, std::abs(scale_[i] * (g[i] - u[i])));
    result_.converged = result_.residual <= options_.tolerance;
    return result_.converged || result_.evaluations >= options_.max_evaluations ? -1 : 0;
  }

  const FixedPointMap& map_;
  std::span<const double> scale_;
  const FixedPointOptions& options_;
  GuardedCall guarded_;
  std::vector<double> last_;
  FixedPoint result_;
};

}  // namespace

FixedPoint solve_fixed_point(const FixedPointMap& map, std::span<double> u, std::span<const double> scale,
                             const FixedPointOptions& options) {
  require_vectors(u.size(), vectors_at_depth * static_cast<std::size_t>(options.depth) + further_vectors);
  sundials::Context context;
  std::vector<double> ones(u.size(), 1);
  const Vector start = vector_of(u, context), unscaled = vector_of(ones, context);
  const Kinsol solver = made(Kinsol(KINCreate(context)));
  Evaluations evaluations(map, scale, options);
  silence(solver.get(), context);
  check(KINSetMAA(solver.get(), options.depth), "KINSetMAA");
  check(KINInit(solver.get(), Evaluations::evaluate, start.get()), "KINInit");
  check(KINSetUserData(solver.get(), &evaluations), "KINSetUserData");
  check(KINSetNumMaxIters(solver.get(), options.max_evaluations + 1), "KINSetNumMaxIters");
  check(KINSetFuncNormTol(solver.get(), std::numeric_limits<double>::min()), "KINSetFuncNormTol");
  const int flag = KINSol(solver.get(), start.get(), KIN_FP, unscaled.get(), unscaled.get());
  const FixedPoint& result = evaluations.result();
  if (result.evaluations == 0) check(flag < 0 ? flag : -1, "KINSol");
  std::ranges::copy(evaluations.last(), u.begin());
  return result;
}

}  // namespace asperity
