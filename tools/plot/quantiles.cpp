// Heights against the quantiles of a Gaussian.
#include <algorithm>
#include <cmath>

#include "stats/measure/parameter.hpp"
#include "tools/plot/measured.hpp"
#include "tools/plot/series.hpp"

namespace asperity::plot {
namespace {

constexpr int shares = 199;

struct Quantiles {
  Series::Column normal, heights, gaussian;
  Series::Column half;  ///< of the band in which 95 % of the heights lie if they are Gaussian; NaN: unknown
  double effective = 0;

  bool known() const { return half.isFinite().any(); }
  Range range() const {
    Field all(normal.size(), 4);
    all << heights, gaussian, gaussian - half, gaussian + half;
    return range_of(all);
  }
};

Quantiles quantiles_of(const Case& c, const std::string& variable) {
  const Sample sample = measured_whole(c, variable);
  const std::vector<QuantilePoint> plot =
      quantile_plot(sample.material_ratio(), sample.moments(), sample.size(), shares);
  const double widths = sample.size().gives_errors() ? half_width_95 : NAN;
  return {column_of(plot, [](const QuantilePoint& p) { return p.normal; }),
          column_of(plot, [](const QuantilePoint& p) { return p.height; }),
          column_of(plot, [](const QuantilePoint& p) { return p.gaussian; }),
          column_of(plot, [&](const QuantilePoint& p) { return widths * p.misfit_error; }),
          sample.size().effective(2)};
}

void add_curves(Series to, const Quantiles& q) {
  to.band(q.normal, q.gaussian - q.half, q.gaussian + q.half, "#d55e00");
  to.line(q.normal, q.gaussian, "#d55e00");
  to.dots(q.normal, q.heights, "#10456b", 0.2);
}

}  // namespace

Figure qq(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases, variable);
  std::vector<Quantiles> all;
  Range heights{unlimited, -unlimited};
  for (const Case& c : cases) {
    all.push_back(quantiles_of(c, variable));
    heights = united(heights, all.back().range());
  }
  const double room = 0.04 * heights.width();
  heights = value_range(request, quantity.unit, heights, {heights.low - room, heights.high + room});
  const Unit unit = unit_for(heights.magnitude(), quantity.unit);
  using enum LegendEntry::Key;
  Figure out = side_by_side(request, cases);
  const bool known = all[0].known();
  if (!out.comparison)
    out.title = known ? "N_eff = " + rounded(all[0].effective)
                      : "too few independent heights for a band, N_eff = " + rounded(all[0].effective);
  out.legend = {{dot, "#10456b", in_plural(quantity)},
                {line, "#d55e00", known ? "Gaussian and 95 % band" : "Gaussian"}};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    out.panels[c].x = {{-3, 3}, "normal quantile"};
    out.panels[c].y = axis_of(heights, unit, above_mean(quantity));
    add_curves({out.panels[c], 1, unit.factor}, all[c]);
  }
  return out;
}

}  // namespace asperity::plot
