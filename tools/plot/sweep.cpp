// Load over approach, and area over load, of contacts under many loads.
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "dataset/units.hpp"
#include "tools/plot/curves.hpp"
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
  Flags converged;

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

void add_curve(Curves& to, const Sweep& of, const Curves::Column& x, const Curves::Column& y,
               const Curves::Column& half, std::size_t colour, bool across) {
  to.line(x, y, line_colour(colour));
  to.bars(x, y, where(half > 0, half), line_colour(colour), across);
  to.dots(x, y, line_colour(colour), 0.4);
  to.dots(x, where(!of.converged, y), "white", 0.22);
}

bool spans_a_decade(Range range, double least) { return least > 0 && range.high >= 10 * least; }

double least_of(const Eigen::ArrayXd& values) {
  return values.isFinite().select(values, unlimited).minCoeff();
}

// Of a quantity that is never negative; `least` without its error.
Axis axis_of_growth(Range range, double least, bool logarithmic, const char* unit, std::string_view name) {
  const Range shown = logarithmic ? Range{std::max(0.9 * range.low, 0.5 * least), 1.15 * range.high}
                                  : Range{0, with_room(range, 0, 0.05).high};
  Axis out = axis_of(shown, cli::unit_for(range.high, unit), name);
  out.logarithmic = logarithmic;
  return out;
}

}  // namespace

Figure sweep(const Cases& cases, const Request&) {
  std::vector<Sweep> all;
  Curves press, grow;
  double least = unlimited;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Sweep& s = all.emplace_back(sweep_of(cases[c].data));
    if (!(s.load.isFinite() && s.approach.isFinite() && s.area.isFinite()).any())
      throw DataError("load", "no row of the table has a load, an approach and an area");
    least = std::min(least, least_of(s.area));
    add_curve(press, s, s.approach, s.load, s.of_approach.half, c, true);
    add_curve(grow, s, s.load, s.area, s.of_area.half, c, false);
  }
  const bool decades = spans_a_decade(grow.x, grow.x.low) && spans_a_decade(grow.y, least);
  const Unit metres = cli::unit_for(press.x.magnitude(), "m");
  Figure out{.panels = {{}, {}}, .aspect = 0.45, .gap_y = 4.8};
  place(out.panels[0], press, axis_of(with_room(press.x, 0.05, 0.05), metres, "approach"),
        axis_of_growth(press.y, 0, false, "N", "load"));
  place(out.panels[1], grow, axis_of_growth(grow.x, grow.x.low, decades, "N", "load"),
        axis_of_growth(grow.y, least, decades, "m2", "contact area"));
  const bool one_kind = std::ranges::all_of(all, [&](const Sweep& s) { return s.words() == all[0].words(); });
  if (one_kind) out.title = all[0].words();
  name_cases(out, cases);
  for (std::size_t c = 0; c < out.legend.size() && !one_kind; ++c)
    if (const std::string errors = all[c].words(); !errors.empty()) out.legend[c].name += ", " + errors;
  if (std::ranges::any_of(all, [](const Sweep& s) { return !s.converged.all(); }))
    out.legend.push_back({LegendEntry::Key::circle, "black", "not converged"});
  return out;
}

}  // namespace asperity::plot
