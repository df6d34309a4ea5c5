#include "stats_ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::cli {

EnsembleRows::Quantity& EnsembleRows::quantity(const Quantities::Row& row) {
  const auto known = std::ranges::find(quantities_, row.name, &Quantity::name);
  return known != quantities_.end() ? *known : quantities_.emplace_back(Quantity{row.name, row.unit});
}

namespace {

// An angle is that of an axis, the same after half a turn: as near to the mean of those before as can be.
double nearest_turn(const Quantities::Row& row, const Ensemble& before) {
  if (row.unit != "rad" || before.quantities() == 0 || before.count()(0) == 0) return row.value;
  return before.mean()(0) + std::remainder(row.value - before.mean()(0), std::numbers::pi);
}

// From -90° on, as those of one surface.
double mean_of(const std::string& unit, const Ensemble& values) {
  const double mean = values.mean()(0);
  return unit == "rad" ? std::remainder(mean, std::numbers::pi) : mean;
}

}  // namespace

void EnsembleRows::add(const Rows& rows) {
  ++surfaces_;
  for (const Quantities::Row& row : rows) {
    Quantity& q = quantity(row);
    q.values.add(Eigen::ArrayXd::Constant(1, nearest_turn(row, q.values)));
    q.squared_errors.add(Eigen::ArrayXd::Constant(1, row.standard_error * row.standard_error));
  }
}

Table EnsembleRows::table() const {
  Table out{{{"quantity", ""},
             {"unit", ""},
             {"mean", "SI"},
             {"standard_error", "SI"},
             {"spread", "SI"},
             {"expected_spread", "SI"},
             {"surfaces", "1"}},
            {}};
  for (const Quantity& q : quantities_)
    out.rows.push_back({q.name, q.unit, mean_of(q.unit, q.values), q.values.standard_error()(0),
                        q.values.spread()(0), std::sqrt(q.squared_errors.mean()(0)), q.values.count()(0)});
  return out;
}

}  // namespace asperity::cli
