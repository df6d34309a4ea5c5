// The material ratio curve with the construction of Sk, Spk and Svk.
#include <algorithm>
#include <cmath>

#include "stats/measure/parameter.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "tools/plot/curves.hpp"
#include "tools/plot/layout.hpp"
#include "tools/plot/measured.hpp"

namespace asperity::plot {
namespace {

constexpr Index pieces = 400, intervals = 99;  // of the curve; shares with an interval
constexpr double line_height = 1.3;            // [em]

struct Bearing {
  CoreParameters core;
  Parameters parameters;
  Curves curves = {};
  bool banded = false;

  /// The tips of the triangles.
  double peak() const { return core.upper + core.spk; }
  double dale() const { return core.lower - core.svk; }
};

using Numbers = Curves::Column;
Numbers both(double a, double b) { return Numbers{{a, b}}; }

// 95 % intervals of the curve, cut off by the axes.
void add_band(Bearing& to, const Sample& sample, const MaterialRatioCurve& curve) {
  const Numbers share = (Numbers::LinSpaced(intervals, 0, intervals - 1) + 0.5) / intervals,
                below = 1 - share, heights = below.unaryExpr([&](double at) { return curve.quantile(at); });
  const std::vector<Estimate> all =
      quantile_estimates(sample, {below.begin(), below.end()}, {heights.begin(), heights.end()});
  const auto interval = [](const Estimate& e) {
    return e.interval.value_or(Interval::about(e.value, half_width_95 * e.standard_error));
  };
  const Numbers low = column_of(all, [&](const Estimate&e) { return interval(e).low; }),
                high = column_of(all, [&](const Estimate&e) { return interval(e).high; });
  to.banded = (low.isFinite() && high.isFinite()).count() > 1;
  to.curves.band(share, low, high, "#0072b2", 0.25, false);
}

Bearing bearing_of(const Case& c, const std::string& variable) {
  const Sample sample = measured_whole(c, variable);
  const MaterialRatioCurve curve = sample.material_ratio();
  Bearing out{curve.core(), measure(sample, Group::material, {})};
  const double upper = out.core.upper, lower = out.core.lower, first = out.core.smr1, second = out.core.smr2;
  const char* fill = "with filledcurves closed fillcolor rgb '#f6cfae' fillstyle solid";
  const std::string grey = "#707070", blue = "#0072b2";
  Curves& to = out.curves;
  if (out.core.spk > 0) to.add(Field{{0, upper}, {0, out.peak()}, {first, upper}}, "xy", fill);
  if (out.core.svk > 0) to.add(Field{{1, lower}, {1, out.dale()}, {second, lower}}, "xy", fill);
  if (sample.size().gives_errors()) add_band(out, sample, curve);
  for (const double end : {upper, lower}) to.line(both(0, 1), both(end, end), grey, 0.8);
  for (const auto& [share, end] : {std::pair{first, upper}, {second, lower}})
    to.line(both(share, share), both(end, -unlimited), grey, 0.8, "(2,3)");
  const Numbers share = Numbers::LinSpaced(pieces + 1, 0, 1);
  to.line(share, share.unaryExpr([&](double at) { return curve.height(at); }), blue, 1.8);
  to.line(both(0, 1), both(upper, lower), "black", 1.4, "(8,5)");
  return out;
}

// Ratios, as the axis has them.
Parameters in_percent(Parameters all) {
  for (Parameter& p : all) p.value *= 100, p.standard_error *= 100, p.unit = "%";
  return all;
}

// The lengths Spk, Sk, Svk stand right of the panel, each at the middle of its arrow, or so far off that
// their names are clear of each other. A panel of this height [em] that is too low for all has Sk alone.
void add_lengths(Script& script, const Bearing& b, const Axis& y, double height) {
  const auto place = [&](double z) {
    return std::clamp((z / y.unit - y.range.low) / y.range.width(), 0.0, 1.0);
  };
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
  Range heights = nothing;
  for (const Case& c : cases) heights = united(heights, all.emplace_back(bearing_of(c, variable)).curves.y);
  const Axis y = value_axis(request, heights, with_room(heights, 0.1, 0.05), quantity, above_mean(quantity));
  using enum LegendEntry::Key;
  Figure out = side_by_side(request, cases);
  if (!out.comparison) out.title = in_words(all[0].parameters, {"Sk", "Spk", "Svk"});
  const bool banded = std::ranges::any_of(all, &Bearing::banded);
  out.legend = {{line, "#0072b2", in_plural(quantity) + (banded ? ", 95 % intervals" : "")},
                {dashes, "black", "core line"}};
  out.right = out.gap_x = 4;
  for (std::size_t c = 0; c < cases.size(); ++c)
    place(out.panels[c], all[c].curves, {.range = {0, 100}, .label = "material ratio [%]", .unit = 0.01}, y);
  if (!out.comparison) add_note(out, 0, in_words(in_percent(all[0].parameters), {"Smr1", "Smr2"}));
  const Layout layout = layout_of(out, request);
  for (std::size_t c = 0; c < cases.size(); ++c)
    add_lengths(out.panels[c].commands, all[c], y, layout.panel_height / layout.em);
  return out;
}

}  // namespace asperity::plot
