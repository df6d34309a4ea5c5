#include "stats/hypothesis/specification.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "marginal/correlation_map.hpp"
#include "marginal/prescribed.hpp"
#include "stats/hypothesis/gaussianity.hpp"
#include "stats/sample/moments.hpp"
#include "stats/sample/quantiles.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {
namespace {

constexpr Index most_rows = 9, most_columns = 17;
constexpr double least_density = 0.1, most_score = 37;
constexpr double patches_per_degree = 10;  // of the t law whose tails the figures have
constexpr double patches_of_stretch = 4;   // the same: a stretch rests on more waves than S_2 counts
// Sku's third cumulant overstates: of n independent heights Fisher's has this skewness at most.
constexpr double most_skewed = 1.6;
constexpr double most_error_of_share = 0.5;  // of summits

// By the smaller of the tails.
double normal_score(const StudentTails& tails) {
  const auto& [below, above] = tails;
  const double score = above < below ? gsl_cdf_ugaussian_Qinv(above) : gsl_cdf_ugaussian_Pinv(below);
  return std::clamp(score, -most_score, most_score);
}

// Of the gamma law of mean 0, variance 1 and this skewness, by Wilson and Hilferty's cube root, which holds
// from one degree, a skewness of √8, on; with five patches or more Sq's is below.
double gamma_score(double z, double skewness) {
  if (std::abs(skewness) < 1e-6) return z;
  if (skewness < 0) return -gamma_score(-z, -skewness);
  const double degrees = std::max(1.0, 8 / (skewness * skewness)), variance = 2 / (9 * degrees);
  return (std::cbrt(std::max(0.0, 1 + z * std::sqrt(2 / degrees))) - 1 + variance) / std::sqrt(variance);
}

// Of Sku, whose upper tail is longer than a gamma law's: Anscombe and Glynn's inverse gamma law.
double kurtosis_score(double z, double skewness) {
  if (!(skewness > 1e-6)) return z;
  const double a = 6 + 8 / skewness * (2 / skewness + std::sqrt(1 + 4 / (skewness * skewness)));
  const double ratio = (1 - 2 / a) / std::max(1e-300, 1 + z * std::sqrt(2 / (a - 4)));
  return std::clamp((1 - 2 / (9 * a) - std::cbrt(ratio)) / std::sqrt(2 / (9 * a)), -most_score, most_score);
}

double largest_deviation(const Eigen::VectorXd& g, std::span<const double>) {
  return g.cwiseAbs().maxCoeff();
}

double two_sided(double score) { return 2 * gsl_cdf_ugaussian_Q(std::abs(score)); }

// S_k/N of (ρ - w)/(1 - w), of S_k/N of ρ: the binomial formula, where S_0/N is 1.
Eigen::Array<double, 5, 1> about_mean(const EffectiveSampleSize& size) {
  const double w = size.mean_power(1), v = 1 - w, s2 = size.mean_power(2), s3 = size.mean_power(3);
  return {0, w, (s2 - w * w) / (v * v), (s3 - 3 * w * s2 + 2 * w * w * w) / (v * v * v),
          (size.mean_power(4) - 4 * w * s3 + 6 * w * w * s2 - 3 * w * w * w * w) / (v * v * v * v)};
}

Index stride(Index lags, Index most) { return (lags + most - 1) / most; }

// R(h) at the lags that are tested needs no others.
Shape longest_lag(const LagField& rho, const Grid& grid) {
  return {std::min(rho.max_p(), grid.shape.nx / 4), std::min(rho.max_q(), grid.shape.ny / 4)};
}

LagField without_rounding_at_zero(const LagField& acf, double step) {
  return LagField::of(
      acf.max_lag(), [&](Index p, Index q) { return acf(p, q) - (p == 0 && q == 0 ? step * step / 12 : 0); });
}

void check(const Specification& asked) {
  if (!(asked.sku >= 1 + asked.ssk * asked.ssk))
    throw ParameterError(
        "kurtosis", "'" + shortest(asked.sku) + "' is below 1 + skewness², the least of any distribution");
}

}  // namespace

