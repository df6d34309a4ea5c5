#include "acf/kernel.hpp"

#include "reference/exponential_target.hpp"
#include "requests.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

KernelRequest profile(std::function<double(double)> target, Index n,
                      Formulation formulation = Formulation::symmetric) {
  KernelRequest request;
  request.target = [target](double p, double q) { return q == 0 ? target(std::abs(p)) : 0.0; };
  request.lags = {n, 1};
  request.formulation = formulation;
  return request;
}

double centre(const Kernel& k) { return k.values(k.values.rows() / 2, k.values.cols() / 2); }

}  // namespace

// a0² + 2 a1² = 1 and 2 a0 a1 = r for the even kernel (a1, a0, a1).
TEST_CASE("two lags have the kernel of the closed form", "[kernel][exact]") {
  for (double r : {0.0, 0.3, 0.6}) {
    const Kernel k = solve_kernel(profile([r](double p) { return p == 0 ? 1 : p == 1 ? r : 0.0; }, 2));
    const double a0 = std::sqrt((1 + std::sqrt(1 - 2 * r * r)) / 2), a1 = r / (2 * a0);
    CAPTURE(r);
    CHECK(k.report.converged);
    CHECK(std::abs(k.values(1, 0) - a0) <= coefficient_error);
    CHECK(std::abs(k.values(0, 0) - a1) <= coefficient_error);
    CHECK(std::abs(k.values(2, 0) - a1) <= coefficient_error);
    CHECK(k.report.tail == Approx(a1 * a1).margin(1e-9).epsilon(0));  // R(2) = a1², target 0
  }
  CHECK(centre(solve_kernel(profile([](double p) { return p == 0   ? 1
                                                          : p == 1 ? 0.3
                                                                   : 0.0; }, 2))) ==
        Approx(0.976098999542).margin(coefficient_error).epsilon(0));
}

// The same with Patir's: a0² + a1² = 1, a0 a1 = r.
TEST_CASE("two lags have Patir's kernel of the closed form", "[kernel][exact]") {
  const double r = 0.3;
  const Kernel k =
      solve_kernel(profile([r](double p) { return p == 0   ? 1
                                                  : p == 1 ? r
                                                           : 0.0; }, 2, Formulation::patir));
  const double a0 = std::sqrt((1 + std::sqrt(1 - 4 * r * r)) / 2);
  CHECK(k.report.converged);
  CHECK(std::abs(k.values(0, 0) - a0) <= coefficient_error);
  CHECK(std::abs(k.values(1, 0) - r / a0) <= coefficient_error);
}

// Twelve digits by validation/independent/kernel.py: Newton's method on dense Jacobians, in numpy.
TEST_CASE("kernels of the exponential target have their known coefficients", "[kernel][exact]") {
  const Kernel three = solve_kernel(cut(3, 3, 4.6));
  CHECK(centre(three) == Approx(0.975293944653).margin(coefficient_error).epsilon(0));
  CHECK(three.values(2, 3) == Approx(0.098781894181).margin(coefficient_error).epsilon(0));
  CHECK(three.values.sum() == Approx(1.700277790182).margin(25 * coefficient_error).epsilon(0));
  CHECK(centre(solve_kernel(cut(7, 4, 4.6))) == Approx(0.899683706892).margin(coefficient_error).epsilon(0));
  CHECK(centre(solve_kernel(cut(31, 31, 4.6))) ==
        Approx(0.531238106775).margin(coefficient_error).epsilon(0));
  CHECK(centre(solve_kernel(cut(31, 31, 7))) == Approx(0.621848156945).margin(coefficient_error).epsilon(0));
  const Kernel seven = solve_kernel(cut(7, 7, 4.6, Formulation::patir));
  CHECK(seven.values(0, 0) == Approx(0.756432661630).margin(coefficient_error).epsilon(0));
  CHECK(seven.values(0, 1) == Approx(0.321579414107).margin(coefficient_error).epsilon(0));
  const Kernel patir = solve_kernel(cut(31, 31, 4.6, Formulation::patir));
  CHECK(patir.values(0, 0) == Approx(0.357017425809).margin(coefficient_error).epsilon(0));
  CHECK(patir.report.mirrored_error == Approx(0.120440).margin(1e-6).epsilon(0));
}

