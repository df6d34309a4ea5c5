// Moments, quantiles, tests of Gaussianity, the material ratio.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/words.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/measure/groups.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "stats/sample/quantiles.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {
namespace {

// ---- moments ----

struct Heights {
  const Sample& sample;
  MomentErrors error = {};
  MomentIntervals interval = {};
  std::string of_mean = {}, of_extremes = {};  // why they have no error; "" where they may have one

  const Moments& m() const { return sample.moments(); }
};

template <auto value, auto error, auto interval>
Estimate moment(const Heights& h) {
  return {h.m().*value, h.error.*error, h.interval.*interval};
}
template <auto value>
Estimate extreme(const Heights& h) {
  return {.value = h.m().*value, .why = h.of_extremes};
}

// The kurtosis of any distribution is 1 at least.
template <>
Estimate moment<&Moments::sku, &MomentErrors::sku, &MomentIntervals::sku>(const Heights& h) {
  Interval ends = h.interval.sku;
  ends.low = std::max(ends.low, std::min(h.m().sku, 1.0));
  return {h.m().sku, h.error.sku, ends};
}

constexpr Definition<Heights> height_table[] = {
    {"mean", of_field, "mean height, from which the heights below are measured",
     [](const Heights& h) {
       const double level = h.sample.surface().level;
       if (!h.of_mean.empty()) return Estimate{.value = level, .why = h.of_mean};
       const auto& [low, high, why] = h.interval.mean;
       return Estimate{level, h.error.mean, Interval::about(level, (high - low) / 2)};
     }},
    {"Sa", of_field, "arithmetic mean height", moment<&Moments::sa, &MomentErrors::sa, &MomentIntervals::sa>},
    {"Sq", of_field, "root mean square height",
     moment<&Moments::sq, &MomentErrors::sq, &MomentIntervals::sq>},
    {"Ssk", "1", "skewness, 0 for a Gaussian",
     moment<&Moments::ssk, &MomentErrors::ssk, &MomentIntervals::ssk>},
    {"Sku", "1", "kurtosis, 3 for a Gaussian",
     moment<&Moments::sku, &MomentErrors::sku, &MomentIntervals::sku>},
    {"Sp", of_field, "maximum peak height of the whole field", extreme<&Moments::sp>},
    {"Sv", of_field, "maximum pit depth of the whole field", extreme<&Moments::sv>},
    {"Sz", of_field, "maximum height Sp + Sv",
     [](const Heights& h) { return Estimate{.value = h.m().sz(), .why = h.of_extremes}; }},
    {"N", "1", "number of points", [](const Heights& h) { return Estimate{h.sample.size().points()}; }}};

// For the distribution that the field was drawn with or evidently has; none for a Gaussian's.
std::optional<TranslationErrors> translation_errors(const Sample& sample) {
  const auto heights = sample.distribution();
  if (!heights) return std::nullopt;
  const LagField rho = underlying_correlation(sample.basis().correlation, CorrelationMap(*heights));
  return TranslationErrors(*heights, sample.basis().size(rho));
}

// From the field's own long waves, whatever its heights.
Heights by_long_waves(const Sample& sample, const HeightErrors& errors) {
  const Moments& m = sample.moments();
  const double t = student_quantile(0.025, errors.degrees());
  Heights out{sample};
  out.error = {.mean = errors.of_mean(),
               .sa = errors([](const Moments& of) { return of.sa; }),
               .sq = errors([](const Moments& of) { return of.sq; }),
               .ssk = errors([](const Moments& of) { return of.ssk; }),
               .sku = errors([](const Moments& of) { return of.sku; })};
  // Heavy tails, of which the field may have few heights, are in the distribution that it evidently has.
  if (const auto theory = translation_errors(sample)) {
    const MomentErrors of_tails = theory->standard_errors(m.sq);
    out.error.ssk = std::max(out.error.ssk, of_tails.ssk);
    out.error.sku = std::max(out.error.sku, of_tails.sku);
  }
  const double taken = errors.taken(), left = std::sqrt(1 - taken),
               of_taken = taken / std::sqrt(2 * errors.degrees_of_mean());
  auto of_scale = [&](double value, double error) {
    const double width = t * std::hypot(error / value, of_taken);
    return Interval::of(value, std::min(value, value / left * std::exp(-width)),
                        value / left * std::exp(width));
  };
  const double t_of_mean = student_quantile(0.025, errors.degrees_of_mean());
  out.interval = {.mean = Interval::about(m.mean, t_of_mean * out.error.mean),
                  .sa = of_scale(m.sa, out.error.sa),
                  .sq = of_scale(m.sq, out.error.sq),
                  .ssk = Interval::about(m.ssk, t * out.error.ssk),
                  .sku = Interval::of_inverse(m.sku, t * out.error.sku / m.sku)};
  return out;
}

// For Gaussian heights, or for the distribution that the field was drawn with or evidently has.
Heights heights_of(const Sample& sample) {
  const Moments& m = sample.moments();
  const EffectiveSampleSize& size = sample.size();
  if (!sample.correlation_gives_errors())
    if (const auto& errors = sample.height_errors()) return by_long_waves(sample, *errors);
  const auto errors = translation_errors(sample);
  if (!errors) return {sample, standard_errors(m, size), confidence_intervals(m, size)};
  return {sample, errors->standard_errors(m.sq), confidence_intervals(m, *errors, size)};
}

// ---- effective sample sizes ----

// Why size k of an estimated correlation has no error; "" where it may have one.
std::string why_no_error(const Sample& sample, int k) {
  if (!sample.basis().estimated) return "";
  if (const std::string few = too_few(sample.size()); !few.empty())
    return "no standard error can be given: " + few;
  if (k == 1) return "no standard error: it rests on lags at which noise hides the correlation";
  if (constexpr double lay = 0.05; k == 2 && sample.extent().negative > lay)
    return "no standard error: the correlation is negative at many lags";
  return "";
}

void add_sizes(ParameterList& out, const Sample& sample) {
  constexpr std::array names{"N_eff_mean", "N_eff", "N_eff_Ssk", "N_eff_Sku"},
      of{"the mean", "Sq", "Ssk", "Sku"};
  const EffectiveSampleSize& size = sample.size();
  const auto errors = sample.size_errors();
  for (int k = 1; k <= 4; ++k) {
    const auto i = static_cast<std::size_t>(k - 1);
    const double value = size.effective(k);
    Estimate estimate{std::isfinite(value) ? value : unknown};
    std::string why = why_no_error(sample, k);
    const double half = 0.5 * size.points();  // beyond it the sum rests on hardly any lag
    if (errors && why.empty() && value < half) estimate = {value, (*errors)(k), errors->interval(k)};
    if (why.empty() && !(value < half)) why = "no standard error: neighbours are hardly correlated";
    out.add(
        names[i], "1", "effective sample size for {}", estimate,
        {.meaning = of[i], .why = "no value: the estimated correlation sums to zero", .why_no_error = why});
  }
}

// ---- the material ratio ----

struct Material {
  MaterialRatioCurve curve;
  CoreParameters core;
  VolumeParameters volumes;
};

template <auto member>
Estimate core(const Material& of) {
  return {of.core.*member};
}
template <auto member>
Estimate volume(const Material& of) {
  return {of.volumes.*member};
}

constexpr Definition<Material> core_table[] = {
    {"Sk", of_field, "core height", core<&CoreParameters::sk>},
    {"Spk", of_field, "reduced peak height", core<&CoreParameters::spk>},
    {"Svk", of_field, "reduced dale height", core<&CoreParameters::svk>},
    {"Smr1", "1", "material ratio where the core begins", core<&CoreParameters::smr1>},
    {"Smr2", "1", "material ratio where the core ends", core<&CoreParameters::smr2>}};

constexpr Definition<Material> volume_table[] = {
    {"Vmp", of_field, "peak material volume per area", volume<&VolumeParameters::vmp>},
    {"Vmc", of_field, "core material volume per area", volume<&VolumeParameters::vmc>},
    {"Vvc", of_field, "core void volume per area", volume<&VolumeParameters::vvc>},
    {"Vvv", of_field, "dale void volume per area", volume<&VolumeParameters::vvv>}};

// ---- tests ----

template <auto value, auto bound>
Estimate p_value(const GoodnessOfFit& fit) {
  return {.value = fit.*value, .is_bound = fit.*bound};
}

constexpr Definition<GoodnessOfFit> test_table[] = {
    {"{}", "1", "{}, statistic", value_of<&GoodnessOfFit::statistic>},
    {"{}_p", "1", "{}, p-value for a Gaussian field of this correlation",
     p_value<&GoodnessOfFit::p, &GoodnessOfFit::p_is_bound>},
    {"{}_naive_p", "1", "{}, p-value if the heights were independent, for comparison",
     p_value<&GoodnessOfFit::naive_p, &GoodnessOfFit::naive_p_is_bound>}};

}  // namespace