SpecificationTest::SpecificationTest(const Specification& asked, const Grid& grid)
    : asked_(asked), grid_(grid) {
  check(asked);
  asked_.correlation = asked.correlation.normalised();
  choose_lags();
  stretch_.emplace(asked_.correlation, grid, longest_lag(asked_.correlation, grid));
  complete_ = theory_of(grid);
  choose_stretches();
  slopes_ = PrescribedSlopes(asked_.correlation, grid);
  if (!asked_.gaussian()) {
    const Translation heights =
        PrescribedHeights{asked_.ssk, asked_.sku, InfeasiblePolicy::nearest}.translation();
    simulation_ = std::make_shared<Simulation>(Simulation{RandomFields(
        {.grid = grid, .correlation = asked_.correlation, .translation = heights}, asked_.seed)});
    slopes_.set_summits(underlying_correlation(asked_.correlation.within({2, 2}), CorrelationMap(heights)),
                        grid);
    return;
  }
  slopes_.set_summits(asked_.correlation, grid);
  slopes_.draw_summits(asked_.correlation, grid, asked_.threads, asked_.seed);
  total_.shape_variances = total_.shape_biases = Eigen::ArrayXd::Zero(complete_.shape_variances.size());
  const LagField& rho = asked_.correlation;
  const double cells = static_cast<double>(grid_.shape.cells());
  const double w = complete_.mean_powers(1), v = 1 - w;
  const LagField square(rho.half_plane().square());
  const EffectiveSampleSize size(rho, Pairs(grid_));
  variance_skewness_ = 8 * (CorrelationAlgebra(rho, grid_).mean_of_triples() / (cells * cells) - w * w * w) /
                       (v * v * v) / std::pow(2 * complete_.mean_powers(2), 1.5);
  sku_skewness_ =
      std::min(most_skewed, 1728 * CorrelationAlgebra(square, grid_).mean_of_triples() / (cells * cells) /
                                std::pow(24 * size.sum(4) / size.points(), 1.5));
}

void SpecificationTest::choose_lags() {
  const LagField& rho = asked_.correlation;
  const CorrelationAlgebra algebra(rho, grid_);
  const double cells = static_cast<double>(grid_.shape.cells());
  const Shape most = longest_lag(rho, grid_);
  const LagField c = algebra.convolution({2 * most.nx, 2 * most.ny}, grid_.periodic.both());
  std::vector<double> scales;  // of third cumulants
  const Index dp = stride(most.nx + 1, most_rows), dq = stride(2 * most.ny + 1, most_columns);
  for (Index p = 0; p <= most.nx; p += dp)
    for (Index q = p == 0 ? dq : -(most.ny / dq) * dq; q <= most.ny; q += dq) {
      const CorrelatedLag h{{p, q}, rho(p, q)};
      const double variance = bartlett_covariance(c, h, h);
      if (!(variance > 1e-12 * c(0, 0))) continue;
      lags_.push_back(h);
      acf_.each.push_back({.quantity = "ACF", .prescribed = h.rho, .lag_x = p, .lag_y = q});
      scales.push_back(std::sqrt(cells) * std::pow(variance, 1.5));
    }
  acf_.skewness = 8 * algebra.third_cumulants(lags_) / Eigen::Map<Eigen::ArrayXd>(scales.data(), lags());
  acf_.patches_per_degree = patches_per_degree;
  if (!lags_.empty()) acf_.largest = {bartlett_correlation(c, lags_), largest_deviation};
}

void SpecificationTest::choose_stretches() {
  for (const std::string& name : stretch_->names())
    lengths_.each.push_back({.quantity = name, .prescribed = 1});
  if (lengths_.each.empty()) return;
  const Eigen::MatrixXd& covariance = complete_.stretch.covariance;
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  lengths_.skewness = complete_.stretch.skewness();
  lengths_.patches_per_degree = patches_of_stretch;
  lengths_.largest = {scale.asDiagonal() * covariance * scale.asDiagonal(), largest_deviation};
}

