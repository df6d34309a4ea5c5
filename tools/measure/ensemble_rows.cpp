#include "tools/measure/ensemble_rows.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::cli {

namespace {

bool is_direction(const std::string& unit) { return unit == "rad"; }

// A direction by the wave that has it, of two periods a turn.
Eigen::ArrayXd summed(const Quantities::Row& row) {
  if (!is_direction(row.unit)) return Eigen::ArrayXd::Constant(1, row.value);
  return Eigen::Array2d(std::cos(2 * row.value), std::sin(2 * row.value));
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

EnsembleRows::Quantity& EnsembleRows::quantity(const Quantities::Row& row) {
  const auto known = std::ranges::find(quantities_, row.name, &Quantity::name);
  return known != quantities_.end() ? *known : quantities_.emplace_back(Quantity{row.name, row.unit});
}

void EnsembleRows::add(const Rows& rows) {
  ++surfaces_;
  for (const Quantities::Row& row : rows) {
    Quantity& q = quantity(row);
    q.values.add(summed(row));
    q.squared_errors.add(Eigen::ArrayXd::Constant(1, row.standard_error * row.standard_error));
  }
}

Table EnsembleRows::table() const {
  Table out{{{"quantity", ""},
             {"unit", ""},
             {"mean", "SI", Holds::unknown},
             {"standard_error", "SI", Holds::unknown},
             {"spread", "SI", Holds::unknown},
             {"expected_spread", "SI", Holds::unknown},
             {"surfaces", "1"}},
            {}};
  for (const Quantity& q : quantities_) {
    const auto [mean, spread] = centre_of(q.unit, q.values);
    const double count = q.values.count()(0);
    out.rows.push_back({q.name, q.unit, mean, spread / std::sqrt(count), spread,
                        std::sqrt(q.squared_errors.mean()(0)), count});
  }
  return out;
}

}  // namespace asperity::cli
