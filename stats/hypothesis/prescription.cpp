#include "stats/hypothesis/prescription.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "marginal/prescribed.hpp"
#include "stats/height/moments.hpp"
#include "stats/height/quantiles.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/acf_error.hpp"
#include "stats/uncertainty/correlation_powers.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {
namespace {

constexpr Index most_rows = 9, most_columns = 17;
constexpr double least_density = 0.1;
constexpr double most_score = 37;
constexpr double patches_per_degree = 10;  // of the t law whose tails the figures have
constexpr double degrees_of_spread =
    0.75;  // a surface, less one: figures are more skewed than Student's law knows

// Sku's third cumulant, of first order, overstates: of n independent heights Fisher's has this skewness at the most.
constexpr double most_skewed = 1.6;

constexpr double most_of_mean =
    0.1;  // of the variance, of a translation, whose biases are about a known mean

// The score of probabilities below and above, whichever is the smaller.
double normal_score(double below, double above) {
  const double score = above < below ? gsl_cdf_ugaussian_Qinv(above) : gsl_cdf_ugaussian_Pinv(below);
  return std::clamp(score, -most_score, most_score);
}

// Of the gamma law of mean 0, variance 1 and this skewness, by Wilson and Hilferty's cube root; below 1e-6 it is z. The cube
// root holds from one degree on (below 2/9 the least value of all would score high), which a skewness of √8 stands for. With
// five patches or more Sq's is below.
double gamma_score(double z, double skewness) {
  if (std::abs(skewness) < 1e-6) return z;
  if (skewness < 0) return -gamma_score(-z, -skewness);
  const double degrees = std::max(1.0, 8 / (skewness * skewness)), variance = 2 / (9 * degrees);
  return (std::cbrt(std::max(0.0, 1 + z * std::sqrt(2 / degrees))) - 1 + variance) / std::sqrt(variance);
}

double two_sided(double score) { return 2 * gsl_cdf_ugaussian_Q(std::abs(score)); }

// (5) and (6) but for their factors 8/N² and 1/N.
double third_cumulant(const CorrelationPowers& powers, Index p, Index q, double rho) {
  auto t = [&](Index k) { return powers.third(k * p, k * q); };
  return (3 * t(1) + t(3)) / 4 - 1.5 * rho * (t(0) + t(2)) + 3 * rho * rho * t(1) - rho * rho * rho * t(0);
}

double covariance(const CorrelationPowers& powers, Shape h, double rho_h, Shape g, double rho_g) {
  auto c = [&](Index p, Index q) { return powers.second(p, q); };
  return c(h.nx - g.nx, h.ny - g.ny) + c(h.nx + g.nx, h.ny + g.ny) - 2 * rho_g * c(h.nx, h.ny) -
         2 * rho_h * c(g.nx, g.ny) + 2 * rho_h * rho_g * c(0, 0);
}

// S_k/N of (ρ - w)/(1 - w), of S_k/N of ρ: the binomial formula, where S_0/N is 1.
std::array<double, 5> about_mean(const std::array<double, 5>& s) {
  const double w = s[1], v = 1 - w;
  return {s[0], w, (s[2] - w * w) / (v * v), (s[3] - 3 * w * s[2] + 2 * w * w * w) / (v * v * v),
          (s[4] - 4 * w * s[3] + 6 * w * w * s[2] - 3 * w * w * w * w) / (v * v * v * v)};
}

Index longest(Index table, Index points) { return std::min(table, points / 4); }

Index stride(Index lags, Index most) { return (lags + most - 1) / most; }

// R(h) at the lags that are tested needs no others.
Shape longest_lag(const LagField& rho, const Grid& grid) {
  return {longest(rho.max_p(), grid.shape.nx), longest(rho.max_q(), grid.shape.ny)};
}

}  // namespace

void Prescription::check() const {
  if (!(sku >= 1 + ssk * ssk))
    throw ParameterError("kurtosis",
                         "value " + shortest(sku) + " is below 1 + skewness², which no distribution has");
  if (!spread && (ssk != 0 || sku != 3))
    throw ParameterError("errors",
                         "theory knows those of Gaussian surfaces only, of skewness 0 and kurtosis 3");
}