void SpecificationTest::check_reach(const EffectiveSampleSize& size) const {
  auto refuse = [](const std::string& why) {
    throw DataError("acf_target", "it reaches too far for the field: " + why + "; use a larger field");
  };
  if (!size.gives_errors())
    refuse("N_eff = " + shortest(std::round(10 * size.effective(2)) / 10) + " is below " +
           shortest(size.least_effective()) + ", the least with which there are errors");
  if (!(size.mean_power(1) < 0.5)) refuse("subtracting its mean removes half of the variance or more");
}

SpecificationTest::Theory SpecificationTest::theory_of(const Pairs& pairs) const {
  const EffectiveSampleSize size(asked_.correlation, pairs);
  check_reach(size);
  Theory out{.mean_powers = about_mean(size), .stretch = stretch_->law(pairs, size.mean_power(1))};
  const auto stretches = static_cast<Index>(stretch_->names().size());
  out.shape_variances = out.shape_biases = Eigen::ArrayXd::Zero(lags() + stretches);
  out.shape_variances.tail(stretches) = out.stretch.covariance.diagonal();
  out.shape_biases.tail(stretches) = -out.stretch.with_variance;
  out.sku_bias = -6 * out.mean_powers(2);
  const AcfError errors(asked_.correlation, pairs);
  for (Index i = 0; const auto& [lag, rho] : lags_) {
    if (pairs.density(lag.nx, lag.ny) > least_density)
      out.shape_variances(i) = std::pow(errors.normalised(lag.nx, lag.ny), 2);
    ++i;
  }
  return out;
}

Eigen::ArrayXd SpecificationTest::measured(const Field& z, const Pairs& pairs, const Theory& theory,
                                           const GridSlopes& slopes, int threads, double step) const {
  const Moments rounded = moments(z), m = step > 0 ? before_rounding(rounded, step) : rounded;
  if (!(m.sq > 0))
    throw DataError("heights", "they stand on steps of " + in_digits(step / rounded.sq, 3) +
                                   " Sq, which are too coarse for the tests");
  LagField acf = estimate_autocorrelation(
      z, pairs, {.max_lag = longest_lag(asked_.correlation, grid_), .threads = threads});
  if (step > 0) acf = without_rounding_at_zero(acf, step);
  const double w = theory.mean_powers(1), of_heights = acf(0, 0) / (1 - w);
  const auto& [square, cells, share, points, plateaus] = before_steps(slopes, step, m.sq * m.sq);
  const Index of_shape = theory.shape_variances.size();
  Eigen::ArrayXd values(at_shapes + of_shape);
  values.head<at_shapes>() << of_heights, m.ssk, m.sku, square, share;
  for (Index i = at_shapes; const auto& [lag, rho] : lags_)
    values(i++) = acf(lag.nx, lag.ny) - (rho - w) * of_heights;
  values.tail(of_shape - lags()) = theory.stretch(acf);
  values.tail(of_shape) = (theory.shape_variances > 0).select(values.tail(of_shape), NAN);
  return values;
}

GridSlopes SpecificationTest::slopes_of(const Field& z, int threads) const {
  return std::isfinite(slopes_.square) ? grid_slopes(z, grid_, threads) : GridSlopes{};
}

// Rounding adds s²/12 to the variance of a height. It is independent of that of the next, to 2e-4, where
// steps are below 1.5 rms differences.
GridSlopes SpecificationTest::before_steps(GridSlopes slopes, double step, double variance) const {
  constexpr double most_steps = 1.5, most_plateaus = 1e-3;
  if (!(step > 0)) return slopes;
  const LagField& rho = asked_.correlation;
  const double difference = std::sqrt(2 * variance * (1 - std::max(rho(1, 0), rho(0, 1)))),
               rounding = step * step / 6 * (1 / (grid_.dx * grid_.dx) + 1 / (grid_.dy * grid_.dy));
  slopes.square = step < most_steps * difference ? slopes.square - rounding : NAN;
  if (slopes.plateaus > most_plateaus) slopes.share = NAN;
  return slopes;
}

