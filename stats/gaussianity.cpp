#include "stats/gaussianity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "stats/missing.hpp"
#include "stats/weighted_chi_squared.hpp"

namespace asperity {
namespace {

constexpr double reach = 6;
constexpr Index supremum_nodes = 97, integral_nodes = 193;

Eigen::ArrayXd line(Index nodes) { return Eigen::ArrayXd::LinSpaced(nodes, -reach, reach); }

int bins_for(const EffectiveSize& size) {
  const double effective = size.points() / std::max(size.sum(3), 1.0);
  return static_cast<int>(std::clamp(2 * std::pow(effective, 0.4), 6.0, 64.0));
}

EffectiveSize independent(const EffectiveSize& size) {
  const Grid grid{{static_cast<Index>(size.points()), 1}, 1, 1, false};
  return EffectiveSize(LagField(Field::Ones(1, 1)), grid);
}

Eigen::ArrayXd eigenvalues(const Eigen::MatrixXd& form) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(form, Eigen::EigenvaluesOnly).eigenvalues();
}

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
  const double n = static_cast<double>(x.size());
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double below = static_cast<double>(i) / n, phi = gsl_cdf_ugaussian_P(x[i]);
    largest = std::max({largest, phi - below, below + 1 / n - phi});
  }
  return std::sqrt(n) * largest;
}

double anderson_darling(const std::vector<double>& x) {
  const double n = static_cast<double>(x.size());
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double rank = static_cast<double>(2 * i + 1) / n;
    sum += rank * log_gaussian(x[i]) + (2 - rank) * log_gaussian(-x[i]) + 1;
  }
  return -sum;
}

double pearson(const std::vector<double>& x, int bins) {
  const double expected = static_cast<double>(x.size()) / bins;
  double sum = 0;
  auto lower = x.begin();
  for (int bin = 1; bin <= bins; ++bin) {
    const auto upper =
        bin < bins ? std::lower_bound(lower, x.end(), gsl_cdf_ugaussian_Pinv(static_cast<double>(bin) / bins))
                   : x.end();
    const double excess = static_cast<double>(upper - lower) - expected;
    sum += excess * excess / expected;
    lower = upper;
  }
  return sum;
}

}  // namespace

// The weights of ∫ D² φ/(Φ(1-Φ)) dx.
Eigen::ArrayXd anderson_darling_weights(const EffectiveSize& size) {
  const Eigen::ArrayXd x = line(integral_nodes);
  const double step = 2 * reach / static_cast<double>(integral_nodes - 1);
  const Eigen::VectorXd root = x.unaryExpr([step](double at) {
    return std::sqrt(step * gsl_ran_ugaussian_pdf(at) / (gsl_cdf_ugaussian_P(at) * gsl_cdf_ugaussian_Q(at)));
  });
  return eigenvalues(root.asDiagonal() * fitted_process_covariance(x, size) * root.asDiagonal());
}

// The weights of B Σ (D(upper) - D(lower))², D = 0 at both ends.
Eigen::ArrayXd pearson_weights(const EffectiveSize& size, int bins) {
  const Eigen::ArrayXd edges = Eigen::ArrayXd::NullaryExpr(
      bins - 1, [=](Index a) { return gsl_cdf_ugaussian_Pinv(static_cast<double>(a + 1) / bins); });
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(bins, bins - 1);
  difference.diagonal().setOnes();
  difference.diagonal(-1).setConstant(-1);
  return eigenvalues(bins * difference * fitted_process_covariance(edges, size) * difference.transpose());
}

GaussianityTest::Laws::Laws(const EffectiveSize& size, int bins)
    : points(size.points()),
      sums{1, size.sum(1), size.sum(2), size.sum(3), size.sum(4)},
      anderson_darling(anderson_darling_weights(size)),
      pearson(pearson_weights(size, bins)),
      supremum(line(supremum_nodes), fitted_process_covariance(line(supremum_nodes), size),
               size.sum(EffectiveSize::powers)) {}

// Of a correlation whose S_3 or S_4 vanishes the moment has no error to this order, and is left out.
double GaussianityTest::Laws::jarque_bera(const Moments& moments) const {
  auto squared_score = [](double deviation, double variance) {
    return variance > 0 ? deviation * deviation / variance : 0;
  };
  return squared_score(moments.ssk, 6 * sums[3] / points) +
         squared_score(moments.sku - 3 + 6 * sums[2] / points, 24 * sums[4] / points);
}

double GaussianityTest::Laws::jarque_bera_p(double statistic) const {
  const int degrees = (sums[3] > 0) + (sums[4] > 0);
  return degrees == 2 ? std::exp(-statistic / 2) : degrees == 1 ? std::erfc(std::sqrt(statistic / 2)) : 1;
}

GaussianityTest::GaussianityTest(const EffectiveSize& size)
    : bins_(bins_for(size)), laws_(size, bins_), naive_(independent(size), bins_) {}

std::array<GoodnessOfFit, 4> GaussianityTest::operator()(const Field& z, const Moments& moments) const {
  const std::vector<double> x = sorted(z, moments);
  const double jb = laws_.jarque_bera(moments), ks = kolmogorov_smirnov(x), ad = anderson_darling(x),
               chi = pearson(x, bins_);
  return {{
      {"Jarque-Bera", jb, laws_.jarque_bera_p(jb), naive_.jarque_bera_p(naive_.jarque_bera(moments))},
      {"Kolmogorov-Smirnov", ks, laws_.supremum.exceedance(ks), naive_.supremum.exceedance(ks)},
      {"Anderson-Darling", ad, weighted_chi_squared_exceedance(laws_.anderson_darling, ad),
       weighted_chi_squared_exceedance(naive_.anderson_darling, ad)},
      {"Pearson chi-squared", chi, weighted_chi_squared_exceedance(laws_.pearson, chi),
       weighted_chi_squared_exceedance(naive_.pearson, chi)},
  }};
}

}  // namespace asperity
