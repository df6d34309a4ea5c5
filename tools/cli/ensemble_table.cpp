#include "tools/cli/ensemble_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/catalogue.hpp"
#include "stats/measure/pooled_maps.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity::cli {
namespace {

const Column* column_of(const Table& table, const std::string& name) {
  const auto found = std::ranges::find(table.columns, name, &Column::name);
  return found == table.columns.end() ? nullptr : &*found;
}

Eigen::ArrayXd numbers_in(const Table& table, const std::string& name) {
  const auto column = static_cast<std::size_t>(column_of(table, name) - table.columns.data());
  Eigen::ArrayXd out(static_cast<Index>(table.rows.size()));
  for (Index i = 0; i < out.size(); ++i)
    out(i) = std::get<double>(table.rows[static_cast<std::size_t>(i)][column]);
  return out;
}

// Of a share p of n: that which p ± 1.96 of it reaches the farther end of Wilson's 95 % interval with.
double error_of_share(double p, double n) {
  const double z = half_width_95, middle = (p + z * z / (2 * n)) / (1 + z * z / n),
               half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return (std::abs(middle - p) + half) / z;
}

void append(Table& table, const Column& column, const Eigen::ArrayXd& values) {
  table.columns.push_back(column);
  for (Index i = 0; i < values.size(); ++i) table.rows[static_cast<std::size_t>(i)].emplace_back(values(i));
}

}  // namespace

void tell_interval(const Tool& tool, double surfaces, double most_degrees) {
  if (!(surfaces >= 2)) return;
  const double degrees = std::min(surfaces - 1, most_degrees);
  tool.note(counted(std::lround(surfaces), "surface") + ": a 95 % interval is " +
            in_digits(student_quantile(0.025, degrees), 3) +
            " standard errors to either side, Student's t of " + counted(std::lround(degrees), "degree") +
            " of freedom");
}

void tell_weights(const Tool& tool, const AreaWeights& weights) {
  if (!weights.differ()) return;
  tool.note(counted(weights.maps(), "surface") + " count by measured area, from " +
            in_digits(100 * weights.least(), 3) + " to " + in_digits(100 * weights.most(), 3) + " % of all");
  if (!weights.give_errors())
    tool.warn(
        "a surface has too few independent heights to count by its area, and there are no standard errors: "
        "leave out the smallest");
}

void warn_of_lays(const Tool& tool, const std::vector<EnsembleParameter>& parameters) {
  constexpr double degree = std::numbers::pi / 180, notable = 5 * degree;
  for (const EnsembleParameter& p : parameters) {
    const bool lay = p.name == "gamma_direction" || p.name.starts_with("ellipticity_");
    const double of_spread = 1 / std::sqrt(2 * (p.surfaces - 1));  // its relative error
    const bool differ = p.spread > notable && p.spread > (1 + 4 * of_spread) * p.expected_spread;
    if (!lay || p.unit != "rad" || !differ) continue;
    return tool.warn(
        "the lays differ by " + in_digits(p.spread / degree, 2) + " deg (" + p.name + "), their errors are " +
        in_digits(p.expected_spread / degree, 2) +
        " deg: lengths, ratios and directions are those of a mixture, heights are pooled; turn the "
        "surfaces (asperity-filter --rotate), or measure them separately");
  }
}

Table ensemble_table(const std::vector<EnsembleParameter>& parameters) {
  Table out{{{"quantity", ""},
             {"unit", ""},
             {"mean", "SI", Holds::unknown},
             {"standard_error", "SI", Holds::unknown},
             {"spread", "SI", Holds::unknown},
             {"expected_spread", "SI", Holds::unknown},
             {"surfaces", "1"}},
            {}};
  for (const EnsembleParameter& p : parameters) {
    if (p.is_bound) out.bounds.insert({out.rows.size(), 2});
    out.rows.push_back({p.name, p.unit, p.mean, p.standard_error, p.spread, p.expected_spread, p.surfaces});
  }
  return out;
}