void SpecificationTest::add(const Field& z, const Grid& grid) {
  auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
  if (shape_of(z) != grid_.shape || !same(grid.dx, grid_.dx) || !same(grid.dy, grid_.dy) ||
      grid.periodic != grid_.periodic)
    throw DataError("heights", "the grid differs from that of the first surface");
  const Pairs pairs = Pairs::of(z, grid_, asked_.threads);
  const Theory theory = pairs.complete() ? complete_ : theory_of(pairs);
  const GridSlopes slopes = slopes_of(z, asked_.threads);
  const Eigen::ArrayXd values = measured(z, pairs, theory, slopes, asked_.threads, height_steps(z).step);
  ++surfaces_;
  if (simulation_) {
    observed_.push_back(shaped(values));
    count_missing(z);
    return;
  }
  add_theory(theory, slopes, values);
}

void SpecificationTest::add_theory(const Theory& theory, const GridSlopes& slopes,
                                   const Eigen::ArrayXd& values) {
  ensemble_.add(values);
  total_.mean_powers += theory.mean_powers;
  total_.sku_bias += theory.sku_bias;
  total_.shape_variances += theory.shape_variances;
  total_.shape_biases += theory.shape_biases;
  const Eigen::Array2d points(slopes.cells, slopes.points);
  const double all = static_cast<double>((grid_.shape.nx - 2) * (grid_.shape.ny - 2)),
               share = slopes_.summits.value;
  const bool scattered = slopes.points < all;
  const Eigen::Array2d of_one(
      slopes_.variance, share * (scattered ? std::max(slopes_.dispersion, 1 - share) : slopes_.dispersion));
  for (const Index i : {0, 1}) {
    if (!std::isfinite(values(at_sdq + i))) continue;
    total_.slope_variances(i) += of_one(i) / points(i);
    total_.slope_points(i) += points(i);
  }
}

double SpecificationTest::score(double z, double skewness, double per_degree) const {
  const double patches = surfaces_ / mean_power(2);
  return normal_score(student_tails(gamma_score(z, skewness / std::sqrt(surfaces_)), patches / per_degree));
}

TestResult SpecificationTest::result(const std::string& name, double prescribed, double mean, double theory,
                                     double skewness) const {
  TestResult out{.quantity = name, .prescribed = prescribed, .mean = mean};
  out.standard_error = theory / std::sqrt(surfaces_);
  out.z = (mean - prescribed) / out.standard_error;
  out.p = two_sided(score(out.z, skewness, patches_per_degree));
  return out;
}

TestResult SpecificationTest::largest_result(const Together& of, Index first) const {
  const double variance = ensemble_.mean()(0);
  const auto n = static_cast<Index>(of.each.size());
  auto part = [&](const Eigen::ArrayXd& all) -> Eigen::ArrayXd {
    return all.segment(first + all.size() - total_.shape_variances.size(), n);
  };
  const Eigen::ArrayXd biases = part(total_.shape_biases) / (1.0 * surfaces_ * surfaces_),
                       mean = part(ensemble_.mean()) / variance - biases;
  const Eigen::ArrayXd error = part(total_.shape_variances).sqrt() / part(ensemble_.count());
  TestResult out = of.each.front();
  out.prescribed = 0, out.p = 1;
  double largest = -1;
  for (Index i = 0; i < n; ++i) {
    if (!(error(i) > 0)) continue;
    const double z = mean(i) / error(i), distance = std::abs(score(z, of.skewness(i), of.patches_per_degree));
    if (!(distance > largest)) continue;
    largest = distance;
    out = of.each[static_cast<std::size_t>(i)];
    out.mean = out.prescribed + mean(i), out.standard_error = error(i), out.z = z;
  }
  if (largest < 0) return out;
  const double bound = -std::expm1(static_cast<double>(n) * std::log1p(-two_sided(largest)));  // Šidák's
  out.p = std::min(bound, of.largest.exceedance(largest));
  out.p_is_bound = out.p == NullDistribution::least;
  return out;
}

