// Intervals that hold their estimates, over surfaces of many kinds.
#include "stats/uncertainty/interval.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/sample/ensemble.hpp"
#include "stats/sample/quantiles.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Case {
  std::string name;
  Grid grid;
  Field z;
};

Field exponential_acf_field(Shape shape, double length, unsigned seed) {
  Field z = white_noise(shape, seed);
  const double a = std::exp(-1 / length), b = std::sqrt(1 - a * a);
  for (Index j = 1; j < shape.ny; ++j) z.col(j) = a * z.col(j - 1) + b * z.col(j);
  for (Index i = 1; i < shape.nx; ++i) z.row(i) = a * z.row(i - 1) + b * z.row(i);
  return z;
}

Field with_holes(Field z) {
  for (Index k = 0; k < z.size(); k += 7) z(k) = std::nan("");
  return z;
}

std::vector<Case> surfaces() {
  const Shape s{24, 20};
  std::vector<Case> out;
  auto add = [&](const std::string& name, Field z) {
    for (const bool periodic : {false, true})
      out.push_back({name + (periodic ? ", periodic" : ""), grid(z.rows(), z.cols(), periodic), z});
  };
  for (unsigned seed = 0; seed < 4; ++seed) add("white noise", white_noise(s, seed));
  for (const double length : {0.7, 2.0, 6.0, 50.0})
    add("exponential " + std::to_string(length), exponential_acf_field(s, length, 5));
  for (const double length : {1.5, 4.0, 12.0})
    add("Gaussian " + std::to_string(length), gaussian_acf_field(s, length, 6));
  for (const Shape window : {Shape{12, 1}, {1, 10}, {5, 5}, {40, 40}})
    add("lay or patches", moving_average(s, window, 7));
  add("sine", sine(s, 1, 3));
  add("sine and noise", sine(s, 1, 3) + 0.01 * white_noise(s, 8));
  Field spike = Field::Zero(s.nx, s.ny);
  spike(3, 5) = 1;
  add("spike", spike);
  add("bimodal", (white_noise(s, 9) > 0).select(Field::Ones(s.nx, s.ny), 0.0));
  add("plane",
      Field::NullaryExpr(s.nx, s.ny, [](Index i, Index j) { return static_cast<double>(i - 2 * j); }));
  add("step", Field::NullaryExpr(s.nx, s.ny, [](Index i, Index) { return i < 12 ? 0.0 : 1.0; }));
  add("logarithms of a normal", exponential_acf_field(s, 2, 10).exp());
  add("with holes", with_holes(exponential_acf_field(s, 2, 11)));
  for (const Shape small : {Shape{8, 8}, {1, 60}, {60, 1}, {2, 2}, {3, 3}})
    add("small", white_noise(small, 12));
  return out;
}

bool holds(const Interval& i, double estimate) {
  return i.known() ? i.low <= estimate && estimate <= i.high && i.why.empty() : std::isnan(i.high);
}

}  // namespace

TEST_CASE("an interval is in order about its estimate, or there is none and it says why",
          "[interval][contract]") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const Interval sound = Interval::of(2, 1, 4), open = Interval::of(2, 1, inf), at = Interval::about(3, 0);
  CHECK((sound.known() && sound.low == 1 && sound.high == 4));
  CHECK((open.known() && open.high == inf));
  CHECK((at.low == 3 && at.high == 3));
  for (const Interval& none : {Interval::of(2, 3, 4), Interval::of(5, 3, 4), Interval::of(3.5, 4, 3)}) {
    CHECK((std::isnan(none.low) && std::isnan(none.high)));
    CHECK_FALSE(none.why.empty());
  }
  for (const Interval& unknown : {Interval::about(2, -nan), Interval::of(nan, 1, 2), Interval::of(2, nan, 3)})
    CHECK((!unknown.known() && unknown.why.empty()));
}

// Between a straight line where ρ ≤ 0 and ln ρ where it was above half the level, a higher ρ had a shorter
// length by up to an eighth of a sample; and the correlation between two lags leapt where one of them fell
// through zero. Intervals of noise were therefore reversed, as [2.624, 2.600] µm.
TEST_CASE("a correlation that is nowhere lower has no shorter length, in any direction",
          "[acf-length][law]") {
  double former = 0;
  for (double below = -0.5; below < 0.2; below += 1e-3) {
    const double lag = crossing_between(1, below, 0.2).lag;
    CHECK(former <= lag);
    former = lag;
  }
  former = 0;
  for (double above = 0.2001; above <= 1; above += 1e-3) {
    const double lag = crossing_between(above, 0.04, 0.2).lag;
    CHECK(former <= lag);
    former = lag;
  }
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> uniform;
  for (int k = 0; k < 200; ++k) {
    Field lower = Field::NullaryExpr(5, 9, [&](Index, Index) { return 0.8 * uniform(generator) - 0.4; });
    Field higher = lower.unaryExpr([&](double rho) { return rho + 0.3 * uniform(generator); });
    lower(0, 4) = higher(0, 4) = 1;
    for (double angle = 0; angle < 3.1; angle += 0.3) {
      const auto near = first_crossing(LagField(lower), grid(9, 9), angle, 0.2),
                 far = first_crossing(LagField(higher), grid(9, 9), angle, 0.2);
      CHECK((!far || (near && near->lag <= far->lag * (1 + 10 * epsilon))));
    }
  }
}

