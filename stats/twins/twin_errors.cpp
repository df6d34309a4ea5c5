#include "stats/twins/twin_errors.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "core/parallel.hpp"

namespace asperity {
namespace {

// What the field was prepared with, as far as it takes heights away from a twin: of a sphere or a cylinder,
// the polynomial that takes as much. Filters would act twice: the twin's correlation is that of the filtered
// field.
Preparation repeated(const Preparation& preparation, const Sample& sample) {
  return {.form = {.degree = preparation.filters() ? 0 : sample.surface().degree}};
}

// The factor that gives twins the rms height of the field, after their form is removed.
double scale_of(const TwinFields& twins, const Sample& sample, const MeasureOptions& asked, Index count) {
  double square = 0;
  for (Index k = 0; k < count; ++k) {
    const Field z = remove_form(twins.heights(k), repeated(asked.preparation, sample).form.degree);
    square += z.isNaN().select(0, z).square().sum() / sample.size().points();
  }
  return sample.moments().sq / std::sqrt(square / static_cast<double>(count));
}

// Of heights of the whole field, which the form has lowered together.
bool is_height(Group group) {
  return group == Group::height || group == Group::quantiles || group == Group::material;
}

bool is_angle(const Parameter& p) { return p.unit == "rad"; }

// √(-½ ln |mean exp(2iθ)|), the standard deviation of axes if it is small, and large without a preferred one:
// K. V. Mardia, P. E. Jupp, Directional statistics, Wiley (2000), section 2.3.
double axial_spread(const std::vector<double>& angles) {
  std::complex<double> sum = 0;
  for (const double angle : angles) sum += std::polar(1.0, 2 * angle);
  return 0.5 * std::sqrt(-2 * std::log(std::min(1.0, std::abs(sum) / static_cast<double>(angles.size()))));
}

struct Spread {
  double mean = 0, deviation = 0;
};
Spread spread_of(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / (n - 1))};
}

bool differs(const Parameter& p) {
  constexpr const char* names[] = {"Sd", "m2_", "m4_", "alpha_", "summit_", "nayak_", "peak_", "Pdq", "Rdq"};
  return std::ranges::any_of(names, [&](const char* name) { return p.name.starts_with(name); });
}

}  // namespace

TwinScope::TwinScope(const Sample& sample)
    : known_(!sample.basis().estimated),
      complete_(sample.basis().pairs.complete()),
      given_(sample.surface().distribution),
      gaussian_(!sample.distribution()),
      stepped_(!doubt_of_steps(sample).empty()) {}

bool TwinScope::holds(const Parameter& p) const {
  if (p.name.starts_with("N") || p.name.starts_with("profiles")) return false;
  if (stepped_ && differs(p) && !p.why.empty()) return false;
  if (differs(p)) return known_ || (complete_ && gaussian_);
  const bool extreme = p.name == "Sp" || p.name == "Sv" || p.name == "Sz";
  return gaussian_ || given_ || !extreme;
}

bool TwinScope::needs_none(const Parameter& p) const {
  return std::isfinite(p.standard_error) || !p.why.empty();
}

namespace {

// Twins, measured as the sample was.
class TwinMeasures {
 public:
  TwinMeasures(const Sample& sample, const MeasureOptions& asked, const TwinOptions& options, TwinWaves waves)
      : sample_(sample),
        asked_(asked),
        fields_(sample, waves, options.seed),
        basis_{fields_.correlation(), false, sample.basis().pairs},
        size_(basis_.size()),
        scale_(scale_of(fields_, sample, asked, std::min<Index>(options.twins, 20))) {
    asked_.threads = 1;
  }

