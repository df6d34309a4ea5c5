// The material ratio curve with the construction of Sk, Spk and Svk.
#include <algorithm>
#include <cmath>

#include "stats/measure/parameter.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "tools/plot/layout.hpp"
#include "tools/plot/measured.hpp"
#include "tools/plot/series.hpp"

namespace asperity::plot {
namespace {

constexpr Index pieces = 400, intervals = 99;  // of the curve; shares with an interval
constexpr double line_height = 1.3;            // [em]

struct Bearing {
  CoreParameters core;
  Parameters parameters;
  Series::Column share, height;                 ///< the curve
  Series::Column at = {}, low = {}, high = {};  ///< 95 % intervals, NaN where they are unknown

  /// The tips of the triangles.
  double peak() const { return core.upper + core.spk; }
  double dale() const { return core.lower - core.svk; }
  bool banded() const { return (low.isFinite() && high.isFinite()).count() > 1; }
  Range range() const { return {std::min(height.minCoeff(), dale()), std::max(height.maxCoeff(), peak())}; }
};

void add_intervals(Bearing& to, const Sample& sample, const MaterialRatioCurve& curve) {
  if (!sample.size().gives_errors()) return;
  std::vector<double> below, heights;
  for (Index k = 0; k < intervals; ++k) {
    below.push_back(1 - (static_cast<double>(k) + 0.5) / intervals);
    heights.push_back(curve.quantile(below.back()));
  }
  const auto interval = [](const Estimate& e) {
    return e.interval.value_or(Interval::about(e.value, half_width_95 * e.standard_error));
  };
  const std::vector<Estimate> all = quantile_estimates(sample, below, heights);
  to.at = column_of(below, [](double share) { return 1 - share; });
  to.low = column_of(all, [&](const Estimate& e) { return interval(e).low; });
  to.high = column_of(all, [&](const Estimate& e) { return interval(e).high; });
}

Bearing bearing_of(const Case& c, const std::string& variable) {
  const Sample sample = measured_whole(c, variable);
  const MaterialRatioCurve curve = sample.material_ratio();
  Bearing out{curve.core(), measure(sample, Group::material, {}), Series::Column(pieces + 1),
              Series::Column(pieces + 1)};
  for (Index k = 0; k <= pieces; ++k) {
    out.share(k) = static_cast<double>(k) / pieces;
    out.height(k) = curve.height(out.share(k));
  }
  add_intervals(out, sample, curve);
  return out;
}

// Ratios, as the axis has them.
Parameters in_percent(Parameters all) {
  for (Parameter& p : all) p.value *= 100, p.standard_error *= 100, p.unit = "%";
  return all;
}

using Numbers = Series::Column;
Numbers both(double a, double b) { return Numbers{{a, b}}; }

void add_curves(Series to, const Bearing& b, Range shown) {
  const double upper = b.core.upper, lower = b.core.lower, first = b.core.smr1, second = b.core.smr2;
  const char* fill = "with filledcurves closed fillcolor rgb '#f6cfae' fillstyle solid";
  const std::string grey = "#707070", blue = "#0072b2";
  if (b.core.spk > 0) to.add(Numbers{{0, 0, first}}, Numbers{{upper, b.peak(), upper}}, fill);
  if (b.core.svk > 0) to.add(Numbers{{1, 1, second}}, Numbers{{lower, b.dale(), lower}}, fill);
  to.band(b.at, b.low.max(shown.low), b.high.min(shown.high), blue, 0.25);
  for (const double end : {upper, lower}) to.line(both(0, 1), both(end, end), grey, 0.8);
  to.line(both(first, first), both(upper, shown.low), grey, 0.8, "(2,3)");
  to.line(both(second, second), both(lower, shown.low), grey, 0.8, "(2,3)");
  to.line(b.share, b.height, blue, 1.8);
  to.line(both(0, 1), both(upper, lower), "black", 1.4, "(8,5)");
}

// The lengths Spk, Sk, Svk stand right of the panel, each at the middle of its arrow, or so far off that
// their names are clear of each other. A panel of this height [em] that is too low for all has Sk alone.
void add_lengths(Script& script, const Bearing& b, Range shown, double height) {
  const auto place = [&](double z) { return std::clamp((z - shown.low) / shown.width(), 0.0, 1.0); };
  const double apart = line_height / height, ends = std::min(0.5, 1.5 * apart),
               core = std::clamp(0.5 * (place(b.core.upper) + place(b.core.lower)), ends, 1 - ends);
  const struct {
    const char* name;
    Range of;
    double least, most;
  } lengths[] = {{"Spk", {b.core.upper, b.peak()}, core + apart, 1 - 0.5 * apart},
                 {"Sk", {b.core.lower, b.core.upper}, core, core},
                 {"Svk", {b.dale(), b.core.lower}, 0.5 * apart, core - apart}};
  for (const auto& [name, of, least, most] : lengths) {
    const double low = place(of.low), high = place(of.high);
    if (!(low < high) || least > most) continue;
    script.line(
        "set arrow from graph 1.03,graph {} to graph 1.03,graph {} heads size screen 0.006,90 linewidth 1",
        low, high);
    script.line("set label {} at graph 1.05,graph {} left noenhanced", gnuplot_string(name),
                std::clamp(0.5 * (low + high), least, most));
  }
}

}  // namespace

Figure abbott(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases, variable);
  std::vector<Bearing> all;
  Range heights{unlimited, -unlimited};
  for (const Case& c : cases) {
    all.push_back(bearing_of(c, variable));
    heights = united(heights, all.back().range());
  }
  const double room = 0.05 * heights.width();
  heights = value_range(request, quantity.unit, heights, {heights.low - 2 * room, heights.high + room});
  const Unit unit = unit_for(heights.magnitude(), quantity.unit);
  using enum LegendEntry::Key;
  Figure out = side_by_side(request, cases);
  if (!out.comparison) out.title = in_words(all[0].parameters, {"Sk", "Spk", "Svk"});
  const bool banded = std::ranges::any_of(all, &Bearing::banded);
  out.legend = {{line, "#0072b2", in_plural(quantity) + (banded ? ", 95 % intervals" : "")},
                {dashes, "black", "core line"}};
  out.right = out.gap_x = 4;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    out.panels[c].x = {{0, 100}, "material ratio [%]"};
    out.panels[c].y = axis_of(heights, unit, above_mean(quantity));
    add_curves({out.panels[c], 0.01, unit.factor}, all[c], heights);
  }
  if (!out.comparison) add_note(out, 0, in_words(in_percent(all[0].parameters), {"Smr1", "Smr2"}));
  const Layout layout = layout_of(out, request);
  for (std::size_t c = 0; c < cases.size(); ++c)
    add_lengths(out.panels[c].commands, all[c], heights, layout.panel_height / layout.em);
  return out;
}

}  // namespace asperity::plot