// The exponential is exact as long as (2) is ln ρ's: down to lengths of 1.3 samples.
TEST_CASE("the length of an exponential of 1.3 samples is exact, wherever it lies between two lags",
          "[acf-length][exact]") {
  const double decay = 1 / 1.33;
  for (double level = 0.02; level < 0.98; level += 0.01) {
    const double exact = -std::log(level) / decay, lag = std::floor(exact);
    const double within = crossing_between(std::exp(-decay * lag), std::exp(-decay * (lag + 1)), level).lag;
    CHECK(std::abs(lag + within - exact) <= 1e-12);
  }
}

// Kurtosis is low by 6 S_2/N and Sq by S_1/(2N), which was put back past the estimate where few heights are
// independent; lengths were reversed, or all to one side, where ρ is noise; and that of the slowest decay was
// that of a ray, not of the lobe.
TEST_CASE("intervals of every surface hold what was measured, or there is none", "[interval][law]") {
  for (const Case& s : surfaces()) {
    CAPTURE(s.name, s.grid.shape.nx, s.grid.shape.ny);
    const Pairs pairs = Pairs::of(s.z, s.grid);
    const LagField acf = estimate_autocorrelation(s.z, pairs, {.max_lag = default_max_lag(s.grid)});
    const Moments m = moments(s.z);
    const MomentIntervals i = confidence_intervals(m, EffectiveSampleSize::of_estimate(acf, pairs));
    CHECK(holds(i.mean, m.mean));
    CHECK(holds(i.sa, m.sa));
    CHECK(holds(i.sq, m.sq));
    CHECK(holds(i.ssk, m.ssk));
    CHECK(holds(i.sku, m.sku));
    const LagField rho = acf.normalised();
    const AcfEstimate estimate(acf, {acf, true, pairs});
    const LengthErrors lengths(estimate, remove_form(s.z), 0.1);
    for (const double level : {0.1, 0.2, 1 / std::numbers::e})
      for (const double angle : {0.0, 0.5, std::numbers::pi / 2, 2.4})
        if (const auto at = first_crossing(rho, s.grid, angle, level))
          CHECK(holds(lengths.along(angle, level, at->lag).interval.value_or(Interval()), at->lag));
    const LobeEstimates lobe = lengths.lobe(0.2);
    for (const auto& of : {lobe.r_min, lobe.r_max, lobe.aspect_ratio, lobe.gamma})
      if (of) CHECK(holds(of->interval.value_or(Interval()), of->value));
  }
}

// Lags of a whole number of periods are as evident as lag zero, which came after them and was then left out:
// "R(0,0) is not positive".
TEST_CASE("lag zero of a periodic wave is admitted before lags of whole periods", "[effective-size][law]") {
  const Grid g = grid(64, 64, true);
  const LagField acf = estimate_autocorrelation(sine(g.shape, 1, 4), g, {.max_lag = default_max_lag(g)});
  CHECK(significant_lags(acf, g)(0, 0) == 1);
  CHECK(EffectiveSampleSize::of_estimate(acf, g).effective(2) <= 10);
}

// ---- quantiles ----

