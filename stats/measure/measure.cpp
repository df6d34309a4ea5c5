#include "stats/measure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "math/noise.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

std::string filled_in(std::string_view text, const std::string& word) {
  std::string out(text);
  if (const auto place = out.find("{}"); place != out.npos) out.replace(place, 2, word);
  return out;
}

}  // namespace

Parameters measure(const Surface& surface, const MeasureOptions& options) {
  const Sample sample(prepared(surface, options.preparation, options.threads), options.threads);
  Parameters out;
  for (const Group group : options.groups)
    std::ranges::copy(measure(sample, group, options), std::back_inserter(out));
  return out;
}

Parameters measure(const Sample& sample, Group group, const MeasureOptions& options) {
  // In the order of Group.
  constexpr std::array groups{height_parameters, quantiles,          gaussianity,      material_parameters,
                              hybrid_parameters, spatial_parameters, profile_averages, feature_parameters};
  return groups.at(static_cast<std::size_t>(group))(sample, options);
}

std::string symbols(Group group) {
  return group == Group::height     ? height_symbols()
         : group == Group::material ? material_symbols()
         : group == Group::hybrid   ? slope_symbols()
         : group == Group::feature  ? feature_symbols()
                                    : "";
}

Sample stand_in(Surface flat, double rms) {
  std::vector<double> row(static_cast<std::size_t>(flat.grid.shape.ny));
  WhiteNoise noise(1);
  for (Index i = 0; i < flat.grid.shape.nx; ++i) {
    noise.row(i, row);
    flat.heights.row(i) += rms * Eigen::Map<const Eigen::ArrayXd>(row.data(), std::ssize(row)).transpose();
  }
  flat.correlation.reset(), flat.distribution.reset();
  const ErrorBasis basis{LagField(Field::Ones(1, 1)), false, Pairs::of(flat.heights, flat.grid)};
  return {std::move(flat), basis, basis.size()};
}

Parameters measure_flat(const Surface& flat, Group group, const MeasureOptions& options) {
  Parameters out = measure(stand_in(flat, 1), group, options);
  const Parameters twice = measure(stand_in(flat, 2), group, options);
  for (std::size_t i = 0; i < out.size(); ++i) {
    Parameter& p = out[i];
    p.standard_error = unknown, p.interval.reset(), p.is_bound = false;
    if (!std::isfinite(p.value)) continue;
    p.why.clear();
    if (p.name == "mean" || p.name == "N" || p.name == "N_missing" || p.name == "profiles") continue;
    const bool has_none = p.name.starts_with("summit_") || p.name.starts_with("nayak_") || p.unit == "m-1" ||
                          p.name.substr(1).starts_with("mr_");
    p.value = !has_none && std::abs(twice[i].value) > std::abs(p.value) ? 0 : unknown;
    if (std::isnan(p.value)) p.why = "no value: the surface is flat";
  }
  return out;
}

std::string missing(const Parameters& parameters) {
  const bool any = std::ranges::any_of(parameters, [](const auto& p) { return std::isfinite(p.value); });
  return parameters.empty() || any ? "" : parameters.front().why;
}

void ParameterList::add(std::string_view symbol, std::string_view unit, std::string_view meaning,
                        const Estimate& estimate, const Words& words) {
  parameters_.push_back({.name = filled_in(symbol, words.symbol),
                         .value = estimate.value,
                         .unit = unit == of_field ? units_ : std::string(unit),
                         .standard_error = estimate.standard_error,
                         .meaning = filled_in(meaning, words.meaning),
                         .interval = estimate.interval,
                         .why = !estimate.why.empty()                 ? estimate.why
                                : !std::isfinite(estimate.value)      ? words.why
                                : std::isnan(estimate.standard_error) ? words.why_no_error
                                                                      : "",
                         .is_bound = estimate.is_bound});
}

Parameters ParameterList::with_known_errors(const EffectiveSampleSize& size) && {
  const std::string why = too_few(size);
  auto has_none = [](const Parameter& p) {  // a count has no error, and a reason is reason enough
    return !std::isfinite(p.value) || !p.why.empty() || p.name.starts_with("N");
  };
  for (Parameter& parameter : parameters_)
    if (!why.empty() && !(std::isnan(parameter.standard_error) && has_none(parameter)))
      parameter.standard_error = unknown, parameter.why = "no standard error can be given: " + why;
  return std::move(parameters_);
}

}  // namespace asperity