  // Nothing of a twin without parameters: all its heights may be the same if those of the field hardly vary.
  std::map<Group, Parameters> of(Index k) const try {
    Surface twin{.grid = sample_.grid(), .heights = scale_ * fields_.heights(k)};
    twin.variable = sample_.surface().variable, twin.units = sample_.surface().units;
    const Sample of(prepared(std::move(twin), repeated(asked_.preparation, sample_)), basis_, size_);
    std::map<Group, Parameters> out;
    for (const Group group : asked_.groups) out[group] = measure(of, group, asked_);
    return out;
  } catch (const DataError&) {
    return {};
  }
  const LagField& correlation() const { return fields_.correlation(); }
  /// Of the logarithm of heights, by the form.
  double scale_bias() const { return std::log(sample_.moments().sq / scale_); }

 private:
  const Sample& sample_;
  MeasureOptions asked_;
  TwinFields fields_;
  ErrorBasis basis_;
  EffectiveSampleSize size_;
  double scale_;
};

MeasureOptions of_groups(MeasureOptions asked, std::initializer_list<Group> kept, bool without) {
  std::erase_if(asked.groups, [&](Group g) { return (std::ranges::find(kept, g) != kept.end()) == without; });
  return asked;
}

}  // namespace

TwinErrors::TwinErrors(const Sample& sample, const MeasureOptions& asked, const TwinOptions& options) {
  const bool known = !sample.basis().estimated;
  const MeasureOptions of_all = known ? of_groups(asked, {Group::gaussianity}, true)
                                      : of_groups(asked, {Group::gaussianity, Group::hybrid}, true),
                       of_short = of_groups(asked, {Group::hybrid, Group::profiles}, false);
  std::optional<TwinMeasures> all, short_ones;
  if (!of_all.groups.empty()) all.emplace(sample, of_all, options, TwinWaves::all);
  if (!known && !of_short.groups.empty() && sample.basis().pairs.complete())
    short_ones.emplace(sample, of_short, options, TwinWaves::short_ones);
  auto add = [&](const std::map<Group, Parameters>& twin, bool of_short_waves) {
    for (const auto& [group, parameters] : twin)
      for (const Parameter& p : parameters) {
        if (!std::isfinite(p.value) || (!known && differs(p) != of_short_waves && group != Group::hybrid))
          continue;
        values_[p.name].push_back(p.value);
        if (p.unit == sample.surface().units && is_height(group)) heights_.insert(p.name);
      }
  };
  while (twins_ < options.twins) {
    const Index count = std::min<Index>(std::max(1, options.threads), options.twins - twins_);
    std::vector<std::map<Group, Parameters>> long_waves(static_cast<std::size_t>(count)),
        short_waves = long_waves;
    parallel_ranges(count, options.threads, [&](Index begin, Index end, int) {
      for (Index k = begin; k < end; ++k) {
        if (all) long_waves[static_cast<std::size_t>(k)] = all->of(twins_ + k);
        if (short_ones) short_waves[static_cast<std::size_t>(k)] = short_ones->of(twins_ + k);
      }
    });
    for (std::size_t k = 0; k < long_waves.size(); ++k) add(long_waves[k], false), add(short_waves[k], true);
    twins_ += count;
    if (options.each) options.each(twins_);
  }
  const double of_spread = 1 / static_cast<double>(std::max<Index>(twins_ - 1, 1));
  quantile_ = gsl_cdf_tdist_Pinv(0.975, 1 / (of_spread + 1 / sample.size().degrees()));
  if (!all) return;
  scale_bias_ = all->scale_bias();
  set_truths(central_lobe(all->correlation(), sample.grid(), asked.sal_level));
}

void TwinErrors::set_truths(const CentralLobe& lobe) {
  truths_["mean"] = 0;
  if (lobe.r_min) truths_["Sal"] = lobe.r_min->length;
  if (lobe.r_max) truths_["slowest_decay"] = lobe.r_max->length;
  if (const auto ratio = lobe.aspect_ratio()) truths_["Str"] = *ratio;
  if (lobe.ellipse) truths_["gamma"] = lobe.ellipse->gamma();
}

