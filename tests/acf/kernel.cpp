#include "acf/kernel.hpp"

#include "acf/kernel_evaluation.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The exponential that has fallen to e⁻ᶜ at the last lags n × m, of which all are prescribed.
KernelRequest cut(Index n, Index m, double c, Formulation formulation = Formulation::symmetric) {
  KernelRequest request;
  request.target = ExponentialTarget{static_cast<double>(n), static_cast<double>(m), std::exp(-c)};
  request.lags = {n, m};
  request.formulation = formulation;
  return request;
}

KernelRequest profile(std::function<double(double)> target, Index n,
                      Formulation formulation = Formulation::symmetric) {
  KernelRequest request;
  request.target = [target](double p, double q) { return q == 0 ? target(std::abs(p)) : 0.0; };
  request.lags = {n, 1};
  request.formulation = formulation;
  return request;
}

double centre(const Kernel& k) { return k.values(k.values.rows() / 2, k.values.cols() / 2); }

// The (n, m) of Creţu, Bălan and Urzică, lengths of the autocorrelation in samples.
const std::vector<Shape> paper{{7, 4}, {3, 3}, {17, 4}, {17, 14}, {13, 13}};

// Newton's last step leaves ‖F‖ below 1e-10, and no eigenvalue of J is below 2 min a^ = 0.5 (at 31 x 31): the
// coefficients are good to 2e-10, the references to 1e-12.
constexpr double coefficient_error = 1e-9;

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
    CHECK(k.report.tail == Approx(a1 * a1).margin(1e-9));  // R(2) = a1², target 0
  }
  CHECK(centre(solve_kernel(profile([](double p) { return p == 0   ? 1
                                                          : p == 1 ? 0.3
                                                                   : 0.0; }, 2))) ==
        Approx(0.976098999542).margin(coefficient_error));
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

// Twelve digits from an independent solution of the same equations.
TEST_CASE("kernels of the exponential target have their known coefficients", "[kernel][exact]") {
  const Kernel three = solve_kernel(cut(3, 3, 4.6));
  CHECK(centre(three) == Approx(0.975293944653).margin(coefficient_error));
  CHECK(three.values(2, 3) == Approx(0.098781894181).margin(coefficient_error));
  CHECK(three.values.sum() == Approx(1.700277790182).margin(25 * coefficient_error));
  CHECK(centre(solve_kernel(cut(7, 4, 4.6))) == Approx(0.899683706892).margin(coefficient_error));
  CHECK(centre(solve_kernel(cut(31, 31, 4.6))) == Approx(0.531238106775).margin(coefficient_error));
  CHECK(centre(solve_kernel(cut(31, 31, 7))) == Approx(0.621848156945).margin(coefficient_error));
  const Kernel seven = solve_kernel(cut(7, 7, 4.6, Formulation::patir));
  CHECK(seven.values(0, 0) == Approx(0.756432661630).margin(coefficient_error));
  CHECK(seven.values(0, 1) == Approx(0.321579414107).margin(coefficient_error));
  const Kernel patir = solve_kernel(cut(31, 31, 4.6, Formulation::patir));
  CHECK(patir.values(0, 0) == Approx(0.357017425809).margin(coefficient_error));
  CHECK(patir.report.mirrored_error == Approx(0.120440).margin(1e-6));
}

