#include "stats_ensemble.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::cli {

EnsembleRows::Quantity& EnsembleRows::quantity(const Quantities::Row& row) {
  const auto known = std::ranges::find(quantities_, row.name, &Quantity::name);
  return known != quantities_.end() ? *known : quantities_.emplace_back(Quantity{row.name, row.unit});
}

void EnsembleRows::add(const Rows& rows) {
  ++surfaces_;
  for (const Quantities::Row& row : rows) {
    Quantity& q = quantity(row);
    q.values.add(Eigen::ArrayXd::Constant(1, row.value));
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
    out.rows.push_back({q.name, q.unit, q.values.mean()(0), q.values.standard_error()(0),
                        q.values.spread()(0), std::sqrt(q.squared_errors.mean()(0)), q.values.count()(0)});
  return out;
}

}  // namespace asperity::cli
