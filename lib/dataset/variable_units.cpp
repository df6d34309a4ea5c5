#include "dataset/variable_units.hpp"

#include <cmath>
#include <stdexcept>

#include "core/error.hpp"
#include "dataset/catalogue.hpp"
#include "dataset/conventions.hpp"
#include "dataset/units.hpp"

namespace asperity {
std::string unit_of(const Variable& variable) {
  const std::string unit = variable.attributes.text("units");
  return unit.empty() ? variable.attributes.text("unit") : unit;
}

std::string si_unit_of(const Variable& variable) {
  const KnownVariable* known = known_variable(variable.name);
  const std::string own = unit_of(variable);
  if (known && !known->unit.empty()) return std::string(known->unit);
  for (const char* unit : {"m", "Pa"})
    if (measures(own, unit)) return unit;
  return own.empty() ? "1" : own;
}

double factor_to(std::string_view unit, const Variable& variable) {
  const std::string own = unit_of(variable), needed(unit);
  if (own == needed || (own.empty() && needed == "1")) return 1;
  if (own.empty())
    throw DataError(variable.name,
                    "it has no unit, where " + needed +
                        " or another of the same quantity is needed: give it the attribute units");
  try {
    const double factor = unit_factor(own, needed);
    if (factor > 0 && std::isfinite(factor)) return factor;
  } catch (const std::invalid_argument& e) {
    throw DataError(variable.name, std::string(e.what()) + ": correct its attribute units");
  }
  throw DataError(variable.name,
                  "'" + own + "' is no multiple of '" + needed + "': correct its attribute units");
}

std::optional<std::vector<double>> lags_of(const Variable& axis) {
  const std::string unit = unit_of(axis);
  const bool samples = unit.empty() || unit == "1" || unit == "px";
  const double factor = samples ? 1 : factor_to("m", axis);
  std::vector<double> lags = present_numbers(axis);
  for (double& lag : lags) lag *= factor;
  if (!samples) return lags;
  for (std::size_t i = 1; i < lags.size(); ++i)
    if (!(std::abs(lags[i] - lags[i - 1] - 1) <= 1e-3))
      throw DataError(axis.name,
                      "its lags have no unit and are not those of samples, one each: give it the "
                      "attribute units");
  return std::nullopt;
}

}  // namespace asperity
