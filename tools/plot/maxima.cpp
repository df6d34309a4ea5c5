// The largest stress at each depth.
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/plot/curves.hpp"
#include "tools/plot/measured.hpp"
#include "tools/plot/table.hpp"

namespace asperity::plot {
namespace {

// The largest of the whole body, which the tool searched for between the layers; NaN where it has not.
struct Top {
  double depth = NAN, value = NAN, depth_error = NAN, value_error = NAN;
};

struct Maxima {
  std::string variable;
  Field curve;  ///< depth, value, half the length of its 95 % interval or NaN
  Quantity quantity;
  Top top = {};
  double accurate = NAN;  ///< the depth from which on the grid resolves the stress
  bool of_magnitude = false;
};

Maxima of_table(const Dataset& table) {
  const bool fits = table.variables.size() > 1 && table.variables[0].name == "depth";
  if (!fits)
    throw DataError("depth",
                    "is not the first column: give a dataset with layers, or the table that asperity-stress "
                    "--result maxima prints");
  const Variable& value = table.variables[1];
  const Eigen::ArrayXd depth = column(table, "depth");
  Maxima out{value.name, Field(depth.size(), 3), quantity_of(value)};
  out.curve << depth, column(table, value.name), half_intervals(table, "standard_error");
  return out;
}

double largest_of(const double* first, std::size_t count, bool of_magnitude) {
  double out = NAN;
  for (std::size_t k = 0; k < count; ++k) out = std::fmax(out, of_magnitude ? std::abs(first[k]) : first[k]);
  return out;
}

Top top_of(const Attributes& a, const std::string& variable) {
  const std::string of = variable == "von_mises"   ? "stress_max_von_mises"
                         : variable == "max_shear" ? "stress_max_shear"
                         : variable == "stress_1"  ? "stress_max_principal"
                                                   : "";
  if (of.empty() || !a.find(of)) return {};
  return {a.number("stress_max_depth", NAN), a.number(of, NAN), a.number("stress_max_depth_error", NAN),
          a.number(of + "_error", NAN)};
}

Maxima of_volume(const Dataset& data, const std::string& variable) {
  const Variable& v = data.at(variable);
  if (v.dimensions.size() < 2 || v.dimensions[0] != "z")
    throw DataError(variable, "is not a volume or a section on depths z");
  const std::vector<double> depths = depths_of(data), values = present_numbers(v);
  const double factor = factor_to(si_unit_of(v), v);
  const std::size_t cells = values.size() / depths.size();
  Maxima out{variable, Field(std::ssize(depths), 3), quantity_of(v), top_of(data.attributes, variable),
             data.attributes.number("stress_accurate_depth", NAN)};
  // The first principal stress is the largest one, positive in tension; others of either sign push or pull.
  out.of_magnitude = out.quantity.zero == Zero::between && variable != "stress_1";
  for (std::size_t k = 0; k < depths.size(); ++k)
    out.curve.row(static_cast<Index>(k)) << depths[k],
        factor * largest_of(&values[k * cells], cells, out.of_magnitude), NAN;
  return out;
}

Maxima maxima_of(const Case& c, const Request& request) {
  Maxima out = is_table(c.data) ? of_table(c.data) : of_volume(c.data, request.variable_or("von_mises"));
  if (!request.scale_by_hertz) return out;
  const double p0 = hertz_pressure(c.data);
  out.curve.rightCols(2) /= p0;
  out.quantity = {out.quantity.name + " / p₀", "", out.quantity.zero};
  out.top.value /= p0, out.top.value_error /= p0;
  return out;
}

void add_curves(Curves& to, const Maxima& m, std::size_t colour) {
  const Curves::Column z = m.curve.col(0), v = m.curve.col(1), half = m.curve.col(2);
  to.band(z, v - half, v + half, line_colour(colour));
  to.line(z, v, line_colour(colour));
  to.dots(z, v, line_colour(colour));
  if (std::isnan(m.top.value)) return;
  const Curves::Column depth{{m.top.depth}}, top{{m.top.value}};
  to.bars(depth, top, Curves::Column{{std::fmax(m.top.depth_error, 0)}}, "black", true);
  to.bars(depth, top, Curves::Column{{std::fmax(m.top.value_error, 0)}}, "black");
  to.add(Field{{m.top.depth, m.top.value}}, "xy",
         "with points pointtype 2 pointsize 0.7*dot linewidth 1.6 linecolor rgb 'black'");
}

// On one axis.
Quantity quantity_of(const std::vector<Maxima>& all, const Cases& cases) {
  std::vector<Quantity> each;
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (all[c].variable != all[0].variable)
      throw DataError(all[c].variable, fmt::format("of {} is not the {} of {}: draw them apart",
                                                   cases[c].label, all[0].variable, cases[0].label));
    each.push_back(all[c].quantity);
  }
  return shared(each, cases, all[0].variable);
}

std::string title_of(const Maxima& m) {
  if (std::isnan(m.top.value))
    return m.curve.col(2).isFinite().all() ? "mean over surfaces, 95 % intervals" : "";
  const auto words = [](double value, double error, const std::string& unit) {
    return in_words(Parameter{"", value, unit.empty() ? "1" : unit, error, ""});
  };
  const std::string where = m.top.depth == 0 ? "the surface" : words(m.top.depth, m.top.depth_error, "m");
  return fmt::format("{} at {} (×)", words(m.top.value, m.top.value_error, m.quantity.unit), where);
}

}  // namespace

Figure maxima(const Cases& cases, const Request& request) {
  std::vector<Maxima> all;
  Range depths = nothing;
  for (const Case& c : cases)
    depths = united(depths, range_of(all.emplace_back(maxima_of(c, request)).curve.col(0)));
  if (!(depths.width() > 0)) throw DataError("depth", "has one value: a curve needs two");
  depths = part_of(depths, request.depth, "depth-range");
  const double least = all[0].accurate;
  const bool inaccurate = depths.contains(least) && least > depths.low;
  Curves curves;
  if (inaccurate)
    curves.line(Curves::Column{{least, least}}, Curves::Column{{0, unlimited}}, "#707070", 1.1, "(8,5)");
  for (std::size_t c = 0; c < all.size(); ++c) add_curves(curves, all[c], c);
  const Range values = united({0, 0}, curves.y);
  if (!(values.magnitude() > 0)) throw DataError(all[0].quantity.name, "no layer holds a value but 0");
  const char* bar = std::ranges::any_of(all, &Maxima::of_magnitude) ? "|" : "";
  const Quantity quantity = quantity_of(all, cases);
  const Axis y = value_axis(request, values, {1.06 * values.low, 1.06 * values.high}, quantity,
                            fmt::format("largest {0}{1}{0}", bar, quantity.name));
  Figure out{.panels = {{}}};
  place(out.panels[0], curves, axis_of(depths, unit_for(depths.high, "m"), "depth z"), y);
  name_cases(out, cases);
  if (inaccurate) out.legend.push_back({LegendEntry::Key::dashes, "#707070", "accurate from here down"});
  if (all.size() == 1) out.title = title_of(all[0]);
  return out;
}

}  // namespace asperity::plot