PrescriptionTest::PrescriptionTest(const Prescription& prescription, const Grid& grid)
    : prescription_(prescription), grid_(grid) {
  prescription_.check();
  prescription_.correlation = prescription.correlation.normalised();
  const LagField& rho = prescription_.correlation;
  choose_lags(CorrelationPowers(tapered(rho, grid), grid));
  if (prescription_.ssk != 0 || prescription_.sku != 3) {
    const PrescribedHeights heights{prescription_.ssk, prescription_.sku, InfeasiblePolicy::nearest};
    const Translation g = heights.translation();
    translated_ = Translated{g, underlying_correlation(rho, CorrelationMap(g))};
  }
  complete_ = theory_of(grid);
  total_.lag_variances = Eigen::ArrayXd::Zero(static_cast<Index>(lags_.size()));
  const double cells = static_cast<double>(grid.shape.cells());
  const double w = complete_.sums[1], v = 1 - w;
  const LagField square(rho.half_plane().square());
  const EffectiveSize size(rho, Pairs(grid));
  variance_skewness_ = 8 * (mean_of_triples(rho, grid) / (cells * cells) - w * w * w) / (v * v * v) /
                       std::pow(2 * complete_.sums[2], 1.5);
  sku_skewness_ = std::min(most_skewed, 1728 * mean_of_triples(square, grid) / (cells * cells) /
                                            std::pow(24 * size.sum(4) / size.points(), 1.5));
}

void PrescriptionTest::Theory::operator+=(const Theory& other) {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += other.sums[k];
  ssk_bias += other.ssk_bias;
  sku_bias += other.sku_bias;
  lag_variances += other.lag_variances;
}

PrescriptionTest::Theory PrescriptionTest::theory_of(const Pairs& pairs) const {
  const LagField& rho = prescription_.correlation;
  const EffectiveSize size(rho, pairs);
  Theory out{.lag_variances = Eigen::ArrayXd::Zero(static_cast<Index>(lags_.size()))};
  for (std::size_t k = 1; k <= 4; ++k) out.sums[k] = size.sum(static_cast<int>(k)) / size.points();
  if (!prescription_.spread && !size.tells_errors())
    throw DataError("acf_target", "it reaches too far for the field, worth N_eff = " +
                                      shortest(std::round(10 * size.effective(2)) / 10) +
                                      " independent points: theory has errors from " +
                                      shortest(size.least_effective()) + " on; take a larger field");
  if (!(out.sums[1] < 0.5))
    throw DataError("acf_target", "it reaches too far for the field, whose mean takes half of the variance");
  if (translated_ && !(out.sums[1] < most_of_mean))
    throw DataError(
        "acf_target",
        "it reaches too far for the field, whose mean takes " + shortest(std::round(100 * out.sums[1])) +
            " % of the variance: of heights that are not Gaussian the biases of Ssk and Sku are known "
            "below 10 %; take a larger field");
  out.sums = about_mean(out.sums);
  out.sku_bias = -6 * out.sums[2];
  if (translated_) {
    const TranslationErrors errors(translated_->heights, EffectiveSize(translated_->below, pairs));
    out.ssk_bias = errors.ssk_bias();
    out.sku_bias = errors.sku_bias();
  }
  const AcfError errors(rho, pairs);
  for (Index i = 0; const Lag& lag : lags_) {
    if (pairs.density(lag.p, lag.q) > least_density)
      out.lag_variances(i) = std::pow(errors.normalised(lag.p, lag.q), 2);
    ++i;
  }
  return out;
}

void PrescriptionTest::choose_lags(const CorrelationPowers& powers) {
  const LagField& rho = prescription_.correlation;
  const double cells = static_cast<double>(grid_.shape.cells());
  const Shape most = longest_lag(rho, grid_);
  const Index dp = stride(most.nx + 1, most_rows), dq = stride(2 * most.ny + 1, most_columns);
  for (Index p = 0; p <= most.nx; p += dp)
    for (Index q = p == 0 ? dq : -(most.ny / dq) * dq; q <= most.ny; q += dq) {
      const double at = rho(p, q), variance = covariance(powers, {p, q}, at, {p, q}, at);
      if (!(variance > 1e-12 * powers.second(0, 0))) continue;
      lags_.push_back(
          {p, q, at, 8 * third_cumulant(powers, p, q, at) / (std::sqrt(cells) * std::pow(variance, 1.5))});
    }
  const auto count = static_cast<Index>(lags_.size());
  Eigen::MatrixXd correlation = Eigen::MatrixXd::NullaryExpr(count, count, [&](Index a, Index b) {
    const Lag &h = lags_[static_cast<std::size_t>(a)], &g = lags_[static_cast<std::size_t>(b)];
    return covariance(powers, {h.p, h.q}, h.rho, {g.p, g.q}, g.rho);
  });
  const Eigen::VectorXd scale = correlation.diagonal().cwiseSqrt().cwiseInverse();
  correlation = scale.asDiagonal() * correlation * scale.asDiagonal();
  if (count > 0) largest_ = GaussianMaximum(correlation, GaussianMaximum::Of::magnitudes);
}

