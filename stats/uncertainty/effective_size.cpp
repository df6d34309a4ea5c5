#include "stats/uncertainty/effective_size.hpp"

#include <numbers>
#include <vector>

namespace asperity {
namespace {

// The part of S_1 and of S_2 in the tails that noise hides, times N/S_2: of a triangular correlation 0 and 7,
// of an exponential one 35 and 17.
constexpr double lost_of_first = 15, lost_of_second = 10;

// The share of the variance, and the modes for each independent height that is left, beyond which what a form
// took cannot be told (form_modes.hpp).
constexpr double most_taken = 0.5, most_modes = 1.0 / 3;

// A lag of an estimate: weight as for_each_lag gives it, z_score = |ρ| √pairs/√N, of a noise of S_2 = 1.
struct Candidate {
  Index p, q;
  double rho, weight, z_score;
};

constexpr auto weaker = [](const Candidate& a, const Candidate& b) { return a.z_score < b.z_score; };

// The lags that may be admitted, as a heap: S_2 ≥ 1 bounds what is asked of them from below. Lag zero comes
// first, also before lags of a periodic field that are as certain.
std::vector<Candidate> candidates(const LagField& rho, const Pairs& pairs) {
  const double least = 3 / std::sqrt(pairs.points());
  std::vector<Candidate> lags;
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
    const double value = rho(p, q);
    const bool zero = p == 0 && q == 0;
    const double z_score = zero ? std::numeric_limits<double>::infinity()
                                : std::abs(value) * std::sqrt(pairs.pair_fraction(p, q));
    if (z_score > least) lags.push_back({p, q, value, weight, z_score});
  });
  std::ranges::make_heap(lags, weaker);
  return lags;
}

// ρ_0; a lag without pairs is NaN.
double without_noise(const LagField& correlation) {
  auto at = [&](Index p, Index q) {
    const bool held = p <= correlation.max_p() && q <= correlation.max_q();
    return held ? correlation(p, q) / correlation(0, 0) : 0;
  };
  const double most = std::fmax(2 * at(1, 0) - at(2, 0), 2 * at(0, 1) - at(0, 2));
  return std::isnan(most) ? 1 : std::clamp(most, 0.1, 1.0);
}

}  // namespace

EffectiveSampleSize::EffectiveSampleSize(const LagField& correlation, const Pairs& pairs,
                                         const FormModes& form)
    : points_(pairs.points()),
      form_(form),
      correlated_(without_noise(correlation)),
      sums_(CorrelationAlgebra(correlation, pairs).power_sums()),
      taken_(mean_power(1)) {
  if (form.degree() > 0) {
    const LagField rho = correlation.normalised().within(longest_lags(pairs.grid())),
                   modes = form.correlation(rho.max_lag());
    taken_ = 0;
    for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
      taken_ += form.count() / points_ * weight * modes(p, q) * rho(p, q);
    });
  }
  form_leaves_enough_ = form.degree() == 0 || taken_ < most_taken;
  taken_ = std::clamp(taken_, 0.0, most_taken);
}

EffectiveSampleSize EffectiveSampleSize::of_estimate(const LagField& estimate, const Pairs& pairs,
                                                     const FormModes& form) {
  const LagField rho = estimate.normalised(), admitted = significant_lags(rho, pairs);
  const auto [p_end, q_end] = admitted.reach();
  const LagField tail = rho.within({2 * p_end + 1, 2 * q_end + 1});
  auto for_each = [&](auto visit) {
    for_each_lag(tail, pairs, [&](Index p, Index q, double weight) {
      const bool held = p <= admitted.max_p() && std::abs(q) <= admitted.max_q();
      if (admitted(p / 2, q / 2) != 0 || (held && admitted(p, q) != 0)) visit(p, q, weight);
    });
  };
  const double n = pairs.points();
  const LagField modes = form.correlation(rho.max_lag());
  double of_modes = 0, kept = 0, weights = 0, lags = 0, sum = 0, squares = 0;
  for_each([&](Index p, Index q, double weight) {
    const double b = modes(p, q), of_mode = weight * b;
    of_modes += of_mode * tail(p, q);
    kept += of_mode * b;
    weights += of_mode;
    sum += weight * tail(p, q);
    if (p != 0 || q != 0) lags += weight / pairs.pair_fraction(p, q);
  });
  const double m = form.count() / n;
  const double taken = std::max(0.0, m * of_modes / (1 - std::min(m * kept, 0.5)));
  const double s1 = std::max(0.0, sum + taken * std::min(weights, n / 2));
  EffectiveSampleSize size(pairs, form, taken);
  size.correlated_ = without_noise(rho);
  const LagField freed = size.freed(rho);
  for_each([&](Index p, Index q, double weight) { squares += weight * std::pow(freed(p, q), 2); });
  const double s2 = std::max(1.0, squares / (1 + lags / n));
  // Of few pairs, an estimate exceeds 1, and its powers all bounds.
  const Field bounded = freed.half_plane().min(1).max(-1);
  const LagField known((admitted.half_plane() != 0).select(bounded, 0));
  size.sums_ = CorrelationAlgebra(known, pairs).power_sums();
  size.sums_[1] = s1 * (1 + lost_of_first * (s2 / n));
  size.sums_[2] = s2 * (1 + lost_of_second * (s2 / n));
  size.taken_ = std::min(taken * (1 + lost_of_first * (s2 / n)), most_taken);
  size.form_leaves_enough_ =
      form.degree() == 0 || (size.taken_ < most_taken && form.count() <= most_modes * size.effective(2));
  size.degrees_ = size.effective(2) / 8;
  return size;
}

LagField EffectiveSampleSize::freed(const LagField& rho) const {
  const double b = taken_ / (1 - taken_);
  return LagField((rho.half_plane() + b * form_.correlation(rho.max_lag()).half_plane()) / (1 + b));
}

double EffectiveSampleSize::variance_of_mean(const std::function<double(int)>& weight, double total) const {
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
    if (lag.z_score <= 3 * std::sqrt(sum_of_squares / n)) break;
    sum_of_squares += lag.weight * lag.rho * lag.rho;
    admitted(lag.p, rho.max_q() + lag.q) = lag.rho;
  }
  return LagField(std::move(admitted));
}

MomentErrors standard_errors(const Moments& moments, const EffectiveSampleSize& size) {
  // (5), each weight from the one before.
  double w = 0;
  auto of_absolute = [&w](int k) {
    if (k % 2 == 1) return 0.0;
    const double m = 0.5 * k - 1;
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
