#include "stats/hypothesis/gaussianity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/words.hpp"
#include "math/linear_algebra.hpp"
#include "stats/filter/missing.hpp"
#include "stats/hypothesis/weighted_chi_squared.hpp"

namespace asperity {
namespace {

constexpr double node_reach = 6;
constexpr Index supremum_nodes = 97, integral_nodes = 193;

Eigen::ArrayXd line(Index nodes) { return Eigen::ArrayXd::LinSpaced(nodes, -node_reach, node_reach); }

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

// How many heights are below each edge between B bins.
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
  const double step = 2 * node_reach / static_cast<double>(integral_nodes - 1);
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

// ---- heights in steps ----

namespace {

using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double coarsest = 1.25;
constexpr Index most_edges = 97;

// ε
double added(const Moments& before, double step) { return step * step / (12 * before.sq * before.sq); }

// Between steps, ascending, in units of Sq, and the number of heights below each.
struct Edges {
  ArrayXd x, below;

  ArrayXd shares() const { return x.unaryExpr(&gsl_cdf_ugaussian_P); }
  Edges at(const std::vector<Index>& which) const { return {x(which), below(which)}; }
};

Edges edges_of(const std::vector<HeightRun>& heights, const Moments& before, const HeightSteps& steps) {
  auto place = [&](double x) { return (before.mean + x * before.sq - steps.lowest) / steps.step + 0.5; };
  const auto first = static_cast<Index>(std::ceil(place(-node_reach))),
             last = static_cast<Index>(std::floor(place(node_reach)));
  Edges out{ArrayXd(last - first + 1), ArrayXd(last - first + 1)};
  double below = 0;
  auto next = heights.begin();
  for (Index k = first; k <= last; ++k) {
    const double edge = steps.lowest + (static_cast<double>(k) - 0.5) * steps.step;
    for (; next != heights.end() && next->height < edge; ++next) below += next->count;
    out.x(k - first) = (edge - before.mean) / before.sq, out.below(k - first) = below;
  }
  return out;
}

// As many as the distributions are simulated at.
Edges thinned(const Edges& all) {
  std::vector<Index> which;
  const Index stride = (all.x.size() + most_edges - 1) / most_edges;
  for (Index k = 0; k < all.x.size(); k += stride) which.push_back(k);
  return all.at(which);
}

// Nearest to those of bins of equal probability.
Edges class_edges(const Edges& all, int bins) {
  std::vector<Index> which;
  for (int b = 1; b < bins; ++b) {
    Index nearest = 0;
    (all.x - gsl_cdf_ugaussian_Pinv(static_cast<double>(b) / bins)).abs().minCoeff(&nearest);
    if (which.empty() || which.back() != nearest) which.push_back(nearest);
  }
  return all.at(which);
}

MatrixXd covariance(const ArrayXd& x, const EffectiveSampleSize& size, double epsilon) {
  const VectorXd density = x.unaryExpr(&gsl_ran_ugaussian_pdf), of_sq = x * density.array();
  return fitted_process_covariance(x, size) + epsilon * density * density.transpose() +
         (epsilon + 0.2 * epsilon * epsilon) * of_sq * of_sq.transpose();
}

// What a function grows by from each edge to the next, its value at the outer ends being these.
ArrayXd growth(const ArrayXd& at_edges, double low, double high) {
  ArrayXd out(at_edges.size() + 1);
  out << at_edges, high;
  out.tail(at_edges.size()) -= at_edges;
  out(0) -= low;
  return out;
}

double supremum_of(const VectorXd& g, std::span<const double>) { return g.cwiseAbs().maxCoeff(); }

// The statistics, and their distributions for one correlation.
class Stepped {
 public:
  Stepped(const Edges& all, int bins, const Moments& before, double epsilon, double points)
      : line_(thinned(all)),
        classes_(class_edges(all, bins)),
        before_(before),
        epsilon_(epsilon),
        points_(points) {
    const ArrayXd shares = line_.shares(), steps = growth(shares, 0, 1);
    weights_ = 0.5 * (steps.head(shares.size()) + steps.tail(shares.size())) / (shares * (1 - shares));
    probabilities_ = growth(classes_.shares(), 0, 1);
    process_ = std::sqrt(points) * (line_.below / points - shares);
  }

