#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "stats/height/distribution.hpp"
#include "tools/measure/height_tables.hpp"
#include "tools/plot/curves.hpp"
#include "tools/plot/measured.hpp"

namespace asperity::plot {
namespace {

struct Distribution {
  Moments moments = {};
  std::vector<Bin> bins = {};
  double points = 0;
  std::string note = {};
  std::string part = {};  // of the cells, "393 of 12288 cells, in contact": beside no Gaussian

  double density(double count, const Bin& bin) const { return count / (points * bin.width()); }
  struct Ends {
    double low, high;
  };
  /// Of the 95 % interval of a count, which is the count itself where no error is known.
  Ends ends(const Bin& bin) const {
    const Interval& of = bin.share.interval;
    return of.known() ? Ends{points * of.low, points * of.high} : Ends{bin.count, bin.count};
  }
};

// With errors, where they can be given.
Distribution distribution_of(const Sample& sample, const HeightRange& range, int bins, double sq) {
  Distribution out{sample.moments(), histogram(sample.surface().heights, bins, range),
                   sample.size().points()};
  if (sample.size().gives_errors())
    set_errors(out.bins, sample.surface().heights, sample.grid(), sample.extent(), sq);
  return out;
}

Distribution distribution_of(const cli::CountedCells& part) {
  const HeightRange own = height_range(part.values), range{0, own.highest};
  if (!(range.highest > 0)) throw DataError(part.variable, "no value is above 0");
  Distribution out{.bins = histogram(part.values, 1, range), .points = part.counted};
  if (own.width() > 0) {
    const Sample sample(
        {.grid = part.grid, .heights = part.values, .variable = part.variable, .units = part.units});
    const int bins = scott_bins({.sq = sample.moments().sq, .sp = range.highest}, part.counted);
    out = distribution_of(sample, range, bins, 0);
  }
  out.part = fmt::format("{} of {} cells, {}", part.counted, part.cells, part.which);
  return out;
}

Distribution distribution_of(const Case& c, const std::string& variable) {
  if (const auto part = cli::counted_cells(c.data, variable)) return distribution_of(*part);
  const Sample sample({grid_of(c.data), field_of(c.data, variable, Missing::not_a_number)});
  const Field& z = sample.surface().heights;
  const Moments& m = sample.moments();
  Bins bins{scott_bins(m, sample.size().points()), height_range(z)};
  const HeightSteps steps = height_steps(z);
  if (steps.step > 0) bins = bins_on_steps(steps, bins);
  Distribution out = distribution_of(sample, bins.range, bins.number, m.sq);
  const bool few = steps.values > 1 && steps.values < 2 * Index{bins.number};
  if (few && !(steps.step > 0))
    out.note = fmt::format("{}: {} different values, in uneven steps: bins between them hold none", variable,
                           steps.values);
  return out;
}

double gaussian(const Moments& m, double z) {
  const double t = (z - m.mean) / m.sq;
  return std::exp(-0.5 * t * t) / (m.sq * std::sqrt(2 * std::numbers::pi));
}

// Intervals are boxes too, which let the histogram and the Gaussian show.
Curves boxes_of(const Distribution& d) {
  Field bars(std::ssize(d.bins), 3), ranges(std::ssize(d.bins), 6);
  for (Index k = 0; const Bin& b : d.bins) {
    const auto [low, high] = d.ends(b);
    bars.row(k) << b.centre(), d.density(b.count, b), b.width();
    ranges.row(k++) << b.centre(), d.density(b.count, b), b.lower, b.upper, d.density(low, b),
        d.density(high, b);
  }
  Curves out;
  out.add(bars, "xyX",
          "with boxes fillstyle solid 1 border linecolor rgb 'white' linewidth 0.4 fillcolor rgb '#b9d3e8'");
  out.add(ranges, "xyxxYY",
          "with boxxyerror fillstyle transparent solid 0.3 noborder fillcolor rgb '#10456b'");
  return out;
}

void add_gaussian(Curves& to, const Moments& m, Range x) {
  const Curves::Column z = Curves::Column::LinSpaced(401, x.low, x.high);
  to.line(z, z.unaryExpr([&](double at) { return gaussian(m, at); }), "#d55e00", 1.6);
}

// The interval of a bin that hardly holds heights goes on beyond.
double top_of(const std::vector<Distribution>& all, const std::vector<Curves>& curves) {
  const double peak = range_of(curves, &Curves::y).high;
  double end = 0;
  for (const Distribution& d : all)
    for (const Bin& b : d.bins) end = std::max(end, d.density(d.ends(b).high, b));
  return std::clamp(end, peak, 2 * peak);
}

// Per the unit with which its numbers are 1 to 1000.
Axis density_axis(double top, const Quantity& quantity) {
  const Unit per = unit_for(1000 / top, quantity.unit);
  return {.range = {0, 1.05 * top * per.factor},
          .label = per.name.empty() ? "density" : "density [1/" + per.name + "]",
          .unit = 1 / per.factor};
}

}  // namespace

Figure pdf(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases, variable);
  std::vector<Distribution> all;
  std::vector<Curves> curves;
  for (const Case& c : cases) curves.push_back(boxes_of(all.emplace_back(distribution_of(c, variable))));
  const Range heights = range_of(curves, &Curves::x);
  for (std::size_t c = 0; c < cases.size(); ++c)
    if (all[c].part.empty()) add_gaussian(curves[c], all[c].moments, heights);
  const Axis x = axis_of(heights, unit_for(heights.magnitude(), quantity.unit), quantity.name),
             y = density_axis(top_of(all, curves), quantity);
  const bool with_errors =
      std::ranges::any_of(all[0].bins, [](const Bin& b) { return b.share.interval.known(); });
  using enum LegendEntry::Key;
  Figure out = side_by_side(request, cases);
  const bool part = !all[0].part.empty();
  if (!out.comparison)
    out.title =
        part ? all[0].part
             : in_words(measure(measured(cases[0], variable), Group::height, {}), {"Sq", "Ssk", "Sku"});
  out.legend = {{box, "#b9d3e8", "histogram"}};
  if (with_errors) out.legend.push_back({box, "#86a8c3", "95 % intervals"});
  if (!part) out.legend.push_back({line, "#d55e00", "Gaussian"});
  for (std::size_t c = 0; c < cases.size(); ++c) {
    place(out.panels[c], curves[c], x, y);
    if (!all[c].note.empty())
      out.notes.push_back((out.comparison ? cases[c].label + ": " : "") + all[c].note);
  }
  return out;
}

}  // namespace asperity::plot