std::string height_symbols() { return symbols_of(height_table); }
std::string material_symbols() { return symbols_of(core_table) + ", " + symbols_of(volume_table); }

Parameters height_parameters(const Sample& sample, const MeasureOptions& options) {
  ParameterList out(sample.surface().units);
  Heights heights = heights_of(sample);
  if (options.preparation.longer.given())
    heights.of_mean = "no standard error: the L-filter has taken the long waves that it rests on";
  if (sample.size().gives_errors() && !sample.surface().distribution && sample.distribution())
    heights.of_extremes =
        "no standard error: the extremes of heights that are not Gaussian rest on tails of which the field "
        "has few heights";
  out.add(height_table, heights);
  add_sizes(out, sample);
  if (!sample.basis().pairs.complete())
    out.add("N_missing", "1", "number of missing points, left out of all parameters",
            {static_cast<double>(sample.grid().shape.cells()) - sample.size().points()});
  return std::move(out).with_known_errors(sample.size());
}

namespace {

constexpr const char* equal_heights = "no standard error: too many heights are equal";

}  // namespace

Parameters quantiles(const Sample& sample, const MeasureOptions& options) {
  const std::vector<double>& shares = options.quantiles;
  const std::vector<double> heights = sample.quantiles(shares);
  const std::vector<Estimate> estimates = quantile_estimates(sample, shares, heights);
  ParameterList out(sample.surface().units);
  for (std::size_t i = 0; i < shares.size(); ++i)
    out.add("quantile_{}", of_field, "height below which this share of the surface lies", estimates[i],
            {.symbol = shortest(shares[i]), .why_no_error = equal_heights});
  return std::move(out).with_known_errors(sample.size());
}

