#include "stats/uncertainty/effective_size.hpp"

#include <numbers>
#include <utility>
#include <vector>

namespace asperity {
namespace {

// The part of S_1 and of S_2 in the tails that noise hides, times N/S_2: of a triangular correlation 0 and 7,
// of an exponential one 35 and 17.
constexpr double lost_of_first = 15, lost_of_second = 10;

// The sums (2) from one lag after the other.
class PowerSums {
 public:
  using Sums = std::array<double, EffectiveSampleSize::powers + 1>;

  // `weight` as for_each_lag gives it.
  void add(double weight, double rho) {
    double power = weight;
    for (std::size_t k = 1; k < sums_.size() && std::abs(power) > 1e-18; ++k) sums_[k] += power *= rho;
  }
  // One that is negative by noise is zero.
  Sums sums() const {
    Sums out = sums_;
    for (double& s : out) s = std::max(s, 0.0);
    return out;
  }

 private:
  Sums sums_ = {};
};

PowerSums::Sums power_sums(const LagField& rho, const Pairs& pairs) {
  PowerSums out;
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) { out.add(weight, rho(p, q)); });
  return out.sums();
}

// The share of the variance, and the modes for each independent height that is left, beyond which what a form
// took cannot be told (form_modes.hpp).
constexpr double most_taken = 0.5, most_modes = 1.0 / 3;

// z = |ρ| √pairs/√N, of a noise of S_2 = 1. Lag zero comes first, also before lags of a periodic field that
// are as certain.
double score(const WeightedLag& lag, const Pairs& pairs) {
  const bool zero = lag.p == 0 && lag.q == 0;
  return zero ? std::numeric_limits<double>::infinity()
              : std::abs(lag.rho) * std::sqrt(pairs.pair_fraction(lag.p, lag.q));
}

// As for_each_lag, of lags with their score.
template <class Visit>
void for_each_score(const LagField& rho, const Pairs& pairs, Visit visit) {
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
    const WeightedLag lag{p, q, rho(p, q), weight};
    visit(lag, score(lag, pairs));
  });
}

// Up to this z no lag is admitted: z² = 9/N 2^k, where the lags above it have an S_2 of 2^k or more.
double least_score(const LagField& rho, const Pairs& pairs) {
  constexpr int octaves = 64;
  const double n = pairs.points();
  std::vector<double> squares(octaves);  // of the lags of an octave of z²
  for_each_score(rho, pairs, [&](const WeightedLag& lag, double z) {
    const int octave = std::min(std::ilogb(z * z * n / 9), octaves - 1);
    if (octave >= 0) squares[static_cast<std::size_t>(octave)] += lag.weight * lag.rho * lag.rho;
  });
  double above = 0;
  for (int k = octaves - 1; k > 0; --k) {
    above += squares[static_cast<std::size_t>(k)];
    if (constexpr double with_round_off = 1 + 1e-6; std::ldexp(with_round_off, k) <= above)
      return 3 * std::sqrt(std::ldexp(1, k) / n);
  }
  return 3 / std::sqrt(n);
}

constexpr auto in_order = [](const WeightedLag& a, const WeightedLag& b) {
  return std::pair(a.p, a.q) < std::pair(b.p, b.q);
};

// The lags h such that h or h/2 is admitted, in order.
std::vector<WeightedLag> tail_of(const LagField& rho, const Pairs& pairs,
                                 const std::vector<WeightedLag>& admitted) {
  const Shape longest = longest_lags(pairs.grid());
  std::vector<WeightedLag> out;
  auto add = [&](Index p, Index q) {
    const bool held =
        p <= std::min(rho.max_p(), longest.nx) && std::abs(q) <= std::min(rho.max_q(), longest.ny);
    if (held) out.push_back({p, q});
  };
  for (const auto& [p, q, value, weight] : admitted) {
    add(p, q);
    for (const Index twice : {2 * p, 2 * p + 1}) {
      if (q >= 0) add(twice, 2 * q), add(twice, 2 * q + 1);
      if (q <= 0) add(twice, 2 * q - 1);
      if (q < 0) add(twice, 2 * q);
    }
  }
  std::ranges::sort(out, in_order);
  const auto same = [](const WeightedLag& a, const WeightedLag& b) { return a.p == b.p && a.q == b.q; };
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
  for (WeightedLag& lag : out) lag.rho = rho(lag.p, lag.q), lag.weight = pairs.weight(lag.p, lag.q);
  std::erase_if(out, [](const WeightedLag& lag) { return !(lag.weight > 0); });
  return out;
}

