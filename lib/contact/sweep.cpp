#include "contact/sweep.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/problem.hpp"
#include "core/error.hpp"

namespace asperity {
namespace {

void check_loads(std::span<const double> loads, const Grid& grid, double limit_pressure) {
  for (std::size_t i = 1; i < loads.size(); ++i)
    if (!(loads[i] > loads[i - 1] && std::isfinite(loads[i])))
      throw ParameterError("sweep",
                           fmt::format("{} N is not above {} N, the previous load", loads[i], loads[i - 1]));
  check_carried("sweep", loads.back(), grid, limit_pressure);
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

void solve_load_sequence(const Grid& grid, const Field& undeformed_gap, ElasticOperator& influence,
                         ContactParameters parameters, std::span<const double> loads,
                         const std::function<void(const Contact&)>& take) {
  if (loads.empty()) return;
  parameters.load = loads.front();
  parameters.check();
  check_loads(loads, grid, parameters.limit_pressure);
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