void PrescriptionTest::add(const Field& z, const Grid& grid) {
  auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
  if (shape_of(z) != grid_.shape || !same(grid.dx, grid_.dx) || !same(grid.dy, grid_.dy) ||
      grid.periodic != grid_.periodic)
    throw DataError("heights", "the surface has another grid than the first one");
  const Moments m = moments(z);
  const Pairs pairs = Pairs::of(z, grid_, prescription_.threads);
  const Theory theory = pairs.complete() ? complete_ : theory_of(pairs);
  const LagField acf = estimate_autocorrelation(
      z, pairs, {.max_lag = longest_lag(prescription_.correlation, grid_), .threads = prescription_.threads});
  const double w = theory.sums[1], variance = acf(0, 0) / (1 - w);
  const auto count = static_cast<Index>(lags_.size());
  Eigen::ArrayXd values(3 + count);
  values.head<3>() << variance, m.ssk, m.sku;
  for (Index i = 0; const Lag& lag : lags_) values(3 + i++) = acf(lag.p, lag.q) - (lag.rho - w) * variance;
  values.tail(count) = (theory.lag_variances > 0).select(values.tail(count), NAN);
  ensemble_.add(values);
  total_ += theory;
  ++surfaces_;
}

double PrescriptionTest::score(double z, double skewness) const {
  const double patches = surfaces_ / mean_sum(2);
  const double t = prescription_.spread ? z : gamma_score(z, skewness / std::sqrt(surfaces_));
  const double degrees =
      prescription_.spread ? degrees_of_spread * (surfaces_ - 1) : patches / patches_per_degree;
  const StudentTails tails = student_tails(t, degrees);
  return normal_score(tails.below, tails.above);
}

Claim PrescriptionTest::claim(const std::string& name, Index quantity, double prescribed, double mean,
                              double theory, double skewness) const {
  Claim out{.quantity = name, .prescribed = prescribed, .mean = mean};
  out.standard_error =
      prescription_.spread ? ensemble_.standard_error()(quantity) : theory / std::sqrt(surfaces_);
  out.z = (mean - prescribed) / out.standard_error;
  out.p = two_sided(score(out.z, skewness));
  return out;
}

// Tested as a variance, told as an rms height.
Claim PrescriptionTest::height_claim() const {
  const double variance = prescription_.sq * prescription_.sq, mean = ensemble_.mean()(0);
  Claim out = claim("Sq", 0, variance, mean, variance * std::sqrt(2 * mean_sum(2)), variance_skewness_);
  out.prescribed = prescription_.sq;
  out.mean = std::sqrt(mean);
  out.standard_error /= 2 * prescription_.sq;
  return out;
}

Claim PrescriptionTest::correlation_claim() const {
  const Eigen::ArrayXd mean = ensemble_.mean() / ensemble_.mean()(0);
  const Eigen::ArrayXd spread = ensemble_.standard_error() / ensemble_.mean()(0);
  Claim out{.quantity = "ACF", .p = 1};
  double largest = -1;
  const Eigen::ArrayXd theory =
      total_.lag_variances.sqrt() / ensemble_.count().tail(total_.lag_variances.size());
  for (Index i = 0; const Lag& lag : lags_) {
    const double strayed = mean(3 + i), error = prescription_.spread ? spread(3 + i) : theory(i);
    ++i;
    if (!(error > 0)) continue;
    const double strays = std::abs(score(strayed / error, lag.skewness));
    if (strays > largest)
      out = {"ACF", lag.rho, lag.rho + strayed, error, strayed / error, 1, lag.p, lag.q}, largest = strays;
  }
  out.p = largest < 0 ? 1 : largest_score_p(largest);
  return out;
}

double PrescriptionTest::largest_score_p(double score) const {
  const double sidak = -std::expm1(static_cast<double>(lags_.size()) * std::log1p(-two_sided(score)));
  return prescription_.spread ? sidak : std::min(sidak, largest_.exceedance(score));
}

std::vector<Claim> PrescriptionTest::claims() const {
  if (surfaces_ == 0) throw DataError("heights", "the ensemble has no surface");
  if (prescription_.spread && surfaces_ < 2)
    throw ParameterError("errors",
                         "a single surface has no spread, which errors rest on where heights are not to be "
                         "Gaussian: name several");
  std::vector<Claim> out;
  if (std::isfinite(prescription_.sq)) out.push_back(height_claim());
  const Eigen::ArrayXd mean = ensemble_.mean();
  const double ssk = mean(1) - total_.ssk_bias / surfaces_, sku = mean(2) - total_.sku_bias / surfaces_;
  out.push_back(claim("Ssk", 1, prescription_.ssk, ssk, std::sqrt(6 * mean_sum(3)), 0));
  out.push_back(claim("Sku", 2, prescription_.sku, sku, std::sqrt(24 * mean_sum(4)), sku_skewness_));
  if (!lags_.empty()) out.push_back(correlation_claim());
  return out;
}

double joint_p(const std::vector<Claim>& claims) {
  double least = 1;
  for (const Claim& c : claims) least = std::min(least, c.p);
  return std::min(1.0, least * static_cast<double>(claims.size()));
}

}  // namespace asperity
