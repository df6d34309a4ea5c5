#include "stats/measure/ensemble_parameters.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// A value and its square error; a direction by the wave that has it, of two periods a turn.
Eigen::Array3d summed(const Parameter& parameter) {
  const double value = parameter.value, square_error = parameter.standard_error * parameter.standard_error;
  if (parameter.unit != "rad") return {square_error, value, 0};
  return {square_error, std::cos(2 * value), std::sin(2 * value)};
}

}  // namespace

void EnsembleParameters::add(const Parameters& parameters) {
  ++surfaces_;
  for (const Parameter& parameter : parameters) {
    auto known = std::ranges::find(quantities_, parameter.name, &Quantity::name);
    if (known == quantities_.end()) known = quantities_.insert(known, {parameter.name, parameter.unit});
    known->values.add(summed(parameter));
    known->is_bound |= parameter.is_bound;
  }
}

std::vector<EnsembleParameter> EnsembleParameters::all() const {
  std::vector<EnsembleParameter> out;
  for (const auto& [name, unit, values, is_bound] : quantities_) {
    const Eigen::Array3d m = values.mean();
    const double n = values.count()(1);
    EnsembleParameter of{name, unit, m(1), values.spread()(1), std::sqrt(m(0)), n, is_bound};
    if (unit == "rad") {
      const double length = std::min(std::hypot(m(1), m(2)), 1.0);
      of.mean = std::atan2(m(2), m(1)) / 2;
      of.spread = n > 1 ? std::sqrt(-2 * std::log(length) * n / (n - 1)) / 2 : NAN;
    }
    out.push_back(of);
  }
  return out;
}

}  // namespace asperity
