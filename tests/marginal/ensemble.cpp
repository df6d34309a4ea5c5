// Surfaces of prescribed skewness, kurtosis and autocorrelation, drawn and counted.
#include "stats/sample/ensemble.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "marginal/johnson.hpp"
#include "marginal/predistortion.hpp"
#include "marginal/prescribed.hpp"
#include "math/hermite.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "support.hpp"
#include "surface/synthesis.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr int surfaces = 60;
constexpr Shape shape{96, 96};
constexpr Shape lags{8, 5};  // compared
constexpr int percentiles = 19;

// z³, z⁴, the autocorrelation, and the share of heights below each percentile of the distribution. All are
// unbiased, for the mean is known to be 0 and the variance 1.
Eigen::ArrayXd figures_of(const Field& z, const Translation& g) {
  const Field acf =
      estimate_autocorrelation(z, {shape, 1, 1}, {.max_lag = {lags.nx - 1, lags.ny - 1}, .level = 0})
          .half_plane();
  Eigen::ArrayXd out(2 + acf.size() + percentiles);
  out << z.cube().mean(), z.square().square().mean(), acf.reshaped<Eigen::RowMajor>(),
      Eigen::ArrayXd::Zero(percentiles);
  for (int i = 1; i <= percentiles; ++i) {
    const double quantile = g(gsl_cdf_ugaussian_Pinv(i / (percentiles + 1.0)));
    out(out.size() - i) = (z <= quantile).cast<double>().mean();
  }
  return out;
}

// What they must be.
Eigen::ArrayXd expected(double skewness, double kurtosis, const Kernel& kernel) {
  const Field acf = kernel.acf_achieved.block(0, -kernel.first_q() - lags.ny + 1, lags.nx, 2 * lags.ny - 1);
  Eigen::ArrayXd out(2 + acf.size() + percentiles);
  out << skewness, kurtosis, acf.reshaped<Eigen::RowMajor>(), Eigen::ArrayXd::Zero(percentiles);
  for (int i = 1; i <= percentiles; ++i) out(out.size() - i) = i / (percentiles + 1.0);
  return out;
}

Ensemble drawn(const Kernel& kernel, const Translation& g) {
  const Synthesis synthesis(kernel.values, shape, {.translation = g.apply});
  Ensemble out;
  for (int n = 0; n < surfaces; ++n)
    out.add(figures_of(synthesis.surface(WhiteNoise(7, static_cast<std::uint64_t>(n))), g));
  return out;
}

KernelRequest request_for(const EllipticTarget& target) {
  KernelRequest request;
  request.target = target.target();
  return request;
}

struct Pair {
  double skewness, kurtosis;
};

}  // namespace

// Each of 93 figures a case leaves 4 standard errors with probability 6e-5 (1.8e-4 by Student's t of 59
// degrees), in 27 cases 0.45 of 2500 are expected at the most, were they independent; neighbouring lags are
// nearly the same, and the seed is fixed. The two figures of the sixth and eighth power are skewed towards
// too small errors where they are too small themselves; 5 standard errors are allowed to the kurtosis.
TEST_CASE(
    "ensembles have the skewness, kurtosis, percentiles and autocorrelation prescribed, within their errors",
    "[marginal][statistics][slow]") {
  const EllipticTarget exponential{.length_x = 9, .length_y = 6};
  const EllipticTarget gaussian{.model = Model::gaussian, .length_x = 9, .length_y = 6};
  const EllipticTarget oriented{.length_x = 12, .length_y = 5, .angle = 0.5};
  for (const EllipticTarget& target : {exponential, gaussian, oriented})
    for (const Pair& pair : std::initializer_list<Pair>{
             {0, 3}, {-0.5, 4}, {1, 6}, {-1.3, 6}, {0, 1.8}, {-2, 10}, {3, 15}, {-3, 16}, {0, 1.1}}) {
      CAPTURE(name_of(target.model), target.angle, pair.skewness, pair.kurtosis);
      const Translation g = johnson_translation(pair.skewness, pair.kurtosis);
      KernelRequest request = request_for(target);
      request.infeasible = InfeasiblePolicy::nearest;
      const Kernel kernel = Predistortion(g).solve(request);
      CHECK(kernel.report.converged == (kernel.report.error <= request.acf_tolerance));
      CHECK(kernel.report.error <= (target.model == Model::gaussian ? 0.15 : 1e-3));
      CHECK(std::abs(kernel.acf_target(3, 2 - kernel.first_q()) - target.target()(3, 2)) <= 1e-15);
      const Ensemble figures = drawn(kernel, g);
      const Eigen::ArrayXd error = figures.standard_error(),
                           deviation = figures.mean() - expected(pair.skewness, pair.kurtosis, kernel);
      for (Index n = 0; n < error.size(); ++n) {
        CAPTURE(n, deviation(n), error(n));
        CHECK(std::abs(deviation(n)) <= (n == 1 ? 5 : 4) * error(n) + 1e-15);
      }
    }
}

