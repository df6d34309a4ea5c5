#include "acf/equations.hpp"

#include <algorithm>

#include "acf/target.hpp"
#include "reference/exponential_target.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Values = std::vector<double>;

// Turned by 30° and drawn out 3 : 1 where it is to be oriented.
Target exponential(Shape lags, bool oriented = false) {
  if (!oriented)
    return ExponentialTarget{static_cast<double>(lags.nx), static_cast<double>(lags.ny), std::exp(-4.6)};
  Target target = [lags](double p, double q) {
    const double x = p / static_cast<double>(lags.nx), y = q / static_cast<double>(lags.ny);
    const double c = std::sqrt(0.75), s = 0.5;
    return std::exp(-4.6 * std::hypot(c * x + s * y, 3 * (c * y - s * x)));
  };
  target.oriented = true;
  return target;
}

Values random_values(const Equations& equations, unsigned seed) {
  const Field f = random_field({equations.count(), 1}, seed);
  return {f.data(), f.data() + f.size()};
}

double absolute_sum(const Field& kernel) { return kernel.abs().sum(); }

// R(p,q) of a kernel by the double sum of its definition.
double direct(const Field& kernel, Index p, Index q) {
  double sum = 0;
  for (Index k = 0; k + p < kernel.rows(); ++k)
    for (Index l = std::max<Index>(0, -q); l < kernel.cols() && l + q < kernel.cols(); ++l)
      sum += kernel(k, l) * kernel(k + p, l + q);
  return sum;
}

Values residual(Equations& equations, const Values& u) {
  Values f(u.size());
  equations.residual(u, f);
  return f;
}

Values product(Equations& equations, const Values& u, const Values& v) {
  Values out(v.size());
  equations.linearize(u);
  equations.jacobian(v, out);
  return out;
}

const std::vector<Shape> shapes{{1, 1}, {1, 6}, {7, 1}, {2, 2}, {3, 5}, {13, 4}, {16, 17}};

// Runs `claim` on the three formulations, by random vectors, whose spectra are of either sign.
template <class Claim>
void for_all_formulations(Shape lags, Claim claim) {
  for (bool oriented : {false, true}) {
    CAPTURE(lags.nx, lags.ny, oriented);
    ZeroPhaseEquations equations(exponential(lags, oriented), lags, oriented);
    claim(equations);
  }
  CAPTURE(lags.nx, lags.ny);
  PatirEquations patir(exponential(lags), lags);
  claim(patir);
}

double inner(const Equations& equations, const Values& x, const Values& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += equations.multiplicity()[i] * x[i] * y[i];
  return sum;
}

}  // namespace

// Each lag is a sum of products bounded by (Σ|kernel|)²; the transforms add a few ε of that. The place of an
// equation is found from a kernel that is not zero there alone.
TEST_CASE("the residual of each formulation is the double sum of the definition, less the target",
          "[equations][exact]") {
  for (Shape lags : shapes)
    for_all_formulations(lags, [&](Equations& equations) {
      const Values u = random_values(equations, 1), f = residual(equations, u);
      const Field kernel = equations.kernel(u);
      const double bound = 8 * epsilon * std::pow(1 + absolute_sum(kernel), 2);
      const bool half_plane = equations.count() > lags.cells();
      std::size_t i = 0;
      for (Index p = 0; p < lags.nx; ++p)
        for (Index q = half_plane && p > 0 ? 1 - lags.ny : 0; q < lags.ny; ++q, ++i)
          CHECK(std::abs(f[i] + equations.target()[i] - direct(kernel, p, q)) <= bound);
      CHECK(i == f.size());
    });
}

// F is quadratic, F(u) = Q(u,u) - R, so F(u+v) - F(u) - J(u)v = Q(v,v) = F(v) + R, exactly and not only to an
// order.
TEST_CASE("the Jacobian leaves exactly the quadratic part of the residual", "[equations][law]") {
  for (Shape lags : shapes)
    for_all_formulations(lags, [&](Equations& equations) {
      const Values u = random_values(equations, 2), v = random_values(equations, 3);
      Values sum = u;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += v[i];
      const Values both = residual(equations, sum), first = residual(equations, u),
                   second = residual(equations, v);
      const Values linear = product(equations, u, v);
      const double size = 1 + absolute_sum(equations.kernel(u)) + absolute_sum(equations.kernel(v));
      for (std::size_t i = 0; i < u.size(); ++i)
        CHECK(std::abs(both[i] - first[i] - linear[i] - second[i] - equations.target()[i]) <=
              16 * epsilon * size * size);
    });
}