  double supremum() const { return process_.abs().maxCoeff(); }
  double anderson_darling() const { return (weights_ * process_.square()).sum(); }
  double pearson() const {
    const ArrayXd expected = points_ * probabilities_;
    return ((growth(classes_.below, 0, points_) - expected).square() / expected).sum();
  }

  struct Scores {
    double jarque_bera;
    std::array<double, 4> p;
    bool at_floor;  ///< of the supremum
  };
  Scores scores(const EffectiveSampleSize& size) const {
    const double s3 = size.sum(3) + std::pow(1 + epsilon_, 3) - 1,
                 s4 = size.sum(4) + std::pow(1 + epsilon_, 4) - 1, bias = 6 * size.sum(2) / points_;
    const double jb =
        points_ * (before_.ssk * before_.ssk / (6 * s3) + std::pow(before_.sku - 3 + bias, 2) / (24 * s4));
    const MatrixXd along = covariance(line_.x, size, epsilon_);
    const NullDistribution largest(along, supremum_of);
    const VectorXd root = weights_.sqrt();
    const ArrayXd of_ad = symmetric_eigenvalues(root.asDiagonal() * along * root.asDiagonal());
    const double ks = largest.exceedance(supremum());
    return {jb,
            {std::exp(-jb / 2), ks, weighted_chi_squared_exceedance(of_ad, anderson_darling()),
             weighted_chi_squared_exceedance(pearson_weights(size), pearson())},
            ks <= NullDistribution::least};
  }

 private:
  ArrayXd pearson_weights(const EffectiveSampleSize& size) const {
    const Index edges = classes_.x.size();
    MatrixXd difference = MatrixXd::Zero(edges + 1, edges);
    difference.diagonal().setOnes();
    difference.diagonal(-1).setConstant(-1);
    const MatrixXd scaled = probabilities_.sqrt().inverse().matrix().asDiagonal() * difference;
    return symmetric_eigenvalues(scaled * covariance(classes_.x, size, epsilon_) * scaled.transpose());
  }

  Edges line_, classes_;
  Moments before_;
  double epsilon_, points_;
  ArrayXd weights_, probabilities_, process_;
};

}  // namespace

Moments before_rounding(const Moments& rounded, double step) {
  const double added = step * step / 12, variance = rounded.sq * rounded.sq, before = variance - added;
  Moments out = rounded;
  out.sq = before * coarsest * coarsest >= step * step ? std::sqrt(before) : NAN;
  out.ssk = rounded.ssk * std::pow(variance / before, 1.5);
  out.sku =
      (rounded.sku * variance * variance - 6 * added * variance + 4.2 * added * added) / (before * before);
  return out;
}

LagField before_rounding(const LagField& rho, const Moments& rounded, double step) {
  const double factor = std::pow(rounded.sq / before_rounding(rounded, step).sq, 2);
  return rho.mapped([factor](double r) { return std::clamp(r * factor, -1.0, 1.0); });
}

std::array<GoodnessOfFit, 4> gaussianity_of_steps(const std::vector<HeightRun>& heights,
                                                  const Moments& moments, const HeightSteps& steps,
                                                  const EffectiveSampleSize& size) {
  std::array<GoodnessOfFit, 4> out = goodness_of_fit_tests();
  const Moments before = before_rounding(moments, steps.step);
  if (!(before.sq > 0)) {
    for (GoodnessOfFit& fit : out)
      fit.statistic = fit.p = fit.naive_p = NAN, fit.why = "no value: the heights stand on steps of " +
                                                           in_digits(steps.step / moments.sq, 3) +
                                                           " Sq, more than " + shortest(coarsest);
    return out;
  }
  const Stepped stepped(edges_of(heights, before, steps), GaussianityTest::bins_for(size), before,
                        added(before, steps.step), size.points());
  const auto correlated = stepped.scores(size), naive = stepped.scores(GaussianityTest::independent(size));
  const std::array statistics{correlated.jarque_bera, stepped.supremum(), stepped.anderson_darling(),
                              stepped.pearson()};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i].statistic = statistics[i], out[i].p = correlated.p[i], out[i].naive_p = naive.p[i];
  out[1].p_is_bound = correlated.at_floor, out[1].naive_p_is_bound = naive.at_floor;
  return out;
}

}  // namespace asperity
