#include "contact/hertz.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_sf_ellint.h>

namespace asperity {
namespace {

constexpr double pi = std::numbers::pi;

double carlson_d(double x, double y, double z) { return gsl_sf_ellint_RD(x, y, z, GSL_PREC_DOUBLE); }

// ln(B/A) of (4) for k = exp t, less the one wanted.
double mismatch(double t, void* wanted) {
  const double k2 = std::exp(2 * t);
  return std::log(carlson_d(0, 1, k2) / carlson_d(0, k2, 1)) - *static_cast<double*>(wanted);
}

// k ≤ 1 for B/A = exp(ratio) ≥ 1; it lies above A/B, for B/A ≥ 1/k.
double axes_ratio(double ratio) {
  if (ratio == 0) return 1;
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_function f{&mismatch, &ratio};
  double low = -ratio, high = 0;
  gsl_root_fsolver_set(solver.get(), &f, low, high);
  for (int i = 0; i < 100 && gsl_root_test_interval(low, high, 2e-16, 2e-16) == GSL_CONTINUE; ++i) {
    gsl_root_fsolver_iterate(solver.get());
    low = gsl_root_fsolver_x_lower(solver.get());
    high = gsl_root_fsolver_x_upper(solver.get());
  }
  return std::exp(gsl_root_fsolver_root(solver.get()));
}

}  // namespace

Hertz hertz(const Bodies& bodies, double load) {
  const double along_x = bodies.curvature_x(), along_y = bodies.curvature_y();
  const double less = std::min(along_x, along_y), more = std::max(along_x, along_y);
  const double k = axes_ratio(std::log(more / less)), modulus = bodies.composite_modulus();
  const double a = std::cbrt(load * carlson_d(0, k * k, 1) / (pi * modulus * less)), b = k * a;

  Hertz out{std::sqrt(a * b), 1.5 * load / (pi * a * b), 0, a, b};
  out.approach = out.pressure * b * gsl_sf_ellint_RF(0, k * k, 1, GSL_PREC_DOUBLE) / modulus;
  if (along_x > along_y) std::swap(out.radius_x, out.radius_y);
  return out;
}

HertzLine hertz_line(double composite_modulus, double curvature, double load_per_length) {
  const double b = std::sqrt(4 * load_per_length / (pi * composite_modulus * curvature));
  return {b, 2 * load_per_length / (pi * b)};
}

}  // namespace asperity
