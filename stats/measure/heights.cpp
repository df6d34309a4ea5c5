// Moments, quantiles, tests of Gaussianity, the material ratio.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/words.hpp"
#include "stats/height/extreme_error.hpp"
#include "stats/height/material_error.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/measure/groups.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {
namespace {

// ---- moments ----

// Why what rests on the tails of the heights has no error; "" where it may have one.
std::string too_few_patches(const Sample& sample, double least) {
  if (!sample.size().gives_errors()) return "no standard error can be given: " + too_few(sample.size());
  const double patches = sample.extent().patches;
  if (patches >= least) return "";
  return "no standard error: there are " + rounded(patches) + " independent patches, fewer than " +
         shortest(least);
}

// Of a length, which the form has lowered.
Interval freed_of_form(const Sample& sample, double value, const WaveError& of) {
  const double width = WaveError{std::hypot(of.error / value, 0.5 * sample.error_of_taken()), of.degrees}
                           .half_width(),
               freed = value / std::sqrt(1 - sample.taken_by_form());
  return Interval::of(value, std::min(value, freed * std::exp(-width)),
                      std::max(value, freed * std::exp(width)));
}

struct Heights {
  const Sample& sample;
  MomentErrors error = {};
  MomentIntervals interval = {};
  std::string of_mean = {};  // why it has no error; "" where it may have one
  Estimate sp = {unknown}, sv = {unknown};