// Kolmogorov and Smirnov's difference of the distributions, in the errors that correlated heights have: the
// share of heights below g(x) is that of y below x, whose indicator has the Hermite coefficients φ(x)
// h_{k-1}(x)/√k, so that by stats/uncertainty/effective_size.hpp (1)
//     Var = φ(x)² Σ_k h_{k-1}(x)² S_k/(k N M).
// The largest of 99 quantiles, were they independent, leaves 4.4 standard errors with probability 1e-3.
TEST_CASE(
    "the distribution of an ensemble strays from the one prescribed by no more than correlated heights may",
    "[marginal][statistics]") {
  const EllipticTarget target{.length_x = 9, .length_y = 6};
  for (const Pair& pair : std::initializer_list<Pair>{{1, 6}, {-2, 10}, {0, 1.1}, {-3, 16}}) {
    CAPTURE(pair.skewness, pair.kurtosis);
    const Translation g = johnson_translation(pair.skewness, pair.kurtosis);
    const Kernel kernel = Predistortion(g).solve(request_for(target));
    const Field rho = autocorrelation(kernel.values, kernel.values.rows(), 2 * kernel.values.cols() - 1);
    const EffectiveSampleSize size(LagField(rho), Grid{shape, 1, 1});
    const Synthesis synthesis(kernel.values, shape, {.translation = g.apply});
    Eigen::ArrayXd below = Eigen::ArrayXd::Zero(99);
    for (int n = 0; n < surfaces; ++n) {
      const Field z = synthesis.surface(WhiteNoise(9, static_cast<std::uint64_t>(n)));
      for (Index i = 0; i < 99; ++i)
        below(i) += (z <= g(gsl_cdf_ugaussian_Pinv(static_cast<double>(i + 1) / 100))).cast<double>().mean() /
                    surfaces;
    }
    for (Index i = 0; i < 99; ++i) {
      const double share = static_cast<double>(i + 1) / 100, x = gsl_cdf_ugaussian_Pinv(share);
      HermiteFunction h(x, gsl_ran_ugaussian_pdf(x));
      double variance = 0;
      for (int k = 1; k <= EffectiveSampleSize::powers; ++k) {
        const double f = h.next();
        variance += f * f / k * size.sum(k) / (size.points() * surfaces);
      }
      CAPTURE(share, below(i), std::sqrt(variance));
      CHECK(std::abs(below(i) - share) <= 4.4 * std::sqrt(variance));
      CHECK(variance <= 1e-4);
    }
  }
}

// The same of an average of skewed noise, whose autocorrelation is the kernel's itself; the distribution of
// the average has no closed form, so that percentiles are not compared.
TEST_CASE(
    "surfaces of filtered noise have the skewness, kurtosis and autocorrelation prescribed, within their "
    "errors",
    "[marginal][statistics]") {
  KernelRequest request = request_for({.length_x = 4, .length_y = 3});
  request.lags = {4, 3};
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel kernel = solve_kernel(request);
  const PrescribedHeights heights{-0.5, 3.6};
  const Synthesis synthesis(kernel.values, shape, {});
  Ensemble figures;
  for (int n = 0; n < surfaces; ++n)
    figures.add(figures_of(synthesis.surface(WhiteNoise(8, static_cast<std::uint64_t>(n), 0,
                                                        heights.noise(kernel.values).apply)),
                           johnson_translation(0, 3)));
  const Eigen::ArrayXd error = figures.standard_error(),
                       deviation = figures.mean() - expected(-0.5, 3.6, kernel);
  for (Index n = 0; n < error.size() - percentiles; ++n) {
    CAPTURE(n, deviation(n), error(n));
    CHECK(std::abs(deviation(n)) <= 4 * error(n) + 1e-15);
  }
  CHECK(error(0) <= 0.05);  // a Gaussian surface would fail
}
