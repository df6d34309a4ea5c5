// The material ratio curve with the construction of Sk, Spk and Svk.
#include <algorithm>
#include <cmath>

#include "stats/measure/parameter.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "tools/plot/measured.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

constexpr Index pieces = 400, errors = 99;  // of the curve; shares with an interval

struct Bearing {
  CoreParameters core;
  Field curve;      ///< share [%] and height
  Field band = {};  ///< share [%] and both ends of the 95 % interval; no rows where errors are unknown

  /// The tips of the triangles.
  double peak() const { return core.upper + core.spk; }
  double dale() const { return core.lower - core.svk; }
  Range range() const {
    const Range r = range_of(curve.col(1));
    return {std::min(r.low, dale()), std::max(r.high, peak())};
  }
};

Field band_of(const Sample& sample, const MaterialRatioCurve& curve) {
  if (!sample.size().gives_errors()) return Field(0, 3);
  std::vector<double> below, heights;
  for (Index k = 0; k < errors; ++k) {
    below.push_back(1 - (static_cast<double>(k) + 0.5) / errors);
    heights.push_back(curve.quantile(below.back()));
  }
  const std::vector<Estimate> estimates = quantile_estimates(sample, below, heights);
  Field out(errors, 3);
  Index known = 0;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const Estimate& e = estimates[k];
    const Interval ends = e.interval.value_or(Interval::about(e.value, half_width_95 * e.standard_error));
    if (std::isfinite(ends.low) && std::isfinite(ends.high))
      out.row(known++) << 100 * (1 - below[k]), ends.low, ends.high;
  }
  return out.topRows(known);
}

Bearing bearing_of(const Case& c, const std::string& variable) {
  const Sample sample = measured_whole(c, variable);
  const MaterialRatioCurve curve = sample.material_ratio();
  Bearing out{curve.core(), Field(pieces + 1, 2)};
  for (Index k = 0; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    out.curve.row(k) << 100 * share, curve.height(share);
  }
  out.band = band_of(sample, curve);
  return out;
}

// Heights are divided by `unit`.
Layer in_units(Field table, double unit, const char* style) {
  table.rightCols(table.cols() - 1) /= unit;
  return points(table, style);
}

std::vector<Layer> layers_of(const Bearing& b, Range shown, double unit) {
  const auto& [sk, spk, svk, smr1, smr2, upper, lower] = b.core;
  const double first = 100 * smr1, second = 100 * smr2;
  std::vector<Layer> out;
  constexpr const char *fill = "with filledcurves closed fillcolor rgb '#f6cfae' fillstyle solid",
                       *thin = "with lines linewidth 0.8 linecolor rgb '#707070'",
                       *drop = "with lines linewidth 0.8 dashtype (2,3) linecolor rgb '#707070'";
  if (spk > 0) out.push_back(in_units(Field{{0, upper}, {0, b.peak()}, {first, upper}}, unit, fill));
  if (svk > 0) out.push_back(in_units(Field{{100, lower}, {100, b.dale()}, {second, lower}}, unit, fill));
  if (b.band.rows() > 1)
    out.push_back(
        in_units(b.band, unit, "with filledcurves fillcolor rgb '#0072b2' fillstyle transparent solid 0.25"));
  out.push_back(in_units(Field{{0, upper}, {100, upper}}, unit, thin));
  out.push_back(in_units(Field{{0, lower}, {100, lower}}, unit, thin));
  out.push_back(in_units(Field{{first, upper}, {first, shown.low}}, unit, drop));
  out.push_back(in_units(Field{{second, lower}, {second, shown.low}}, unit, drop));
  out.push_back(in_units(b.curve, unit, "with lines linewidth 1.8 linecolor rgb '#0072b2'"));
  out.push_back(in_units(Field{{0, upper}, {100, lower}}, unit,
                         "with lines linewidth 1.4 dashtype (8,5) linecolor rgb 'black'"));
  return out;
}

// Sk, Spk and Svk as lengths right of the panel.
Script lengths_of(const Bearing& b, double unit) {
  Script out;
  auto add = [&](const char* name, double from, double to) {
    if (from == to) return;
    out.line(
        "set arrow from graph 1.03,first {0} to graph 1.03,first {1} heads size screen 0.006,90 linewidth 1",
        from / unit, to / unit);
    out.line("set label {} at graph 1.05,first {} left noenhanced", gnuplot_string(name),
             0.5 * (from + to) / unit);
  };
  add("Spk", b.core.upper, b.peak());
  add("Sk", b.core.lower, b.core.upper);
  add("Svk", b.dale(), b.core.lower);
  return out;
}

// Above the axis, on the inner side of each line.
Script ratios_of(const Bearing& b) {
  Script out;
  auto add = [&](const char* name, double share, const char* side, double offset) {
    out.line("set label {} at first {},graph 0.05 {} noenhanced offset character {},0",
             gnuplot_string(fmt::format("{} = {} %", name, brief(100 * share))), 100 * share, side, offset);
  };
  add("Smr1", b.core.smr1, "left", 0.5);
  add("Smr2", b.core.smr2, "right", -0.5);
  return out;
}

std::string title_of(const CoreParameters& core, const Unit& unit) {
  return fmt::format("Sk = {}, Spk = {}, Svk = {} {}", brief(core.sk / unit.factor),
                     brief(core.spk / unit.factor), brief(core.svk / unit.factor), unit.name);
}

}  // namespace

Figure abbott(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases[0].data.at(variable));
  std::vector<Bearing> all;
  Range heights{unlimited, -unlimited};
  for (const Case& c : cases) {
    all.push_back(bearing_of(c, variable));
    heights = united(heights, all.back().range());
  }
  const double room = 0.05 * heights.width();
  heights = value_range(request, quantity.unit, {heights.low - 2 * room, heights.high + room});
  const Unit unit = unit_for(heights.magnitude(), quantity.unit);
  using enum LegendEntry::Key;
  Figure out = side_by_side(request, cases);
  if (!out.comparison) out.title = title_of(all[0].core, unit);
  const bool banded = std::ranges::any_of(all, [](const Bearing& b) { return b.band.rows() > 1; });
  out.legend = {{line, "#0072b2", in_plural(quantity) + (banded ? ", 95 % intervals" : "")},
                {dashes, "black", "core line"}};
  out.right = out.gap_x = 4;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    out.panels[c].x = {{0, 100}, "material ratio [%]"};
    out.panels[c].y = axis_of(heights, unit, above_mean(quantity));
    out.panels[c].commands = lengths_of(all[c], unit.factor);
    if (!out.comparison) out.panels[c].commands.add(ratios_of(all[c]));
    out.panels[c].layers = layers_of(all[c], heights, unit.factor);
  }
  return out;
}

}  // namespace asperity::plot
