#include "stats/measure/ensemble_parameters.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

bool is_direction(const std::string& unit) { return unit == "rad"; }

// A direction by the wave that has it, of two periods a turn.
Eigen::ArrayXd summed(const Parameter& parameter) {
  if (!is_direction(parameter.unit)) return Eigen::ArrayXd::Constant(1, parameter.value);
  return Eigen::Array2d(std::cos(2 * parameter.value), std::sin(2 * parameter.value));
}

struct Centre {
  double mean, spread;
};

Centre centre_of(const std::string& unit, const Ensemble& values) {
  const Eigen::ArrayXd mean = values.mean();
  if (!is_direction(unit)) return {mean(0), values.spread()(0)};
  const double n = values.count()(0), length = std::min(std::hypot(mean(0), mean(1)), 1.0);
  return {std::atan2(mean(1), mean(0)) / 2, n > 1 ? std::sqrt(-2 * std::log(length) * n / (n - 1)) / 2 : NAN};
}

}  // namespace

void EnsembleParameters::add(const Parameters& parameters) {
  ++surfaces_;
  for (const Parameter& parameter : parameters) {
    auto q = std::ranges::find(quantities_, parameter.name, &Quantity::name);
    if (q == quantities_.end()) q = quantities_.insert(q, {parameter.name, parameter.unit});
    q->values.add(summed(parameter));
    q->squared_errors.add(Eigen::ArrayXd::Constant(1, parameter.standard_error * parameter.standard_error));
  }
}

std::vector<EnsembleParameter> EnsembleParameters::all() const {
  std::vector<EnsembleParameter> out;
  for (const auto& [name, unit, values, squared_errors] : quantities_) {
    const auto [mean, spread] = centre_of(unit, values);
    out.push_back({name, unit, mean, spread, std::sqrt(squared_errors.mean()(0)), values.count()(0)});
  }
  return out;
}

}  // namespace asperity
