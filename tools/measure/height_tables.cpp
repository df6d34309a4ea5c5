#include "tools/measure/height_tables.hpp"

#include <cmath>

#include "stats/height/kernel_density.hpp"
#include "stats/height/material_ratio.hpp"
#include "tools/measure/field_options.hpp"

namespace asperity::cli {
namespace {

// NaN where errors cannot be given.
double known(const Heights& of, double error) { return of.size.gives_errors() ? error : NAN; }
double misfit(const Heights& of, double deviation, double error) {
  const double scale = known(of, error);
  return scale > 0 || std::isnan(scale) ? deviation / scale : deviation;
}

}  // namespace

Table histogram_of(const Heights& of, int bins, std::optional<HeightRange> range) {
  const std::string density = unit_to(of.surface.units, -1);
  Table out{{{"height", of.surface.units},
             {"count", "1"},
             {"standard_error", "1", Holds::unknown},
             {"gaussian", "1"},
             {"misfit", "1", Holds::unknown},
             {"density", density},
             {"density_error", density, Holds::unknown},
             {"gaussian_density", density}},
            {}};
  for (const Bin& bin : histogram(of.surface.heights, of.m, of.size, bins, range)) {
    const double per_height = 1 / (of.size.points() * bin.width()), error = known(of, bin.count_error);
    out.rows.push_back({bin.centre(), bin.count, error, bin.expected,
                        misfit(of, bin.count - bin.expected, bin.misfit_error), bin.count * per_height,
                        error * per_height, bin.expected * per_height});
  }
  return out;
}

Table density_of(const Heights& of, double bandwidth, int rows, std::optional<HeightRange> range) {
  const std::string density = unit_to(of.surface.units, -1);
  Table out{{{"height", of.surface.units},
             {"density", density},
             {"standard_error", density, Holds::unknown},
             {"gaussian_density", density},
             {"misfit", "1", Holds::unknown}},
            {}};
  for (const DensityPoint& p : kernel_density(of.surface.heights, of.m, of.size, bandwidth, rows, range))
    out.rows.push_back({p.height, p.density, known(of, p.density_error), p.gaussian,
                        misfit(of, p.density - p.gaussian, p.misfit_error)});
  return out;
}

Table quantiles_of(const Heights& of, int rows, int threads) {
  const std::string& unit = of.surface.units;
  Table out{{{"share", "1"},
             {"normal_quantile", "1"},
             {"height", unit},
             {"standard_error", unit, Holds::unknown},
             {"gaussian_height", unit},
             {"misfit", "1", Holds::unknown}},
            {}};
  const MaterialRatioCurve curve(of.surface.heights, threads);
  for (const QuantilePoint& p : quantile_plot(curve, of.m, of.size, rows))
    out.rows.push_back({p.share, p.normal, p.height, known(of, p.height_error), p.gaussian,
                        misfit(of, p.height - p.gaussian, p.misfit_error)});
  return out;
}

}  // namespace asperity::cli