// |⟨J u, v⟩| ≤ 2 max|a^| ‖u‖ ‖v‖ ≤ 2 Σ|a| ‖u‖ ‖v‖
TEST_CASE("the Jacobian of an even kernel is self-adjoint under the multiplicities", "[equations][law]") {
  for (Shape lags : shapes)
    for (bool oriented : {false, true}) {
      CAPTURE(lags.nx, lags.ny, oriented);
      ZeroPhaseEquations equations(exponential(lags, oriented), lags, oriented);
      const Values a = random_values(equations, 4), u = random_values(equations, 5),
                   v = random_values(equations, 6);
      const Values image = product(equations, a, u), back = product(equations, a, v);
      const double size =
          2 * absolute_sum(equations.kernel(a)) * std::sqrt(inner(equations, u, u) * inner(equations, v, v));
      CHECK(std::abs(inner(equations, image, v) - inner(equations, u, back)) <= 8 * epsilon * size);
    }
}

// For a = δ the Jacobians are diagonal: 2 for the zero-phase kernels; 1, and 2 at lag zero, for Patir's.
TEST_CASE("at white noise the preconditioner is the exact inverse of the Jacobian", "[equations][exact]") {
  for (Shape lags : shapes)
    for_all_formulations(lags, [&](Equations& equations) {
      Values delta(static_cast<std::size_t>(equations.count()), 0.0);
      delta[0] = 1;
      const Values v = random_values(equations, 7);
      Values back = product(equations, delta, v);
      equations.precondition(back);
      const double bound = 16 * epsilon * (1 + absolute_sum(equations.kernel(v)));
      for (std::size_t i = 0; i < v.size(); ++i) CHECK(std::abs(back[i] - v[i]) <= bound);
    });
}

TEST_CASE(
    "the residual refuses a kernel whose spectrum changes sign, computes it still, and lets the start pass",
    "[equations][contract]") {
  ZeroPhaseEquations equations(exponential({13, 4}), {13, 4}, false);
  const Values start = equations.start();
  Values f(start.size()), negated(start.size()), negative(start.size(), 0.0), positive(negative);
  CHECK(equations.residual(start, f));
  negative[0] = -1, positive[0] = 1;
  CHECK_FALSE(equations.residual(negative, negated));
  CHECK(equations.residual(positive, f));
  CHECK(negated == f);
}

// Σ w u² = Σ kernel², to round-off.
TEST_CASE("every start has the variance of the target, and so have the multiplicities",
          "[equations][exact]") {
  for (Shape lags : shapes)
    for_all_formulations(lags, [&](Equations& equations) {
      const Values start = equations.start();
      const double bound = epsilon * static_cast<double>(4 * lags.cells());
      CHECK(std::abs(equations.kernel(start).square().sum() - 1) <= bound);
      CHECK(std::abs(inner(equations, start, start) - 1) <= bound);
    });
}

// A target is sound when it is the autocorrelation of a kernel: the spectrum of R is then |a^|². The cosine
// of a frequency that does not fit the lags is sound too but cut; a triangle turned upside down is no
// autocorrelation at all.
TEST_CASE("feasibility separates the sound, the doubtful and the impossible targets", "[equations][law]") {
  auto of = [](auto f, Index n) {
    return ZeroPhaseEquations(Target([f](double p, double) { return f(p); }), {n, 1}, false).feasibility();
  };
  const Feasibility sound = of([](double p) { return 1 - std::abs(p) / 8; }, 8);
  CHECK(sound.least >= -16 * epsilon);
  const Feasibility doubtful = of([](double p) { return std::cos(p); }, 40);
  CHECK(doubtful.least < -0.05);
  CHECK(doubtful.windowed >= -16 * epsilon);
  const Feasibility impossible = of([](double p) { return p == 0 ? 1.0 : std::abs(p) < 3 ? -0.9 : 0.0; }, 8);
  CHECK(impossible.windowed < -0.1);
}
