#include "tools/surface/marginal_dataset.hpp"

#include "core/error.hpp"
#include "marginal/johnson.hpp"

namespace asperity::cli {
namespace {

constexpr const char* kernel_quantiles = "kernel_quantiles";

MeasuredHeights quantiles_of(const Variable& variable) {
  const std::vector<double> values = numbers(variable.values);
  const double highest = variable.attributes.number("highest_score", NAN);
  if (values.size() != 2 * MeasuredHeights::half + 1 || !(highest > 0 && highest < 40))
    throw DataError(variable.name, "is not a table of quantiles at normal scores");
  MeasuredHeights out{highest / static_cast<double>(MeasuredHeights::half),
                      Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Index>(values.size()))};
  for (Index j = 1; j < out.quantiles.size(); ++j)
    if (!(out.quantiles(j) >= out.quantiles(j - 1)))
      throw DataError(variable.name, "its heights do not increase");
  const HeightMoments moments = height_moments(out.translation());
  if (!(std::abs(moments.mean) <= 1e-6 && std::abs(moments.variance - 1) <= 1e-6))
    throw DataError(variable.name, "its mean is not 0 or its variance not 1");
  return out;
}

}  // namespace

Marginal Marginal::of(MeasuredHeights measured) {
  Translation translation = measured.translation();
  const HeightMoments moments = height_moments(translation);
  return {std::move(translation), moments.skewness, moments.kurtosis, std::move(measured)};
}

void set_quantiles(Dataset& data, const std::string& name, const MeasuredHeights& measured) {
  const Eigen::ArrayXd& q = measured.quantiles;
  data.set_dimension("normal_score", q.size());
  Variable variable{name, {"normal_score"}, std::vector<double>(q.begin(), q.end()), {}};
  variable.attributes.set("units", "1");
  variable.attributes.set("long_name", "heights over their rms at evenly spaced normal scores");
  variable.attributes.set("highest_score", measured.step * static_cast<double>(MeasuredHeights::half));
  variable.attributes.set_values("actual_range", Values(std::vector<double>{q(0), q(q.size() - 1)}));
  data.put(std::move(variable));
}

void set_marginal(Dataset& data, const Marginal& marginal) {
  data.attributes.set("kernel_heights", marginal.translation.family);
  data.attributes.set("kernel_skewness", marginal.skewness);
  data.attributes.set("kernel_kurtosis", marginal.kurtosis);
  if (marginal.measured) set_quantiles(data, kernel_quantiles, *marginal.measured);
}

std::optional<Marginal> marginal_of(const Dataset& data) {
  const std::string family = data.attributes.text("kernel_heights");
  if (family.empty()) return std::nullopt;
  if (family == "measured") return Marginal::of(quantiles_of(data.at(kernel_quantiles)));
  const double skewness = data.attributes.number("kernel_skewness", NAN),
               kurtosis = data.attributes.number("kernel_kurtosis", NAN);
  try {
    return Marginal{johnson_translation(skewness, kurtosis), skewness, kurtosis};
  } catch (const ParameterError& error) {
    throw DataError("kernel_heights", error.name + " " + error.what());
  }
}

HeightsWithAcf measured_with_acf(const Dataset& data) {
  HeightsWithAcf out{data.attributes.number("acf_skewness", NAN),
                     data.attributes.number("acf_kurtosis", NAN)};
  if (const Variable* quantiles = data.find("acf_quantiles")) out.measured = quantiles_of(*quantiles);
  return out;
}

}  // namespace asperity::cli
