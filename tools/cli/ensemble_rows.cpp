#include "tools/cli/ensemble_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "dataset/catalogue.hpp"
#include "stats/sample/ensemble.hpp"

namespace asperity::cli {
namespace {

bool among(const std::vector<std::string_view>& names, std::string_view name) {
  return std::ranges::any_of(names, [&](std::string_view one) { return fits(one, name); });
}

// "yes" of 0 or 1, which has a mean: the share.
std::string unit_of(const KnownAttribute& attribute) {
  return attribute.unit == "yes" ? "1" : std::string(attribute.unit);
}

}  // namespace

void EnsembleRows::add(const std::string& surface, const Attributes& attributes, bool converged) {
  Row row{surface, {}, converged};
  for (const Attribute& a : attributes) {
    if (!a.name.starts_with(content_.prefix) || std::holds_alternative<std::string>(a.values)) continue;
    if (const std::vector<double> all = numbers(a.values); all.size() == 1) row.values[a.name] = all[0];
  }
  rows_.push_back(std::move(row));
}

std::vector<EnsembleRows::Asked> EnsembleRows::columns() const {
  std::set<std::string> present;
  for (const Row& row : rows_)
    for (const auto& [name, value] : row.values) present.insert(name);
  std::vector<Asked> out;
  for (const KnownAttribute& known : known_attributes())
    for (const std::string& name : present) {
      if (known_attribute(name) != &known) continue;
      const std::string shown = name.substr(content_.prefix.size());
      const bool result = known.role == Role::result && !among(content_.without, shown);
      if (!result && !among(content_.achieved, shown)) continue;
      out.push_back({name, {shown, unit_of(known), Holds::open}, result && !among(content_.places, shown)});
    }
  return out;
}

Table EnsembleRows::table() const {
  Table out{{{"surface", ""}}, {}};
  const std::vector<Asked> asked = columns();
  for (const Asked& a : asked) out.columns.push_back(a.column);
  Ensemble ensemble;
  ensemble.add(
      Eigen::ArrayXd::Constant(static_cast<Eigen::Index>(asked.size()), NAN));  // where none converged
  for (const Row& row : rows_) {
    Eigen::ArrayXd values(static_cast<Eigen::Index>(asked.size()));
    std::vector<Cell> cells{row.surface};
    for (std::size_t c = 0; c < asked.size(); ++c) {
      const auto found = row.values.find(asked[c].attribute);
      double value = found == row.values.end() ? NAN : found->second;
      if (asked[c].column.name == "converged") value = row.converged ? 1 : 0;
      cells.emplace_back(value);
      values(static_cast<Eigen::Index>(c)) = asked[c].averaged ? value : NAN;
    }
    if (row.converged) ensemble.add(values);
    out.rows.push_back(std::move(cells));
  }
  for (const auto& [name, values] :
       {std::pair{"mean", ensemble.mean()}, std::pair{"standard_error", ensemble.standard_error()}}) {
    out.rows.push_back({name});
    for (const double value : values) out.rows.back().emplace_back(value);
  }
  return out;
}

}  // namespace asperity::cli