TEST_CASE("every kernel of the paper under the 1 % cut meets its equations in both quadrants to 1e-10",
          "[kernel][exact]") {
  for (Shape lags : paper) {
    const Kernel k = solve_kernel(cut(lags.nx, lags.ny, 4.6));
    CAPTURE(lags.nx, lags.ny);
    CHECK(k.report.converged);
    CHECK(k.report.residual <= 1e-10);
    CHECK(k.report.mirrored_error <= 1e-10);
    CHECK(k.report.newton_steps <= 6);
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

// n_max ≈ 0.3 c eᶜ is 7 for c = 2.3: narrow or small kernels have positive spectra, 13 × 13 has one that
// changes sign, 17 × 14 has none, but a wider one meets all its equations.
TEST_CASE("every 10 % cut of the paper is met in full by a kernel of its size, or by a wider one",
          "[kernel][exact]") {
  for (Shape lags : paper) {
    const Kernel k = solve_kernel(cut(lags.nx, lags.ny, std::log(10)));
    CAPTURE(lags.nx, lags.ny, k.report.reason);
    CHECK(k.report.converged);
    CHECK(k.report.residual <= 1e-10);
    CHECK(k.report.answer == (lags == Shape{17, 14} ? Answer::wider : Answer::exact));
    CHECK(std::abs(k.values.square().sum() - 1) <= 2e-10);
  }
}

TEST_CASE("a 10 % cut in Patir's formulation ends solved, nearly met, or refused by its name",
          "[kernel][contract]") {
  for (Shape lags : paper) {
    const KernelRequest request = cut(lags.nx, lags.ny, std::log(10), Formulation::patir);
    CAPTURE(lags.nx, lags.ny);
    try {
      const Kernel k = solve_kernel(request);
      CHECK(k.report.residual <= 1e-2);
      CHECK(k.report.change == (k.report.answer == Answer::exact ? 0 : k.report.residual));
    } catch (const ParameterError& e) {
      CHECK(e.name == "lags");
      CHECK_THAT(e.what(), ContainsSubstring("take more, such as") && ContainsSubstring("more than 0.01"));
    }
  }
}

// The paper's larger problem, under a cut that has no kernel of its size.
TEST_CASE("what is infeasible is answered as asked", "[kernel][contract]") {
  KernelRequest request = cut(31, 31, 2.3);
  request.infeasible = InfeasiblePolicy::error;
  CHECK_THROWS_AS(solve_kernel(request), ParameterError);
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel wider = solve_kernel(request);
  CHECK(wider.report.answer == Answer::wider);
  CHECK(wider.report.change <= 1e-10);
  CHECK(wider.values.rows() > 61);
  request.infeasible = InfeasiblePolicy::least_squares;
  const Kernel squares = solve_kernel(request);
  CHECK(squares.report.answer == Answer::least_squares);
  CHECK(squares.values.rows() == 61);
  CHECK(squares.report.change <= 4e-3);  // 2.3e-3 before its variance is set right
  CHECK(squares.report.change >= 1e-3);
  CHECK_FALSE(squares.report.converged);  // for acf_tolerance is 1e-3
  request.acf_tolerance = 4e-3;
  CHECK(solve_kernel(request).report.converged);
}

// exp(-(r/10)^2.3) belongs to no surface: its slopes would have the variance -R''(0) = 0. Clipping the spectrum is the least
// change in the mean square over the plane, and the same from many lags as from those where 1e-3 is left.
TEST_CASE("a target that no number of lags gives a kernel is clipped at once, as near as with many lags",
          "[kernel][law]") {
  KernelRequest request;
  auto fall = [](double p, double q) { return std::exp(-std::pow(std::hypot(p, q) / 10, 2.3)); };
  request.target = fall;
  request.target.reach = [](double t) {
    const auto n = static_cast<Index>(std::ceil(10 * std::pow(-std::log(t), 1 / 2.3)));
    return Shape{n, n};
  };
  CHECK_THROWS_AS(solve_kernel(request), ParameterError);  // changed by more than 1e-2
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel kernel = solve_kernel(request);
  CHECK(kernel.report.answer == Answer::nearest);
  CHECK(kernel.report.newton_steps <= 20);  // of the one trial that asks
  CHECK(kernel.lags == request.target.reach(1e-3));
  CHECK(kernel.report.change > 1e-5);
  CHECK_FALSE(kernel.report.converged);
  CHECK_THAT(kernel.report.reason, ContainsSubstring("whatever the lags"));
  CHECK(kernel.report.reason.find("take more") == std::string::npos);
  request.method = Method::spectral;
  request.lags = {80, 80};
  CHECK(std::abs(solve_kernel(request).report.error - kernel.report.error) <=
        0.05 * kernel.report.error + 1e-4);
  request.method = Method::newton_krylov;
  request.lags = {};
  request.infeasible = InfeasiblePolicy::error;
  CHECK_THROWS_AS(solve_kernel(request), ParameterError);
}

TEST_CASE("targets at the limits end in a kernel with its error, or in a refusal", "[kernel][contract]") {
  auto outcome = [](Target target, Shape lags) {
    KernelRequest request;
    request.target = std::move(target);
    request.lags = lags;
    return solve_kernel(request);
  };
  auto gaussian = [](double c) {
    return [c](double p, double q) { return std::exp(-c * (p * p + q * q) / 961); };
  };
  const auto delta = [](double p, double q) { return p == 0 && q == 0 ? 1.0 : 0.0; };
  CHECK(outcome(delta, {1, 1}).report.residual == 0);
  CHECK(outcome(delta, {9, 5}).report.residual <= 4 * epsilon);
  for (double c : {4.6, 14.0, 30.0}) {  // spectra from -1e-3 to round-off
    const Kernel k = outcome(gaussian(c), {31, 31});
    CAPTURE(c, name_of(k.report.answer));
    CHECK(k.report.converged);
    CHECK(k.report.residual <= 1e-6);
    CHECK(k.values.isFinite().all());
  }
  CHECK_THROWS_AS(outcome([](double, double) { return 1.0; }, {31, 31}), ParameterError);
  const Kernel thin = outcome(ExponentialTarget{300, 3}, {600, 6});  // γ = 100
  CHECK(thin.report.residual <= 1e-10);
  CHECK(outcome(ExponentialTarget{20, 1e-3}, {50, 1}).report.residual <= 1e-10);
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

TEST_CASE("every method that arrives finds the same kernel, and each says how far it came", "[kernel][law]") {
  const Kernel newton = solve_kernel(cut(13, 13, 4.6));
  for (Method method : {Method::fixed_point, Method::conjugate_gradient}) {
    KernelRequest request = cut(13, 13, 4.6);
    request.method = method;
    const Kernel k = solve_kernel(request);
    CAPTURE(name_of(method), k.report.reason);
    CHECK(k.report.converged);
    CHECK((k.values - newton.values).abs().maxCoeff() <= coefficient_error);
  }
  KernelRequest request = cut(63, 63, 4.6);
  request.method = Method::fixed_point;  // diverges
  const Kernel lost = solve_kernel(request);
  CHECK_FALSE(lost.report.converged);
  CHECK(lost.report.answer == Answer::best);
  CHECK(lost.report.change == lost.report.residual);
  CHECK(lost.values.isFinite().all());
  request.method = Method::spectral;
  const Kernel root = solve_kernel(request);
  CHECK(root.report.answer == Answer::spectral);
  CHECK(root.report.newton_steps == 0);
  CHECK(root.report.error <=
        2e-4);  // e^-18.4 at the edge of its torus is far below; the root's own tail is cut
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
  CHECK_THROWS_AS(formulation_named("bakolas"), ParameterError);
}