Parameters gaussianity(const Sample& sample, const MeasureOptions&) {
  constexpr std::array symbols{"JB", "KS", "A2", "chi2"};
  auto fits = sample.goodness_of_fit();
  ParameterList out(sample.surface().units);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!sample.size().gives_errors()) {
      fits[i].p = unknown, fits[i].p_is_bound = false;
      if (fits[i].why.empty()) fits[i].why = "no p-value can be given: " + too_few(sample.size());
    }
    out.add(test_table, fits[i], {symbols[i], std::string(fits[i].test), fits[i].why});
  }
  return std::move(out).all();
}

Parameters material_parameters(const Sample& sample, const MeasureOptions& options) {
  const auto [p, q] = options.material_ratios;
  const MaterialRatioCurve curve = sample.material_ratio();
  const Material of{curve, curve.core(), curve.volumes(p, q)};
  ParameterList out(sample.surface().units);
  out.add(core_table, of);
  const std::vector<Estimate> inverse =
      quantile_estimates(sample, {1 - p, 1 - q}, {curve.height(p), curve.height(q)});
  out.add("Smc_p", of_field, "inverse material ratio at {}", inverse[0],
          {.meaning = shortest(p), .why_no_error = equal_heights});
  out.add("Smc_q", of_field, "inverse material ratio at {}", inverse[1],
          {.meaning = shortest(q), .why_no_error = equal_heights});
  out.add(volume_table, of);
  return std::move(out).with_known_errors(sample.size());
}

}  // namespace asperity
