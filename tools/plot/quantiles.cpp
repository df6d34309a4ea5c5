// Heights against the quantiles of a Gaussian.
#include "stats/measure/parameter.hpp"
#include "tools/plot/curves.hpp"
#include "tools/plot/measured.hpp"

namespace asperity::plot {
namespace {

constexpr int shares = 199;

// The band holds 95 % of the heights if they are Gaussian.
Curves quantile_curves(const Sample& sample) {
  const std::vector<QuantilePoint> plot =
      quantile_plot(sample.material_ratio(), sample.moments(), sample.size(), shares);
  const Curves::Column normal = column_of(plot, &QuantilePoint::normal),
                       gaussian = column_of(plot, &QuantilePoint::gaussian),
                       half = half_width_95 * column_of(plot, &QuantilePoint::misfit_error);
  Curves out;
  if (sample.size().gives_errors()) out.band(normal, gaussian - half, gaussian + half, "#d55e00");
  out.line(normal, gaussian, "#d55e00");
  out.dots(normal, column_of(plot, &QuantilePoint::height), "#10456b", 0.2);
  return out;
}

}  // namespace

Figure qq(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const Quantity quantity = quantity_of(cases, variable);
  std::vector<Curves> all;
  bool known = false;
  double effective = 0;
  for (const Case& c : cases) {
    const Sample sample = measured_whole(c, variable);
    all.push_back(quantile_curves(sample));
    if (all.size() == 1) known = sample.size().gives_errors(), effective = sample.size().effective(2);
  }
  const Range heights = range_of(all, &Curves::y);
  const Axis y = value_axis(request, heights, with_room(heights, 0.04, 0.04), quantity, above_mean(quantity));
  using enum LegendEntry::Key;
  Figure out = side_by_side(request, cases);
  if (!out.comparison)
    out.title =
        (known ? "N_eff = " : "too few independent heights for a band, N_eff = ") + rounded(effective);
  out.legend = {{dot, "#10456b", in_plural(quantity)},
                {line, "#d55e00", known ? "Gaussian and 95 % band" : "Gaussian"}};
  for (std::size_t c = 0; c < all.size(); ++c) place(out.panels[c], all[c], {{-3, 3}, "normal quantile"}, y);
  return out;
}

}  // namespace asperity::plot