  const Moments& m() const { return sample.moments(); }
};

template <auto value, auto error, auto interval>
Estimate moment(const Heights& h) {
  return {h.m().*value, h.error.*error, h.interval.*interval};
}

// Summits and pits are independent.
Estimate sum_of_extremes(const Heights& h) {
  const double value = h.m().sz();
  Estimate out{.value = value,
               .standard_error = std::hypot(h.sp.standard_error, h.sv.standard_error),
               .why = h.sp.why.empty() ? h.sv.why : h.sp.why};
  if (!h.sp.interval || !h.sv.interval) return out;
  const Interval &p = *h.sp.interval, &v = *h.sv.interval;
  out.interval = Interval::of(value, value - std::hypot(h.sp.value - p.low, h.sv.value - v.low),
                              value + std::hypot(p.high - h.sp.value, v.high - h.sv.value));
  return out;
}

// The kurtosis of any distribution is 1 at least. That of heavy tails is decided by a few heights, of which
// the field's own waves tell little.
template <>
Estimate moment<&Moments::sku, &MomentErrors::sku, &MomentIntervals::sku>(const Heights& h) {
  constexpr double heavy = 4;
  const double value = h.m().sku;
  Interval ends = h.interval.sku;
  ends.low = std::max(ends.low, std::min(value, 1.0));
  const bool rough = value > heavy && std::isfinite(h.error.sku) && !h.sample.correlation_gives_errors();
  return {value, h.error.sku, ends, rough ? "its error is rough, as few heights decide it" : ""};
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
    {"Sp", of_field, "maximum peak height of the whole field", [](const Heights& h) { return h.sp; }},
    {"Sv", of_field, "maximum pit depth of the whole field", [](const Heights& h) { return h.sv; }},
    {"Sz", of_field, "maximum height Sp + Sv", sum_of_extremes},
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
  Heights out{sample};
  const WaveError mean = errors.of_mean(), sa = errors([](const Moments&of) { return of.sa; }),
                  sq = errors([](const Moments&of) { return of.sq; }),
                  ssk = errors([](const Moments&of) { return of.ssk; }),
                  sku = errors([](const Moments&of) { return of.sku; });
  out.error = {mean.error, sa.error, sq.error, ssk.error, sku.error};
  // Heavy tails, of which the field may have few heights, are in the distribution that it evidently has; its
  // own waves are low by a factor of three at most (patchy fields), and a distribution knows no bound.
  if (const auto theory = translation_errors(sample)) {
    constexpr double most = 3;
    const MomentErrors of_tails = theory->standard_errors(m.sq);
    auto widen = [](double& error, double to) { error = std::clamp(to, error, most * error); };
    widen(out.error.ssk, of_tails.ssk), widen(out.error.sku, of_tails.sku);
  }
  auto half_width = [](double error, const WaveError& of) {
    return WaveError{error, of.degrees}.half_width();
  };
  out.interval = {.mean = Interval::about(m.mean, mean.half_width()),
                  .sa = freed_of_form(sample, m.sa, sa),
                  .sq = freed_of_form(sample, m.sq, sq),
                  .ssk = Interval::about(m.ssk, half_width(out.error.ssk, ssk)),
                  .sku = Interval::of_inverse(m.sku, half_width(out.error.sku, sku) / m.sku)};
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

// ---- extremes ----

// The highest height above the mean, of side 1, or the depth of the lowest, -1, by the error of the level
// that it is measured from.
Estimate extreme(const Sample& sample, double side, double error_of_level) {
  const Moments& m = sample.moments();
  const LagField& rho = sample.basis().correlation;
  Estimate out{.value = side > 0 ? m.sp : m.sv, .why = too_few_patches(sample, 100)};
  if (!sample.needs_errors() || !out.why.empty()) return out;
  const double level = std::exp(-1);
  const auto along_x = first_crossing(rho.normalised().along_x(), level),
             along_y = first_crossing(rho.normalised().along_y(), level);
  auto length = [](const std::optional<Crossing>& at, Index n) {
    return at ? at->lag : static_cast<double>(n);
  };
  const Field z = side * (sample.surface().heights - m.mean);
  const auto error =
      extreme_error(z, sample.grid(), length(along_x, z.rows()), length(along_y, z.cols()), error_of_level);
  if (error)
    out.standard_error = error->error, out.interval = error->interval;
  else
    out.why = "no standard error: fewer than six summits are two lengths apart, or they are equal";
  return out;
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
  const Sample& sample;
  const MaterialRatioCurve& curve;
  CoreParameters core;
  VolumeParameters volumes;
  std::optional<MaterialErrors> errors;
  std::array<double, 2> ratios;

  // A figure of the core.
  Estimate core_figure(const Estimate& of) const {
    if (!errors || !errors->core_may_be_elsewhere || !std::isfinite(of.standard_error)) return of;
    return {.value = of.value,
            .why = "no standard error: the core may begin elsewhere, where the curve falls as little"};
  }
  Estimate length(double value, const WaveError& of) const {
    if (!(of.error > 0 && value > 0)) return {value};
    return {value, of.error, freed_of_form(sample, value, of)};
  }
  // Of the few heights that are highest or lowest.
  Estimate of_tail(double value, const WaveError& of) const {
    const std::string why = too_few_patches(sample, 40);
    return why.empty() ? length(value, of) : Estimate{.value = value, .why = why};
  }
  // Of what lies beyond the core.
  Estimate outside(const Estimate& of) const {
    if (of.value == 0) return {.value = 0, .why = "no standard error: nothing lies beyond the core"};
    return core_figure(of);
  }
  // An extreme of the field, measured from an end of the core.
  Estimate outside(double value, double side, const WaveError& of_level) const {
    Estimate out = extreme(sample, side, of_level.error);
    if (const double moved = value - out.value; out.interval)
      out.interval =
          Interval::of(value, std::max(0.0, out.interval->low + moved), out.interval->high + moved);
    out.value = value;
    return outside(out);
  }
  // Of two heights.
  Estimate fall(const std::array<double, 2>& of_ratios, double value, const WaveError& of) const {
    if (of_ratios[0] == of_ratios[1]) return {.value = 0, .why = "no standard error: p and q are the same"};
    const std::string why = few_beyond(sample, std::min(of_ratios[0], 1 - of_ratios[1]));
    return why.empty() ? length(value, of) : Estimate{.value = value, .why = why};
  }
  static Estimate share(double value, const WaveError& of) {
    if (!(of.error > 0)) return {value};
    return {
        value, of.error,
        Interval::of(value, std::max(0.0, value - of.half_width()), std::min(1.0, value + of.half_width()))};
  }
  const MaterialErrors& error() const {
    static const MaterialErrors none;
    return errors ? *errors : none;
  }
};

constexpr Definition<Material> core_table[] = {
    {"Sk", of_field, "core height",
     [](const Material& m) { return m.core_figure(m.length(m.core.sk, m.error().sk)); }},
    {"Spk", of_field, "reduced peak height",
     [](const Material& m) { return m.outside(m.of_tail(m.core.spk, m.error().spk)); }},
    {"Svk", of_field, "reduced dale height",
     [](const Material& m) { return m.outside(m.of_tail(m.core.svk, m.error().svk)); }},
    {"Smr1", "1", "material ratio where the core begins",
     [](const Material& m) { return m.core_figure(Material::share(m.core.smr1, m.error().smr1)); }},
    {"Smr2", "1", "material ratio where the core ends",
     [](const Material& m) { return m.core_figure(Material::share(m.core.smr2, m.error().smr2)); }},
    {"Spkx", of_field, "maximum peak height above the core",
     [](const Material& m) { return m.outside(m.core.spkx, 1, m.error().upper); }},
    {"Svkx", of_field, "maximum pit depth below the core",
     [](const Material& m) { return m.outside(m.core.svkx, -1, m.error().lower); }},
    {"Sak1", of_field, "area of the reduced peaks, Smr1 Spk / 2",
     [](const Material& m) { return m.outside(m.of_tail(m.core.sak1, m.error().sak1)); }},
    {"Sak2", of_field, "area of the reduced dales, (1 - Smr2) Svk / 2",
     [](const Material& m) { return m.outside(m.of_tail(m.core.sak2, m.error().sak2)); }}};

constexpr Definition<Material> fall_table[] = {
    {"Sdc", of_field, "height difference Smc_p - Smc_q",
     [](const Material& m) { return m.fall(m.ratios, m.curve.fall(m.ratios), m.error().sdc); }},
    {"Sxp", of_field, "peak extreme height, Smc at 0.025 less Smc at 0.5",
     [](const Material& m) { return m.fall(sxp_ratios, m.curve.fall(sxp_ratios), m.error().sxp); }}};

constexpr Definition<Material> volume_table[] = {
    {"Vmp", of_field, "peak material volume per area",
     [](const Material& m) { return m.of_tail(m.volumes.vmp, m.error().vmp); }},
    {"Vmc", of_field, "core material volume per area",
     [](const Material& m) { return m.length(m.volumes.vmc, m.error().vmc); }},
    {"Vvc", of_field, "core void volume per area",
     [](const Material& m) { return m.length(m.volumes.vvc, m.error().vvc); }},
    {"Vvv", of_field, "dale void volume per area",
     [](const Material& m) { return m.of_tail(m.volumes.vvv, m.error().vvv); }}};

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
std::string material_symbols() {
  return symbols_of(core_table) + ", " + symbols_of(fall_table) + ", " + symbols_of(volume_table);
}

Parameters height_parameters(const Sample& sample, const MeasureOptions& options) {
  ParameterList out(sample.surface().units);
  Heights heights = heights_of(sample);
  if (options.preparation.longer.given())
    heights.of_mean = "no standard error: the L-filter has taken the long waves that it rests on";
  heights.sp = extreme(sample, 1, heights.error.mean), heights.sv = extreme(sample, -1, heights.error.mean);
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
  const Material of{.sample = sample,
                    .curve = curve,
                    .core = curve.core(),
                    .volumes = curve.volumes(p, q),
                    .errors = sample.material_errors(curve, options.material_ratios),
                    .ratios = options.material_ratios};
  ParameterList out(sample.surface().units);
  const Words words{.why_no_error = equal_heights};
  out.add(core_table, of, words);
  const std::vector<Estimate> inverse =
      quantile_estimates(sample, {1 - p, 1 - q}, {curve.height(p), curve.height(q)});
  out.add("Smc_p", of_field, "inverse material ratio at {}", inverse[0],
          {.meaning = shortest(p), .why_no_error = equal_heights});
  out.add("Smc_q", of_field, "inverse material ratio at {}", inverse[1],
          {.meaning = shortest(q), .why_no_error = equal_heights});
  out.add(fall_table, of, words);
  for (const auto& [c, text] : options.material_heights)
    out.add("Smr_{}", "1", "material ratio at {} above the mean", share_above(sample, curve, c),
            {.symbol = text, .meaning = text, .why_no_error = equal_heights});
  out.add(volume_table, of, words);
  return std::move(out).with_known_errors(sample.size());
}

}  // namespace asperity