Table comparison_table(const std::vector<ComparedParameter>& parameters) {
  Table out{{{"quantity", ""},
             {"unit", ""},
             {"first", "SI", Holds::unknown},
             {"first_error", "SI", Holds::unknown},
             {"others", "SI", Holds::unknown},
             {"others_error", "SI", Holds::unknown},
             {"surfaces", "1"},
             {"z", "1", Holds::unknown},
             {"p", "1", Holds::unknown},
             {"verdict", ""}},
            {}};
  for (const ComparedParameter& c : parameters)
    out.rows.push_back({c.name, c.unit, c.first, c.first_error, c.others, c.others_error, c.number, c.z, c.p,
                        std::isnan(c.p) ? "unknown"
                        : c.differs     ? "differs"
                                        : "agrees"});
  return out;
}

// Coordinates of grids that agree to six digits do too.
void EnsembleTable::check_keys(const Table& table, const std::string& file) const {
  constexpr double printed = 1e-6;
  const auto refuse = [&] {
    throw DataError(file, "its rows differ from those of the first surface: they cannot be averaged");
  };
  if (table.rows.size() != first_.rows.size()) refuse();
  const auto column_like_first = [&](const std::string& name) {
    const Column* own = column_of(table, name);
    if (own == nullptr) refuse();
    const std::string& unit = column_of(first_, name)->unit;
    if (own->unit != unit)
      throw DataError(file, "its unit, " + own->unit + ", differs from that of " + file_ + ", " + unit +
                                ": quantities of different kinds cannot be averaged");
    return own;
  };
  for (const std::string& key : content_.keys) {
    const Column* column = column_like_first(key);
    if (column->unit.empty()) continue;
    const Eigen::ArrayXd own = numbers_in(table, key), first = numbers_in(first_, key);
    if (!((own - first).abs() <= printed * first.abs()).all()) refuse();
  }
  column_like_first(content_.value);
}

void EnsembleTable::add_further(const Table& table, const std::string& name, Error error, double weight) {
  const Column* column = column_of(table, name);
  if (column == nullptr) return;
  auto known = std::ranges::find(further_, name, [](const Further& f) { return f.column.name; });
  if (known == further_.end()) known = further_.insert(known, {{name, column->unit, Holds::unknown}, error});
  known->values.add(numbers_in(table, name), weight);
}

void EnsembleTable::add_reasons(const Table& table) {
  const Column* column = content_.reason.empty() ? nullptr : column_of(table, content_.reason);
  if (column == nullptr) return;
  reasons_.resize(table.rows.size());
  for (std::size_t i = 0; i < reasons_.size(); ++i) {
    const auto& why =
        std::get<std::string>(table.rows[i][static_cast<std::size_t>(column - table.columns.data())]);
    if (why != "-" && reasons_[i].surfaces++ == 0) reasons_[i].first = why;
  }
}

void EnsembleTable::append_reasons(Table& out) const {
  constexpr double most = 0.1;
  if (reasons_.empty()) return;
  const auto error = static_cast<std::size_t>(column_of(out, content_.error) - out.columns.data());
  out.columns.push_back({content_.reason, ""});
  for (std::size_t i = 0; i < reasons_.size(); ++i) {
    const bool biased = reasons_[i].surfaces > most * surfaces_;
    if (biased) out.rows[i][error] = NAN;
    out.rows[i].emplace_back(biased ? reasons_[i].first : "-");
  }
}

void EnsembleTable::add(const Table& table, const std::string& file, double weight) {
  if (surfaces_++ == 0) first_ = table, file_ = file, content_ = content_of_(table);
  check_keys(table, file);
  values_.add(numbers_in(table, content_.value), weight);
  if (column_of(table, content_.error))
    square_errors_.add(numbers_in(table, content_.error).square(), weight);
  for (const std::string& name : content_.others) add_further(table, name, Error::of_spread, weight);
  for (const std::string& name : content_.shares) add_further(table, name, Error::of_share, weight);
  for (const std::string& name : content_.means) add_further(table, name, Error::none, weight);
  add_reasons(table);
}

