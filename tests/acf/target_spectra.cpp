#include <memory>
#include <numbers>

#include <Eigen/Core>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_gamma.h>

#include "acf/radial.hpp"
#include "acf/target.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// ∫_0^∞ ρ(r) exp(-r²/2w²) r dr, in ln r from 1e-14 w to 9 w.
template <class Correlation>
double smoothed(const Correlation& rho, double w) {
  auto f = [&](double x) {
    const double r = std::exp(x);
    return rho(r) * std::exp(-r * r / (2 * w * w)) * r * r;
  };
  gsl_function g{[](double x, void* p) { return (*static_cast<decltype(f)*>(p))(x); }, &f};
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> space(
      gsl_integration_workspace_alloc(2000), gsl_integration_workspace_free);
  double sum = 0, error = 0;
  gsl_integration_qag(&g, std::log(1e-14 * w), std::log(9 * w), 1e-12 * w * w, 1e-11, 2000, GSL_INTEG_GAUSS31,
                      space.get(), &sum, &error);
  return sum;
}

// Γ(-ν, a), for small arguments from Γ(1-ν, a): gsl_sf_gamma_inc of GSL 2.7 is wrong in the fourth digit at
// (-0.3, 5e-5).
double upper_gamma(double nu, double a) {
  if (nu > 1 || a > 1) return gsl_sf_gamma_inc(-nu, a);
  return (std::pow(a, -nu) * std::exp(-a) - gsl_sf_gamma_inc(1 - nu, a)) / nu;
}

// The least and the largest value of the discrete spectrum of R on 2n × 2n lags, tapered by
// (1-|p|/n)(1-|q|/n): a positive definite factor that ends at n, so that the torus adds nothing of its own.
struct Range {
  double least, most;
};
template <class Correlation>
Range tapered_spectrum(const Correlation& R, Index n) {
  Eigen::MatrixXd lags(2 * n, 2 * n), cosine(2 * n, 2 * n), sine(2 * n, 2 * n);
  auto lag = [&](Index i) { return static_cast<double>(i < n ? i : i - 2 * n); };
  auto taper = [&](double p) { return 1 - std::abs(p) / static_cast<double>(n); };
  for (Index i = 0; i < 2 * n; ++i)
    for (Index j = 0; j < 2 * n; ++j) {
      const double phase = std::numbers::pi * static_cast<double>(i * j % (2 * n)) / static_cast<double>(n);
      cosine(i, j) = std::cos(phase);
      sine(i, j) = std::sin(phase);
      const double t = taper(lag(i)) * taper(lag(j));
      lags(i, j) = t > 0 ? t * R(lag(i), lag(j)) : 0;
    }
  const Eigen::MatrixXd spectrum = cosine * lags * cosine - sine * lags * sine;
  return {spectrum.minCoeff(), spectrum.maxCoeff()};
}

}  // namespace

// Parseval: ∫ρ exp(-r²/2w²) r dr = w² ∫C exp(-q²w²/2) q dq / ∫C q dq, the Laplace transform of C in q²,
// which C alone has; with a = w²/2 it is, for (1) of SelfAffineCorrelation,
//     2H/(1+H) [1 - exp(-a) + a^(1+H) Γ(-H, a)].
// The quadrature stops at 1e-11, ρ is good to 1e-11; w = 0.01 … 20 weighs q from 100 down to 0.05.
TEST_CASE("the self-affine correlation has a spectrum flat below 1 and of slope -2(1+H) above",
          "[target][law]") {
  for (double H : {0.01, 0.3, 0.8, 1.0}) {
    const SelfAffineCorrelation rho(H);
    for (double w : {0.01, 0.1, 1.0, 4.0, 20.0}) {
      const double a = w * w / 2;
      const double exact = 2 * H / (1 + H) * (-std::expm1(-a) + std::pow(a, 1 + H) * upper_gamma(H, a));
      CAPTURE(H, w);
      CHECK(std::abs(smoothed(rho, w) - exact) <= 5e-11 * w * w);
    }
  }
}

// The same for C = (1+q²)^-(1+ν): ν w² exp(a) a^ν Γ(-ν, a).
TEST_CASE("Matérn's correlation has the spectrum (1+q²) to the power -(1+ν)", "[target][law]") {
  for (double nu : {0.01, 0.3, 0.8, 1.0, 4.2}) {
    const MaternCorrelation rho(nu);
    for (double w : {0.1, 1.0, 4.0, 20.0}) {
      const double a = w * w / 2;
      const double exact = nu * w * w * std::exp(a) * std::pow(a, nu) * upper_gamma(nu, a);
      CAPTURE(nu, w);
      CHECK(std::abs(smoothed(rho, w) - exact) <= 5e-11 * w * w);
    }
  }
}

