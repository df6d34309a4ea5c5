#include "contact/sweep.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace asperity {
namespace {

constexpr double round_off = 1e-12;

void check_loads(const std::vector<double>& loads, double largest) {
  for (std::size_t i = 1; i < loads.size(); ++i)
    if (!(loads[i] > loads[i - 1] && std::isfinite(loads[i])))
      throw ParameterError("loads",
                           fmt::format("{} N is not above {} N, the one before", loads[i], loads[i - 1]));
  if (loads.back() > largest * (1 + round_off))
    throw ParameterError(
        "loads", fmt::format("{} N is more than the limit pressure carries on the whole domain, {:.6g} N",
                             loads.back(), largest));
}

// (1), from one solution or from two; before the first it is empty.
class Prediction {
 public:
  Field at(double load) const {
    if (before_.size() == 0) return last_ * (load / last_load_);
    const double ahead = (load - last_load_) / (last_load_ - load_before_);
    return (last_ + ahead * (last_ - before_)).max(0.0);
  }
  void learn(double load, const Field& pressure) {
    before_ = std::exchange(last_, pressure);
    load_before_ = std::exchange(last_load_, load);
  }

 private:
  Field last_, before_;
  double last_load_ = 0, load_before_ = 0;
};

}  // namespace

std::vector<double> geometric_loads(double from, double to, int count) {
  std::vector<double> loads;
  loads.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    loads.push_back(from * std::pow(to / from, static_cast<double>(i) / (count - 1)));
  loads.back() = to;
  return loads;
}

void press_in_turn(const Grid& grid, const Field& undeformed_gap, ElasticOperator& influence,
                   ContactParameters parameters, const std::vector<double>& loads,
                   const std::function<void(const Contact&)>& take) {
  if (loads.empty()) return;
  parameters.load = loads.front();
  parameters.check();
  check_loads(loads, parameters.limit_pressure * grid.size_x() * grid.size_y());
  Prediction prediction;
  for (double load : loads) {
    parameters.start = prediction.at(load);
    parameters.load = load;
    const Contact contact = solve_contact(grid, undeformed_gap, influence, parameters);
    prediction.learn(load, contact.pressure);
    take(contact);
  }
}

}  // namespace asperity