std::optional<TestResult> SpecificationTest::slope_by_theory() const {
  const double variance = asked_.sq * asked_.sq, expected = variance * slopes_.square,
               mean = ensemble_.mean()(at_sdq), count = ensemble_.count()(at_sdq);
  if (!std::isfinite(expected) || !(count > 0)) return std::nullopt;
  TestResult out{.quantity = "Sdq", .prescribed = std::sqrt(expected), .mean = std::sqrt(mean)};
  const double error = variance * std::sqrt(total_.slope_variances(0)) / count;
  out.standard_error = error / (2 * out.prescribed);
  out.z = (mean - expected) / error;
  const double skewness = slopes_.skewness / std::sqrt(total_.slope_points(0) / surfaces_);
  out.p = two_sided(score(out.z, skewness, patches_per_degree));
  return out;
}

// Counts are skewed as Poisson's: 1/√n, which is their relative error where φ is 1. A few tell nothing.
std::optional<TestResult> SpecificationTest::summits_by_theory() const {
  const auto& [share, of_lattice] = slopes_.summits;
  const double mean = ensemble_.mean()(at_summits), count = ensemble_.count()(at_summits);
  if (!(share > 0) || !(count > 0)) return std::nullopt;
  const double error = std::hypot(std::sqrt(total_.slope_variances(1)) / count, of_lattice),
               area = grid_.cell_area();
  if (!(error < most_error_of_share * share)) return std::nullopt;
  TestResult out{.quantity = "summit_density", .prescribed = share / area, .mean = mean / area};
  out.standard_error = error / area;
  out.z = (mean - share) / error;
  out.p = two_sided(normal_score(student_tails(gamma_score(out.z, error / share), slopes_.drawn - 1)));
  return out;
}

std::vector<TestResult> SpecificationTest::by_theory() const {
  std::vector<TestResult> out;
  const Eigen::ArrayXd mean = ensemble_.mean();
  if (std::isfinite(asked_.sq)) {  // tested as a variance, reported as an rms height
    const double variance = asked_.sq * asked_.sq, error = variance * std::sqrt(2 * mean_power(2));
    out.push_back(result("Sq", variance, mean(0), error, variance_skewness_));
    out[0].prescribed = asked_.sq;
    out[0].mean = std::sqrt(mean(0));
    out[0].standard_error /= 2 * asked_.sq;
  }
  const double sku = mean(2) - total_.sku_bias / surfaces_;
  out.push_back(result("Ssk", asked_.ssk, mean(1), std::sqrt(6 * mean_power(3)), 0));
  out.push_back(result("Sku", asked_.sku, sku, std::sqrt(24 * mean_power(4)), 0));
  out.back().p = two_sided(kurtosis_score(out.back().z, sku_skewness_ / std::sqrt(surfaces_)));
  for (const auto& row : {slope_by_theory(), summits_by_theory()})
    if (row) out.push_back(*row);
  if (!lags_.empty()) out.push_back(largest_result(acf_, 0));
  if (!lengths_.each.empty()) out.push_back(largest_result(lengths_, lags()));
  return out;
}

std::vector<TestResult> SpecificationTest::results() const {
  if (surfaces_ == 0) throw DataError("heights", "the ensemble has no surface");
  return simulation_ ? by_simulation() : by_theory();
}

double joint_p(const std::vector<TestResult>& results) {
  double least = 1;
  for (const TestResult& c : results) least = std::min(least, c.p);
  return std::min(1.0, least * static_cast<double>(results.size()));
}

}  // namespace asperity
