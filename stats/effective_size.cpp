#include "stats/effective_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

// A lag of an estimate: weight as for_each_lag gives it, evidence = |ρ| √pairs/√N.
struct Candidate {
  Index p, q;
  double rho, weight, evidence;
};

constexpr auto weaker = [](const Candidate& a, const Candidate& b) { return a.evidence < b.evidence; };

// The lags that may be admitted, as a heap: S_2 ≥ 1 bounds what is asked of them from below.
std::vector<Candidate> candidates(const LagField& rho, const Pairs& pairs) {
  const double least = 3 / std::sqrt(pairs.points());
  std::vector<Candidate> lags;
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
    const double value = rho(p, q);
    const double evidence = std::abs(value) * std::sqrt(pairs.share(p, q));
    if (evidence > least) lags.push_back({p, q, value, weight, evidence});
  });
  std::ranges::make_heap(lags, weaker);
  return lags;
}

// S_1 over twice the admitted reach, the field's mean put back.
double sum_of_tail(const LagField& rho, const LagField& admitted, const Pairs& pairs) {
  double sum = 0, lags = 0;
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
    if (admitted(p / 2, q / 2) == 0) return;
    sum += weight * rho(p, q);
    lags += weight;
  });
  return std::max(0.0, sum / (1 - std::min(lags / pairs.points(), 0.5)));
}

}  // namespace

EffectiveSize::EffectiveSize(const LagField& correlation, const Pairs& pairs) : points_(pairs.points()) {
  const LagField rho = correlation.normalised();
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
    const double value = rho(p, q);
    double power = weight;
    for (std::size_t k = 1; k <= powers && std::abs(power) > 1e-18; ++k) sums_[k] += power *= value;
  });
  for (double& s : sums_) s = std::max(s, 0.0);
}

EffectiveSize EffectiveSize::of_estimate(const LagField& estimate, const Pairs& pairs) {
  const LagField admitted = significant_lags(estimate, pairs);
  EffectiveSize size(admitted, pairs);
  size.sums_[1] = sum_of_tail(estimate.normalised(), admitted, pairs);
  return size;
}

double EffectiveSize::variance_of_mean(const std::function<double(int)>& weight, double total) const {
  double variance = 0, rest = total;
  for (int k = 1; k <= powers; ++k) {
    const double w = weight(k);
    variance += w * sum(k);
    rest -= w;
  }
  return (variance + std::max(rest, 0.0) * sum(powers)) / points_;
}

LagField significant_lags(const LagField& estimate, const Pairs& pairs) {
  const LagField rho = estimate.normalised();
  const double n = pairs.points();
  Field admitted = Field::Zero(rho.max_p() + 1, 2 * rho.max_q() + 1);
  double sum_of_squares = 0;
  std::vector<Candidate> heap = candidates(rho, pairs);
  for (; !heap.empty(); heap.pop_back()) {
    std::ranges::pop_heap(heap, weaker);
    const Candidate& lag = heap.back();
    if (lag.evidence <= 3 * std::sqrt(sum_of_squares / n)) break;
    sum_of_squares += lag.weight * lag.rho * lag.rho;
    admitted(lag.p, rho.max_q() + lag.q) = lag.rho;
  }
  return LagField(std::move(admitted));
}

MomentErrors standard_errors(const Moments& moments, const EffectiveSize& size) {
  // (5), each weight from the one before.
  double w = 0;
  auto of_absolute = [&w](int k) {
    if (k % 2 == 1) return 0.0;
    const double m = k / 2 - 1;
    w = k == 2 ? std::numbers::inv_pi : w * (2 * m - 1) * (2 * m - 1) / ((2 * m + 1) * (2 * m + 2));
    return w;
  };
  const double n = size.points(), sigma = moments.sq;
  return {.mean = sigma * std::sqrt(size.sum(1) / n),
          .sa = sigma * std::sqrt(size.variance_of_mean(of_absolute, 1 - 2 * std::numbers::inv_pi)),
          .sq = sigma * std::sqrt(size.sum(2) / (2 * n)),
          .ssk = std::sqrt(6 * size.sum(3) / n),
          .sku = std::sqrt(24 * size.sum(4) / n)};
}

}  // namespace asperity
