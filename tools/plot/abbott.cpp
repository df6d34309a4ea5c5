// The material ratio curve with the construction of Sk, Spk and Svk.
#include <algorithm>
#include <cmath>

#include "stats/measure/parameter.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "tools/plot/construction.hpp"
#include "tools/plot/measured.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

constexpr Index pieces = 400, intervals = 99;  // of the curve; shares with an interval

struct Bearing : Construction {
  Field band = {};  ///< share [%] and both ends of the 95 % interval; no rows where errors are unknown

  Range range() const {
    const Range r = range_of(curve.col(1));
    return {std::min(r.low, dale()), std::max(r.high, peak())};
  }
};

Field band_of(const Sample& sample, const MaterialRatioCurve& curve) {
  if (!sample.size().gives_errors()) return Field(0, 3);
  std::vector<double> below, heights;
  for (Index k = 0; k < intervals; ++k) {
    below.push_back(1 - (static_cast<double>(k) + 0.5) / intervals);
    heights.push_back(curve.quantile(below.back()));
  }
  const std::vector<Estimate> estimates = quantile_estimates(sample, below, heights);
  Field out(intervals, 3);
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
  Bearing out{{curve.core(), Field(pieces + 1, 2)}};
  for (Index k = 0; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    out.curve.row(k) << 100 * share, curve.height(share);
  }
  out.band = band_of(sample, curve);
  return out;
}

std::vector<Layer> layers_of(const Bearing& b, Range shown, double unit) {
  const double spk = b.core.spk, svk = b.core.svk, upper = b.core.upper, lower = b.core.lower,
               first = 100 * b.core.smr1, second = 100 * b.core.smr2;
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

std::string title_of(const CoreParameters& core, const Unit& unit) {
  return fmt::format("Sk = {}, Spk = {}, Svk = {} {}", brief(core.sk / unit.factor),
                     brief(core.spk / unit.factor), brief(core.svk / unit.factor), unit.name);
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
  if (!out.comparison) out.title = title_of(all[0].core, unit);
  const bool banded = std::ranges::any_of(all, [](const Bearing& b) { return b.band.rows() > 1; });
  out.legend = {{line, "#0072b2", in_plural(quantity) + (banded ? ", 95 % intervals" : "")},
                {dashes, "black", "core line"}};
  out.right = out.gap_x = 4;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    out.panels[c].x = {{0, 100}, "material ratio [%]"};
    out.panels[c].y = axis_of(heights, unit, above_mean(quantity));
    out.panels[c].layers = layers_of(all[c], heights, unit.factor);
  }
  const Layout layout = layout_of(out, request);
  for (std::size_t c = 0; c < cases.size(); ++c) add_labels(out, c, all[c], heights, layout);
  return out;
}

}  // namespace asperity::plot