TEST_CASE("every kernel of the paper under the 1 % cut meets its equations in both quadrants to 1e-10",
          "[kernel][exact]") {
  for (Shape lags : paper) {
    const Kernel k = solve_kernel(cut(lags.nx, lags.ny, 4.6));
    CAPTURE(lags.nx, lags.ny);
    CHECK(k.report.converged);
    CHECK(k.report.residual <= 1e-10);
    CHECK(k.report.mirrored_error <= 1e-10);
    CHECK(k.report.steps <= 6);
  }
}

TEST_CASE("Patir's equations are met to 1e-10 while the mirrored quadrant is wrong by a twentieth and more",
          "[kernel][exact]") {
  for (Shape lags : paper) {
    const Kernel k = solve_kernel(cut(lags.nx, lags.ny, 4.6, Formulation::patir));
    CAPTURE(lags.nx, lags.ny);
    CHECK(k.report.converged);
    CHECK(k.report.residual <= 1e-10);
    CHECK(k.report.mirrored_error >= (lags == Shape{3, 3} ? 0.05 : 0.1));  // 3 x 3: 0.068
  }
}

// The oriented equations know the axis-aligned target too, whose solution is even in both indices.
TEST_CASE("the oriented formulation finds the symmetric kernel of a symmetric target", "[kernel][law]") {
  const Kernel a = solve_kernel(cut(13, 7, 4.6)), b = solve_kernel(cut(13, 7, 4.6, Formulation::oriented));
  CHECK((a.values - b.values).abs().maxCoeff() <= coefficient_error);
}

TEST_CASE("an oriented target is met in both quadrants, and the symmetric formulation refuses it",
          "[kernel][exact]") {
  KernelRequest request;
  request.target = [](double p, double q) {
    const double c = std::sqrt(0.75), s = 0.5;
    return std::exp(-4.6 / 31 * std::hypot(c * p + s * q, 3 * (c * q - s * p)));
  };
  request.target.oriented = true;
  request.lags = {31, 31};
  const Kernel k = solve_kernel(request);
  CHECK(k.formulation == Formulation::oriented);
  CHECK(k.report.residual <= 1e-10);
  CHECK(k.report.mirrored_error <= 1e-10);
  CHECK(k.acf_target(10, 61 + 10) > 2 * k.acf_target(10, 61 - 10));  // it is oriented
  request.formulation = Formulation::symmetric;
  CHECK_THROWS_AS(solve_kernel(request), ParameterError);
}

TEST_CASE("lags left open are chosen such that the error over all lags keeps to the tolerance",
          "[kernel][contract]") {
  for (double length : {0.01, 1.0, 17.0})
    for (double tolerance : {1e-2, 1e-3, 1e-5}) {
      KernelRequest request;
      const ExponentialTarget model{length, length / 2};
      request.target = model;
      request.target.reach = [model](double t) { return model.lags(-std::log(t)); };
      request.acf_tolerance = tolerance;
      const Kernel k = solve_kernel(request);
      CAPTURE(length, tolerance, k.lags.nx, k.lags.ny);
      CHECK(k.report.answer == Answer::exact);
      CHECK(k.report.error <= tolerance);
    }
}

TEST_CASE("the achieved autocorrelation is the double sum over the kernel, zero where it has ended",
          "[kernel][exact]") {
  for (Formulation formulation : {Formulation::symmetric, Formulation::patir}) {
    const Kernel k = solve_kernel(cut(5, 3, 4.6, formulation));
    REQUIRE(k.acf_achieved.rows() == 10);
    REQUIRE(k.acf_achieved.cols() == 11);
    for (Index p = 0; p < 10; ++p)
      for (Index q = -5; q <= 5; ++q) {
        double sum = 0;
        for (Index i = 0; i + p < k.values.rows(); ++i)
          for (Index j = std::max<Index>(0, -q); j < k.values.cols() && j + q < k.values.cols(); ++j)
            sum += k.values(i, j) * k.values(i + p, j + q);
        CHECK(std::abs(k.acf_achieved(p, q - k.first_q()) - sum) <= 32 * epsilon);  // Σ|kernel|² < 4
      }
    CHECK(k.acf_achieved.row(9).isZero(0));
    CHECK(k.acf_achieved.col(0).isZero(0));
  }
}

