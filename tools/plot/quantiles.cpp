// Heights against the quantiles of a Gaussian.
#include <algorithm>
#include <cmath>

#include "stats/measure/parameter.hpp"
#include "tools/plot/measured.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

constexpr int shares = 199;

struct Quantiles {
  Field points;     ///< normal quantile and height
  Field line;       ///< that of the Gaussian
  Field band = {};  ///< in which 95 % of the heights lie if they are Gaussian; no rows where it is unknown
  double effective = 0;
};

Quantiles quantiles_of(const Case& c, const std::string& variable) {
  const Sample sample = measured_whole(c, variable);
  const std::vector<QuantilePoint> plot =
      quantile_plot(sample.material_ratio(), sample.moments(), sample.size(), shares);
  const bool known = sample.size().gives_errors();
  Quantiles out{Field(shares, 2), Field(shares, 2), Field(known ? shares : 0, 3), sample.size().effective(2)};
  for (Index k = 0; const QuantilePoint& p : plot) {
    out.points.row(k) << p.normal, p.height;
    out.line.row(k) << p.normal, p.gaussian;
    const double half = half_width_95 * p.misfit_error;
    if (known) out.band.row(k) << p.normal, p.gaussian - half, p.gaussian + half;
    ++k;
  }
  return out;
}

std::vector<Layer> layers_of(const Quantiles& q, double unit) {
  std::vector<Layer> out;
  if (q.band.rows() > 0)
    out.push_back(
        in_units(q.band, unit, "with filledcurves fillcolor rgb '#d55e00' fillstyle transparent solid 0.2"));
  out.push_back(in_units(q.line, unit, "with lines linewidth 1.4 linecolor rgb '#d55e00'"));
  out.push_back(
      in_units(q.points, unit, "with points pointtype 7 pointsize 0.2*dot linecolor rgb '#10456b'"));
  return out;
}

}  // namespace

Figure qq(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases, variable);
  std::vector<Quantiles> all;
  Range heights{unlimited, -unlimited};
  for (const Case& c : cases) {
    all.push_back(quantiles_of(c, variable));
    for (const Field& f : {all.back().points, all.back().line, all.back().band})
      if (f.rows() > 0) heights = united(heights, range_of(f.rightCols(f.cols() - 1)));
  }
  const double room = 0.04 * heights.width();
  heights = value_range(request, quantity.unit, heights, {heights.low - room, heights.high + room});
  const Unit unit = unit_for(heights.magnitude(), quantity.unit);
  using enum LegendEntry::Key;
  Figure out = side_by_side(request, cases);
  const bool known = all[0].band.rows() > 0;
  if (!out.comparison)
    out.title = known ? "N_eff = " + rounded(all[0].effective)
                      : "too few independent heights for a band, N_eff = " + rounded(all[0].effective);
  out.legend = {{dot, "#10456b", in_plural(quantity)},
                {line, "#d55e00", known ? "Gaussian and 95 % band" : "Gaussian"}};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    out.panels[c].x = {{-3, 3}, "normal quantile"};
    out.panels[c].y = axis_of(heights, unit, above_mean(quantity));
    out.panels[c].layers = layers_of(all[c], unit.factor);
  }
  return out;
}

}  // namespace asperity::plot