Table EnsembleTable::table() const {
  Table out{{}, std::vector<std::vector<Cell>>(first_.rows.size())};
  for (const std::string& key : content_.keys) {
    const Column* column = column_of(first_, key);
    const auto c = static_cast<std::size_t>(column - first_.columns.data());
    out.columns.push_back(*column);
    for (std::size_t i = 0; i < out.rows.size(); ++i) out.rows[i].push_back(first_.rows[i][c]);
  }
  const std::string unit = column_of(first_, content_.value)->unit;
  append(out, {content_.value, unit, Holds::unknown}, values_.mean());
  append(out, {content_.error, unit, Holds::unknown}, values_.standard_error());
  for (const auto& [column, error, values] : further_) {
    append(out, column, values.mean());
    if (error == Error::none) continue;
    const Column of_error{column.name + "_standard_error", column.unit, Holds::unknown};
    if (error == Error::of_share)
      append(out, of_error, values.mean().binaryExpr(values.count(), &error_of_share));
    else
      append(out, of_error, values.standard_error());
  }
  if (square_errors_.count().size() > 0) {
    append(out, {"spread", unit, Holds::unknown}, values_.spread());
    append(out, {"expected_spread", unit, Holds::unknown}, square_errors_.mean().sqrt());
  }
  append(out, {"surfaces", "1"}, values_.count());
  append_reasons(out);
  return out;
}

void EnsembleTable::print(const Tool& tool, const Eigen::ArrayXd& pooled,
                          const Eigen::ArrayXd& errors) const {
  if (surfaces_ == 0) return;
  Table out = table();
  const auto value = static_cast<std::size_t>(column_of(out, content_.value) - out.columns.data());
  for (Index i = 0; i < pooled.size(); ++i) {
    auto& row = out.rows[static_cast<std::size_t>(i)];
    row[value] = pooled(i), row[value + 1] = errors(i);
  }
  tell_interval(tool, surfaces_, pooled.size() > 0 ? PooledMaps::most_degrees : INFINITY);
  if (values_.count().minCoeff() < surfaces_)
    tool.note("rows of fewer surfaces have fewer degrees of freedom, surfaces - 1");
  cli::print(tool, out);
}

int print_table(const Tool& tool, EnsembleInput& surfaces, const Several& several,
                const EnsembleTable::ContentOf& content,
                const std::function<Table(EnsembleMember&&)>& table_of_one,
                const std::vector<double>& areas) {
  const bool alone = surfaces.resolve(tool) == 1;
  EnsembleTable mean(content);
  AreaWeights weights;
  const auto weight_of_next = [&] {
    return areas.empty() ? 1 : weights.of(areas[static_cast<std::size_t>(weights.maps())]);
  };
  const auto take = [&](const Table& one, const std::string& name) {
    alone ? print(tool, one) : mean.add(one, name, weight_of_next());
  };
  const int code = surfaces.for_each(tool, table_of_one, take, several);
  tell_weights(tool, weights);
  mean.print(tool);
  return code;
}

void EnsembleField::add(const Field& field, double weight) {
  rows_ = field.rows();
  values_.add(Eigen::Map<const Eigen::ArrayXd>(field.data(), field.size()), weight);
}

// ---- a row for each surface ----