TEST_CASE("the errors of the report are those of its tables, and the kernel's sum is positive",
          "[kernel][law]") {
  for (Formulation formulation : {Formulation::symmetric, Formulation::patir}) {
    const Kernel k = solve_kernel(cut(17, 4, 4.6, formulation));
    CHECK((k.acf_achieved - k.acf_target).abs().maxCoeff() == k.report.error);
    CHECK(k.report.error == std::max({k.report.residual, k.report.mirrored_error, k.report.tail}));
    CHECK(k.values.sum() > 0);
  }
}

// The tail is free and extrapolates the exponential: c decay lengths leave the errors below, over all lags of
// the plane.
TEST_CASE("more lags shrink the error over all lags as documented", "[kernel][order]") {
  struct Row {
    double c, error;
  };
  for (Row row : {Row{4.6, 2e-3}, Row{6, 5e-4}, Row{9, 2e-5}, Row{11.5, 1.5e-6}}) {
    const Kernel k = solve_kernel(cut(48, 48, row.c));
    CAPTURE(row.c);
    CHECK(k.report.converged);
    CHECK(k.report.error <= row.error);
    CHECK(k.report.error >= row.error / 4);
  }
}

TEST_CASE("a transposed request has the transposed kernel", "[kernel][law]") {
  const Kernel a = solve_kernel(cut(17, 4, 4.6)), b = solve_kernel(cut(4, 17, 4.6));
  CHECK((a.values - b.values.transpose()).abs().maxCoeff() <= coefficient_error);
}

TEST_CASE("the rms height scales the kernel and leaves the report alone", "[kernel][law]") {
  KernelRequest request = cut(7, 4, 4.6);
  const Kernel unit = solve_kernel(request);
  request.rms = 4e-7;
  const Kernel scaled = solve_kernel(request);
  CHECK((scaled.values / 4e-7 - unit.values).abs().maxCoeff() <= 4 * epsilon);
  CHECK(std::abs(scaled.values.square().sum() / 1.6e-13 - 1) <= 1e-10);
  CHECK(scaled.report.residual == unit.report.residual);
}

TEST_CASE("a request that cannot be meant is refused by its name", "[kernel][contract]") {
  auto refused = [](auto change) {
    KernelRequest request = cut(7, 4, 4.6);
    change(request);
    try {
      solve_kernel(request);
    } catch (const ParameterError& e) {
      return e.name;
    }
    return std::string();
  };
  CHECK(refused([](KernelRequest& r) { r.lags = {0, 4}; }) == "lags");
  CHECK(refused([](KernelRequest& r) { r.lags = {}; }) == "lags");  // and how far it reaches is not known
  CHECK(refused([](KernelRequest& r) { r.acf_tolerance = 0; }) == "acf-tolerance");
  CHECK(refused([](KernelRequest& r) { r.target.known = Shape{6, 4}; }) == "lags");
  CHECK(refused([](KernelRequest& r) { r.lags = {1 << 20, 1 << 20}; }) == "lags");
  CHECK(refused([](KernelRequest& r) { r.rms = 0; }) == "rq");
  CHECK(refused([](KernelRequest& r) { r.tolerance = 1e-20; }) == "tolerance");
  CHECK(refused([](KernelRequest& r) { r.target = {}; }) == "target");
  CHECK(refused([](KernelRequest& r) { r.target = [](double, double) { return 2.0; }; }) == "target");
  CHECK_THROWS_AS(enum_named<Formulation>("bakolas", "formulation"), ParameterError);
}