std::optional<TwinErrors::Law> TwinErrors::law_of(const Parameter& p) const {
  const auto found = values_.find(p.name);
  if (found == values_.end() || !std::isfinite(p.value)) return std::nullopt;
  std::vector<double> values = found->second;
  if (static_cast<double>(values.size()) < std::max(10.0, 0.8 * static_cast<double>(twins_)))
    return std::nullopt;
  if (is_angle(p)) {
    const double spread = axial_spread(values);
    if (!(spread > 0)) return std::nullopt;
    if (quantile_ * spread >= std::numbers::pi / 2)
      return Law{std::numeric_limits<double>::quiet_NaN(), {}, "no direction is preferred"};
    return Law{spread, Interval::about(p.value, quantile_ * spread)};
  }
  if (p.value == 0) return std::nullopt;  // as a slope along ridges, which no twin has
  const auto truth = truths_.find(p.name);
  const bool positive = p.value > 0 && std::ranges::all_of(values, [](double t) { return t > 0; });
  const double error = spread_of(values).deviation;
  constexpr double rounding = 1e-9;
  if (!(error > rounding * std::abs(p.value))) return std::nullopt;  // it does not vary
  if (!positive) {
    const double bias = truth == truths_.end() ? 0 : spread_of(values).mean - truth->second;
    const double centre = p.value - bias, half = quantile_ * error;
    const bool signless = p.value > 0 && std::ranges::all_of(values, [](double t) { return t >= 0; });
    return Law{error,
               Interval::of(p.value, signless ? std::max(centre - half, 0.0) : centre - half, centre + half)};
  }
  for (double& t : values) t = std::log(t);
  const auto [mean, deviation] = spread_of(values);
  const double bias = truth != truths_.end()      ? mean - std::log(truth->second)
                      : heights_.contains(p.name) ? scale_bias_
                                                  : 0,
               centre = std::log(p.value) - bias;
  double low = std::exp(centre - quantile_ * deviation), high = std::exp(centre + quantile_ * deviation);
  if (p.name == "Str" || p.name.starts_with("Smr")) high = std::min(high, 1.0);
  if (p.name == "gamma") low = std::max(low, 1.0);
  return Law{error, Interval::of(p.value, low, high)};
}

void TwinErrors::apply(Parameters& parameters, const std::function<bool(const Parameter&)>& wanted) const {
  for (Parameter& p : parameters)
    if (wanted(p))
      if (const auto law = law_of(p)) {
        p.standard_error = law->error;
        p.interval = law->interval;
        p.why = law->why;
        if (law->why.empty()) p.source = std::to_string(twins_) + " twins";
      }
}

namespace {

// In seconds of one core, about, so that the answer does not depend on the machine.
double seconds_of_twins(const Grid& grid, const MeasureOptions& asked) {
  double seconds = 0;  // for 512x512 points
  for (const Group group : asked.groups)
    seconds += group == Group::gaussianity                           ? 0
               : group == Group::height || group == Group::quantiles ? 0.8
                                                                     : 2.4;
  return seconds * static_cast<double>(grid.shape.cells()) / (512 * 512);
}

}  // namespace

bool twins_are_quick(const Grid& grid, const MeasureOptions& asked) {
  constexpr double quick = 2.5;
  return seconds_of_twins(grid, asked) <= quick;
}

bool errors_by_twins(const Sample& sample, const MeasureOptions& asked, TwinUse use,
                     const TwinOptions& options, Parameters& parameters) {
  const TwinScope scope(sample);
  auto wanted = [&](const Parameter& p) {
    const bool of_waves_taken = p.name == "mean" && asked.preparation.longer.given();
    return scope.holds(p) && !of_waves_taken && (use == TwinUse::everywhere || !scope.needs_none(p));
  };
  if (!sample.size().gives_errors() || std::ranges::none_of(parameters, wanted)) return true;
  if (use == TwinUse::where_quick && !twins_are_quick(sample.grid(), asked)) return false;
  TwinErrors(sample, asked, options).apply(parameters, wanted);
  return true;
}

}  // namespace asperity
