#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "stats/height/distribution.hpp"
#include "tools/measure/height_tables.hpp"
#include "tools/plot/measured.hpp"
#include "tools/plot/series.hpp"

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

struct Scales {
  Unit height, per;  ///< of the axis; the density is per `per`, so that its numbers are 1 to 1000
  Range x;           ///< in SI
  double top;        ///< of the density, per unit of height
};

Scales scales_of(const std::vector<Distribution>& all, const Quantity& quantity) {
  Range x{unlimited, -unlimited};
  double peak = 0, end = 0;  // of the densities, and of their intervals
  for (const Distribution& d : all) {
    x = united(x, {d.bins.front().lower, d.bins.back().upper});
    if (d.part.empty()) peak = std::max(peak, gaussian(d.moments, d.moments.mean));
    for (const Bin& b : d.bins) {
      peak = std::max(peak, d.density(b.count, b));
      end = std::max(end, d.density(d.ends(b).high, b));
    }
  }
  peak = std::clamp(end, peak, 2 * peak);  // the interval of a bin that hardly holds heights goes on beyond
  const Unit height = unit_for(x.magnitude(), quantity.unit), per = unit_for(1000 / peak, quantity.unit);
  return {height, per, x, 1.05 * peak * per.factor};
}

// Intervals are boxes too, which let the histogram and the Gaussian show.
void add_curves(Panel& panel, const Distribution& d, const Scales& scales) {
  constexpr int samples = 400;
  const double height = scales.height.factor, per = scales.per.factor;
  Field bars(std::ssize(d.bins), 3), ranges(std::ssize(d.bins), 6);
  for (Index k = 0; const Bin& b : d.bins) {
    const auto [low, high] = d.ends(b);
    bars.row(k) << b.centre() / height, d.density(b.count, b) * per, b.width() / height;
    ranges.row(k++) << b.centre() / height, d.density(b.count, b) * per, b.lower / height, b.upper / height,
        d.density(low, b) * per, d.density(high, b) * per;
  }
  panel.layers = {
      points(bars,
             "with boxes fillstyle solid 1 border linecolor rgb 'white' linewidth 0.4 fillcolor rgb "
             "'#b9d3e8'"),
      points(ranges,
             "with boxxyerror fillstyle transparent solid 0.3 noborder fillcolor rgb "
             "'#10456b'")};
  const Series::Column z = Series::Column::LinSpaced(samples + 1, scales.x.low, scales.x.high);
  if (d.part.empty())
    Series(panel, height, 1 / per)
        .line(z, z.unaryExpr([&](double at) { return gaussian(d.moments, at); }), "#d55e00", 1.6);
}

}  // namespace

Figure pdf(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases, variable);
  std::vector<Distribution> all;
  for (const Case& c : cases) all.push_back(distribution_of(c, variable));
  const Scales scales = scales_of(all, quantity);
  const bool with_errors =
      std::ranges::any_of(all[0].bins, [](const Bin& b) { return b.share.interval.known(); });
  const std::string& per = scales.per.name;
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
    out.panels[c].x = axis_of(scales.x, scales.height, quantity.name);
    out.panels[c].y = {{0, scales.top}, per.empty() ? "density" : "density [1/" + per + "]"};
    add_curves(out.panels[c], all[c], scales);
    if (!all[c].note.empty())
      out.notes.push_back((out.comparison ? cases[c].label + ": " : "") + all[c].note);
  }
  return out;
}

}  // namespace asperity::plot
