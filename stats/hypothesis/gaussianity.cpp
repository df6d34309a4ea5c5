#include "stats/hypothesis/gaussianity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "math/linear_algebra.hpp"
#include "stats/filter/missing.hpp"
#include "stats/uncertainty/weighted_chi_squared.hpp"

namespace asperity {
namespace {

constexpr double reach = 6;
constexpr Index supremum_nodes = 97, integral_nodes = 193;

Eigen::ArrayXd line(Index nodes) { return Eigen::ArrayXd::LinSpaced(nodes, -reach, reach); }

std::vector<double> sorted(const Field& z, const Moments& moments) {
  std::vector<double> x(z.data(), z.data() + z.size());
  if (has_missing(z)) std::erase_if(x, [](double height) { return std::isnan(height); });
  for (double& value : x) value = (value - moments.mean) / moments.sq;
  std::ranges::sort(x);
  return x;
}

// ln Φ(x); below -37, where Φ is near the smallest double, by its asymptote.
double log_gaussian(double x) {
  return x > -37 ? std::log(gsl_cdf_ugaussian_P(x))
                 : -0.5 * x * x - std::log(-x * std::sqrt(2 * std::numbers::pi)) - 1 / (x * x);
}

double kolmogorov_smirnov(const std::vector<double>& x) {
  const auto n = static_cast<double>(x.size());
  double largest = 0, below = 0;
  for (const double height : x) {
    const double phi = gsl_cdf_ugaussian_P(height);
    largest = std::max({largest, phi - below / n, (below + 1) / n - phi});
    ++below;
  }
  return std::sqrt(n) * largest;
}

// What x_i adds to -(3), i from 0.
double anderson_darling_term(double i, double n, double x) {
  const double rank = (2 * i + 1) / n;
  return rank * log_gaussian(x) + (2 - rank) * log_gaussian(-x) + 1;
}

double anderson_darling(const std::vector<double>& x) {
  double sum = 0, below = 0;
  for (const double height : x) sum += anderson_darling_term(below++, static_cast<double>(x.size()), height);
  return -sum;
}

// How many heights lie below each edge between B bins.
std::vector<double> counts_below_edges(const std::vector<double>& x, int bins) {
  std::vector<double> counts;
  for (int b = 1; b < bins; ++b) {
    const auto edge = std::ranges::lower_bound(x, gsl_cdf_ugaussian_Pinv(static_cast<double>(b) / bins));
    counts.push_back(static_cast<double>(edge - x.begin()));
  }
  return counts;
}

double pearson(const std::vector<double>& x, int bins) {
  const auto n = static_cast<double>(x.size());
  const double expected = n / bins;
  double sum = 0, lower = 0;
  std::vector<double> edges = counts_below_edges(x, bins);
  edges.push_back(n);
  for (const double upper : edges) {
    sum += std::pow(upper - lower - expected, 2) / expected;
    lower = upper;
  }
  return sum;
}

}  // namespace

// The weights of ∫ D² φ/(Φ(1-Φ)) dx.
Eigen::ArrayXd anderson_darling_weights(const EffectiveSampleSize& size) {
  const Eigen::ArrayXd x = line(integral_nodes);
  const double step = 2 * reach / static_cast<double>(integral_nodes - 1);
  const Eigen::VectorXd root = x.unaryExpr([step](double at) {
    return std::sqrt(step * gsl_ran_ugaussian_pdf(at) / (gsl_cdf_ugaussian_P(at) * gsl_cdf_ugaussian_Q(at)));
  });
  return symmetric_eigenvalues(root.asDiagonal() * fitted_process_covariance(x, size) * root.asDiagonal());
}

// The weights of B Σ (D(upper) - D(lower))², D = 0 at both ends.
Eigen::ArrayXd pearson_weights(const EffectiveSampleSize& size, int bins) {
  const Eigen::ArrayXd edges = Eigen::ArrayXd::NullaryExpr(
      bins - 1, [=](Index a) { return gsl_cdf_ugaussian_Pinv(static_cast<double>(a + 1) / bins); });
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(bins, bins - 1);
  difference.diagonal().setOnes();
  difference.diagonal(-1).setConstant(-1);
  return symmetric_eigenvalues(bins * difference * fitted_process_covariance(edges, size) *
                               difference.transpose());
}

GaussianityTest::NullDistributions::NullDistributions(const EffectiveSampleSize& of, int bins)
    : size(of),
      anderson_darling(anderson_darling_weights(size)),
      pearson(pearson_weights(size, bins)),
      supremum(supremum_distribution(line(supremum_nodes),
                                     fitted_process_covariance(line(supremum_nodes), size),
                                     size.sum(EffectiveSampleSize::powers))) {}

// Of a correlation whose S_3 or S_4 vanishes the moment has no error to this order, and is left out.
double GaussianityTest::NullDistributions::jarque_bera(const Moments& moments) const {
  auto squared_score = [](double deviation, double variance) {
    return variance > 0 ? deviation * deviation / variance : 0;
  };
  return squared_score(moments.ssk, 6 * size.sum(3) / size.points()) +
         squared_score(moments.sku - 3 + 6 * size.sum(2) / size.points(), 24 * size.sum(4) / size.points());
}

double GaussianityTest::NullDistributions::jarque_bera_p(double statistic) const {
  const int degrees = (size.sum(3) > 0) + (size.sum(4) > 0);
  if (degrees == 0) return 1;
  return degrees == 1 ? std::erfc(std::sqrt(statistic / 2)) : std::exp(-statistic / 2);
}

std::array<GoodnessOfFit, 4> goodness_of_fit_tests() {
  return {{{"Jarque-Bera"}, {"Kolmogorov-Smirnov"}, {"Anderson-Darling"}, {"Pearson chi-squared"}}};
}

int GaussianityTest::bins_for(const EffectiveSampleSize& size) {
  const double effective = size.points() / std::max(size.sum(3), 1.0);
  return static_cast<int>(std::clamp(2 * std::pow(effective, 0.4), 6.0, 64.0));
}

EffectiveSampleSize GaussianityTest::independent(const EffectiveSampleSize& size) {
  const Grid grid{{static_cast<Index>(size.points()), 1}, 1, 1, false};
  return EffectiveSampleSize(LagField(Field::Ones(1, 1)), grid);
}

GaussianityTest::GaussianityTest(const EffectiveSampleSize& size)
    : bins_(bins_for(size)), correlated_(size, bins_), independent_(independent(size), bins_) {}

std::array<GoodnessOfFit, 4> GaussianityTest::operator()(const Field& z, const Moments& moments) const {
  const std::vector<double> x = sorted(z, moments);
  const double jb = correlated_.jarque_bera(moments), ks = kolmogorov_smirnov(x), ad = anderson_darling(x),
               chi = pearson(x, bins_);
  std::array<GoodnessOfFit, 4> out = goodness_of_fit_tests();
  auto set = [](GoodnessOfFit& fit, double statistic, double p, double naive) {
    fit.statistic = statistic, fit.p = p, fit.naive_p = naive;
  };
  set(out[0], jb, correlated_.jarque_bera_p(jb),
      independent_.jarque_bera_p(independent_.jarque_bera(moments)));
  set(out[1], ks, correlated_.supremum.exceedance(ks), independent_.supremum.exceedance(ks));
  out[1].p_is_bound = out[1].p <= NullDistribution::least;
  out[1].naive_p_is_bound = out[1].naive_p <= NullDistribution::least;
  set(out[2], ad, weighted_chi_squared_exceedance(correlated_.anderson_darling, ad),
      weighted_chi_squared_exceedance(independent_.anderson_darling, ad));
  set(out[3], chi, weighted_chi_squared_exceedance(correlated_.pearson, chi),
      weighted_chi_squared_exceedance(independent_.pearson, chi));
  return out;
}

}  // namespace asperity