// ρ_0; a lag without pairs is NaN.
double without_noise(const LagField& all) {
  const LagField correlation = all.within({2, 2});
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
      sums_(power_sums(correlation.normalised(), pairs)),
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
  const LagField rho = estimate.normalised();
  const std::vector<WeightedLag> admitted = significant(rho, pairs), tail = tail_of(rho, pairs, admitted);
  const double n = pairs.points();
  double of_modes = 0, kept = 0, weights = 0, lags = 0, sum = 0, squares = 0;
  for (const auto& [p, q, value, weight] : tail) {
    const double b = form(p, q), of_mode = weight * b;
    of_modes += of_mode * value;
    kept += of_mode * b;
    weights += of_mode;
    sum += weight * value;
    if (p != 0 || q != 0) lags += weight / pairs.pair_fraction(p, q);
  }
  const double m = form.count() / n;
  const double taken = std::max(0.0, m * of_modes / (1 - std::min(m * kept, 0.5)));
  const double s1 = std::max(0.0, sum + taken * std::min(weights, n / 2));
  EffectiveSampleSize size(pairs, form, taken);
  size.correlated_ = without_noise(rho);
  for (const WeightedLag& lag : tail) squares += lag.weight * std::pow(size.freed(lag), 2);
  const double s2 = std::max(1.0, squares / (1 + lags / n));
  // Of few pairs, an estimate exceeds 1, and its powers all bounds.
  auto bounded = [&](const WeightedLag& lag) { return std::clamp(size.freed(lag), -1.0, 1.0); };
  PowerSums known;
  const double at_zero = bounded({.rho = 1});
  for (const WeightedLag& lag : admitted) known.add(lag.weight, bounded(lag) / at_zero);
  size.sums_ = known.sums();
  size.sums_[1] = s1 * (1 + lost_of_first * (s2 / n));
  size.sums_[2] = s2 * (1 + lost_of_second * (s2 / n));
  size.taken_ = std::min(taken * (1 + lost_of_first * (s2 / n)), most_taken);
  size.form_leaves_enough_ =
      form.degree() == 0 || (size.taken_ < most_taken && form.count() <= most_modes * size.effective(2));
  size.degrees_ = size.effective(2) / 8;
  return size;
}

LagField EffectiveSampleSize::freed(const LagField& rho) const {
  return LagField::of(rho.max_lag(), [&](Index p, Index q) { return freed({p, q, rho(p, q)}); });
}

double EffectiveSampleSize::freed(const WeightedLag& lag) const {
  const double b = taken_ / (1 - taken_);
  return (lag.rho + b * form_(lag.p, lag.q)) / (1 + b);
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

std::vector<WeightedLag> significant(const LagField& rho, const Pairs& pairs) {
  const double least = least_score(rho, pairs), n = pairs.points();
  std::vector<WeightedLag> lags;
  for_each_score(rho, pairs, [&](const WeightedLag& lag, double z) {
    if (z > least) lags.push_back(lag);
  });
  std::ranges::stable_sort(lags, std::greater(), [&](const WeightedLag& lag) { return score(lag, pairs); });
  // Lags of one score, such as (0,q) and (0,-q), come in together: of the transpose they are a single one.
  constexpr double round_off = 1e-9;
  double sum_of_squares = 0;
  auto end = lags.begin();
  while (end != lags.end() && score(*end, pairs) > 3 * std::sqrt(sum_of_squares / n))
    for (const double z = (1 - round_off) * score(*end, pairs); end != lags.end() && score(*end, pairs) >= z;
         ++end)
      sum_of_squares += end->weight * end->rho * end->rho;
  lags.erase(end, lags.end());
  std::ranges::sort(lags, in_order);
  return lags;
}

LagField significant_lags(const LagField& estimate, const Pairs& pairs) {
  const LagField rho = estimate.normalised();
  Field admitted = Field::Zero(rho.max_p() + 1, 2 * rho.max_q() + 1);
  for (const auto& [p, q, value, weight] : significant(rho, pairs)) admitted(p, rho.max_q() + q) = value;
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