namespace {

struct SurfaceRow {
  std::string surface;
  SurfaceResults results;
};
using SurfaceRows = std::vector<SurfaceRow>;

struct ResultColumn {
  std::string attribute;
  Column column;
  bool averaged, share;  // share: of 0 or 1
};

// Nothing of a text or of several numbers.
std::optional<double> number_in(const Values& values) {
  if (std::holds_alternative<std::string>(values)) return std::nullopt;
  const std::vector<double> all = numbers(values);
  return all.size() == 1 ? std::optional(all[0]) : std::nullopt;
}

bool among(const std::vector<std::string_view>& names, std::string_view name) {
  return std::ranges::any_of(names, [&](std::string_view one) { return fits(one, name); });
}

// In the order of the catalogue. "yes" of 0 or 1 has a mean: the share.
std::vector<ResultColumn> result_columns(const SurfaceRows& rows, const RowContent& content) {
  std::set<std::string> present;
  for (const SurfaceRow& row : rows)
    for (const Attribute& a : row.results.attributes)
      if (a.name.starts_with(content.prefix) && number_in(a.values)) present.insert(a.name);
  std::vector<ResultColumn> out;
  for (const KnownAttribute& known : known_attributes())
    for (const std::string& name : present) {
      if (known_attribute(name) != &known) continue;
      const std::string shown = name.substr(content.prefix.size());
      const bool result = known.role == Role::result && !among(content.without, shown);
      if (!result && !among(content.achieved, shown)) continue;
      const std::string unit = known.unit == "yes" ? "1" : std::string(known.unit);
      const bool share = known.unit == "yes" && !shown.ends_with("converged");
      out.push_back({name, {shown, unit, Holds::open}, result && !among(content.places, shown), share});
    }
  return out;
}

double value_in(const SurfaceRow& row, const ResultColumn& column) {
  if (column.column.name == "converged") return row.results.converged ? 1 : 0;
  const Values* values = row.results.attributes.find(column.attribute);
  return values == nullptr ? NAN : number_in(*values).value_or(NAN);
}

Eigen::ArrayXd errors_of(const Ensemble& ensemble, const std::vector<ResultColumn>& columns) {
  Eigen::ArrayXd out = ensemble.standard_error();
  for (Index i = 0; i < out.size(); ++i)
    if (columns[static_cast<std::size_t>(i)].share && ensemble.count()(i) > 0)
      out(i) = error_of_share(ensemble.mean()(i), ensemble.count()(i));
  return out;
}

Table table_of(const Tool& tool, const SurfaceRows& rows, const RowContent& content) {
  const std::vector<ResultColumn> columns = result_columns(rows, content);
  Table out{{{"surface", ""}}, {}};
  for (const ResultColumn& c : columns) out.columns.push_back(c.column);
  Eigen::ArrayXd averaged = Eigen::ArrayXd::Constant(std::ssize(columns), NAN);
  Ensemble ensemble;
  ensemble.add(averaged);  // where none converged
  const auto add_row = [&](const std::string& name, const auto& values) {
    out.rows.push_back({name});
    for (const double value : values) out.rows.back().emplace_back(value);
  };
  for (const SurfaceRow& row : rows) {
    std::vector<double> values;
    for (const ResultColumn& c : columns) {
      values.push_back(value_in(row, c));
      if (c.averaged) averaged(std::ssize(values) - 1) = values.back();
    }
    if (row.results.converged) ensemble.add(averaged);
    add_row(row.surface, values);
  }
  tell_interval(tool, static_cast<double>(std::ranges::count_if(
                          rows, [](const SurfaceRow& row) { return row.results.converged; })));
  add_row("mean", ensemble.mean());
  add_row("standard_error", errors_of(ensemble, columns));
  add_row("spread", ensemble.spread());
  return out;
}

}  // namespace

int print_rows(const Tool& tool, EnsembleInput& surfaces, Several several, const RowContent& content,
               const std::function<SurfaceResults(EnsembleMember&&)>& results_of_one) {
  SurfaceRows rows;
  several.failed = [&](const std::string& name) { rows.push_back({name, {{}, false}}); };
  const auto take = [&](SurfaceResults&& one, const std::string& name) {
    rows.push_back({name, std::move(one)});
    return rows.back().results.code;
  };
  const int code = surfaces.for_each(tool, results_of_one, take, several);
  print(tool, table_of(tool, rows, content));
  return code;
}

}  // namespace asperity::cli
