#include "marginal/predistortion.hpp"

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// z = (e^{y/δ} - √w)/…, of correlation (w^ρ - 1)/(w - 1).
struct Lognormal {
  double delta;
  double w() const { return std::exp(1 / (delta * delta)); }
  Translation translation() const {
    return {"S_L", 1, [=, *this](std::span<double> y) {
              for (double& value : y)
                value = std::expm1(value / delta - 0.5 / (delta * delta)) / std::sqrt(w() - 1);
            }};
  }
};

KernelRequest request_for(const EllipticTarget& target) {
  KernelRequest request;
  request.target = target.target();
  return request;
}

// Falls to -0.5 at half a wavelength.
const EllipticTarget lay{
    .model = Model::exponential_cosine, .length_x = 40, .length_y = 10, .wavelength = 24};

}  // namespace

// The map is right to 1e-12, its inverse to 1e-11.
TEST_CASE("the target below lognormal heights of correlation r is log(1 + (w-1) r)/log(w)",
          "[predistortion][exact]") {
  const Lognormal heights{1.2};
  const Target r = EllipticTarget{.length_x = 7, .length_y = 5, .angle = 0.4}.target();
  const Target rho = Predistortion(heights.translation()).target(r);
  CHECK(rho.oriented);
  for (double p : {0.0, 1.0, 5.0})
    for (double q : {-4.0, 0.0, 3.0, 20.0}) {
      CAPTURE(p, q);
      CHECK(std::abs(rho(p, q) - std::log1p((heights.w() - 1) * r(p, q)) / std::log(heights.w())) <= 1e-11);
    }
  CHECK(rho(0, 0) == 1);
}

// r is known to be positive to the caller alone: below the bound lies what is between R_z(-t) and R_z(t).
TEST_CASE("the reach of a predistorted target holds all lags above its bound, either sign, and no lag more",
          "[predistortion][law]") {
  const Target r = EllipticTarget{.length_x = 7, .length_y = 5}.target();
  const Predistortion predistortion(Lognormal{0.8}.translation());
  const Target rho = predistortion.target(r);
  for (double bound : {0.3, 1e-2, 1e-4}) {
    const auto [n, m] = rho.reach(bound);
    CHECK(rho(static_cast<double>(n), 0) <= bound);
    CHECK(rho(0, static_cast<double>(m)) <= bound);
    const double below = -predistortion.map()(-bound);
    CHECK(r(static_cast<double>(n - 1), 0) > below);
    CHECK(r(0, static_cast<double>(m - 1)) > below);
  }
}

// Residuals of 1e-10 in ρ become at most R'(1) = 1.4 times that; the sums over the kernel round off far
// below.
TEST_CASE("a kernel of heights has unit variance, and tables and errors that are those of the heights",
          "[predistortion][exact]") {
  const Lognormal heights{1.2};
  KernelRequest request = request_for({.length_x = 9, .length_y = 6});
  request.rms = 4e-7;
  const Predistortion predistortion(heights.translation());
  const Kernel kernel = predistortion.solve(request);
  REQUIRE(kernel.report.converged);
  CHECK(kernel.rms == request.rms);
  CHECK(std::abs(kernel.values.square().sum() - 1) <= 1e-9);
  const double variance = request.rms * request.rms;
  const Field rho = autocorrelation(kernel.values, kernel.acf_achieved.rows(), kernel.acf_achieved.cols());
  double error = 0;
  for (Index p = 0; p < rho.rows(); ++p)
    for (Index column = 0; column < rho.cols(); ++column) {
      const double r = std::expm1(rho(p, column) * std::log(heights.w())) / (heights.w() - 1);
      const double target =
          request.target(static_cast<double>(p), static_cast<double>(column + kernel.first_q()));
      error = std::max(error, std::abs(r - target));
      CHECK(std::abs(kernel.acf_achieved(p, column) / variance - r) <= 1e-11);
      CHECK(std::abs(kernel.acf_target(p, column) / variance - target) <= 1e-15);
    }
  CHECK(std::abs(kernel.report.error - error) <= 1e-11);
  CHECK(kernel.report.error <= request.acf_tolerance);
  CHECK(kernel.report.residual <= request.tolerance);
}

TEST_CASE("without predistortion the heights' autocorrelation is wrong by more than a tenth, with it by 1e-3",
          "[predistortion][law]") {
  const Lognormal heights{0.8};
  const KernelRequest request = request_for({.length_x = 9, .length_y = 6});
  const Predistortion predistortion(heights.translation());
  double naive = 0;
  for (double p = 0; p < 9; ++p) {
    const double r = request.target(p, 0);
    naive = std::max(naive, std::abs(predistortion.map()(r) - r));
  }
  CHECK(naive > 0.1);
  CHECK(predistortion.solve(request).report.error <= 1e-3);
}

// Lognormal heights of δ = 1 correlate no lower than -1/w = -0.368.
TEST_CASE(
    "a correlation lower than the heights can have is refused, or changed as asked and by no more than is "
    "told",
    "[predistortion][contract]") {
  const Lognormal heights{1};
  const Predistortion predistortion(heights.translation());
  KernelRequest request = request_for(lay);
  const double least = request.target(12, 0);
  REQUIRE(least < -0.4);
  CHECK(std::abs(predistortion.change(request.target) - (-1 / heights.w() - least)) <= 0.02);
  for (InfeasiblePolicy answer : {InfeasiblePolicy::automatic, InfeasiblePolicy::error}) {
    request.infeasible = answer;
    CHECK_THROWS_MATCHES(predistortion.solve(request), ParameterError,
                         Catch::Matchers::Predicate<ParameterError>([](const ParameterError& e) {
                           return e.name == "marginal" &&
                                  std::string(e.what()).find("-0.368") != std::string::npos;
                         }));
  }
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel kernel = predistortion.solve(request);
  CHECK(kernel.report.answer == Answer::nearest);
  CHECK(kernel.report.change >= predistortion.change(request.target) - 1e-9);
  CHECK((kernel.acf_achieved - kernel.acf_target).abs().maxCoeff() == kernel.report.error);
  CHECK(kernel.acf_achieved.minCoeff() >= -1 / heights.w() - 1e-12);
}

TEST_CASE("heights of a symmetric distribution may correlate as low as any", "[predistortion][contract]") {
  const double rms = std::sqrt(0.5 * std::expm1(2.0));
  const Predistortion predistortion({"S_U", 1, [=](std::span<double> y) {
                                       for (double& value : y) value = std::sinh(value) / rms;
                                     }});
  CHECK(predistortion.change(request_for(lay).target) == 0);
}
