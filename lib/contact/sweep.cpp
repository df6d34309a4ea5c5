#include "contact/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "contact/problem.hpp"
#include "core/error.hpp"

namespace asperity {
namespace {

void check_loads(std::span<const double> loads, const Grid& grid, double limit_pressure) {
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (!(loads[i] > 0 && std::isfinite(loads[i])))
      throw ParameterError("sweep", fmt::format("{} N is not above 0", loads[i]));
    if (i > 0 && loads[i] == loads[i - 1])
      throw ParameterError("sweep", fmt::format("{} N equals the previous load", loads[i]));
  }
  check_carried("sweep", std::ranges::max(loads), grid, limit_pressure);
}

// (3), from one solution or from two; before the first it is empty.
class Prediction {
 public:
  Field at(double load, const Ranks& ranks) const {
    if (before_.size() == 0) return last_ * (load / last_load_);
    const double ahead = (load - last_load_) / (last_load_ - load_before_);
    Field out = (last_ + ahead * (last_ - before_)).max(0.0);
    if (!(largest(ranks, out.maxCoeff()) > 0)) out = last_ * (load / last_load_);  // a fall by far
    return out;
  }
  void learn(double load, const Field& pressure) {
    before_ = std::exchange(last_, pressure);
    load_before_ = std::exchange(last_load_, load);
  }

 private:
  Field last_, before_;
  double last_load_ = 0, load_before_ = 0;
};

// What the greatest load so far has left of the bodies.
class Flattened {
 public:
  explicit Flattened(const Field& gap) : gap_(gap) {}

  bool holds_for(double load) const { return load < greatest_ && left_.size() > 0; }
  Contact press(const Grid& grid, ElasticOperator& influence, const ContactParameters& parameters) const {
    if (!holds_for(parameters.load)) return solve_contact(grid, gap_, influence, parameters);
    Contact out = solve_contact(grid, gap_ + left_, influence, parameters);
    out.flattening = left_;
    out.flattening_load = greatest_;
    return out;
  }
  void learn(const Contact& contact, const ContactParameters& parameters) {
    if (parameters.load < greatest_) return;
    greatest_ = parameters.load;
    if (contact.plastic_area > 0) left_ = plastic_flattening(contact);
  }

 private:
  const Field& gap_;
  Field left_;
  double greatest_ = 0;
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
  Flattened flattened(undeformed_gap);
  for (double load : loads) {
    parameters.start = prediction.at(load, influence.slabs().ranks());
    parameters.load = load;
    const Contact contact = flattened.press(grid, influence, parameters);
    flattened.learn(contact, parameters);
    prediction.learn(load, contact.pressure);
    take(contact);
  }
}

}  // namespace asperity