namespace {

int calls = 0;

// GSL's own handler would end the process.
struct Counted {
  gsl_error_handler_t* former = gsl_set_error_handler([](const char*, const char*, int, int) { ++calls; });
  Counted() { calls = 0; }
  ~Counted() { gsl_set_error_handler(former); }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
};

constexpr double inf = std::numeric_limits<double>::infinity(),
                 no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// The χ² and t quantiles of degrees that are no number ended the program of whoever used the library: a flat
// surface has 0/0.
TEST_CASE("no argument of a quantile reaches GSL's error handler", "[quantiles][contract]") {
  const Counted handler;
  const double degrees[] = {no_number, -inf, -1,  0,   1e-300, 1e-7, 1e-5,  0.005,
                            0.02,      1,    1e3, 1e5, 1e8,    1e12, 1e300, inf},
               tails[] = {no_number, -1, 0, 1e-300, 1e-12, 0.025, 0.5, 0.975, 1, 2, inf};
  for (const double d : degrees)
    for (const double t : tails) {
      CAPTURE(d, t);
      const bool chi = t >= 0 && t <= 1 && d >= 1e-6, student = t > 0 && t < 1 && d >= 0.01;
      if (!chi) CHECK(std::isnan(chi_squared_share(t, d)));
      if (chi && d < 1e300) CHECK(!std::isnan(chi_squared_share(t, d)));
      if (!student || d >= 1) CHECK(std::isnan(student_quantile(t, d)) == !student);
      CHECK(std::isnan(student_tails(t, d).below) == !(d >= 0.01 && !std::isnan(t)));
      CHECK(std::isnan(student_tails(-t, d).above) == !(d >= 0.01 && !std::isnan(t)));
    }
  CHECK(calls == 0);
}

TEST_CASE("within their bounds quantiles are those of GSL, and the normal ones at the end",
          "[quantiles][exact]") {
  for (const double d : {0.5, 3.0, 41.0, 9e3}) {
    CHECK(chi_squared_share(0.025, d) == gsl_cdf_chisq_Qinv(0.025, d) / d);
    CHECK(student_quantile(0.025, d) == gsl_cdf_tdist_Qinv(0.025, d));
    CHECK(student_tails(1.5, d).above == gsl_cdf_tdist_Q(1.5, d));
  }
  // t of ν degrees is x + (x³ + x)/4ν, 1.2e-9 beside the normal x = 1.96 of ν = 2e9.
  const double x = gsl_cdf_ugaussian_Qinv(0.025);
  CHECK(std::abs(student_quantile(0.025, 2e9) - x) <= 0);
  CHECK(std::abs(gsl_cdf_tdist_Qinv(0.025, 0.99e9) - x) <= 2.5e-9);
}

// ---- ensemble ----

// 1 … n: mean (n+1)/2, variance n(n+1)/12. Numbers below 2^53 apart, so that an offset of 1e9 is exact; each
// of the n steps rounds by ε of the offset at most, less than n ε 1e9 = 2e-4 in the mean of spread 289.
TEST_CASE("the numbers 1 to n have mean (n+1)/2 and variance n(n+1)/12, on any offset", "[ensemble][exact]") {
  const double n = 1000;
  for (double offset : {0.0, 1e9}) {
    Ensemble ensemble;
    for (double x = 1; x <= n; ++x) ensemble.add(Eigen::ArrayXd::Constant(1, offset + x));
    const double rounding = n * epsilon * (offset + n);
    const double variance = n * (n + 1) / 12;
    CHECK(std::abs(ensemble.mean()(0) - offset - (n + 1) / 2) <= rounding);
    CHECK(std::abs(ensemble.spread()(0) - std::sqrt(variance)) <= rounding);
    CHECK(std::abs(ensemble.standard_error()(0) - std::sqrt(variance / n)) <= rounding);
  }
}

// By plain sums: Σ w x/Σ w, and Σ w (x - mean)²/(Σ w (n-1)).
TEST_CASE("weighted realisations have the mean and the error of weighted least squares",
          "[ensemble][exact]") {
  const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(9, -1, 3).cube(),
                       w = Eigen::ArrayXd::LinSpaced(9, 0.5, 4);
  Ensemble ensemble;
  for (Index m = 0; m < x.size(); ++m) ensemble.add(x.segment(m, 1), w(m));
  const double mean = (w * x).sum() / w.sum(), square = (w * (x - mean).square()).sum() / (w.sum() * 8);
  CHECK(std::abs(ensemble.mean()(0) - mean) <= 1e-13);
  CHECK(std::abs(ensemble.standard_error()(0) / std::sqrt(square) - 1) <= 1e-14);
  CHECK(std::abs(ensemble.spread()(0) / std::sqrt(9 * square) - 1) <= 1e-14);
}

TEST_CASE("a realisation without a quantity counts for the others only", "[ensemble][contract]") {
  Ensemble ensemble;
  ensemble.add(Eigen::Array3d(1, NAN, NAN));
  ensemble.add(Eigen::Array3d(3, 7, NAN));
  CHECK(ensemble.count()(0) == 2);
  CHECK(ensemble.count()(1) == 1);
  CHECK(ensemble.mean()(0) == 2);
  CHECK(ensemble.mean()(1) == 7);
  CHECK(ensemble.spread()(0) == Approx(std::sqrt(2)).epsilon(1e-15));
  CHECK(std::isnan(ensemble.spread()(1)));
  CHECK(std::isnan(ensemble.mean()(2)));
  CHECK_THROWS_AS(ensemble.add(Eigen::Array2d(1, 2)), DataError);
}
