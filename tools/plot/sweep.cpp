// Load over approach, and area over load, of contacts under many loads.
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "dataset/units.hpp"
#include "tools/plot/series.hpp"
#include "tools/plot/source.hpp"
#include "tools/plot/table.hpp"

namespace asperity::plot {
namespace {

// Half the length of error bars: of the mean over surfaces, else what the grid leaves.
struct Errors {
  Eigen::ArrayXd half;
  const char* words = "";

  bool known() const { return (half > 0).any(); }
};

Errors errors_of(const Dataset& table, const std::string& name) {
  const std::string spread = name + "_standard_error";
  if (table.has(spread)) return {half_intervals(table, spread), "95 % intervals of the mean"};
  return {column(table, name + "_error"), "error of the grid"};
}

struct Sweep {
  Eigen::ArrayXd load, approach, area;
  Errors of_approach, of_area;
  Eigen::Array<bool, Eigen::Dynamic, 1> converged;

  /// What its errors are, "" of none.
  std::string words() const {
    return of_approach.known() ? of_approach.words : of_area.known() ? of_area.words : "";
  }
};

Sweep sweep_of(const Dataset& data) {
  for (const auto& [name, unit] : {std::pair{"load", "N"}, {"approach", "m"}, {"area", "m2"}}) {
    if (!is_table(data) || !data.has(name))
      throw DataError(name, "is in no column: give the table that asperity-contact --sweep prints");
    if (const std::string its = si_unit_of(data.at(name)); its != unit)
      throw DataError(name, fmt::format("is in {}, and not in {}", its, unit));
  }
  // What the outline of the cells adds to the area is told apart only where it is known.
  const std::string area = column(data, "area_corrected").isFinite().all() ? "area_corrected" : "area";
  return {column(data, "load"),        column(data, "approach"), column(data, area),
          errors_of(data, "approach"), errors_of(data, area),    column(data, "converged") != 0};
}

Range range_of_all(const Eigen::ArrayXd& values, const Eigen::ArrayXd& half) {
  const Eigen::ArrayXd by = half.isFinite().select(half, 0.0);
  Field both(values.size(), 2);
  both << values - by, values + by;
  return range_of(both);
}

Range with_room(Range r, bool from_zero) {
  const double room = 0.05 * r.width();
  return {from_zero ? 0 : r.low - room, r.high + room};
}

bool spans_a_decade(Range range, double least) { return least > 0 && range.high >= 10 * least; }

// Of a quantity that is never negative.
Axis axis_of_growth(Range range, double least, bool logarithmic, const Unit& unit, std::string_view name) {
  if (!logarithmic) return axis_of(with_room(range, true), unit, name);
  Axis out = axis_of({std::max(0.9 * range.low, 0.5 * least), 1.15 * range.high}, unit, name);
  out.logarithmic = true;
  return out;
}

void add_curve(Series to, const Sweep& of, const Series::Column& x, const Series::Column& y,
               const Series::Column& half, std::size_t colour, bool across) {
  to.line(x, y, line_colour(colour));
  to.bars(x, y, where(half > 0, half), line_colour(colour), across);
  to.dots(x, y, line_colour(colour), 0.4);
  to.dots(x, where(!of.converged, y), "white", 0.22);
}

}  // namespace

Figure sweep(const Cases& cases, const Request&) {
  std::vector<Sweep> all;
  Range load{unlimited, -unlimited}, approach = load, area = load;
  double least_load = unlimited, least_area = unlimited;
  for (const Case& c : cases) {
    const Sweep& s = all.emplace_back(sweep_of(c.data));
    if (!(s.load.isFinite() && s.approach.isFinite() && s.area.isFinite()).any())
      throw DataError("load", "no row of the table has a load, an approach and an area");
    const Eigen::ArrayXd exact = Eigen::ArrayXd::Zero(s.load.size());
    load = united(load, range_of_all(s.load, exact));
    approach = united(approach, range_of_all(s.approach, s.of_approach.half));
    area = united(area, range_of_all(s.area, s.of_area.half));
    least_load = std::min(least_load, range_of_all(s.load, exact).low);
    least_area = std::min(least_area, range_of_all(s.area, exact).low);
  }
  const Unit newtons = cli::unit_for(load.high, "N"), metres = cli::unit_for(approach.magnitude(), "m"),
             squares = cli::unit_for(area.high, "m2");
  Figure out{.aspect = 0.45, .gap_y = 4.8};
  Panel press, grow;
  press.x = axis_of(with_room(approach, false), metres, "approach");
  press.y = axis_of(with_room(load, true), newtons, "load");
  const bool decades = spans_a_decade(load, least_load) && spans_a_decade(area, least_area);
  grow.x = axis_of_growth(load, least_load, decades, newtons, "load");
  grow.y = axis_of_growth(area, least_area, decades, squares, "contact area");
  using enum LegendEntry::Key;
  const bool one_kind = std::ranges::all_of(all, [&](const Sweep& s) { return s.words() == all[0].words(); });
  for (std::size_t c = 0; c < all.size(); ++c) {
    const Sweep& s = all[c];
    add_curve({press, metres.factor, newtons.factor}, s, s.approach, s.load, s.of_approach.half, c, true);
    add_curve({grow, newtons.factor, squares.factor}, s, s.load, s.area, s.of_area.half, c, false);
    const std::string errors = s.words(), own = one_kind || errors.empty() ? "" : ", " + errors;
    if (all.size() > 1) out.legend.push_back({line, line_colour(c), cases[c].label + own});
  }
  if (one_kind) out.title = all[0].words();
  if (std::ranges::any_of(all, [](const Sweep& s) { return !s.converged.all(); }))
    out.legend.push_back({circle, "black", "not converged"});
  out.panels = {press, grow};
  return out;
}

}  // namespace asperity::plot