// A product of positive definite functions is positive definite. Each of 4 n² lags is good to 1e-11.
TEST_CASE("every model is positive definite, turned and across its parameters", "[target][law]") {
  const Index n = 24;
  for (Model model : {Model::exponential, Model::gaussian, Model::matern, Model::stretched_exponential,
                      Model::self_affine, Model::exponential_cosine})
    for (double parameter : {0.05, 0.5, 1.0})
      for (double length : {3.0, 40.0}) {
        EllipticTarget t;
        t.model = model;
        t.length_x = length;
        t.length_y = 0.4 * length;
        t.angle = 0.4;
        t.smoothness = 10 * parameter;
        t.exponent = 2 * parameter;
        t.hurst = parameter;
        t.wavelength = 8 * parameter;
        const Range spectrum = tapered_spectrum(t.target(), n);
        CAPTURE(name_of(model), parameter, length, spectrum.most);
        CHECK(spectrum.least >= -4e-11 * static_cast<double>(n * n));
      }
}

// Its spectrum at q = 0 is ∫exp(-r) cos(kr) r dr = (1-k²)/(1+k²)² < 0 for k > 1.
TEST_CASE("the radial exp(-r) cos(kr) is no autocorrelation, which the same measure shows", "[target][law]") {
  auto radial = [](double p, double q) {
    const double r = std::hypot(p, q) / 3;
    return std::exp(-r) * std::cos(3 * r);
  };
  CHECK(tapered_spectrum(radial, 24).least <= -1);
}

// The last lag above t lies less than one lag inside the box, on its side at the tangent point; the tables'
// 1e-11 and, of the self-affine ripple, the 0.02 of last_above.
TEST_CASE("reach is the least box of lags outside of which the target stays within t", "[target][exact]") {
  for (Model model :
       {Model::exponential, Model::gaussian, Model::matern, Model::stretched_exponential, Model::self_affine})
    for (double t : {0.3, 0.1, 1e-3}) {
      EllipticTarget e;
      e.model = model;
      e.length_x = 17;
      e.length_y = 6;
      e.smoothness = 0.7;
      e.exponent = 1.3;
      e.angle = 0.4;
      const Target R = e.target();
      const Shape box = R.reach(t);
      const auto n = static_cast<double>(box.nx), m = static_cast<double>(box.ny);
      auto most_in_row = [&](double p) {
        double most = 0;
        for (double q = -3 * m; q <= 3 * m; q += 0.125) most = std::max(most, std::abs(R(p, q)));
        return most;
      };
      auto most_in_column = [&](double q) {
        double most = 0;
        for (double p = -3 * n; p <= 3 * n; p += 0.125) most = std::max(most, std::abs(R(p, q)));
        return most;
      };
      CAPTURE(name_of(model), t, box.nx, box.ny);
      for (double beyond : {0.0, 1.0, 2.0, 7.0, 20.0}) {
        CHECK(most_in_row(n + beyond) <= t * (1 + 1e-9));
        CHECK(most_in_column(m + beyond) <= t * (1 + 1e-9));
      }
      // A lag further in, and one more for the ripple's 0.02 of r, which is 0.2 lags here.
      const double slack = model == Model::self_affine ? 2 : 1;
      CHECK(most_in_row(n - slack) > t * 0.999);
      CHECK(most_in_column(m - slack) > t * 0.999);
    }
}

TEST_CASE("reach is the lengths at the level, one lag at 1 and bounded where there is no bound",
          "[target][exact]") {
  for (Model model : {Model::exponential, Model::gaussian, Model::matern, Model::stretched_exponential,
                      Model::exponential_cosine}) {
    EllipticTarget e;
    e.model = model;
    e.length_x = 17;
    e.length_y = 4;
    e.spacing_y = 0.5;
    CAPTURE(name_of(model));
    CHECK(e.target().reach(0.1) == Shape{17, 8});
    CHECK(e.target().reach(1) == Shape{1, 1});
    CHECK(e.target().reach(0) == Shape{Index{1} << 30, Index{1} << 30});
  }
}

// From r = 1 on; below, the envelope is above 1 or never met. Checked through last_above, which starts from
// it.
TEST_CASE("beyond last_above the self-affine correlation stays within t, and reaches it 0.03 below",
          "[target][exact]") {
  for (double H : {0.01, 0.1, 0.5, 0.8, 1.0}) {
    const SelfAffineCorrelation rho(H);
    for (double t : {0.9, 0.3, 0.05, 1e-2, 1e-3, 1e-5}) {
      const double last = rho.last_above(t);
      double beyond = 0, just_below = 0;
      for (double r = last; r < 4 * last + 30; r += 0.003) beyond = std::max(beyond, std::abs(rho(r)));
      for (double r = std::max(0.0, last - 0.03); r <= last; r += 1e-4)
        just_below = std::max(just_below, std::abs(rho(r)));
      CAPTURE(H, t, last);
      CHECK(beyond <= t);
      CHECK(just_below > 0.9999 * t);
    }
  }
}
