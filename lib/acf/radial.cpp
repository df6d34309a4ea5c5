#include "acf/radial.hpp"

#include <cmath>
#include <memory>
#include <new>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

namespace asperity {

QuinticTable::QuinticTable(double first, double step, const std::vector<Node>& nodes)
    : first_(first), step_(step) {
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double f0 = nodes[i][0], d0 = step * nodes[i][1], s0 = step * step * nodes[i][2];
    const double f1 = nodes[i + 1][0], d1 = step * nodes[i + 1][1], s1 = step * step * nodes[i + 1][2];
    const double rise = f1 - f0;
    pieces_.push_back({f0, d0, s0 / 2, 10 * rise - 6 * d0 - 4 * d1 - 1.5 * s0 + 0.5 * s1,
                       -15 * rise + 8 * d0 + 7 * d1 + 1.5 * s0 - s1,
                       6 * rise - 3 * d0 - 3 * d1 - 0.5 * s0 + 0.5 * s1});
  }
}

double falls_to(const std::function<double(double)>& correlation, double t) {
  auto excess = [&](double log_r) { return correlation(std::exp(log_r)) - t; };
  double low = std::log(0.01), high = low;
  while (excess(high) > 0) low = high, high += 0.1;
  while (!(excess(low) > 0)) {
    if (low < std::log(1e-300)) return 0;
    high = low, low -= 2;
  }
  using Excess = decltype(excess);
  gsl_function f{[](double x, void* g) { return (*static_cast<Excess*>(g))(x); }, &excess};
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (!solver) throw std::bad_alloc();
  gsl_root_fsolver_set(solver.get(), &f, low, high);
  for (int i = 0; i < 200 && gsl_root_test_interval(low, high, 1e-15, 0) == GSL_CONTINUE; ++i) {
    gsl_root_fsolver_iterate(solver.get());
    low = gsl_root_fsolver_x_lower(solver.get());
    high = gsl_root_fsolver_x_upper(solver.get());
  }
  return std::exp(gsl_root_fsolver_root(solver.get()));
}

}  // namespace asperity
