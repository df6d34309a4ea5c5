#include <algorithm>
#include <cmath>
#include <span>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/spatial/acf_length.hpp"
#include "tools/plot/series.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

struct Point {
  double lag;  ///< in metres, or in samples if the spacing is unknown
  double rho, error = 0;
};
using Curve = std::vector<Point>;

// Both profiles of a case: the target and the curve compared with it.
struct Profiles {
  Curve target[2], found[2];  ///< along x, along y
  bool estimated = false;     ///< from the heights; otherwise from the kernel
  bool with_errors = false;   ///< standard errors are known
  bool in_metres = true;
};

// The lags of a dimension in metres, or in samples if the spacing is unknown.
std::vector<double> lags_of(const Dataset& data, const char* name, bool& in_metres) {
  const Variable& axis = data.at(name);
  if (const auto metres = asperity::lags_of(axis)) return *metres;
  std::vector<double> lags = numbers(axis.values);
  in_metres = in_metres && data.has("x");
  if (data.has("x"))
    for (double& lag : lags) lag *= name[0] == 'p' ? grid_of(data).dx : grid_of(data).dy;
  return lags;
}

Index zero_of(const std::vector<double>& lags, const char* name) {
  const auto at = std::ranges::min_element(lags, {}, [](double lag) { return std::abs(lag); });
  const double step = lags.size() > 1 ? std::abs(lags[1] - lags[0]) : 1;
  if (at == lags.end() || !(std::abs(*at) <= 1e-6 * step)) throw DataError(name, "lag 0 is missing");
  return at - lags.begin();
}

// The profiles of a function over the half-plane of lags, divided by its value at lag zero.
void read_profiles(const Dataset& data, const char* name, Curve (&curves)[2], bool& in_metres) {
  const Field table = table_of(data, name, "", Missing::not_a_number);
  const std::vector<double> p = lags_of(data, "p", in_metres), q = lags_of(data, "q", in_metres);
  const Index p0 = zero_of(p, "p"), q0 = zero_of(q, "q");
  auto add = [&](Curve& curve, double lag, double value) {
    if (!std::isnan(value)) curve.push_back({lag, value / table(p0, q0)});  // NaN: beyond the target's table
  };
  for (Index i = p0; i < table.rows(); ++i) add(curves[0], p[static_cast<std::size_t>(i)], table(i, q0));
  for (Index j = q0; j < table.cols(); ++j) add(curves[1], q[static_cast<std::size_t>(j)], table(p0, j));
}

// Without a target, four 10 % lengths show the whole decay.
double lag_worth_showing(const Profiles& profiles, const LagField& rho, const Grid& grid) {
  if (!profiles.target[0].empty())
    return 1.25 * std::max(profiles.target[0].back().lag, profiles.target[1].back().lag);
  const auto x = first_crossing(rho.along_x(), 0.1), y = first_crossing(rho.along_y(), 0.1);
  return x && y ? 4 * std::max(x->lag * grid.dx, y->lag * grid.dy) : unlimited;
}

void estimate_profiles(const Dataset& data, Profiles& profiles) {
  const Grid grid = grid_of(data);
  const Field z = field_of(data, "heights", Missing::not_a_number);
  const Surface surface{.grid = grid, .heights = remove_form(z)};
  const AcfEstimate estimate = AcfEstimate::of(surface, {.max_lag = default_max_lag(grid)});
  const LagField& rho = estimate.rho;
  profiles.with_errors = estimate.size.gives_errors();
  const double most = lag_worth_showing(profiles, rho, grid);
  const double steps[] = {grid.dx, grid.dy};
  const Index last[] = {rho.max_p(), rho.max_q()};
  for (std::size_t d = 0; d < 2; ++d) {
    const Eigen::ArrayXd errors = profile_errors(estimate, surface.heights, d == 0, false).acf;
    for (Index k = 0; k <= last[d] && static_cast<double>(k) * steps[d] <= most; ++k)
      profiles.found[d].push_back({static_cast<double>(k) * steps[d], d == 0 ? rho(k, 0) : rho(0, k),
                                   profiles.with_errors ? errors(k) : 0});
  }
  profiles.estimated = true;
}

bool drawable(const Curve& curve) {
  for (std::size_t k = 1; k < curve.size(); ++k)
    if (std::isfinite(curve[k - 1].rho) && std::isfinite(curve[k].rho)) return true;
  return false;
}

Profiles profiles_of(const Case& c) {
  Profiles out;
  if (c.data.has("acf_target")) read_profiles(c.data, "acf_target", out.target, out.in_metres);
  if (c.data.has("heights"))
    estimate_profiles(c.data, out);
  else
    read_profiles(c.data, "acf_achieved", out.found, out.in_metres);
  if (!drawable(out.found[0]) && !drawable(out.found[1]))
    throw DataError(
        out.estimated ? "heights" : "acf_achieved",
        "the autocorrelation is known at no two neighbouring lags: measure a denser field, or draw "
        "a map");
  return out;
}

// Bands of ± 2 standard errors first, then the curves, the target on top.
void add_curves(Series to, const Profiles& profiles) {
  const auto lags = [](const Curve& c) { return column_of(c, [](const Point& p) { return p.lag; }); };
  const auto at = [](const Curve& c, int errors) {
    return column_of(c, [&](const Point& p) { return p.rho + errors * p.error; });
  };
  for (std::size_t d = 0; d < 2 && profiles.with_errors; ++d)
    to.band(lags(profiles.found[d]), at(profiles.found[d], -2), at(profiles.found[d], 2), line_colour(d),
            0.18);
  for (std::size_t d = 0; d < 2; ++d)
    to.line(lags(profiles.found[d]), at(profiles.found[d], 0), line_colour(d), 1.6);
  for (const Curve& target : profiles.target) to.line(lags(target), at(target, 0), "black", 1.2, "(8,5)");
}

// Of what is drawn in any panel.
std::vector<LegendEntry> legend(const std::vector<Profiles>& all) {
  using enum LegendEntry::Key;
  std::vector<LegendEntry> out;
  for (std::size_t d = 0; d < 2; ++d)
    if (std::ranges::any_of(all, [&](const Profiles& p) { return drawable(p.found[d]); }))
      out.push_back({line, line_colour(d), d == 0 ? "along x" : "along y"});
  if (std::ranges::any_of(all, [](const Profiles& p) { return !p.target[0].empty(); }))
    out.push_back({dashes, "black", "target"});
  return out;
}

const char* words_of(const Profiles& p) {
  return !p.estimated    ? "kernel"
         : p.with_errors ? "surface ± 2 standard errors"
                         : "surface, too few independent heights for errors";
}

// A line within the range joins two of a curve's points there.
void require_two(const std::vector<Profiles>& all, Range lags) {
  for (const Profiles& p : all)
    for (const Curve& curve : p.found)
      if (std::ranges::count_if(curve, [&](const Point& at) { return lags.contains(at.lag); }) > 1) return;
  throw ParameterError("x-range", "contains no two lags of a curve: widen it");
}

}  // namespace

Figure acf(const Cases& cases, const Request& request) {
  std::vector<Profiles> all;
  double longest = 0, lowest = 0;
  for (const Case& c : cases) {
    all.push_back(profiles_of(c));
    for (const auto& curves : {std::span(all.back().found), std::span(all.back().target)})
      for (const Curve& curve : curves)
        for (const Point& p : curve) lowest = std::min(lowest, p.rho - 2 * p.error);
    for (const Curve& curve : all.back().found)  // a target may go on beyond
      if (!curve.empty()) longest = std::max(longest, curve.back().lag);
  }
  for (std::size_t c = 1; c < all.size(); ++c)
    if (all[c].in_metres != all[0].in_metres)
      throw DataError("lags", fmt::format("are in metres in one of {} and {}, and in samples in the other: "
                                          "draw them apart",
                                          cases[0].label, cases[c].label));
  const Range lags = part_of({0, longest}, request.x, "x-range");
  require_two(all, lags);
  const Unit length = all[0].in_metres ? unit_for(lags.high, "m") : Unit{1, "samples"};
  Figure out = side_by_side(request, cases);
  const std::string first = words_of(all[0]);
  const bool alike = std::ranges::all_of(all, [&](const Profiles& p) { return words_of(p) == first; });
  if (alike) out.title = first;
  out.legend = legend(all);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Panel& panel = out.panels[c];
    if (!alike) panel.label += std::string(", ") + words_of(all[c]);
    panel.x = axis_of(lags, length, "lag");
    panel.y = {{lowest < 0 ? std::floor(lowest * 10 - 0.2) / 10 : 0, 1.04}, "autocorrelation ρ"};
    panel.commands.line("set xzeroaxis linewidth 0.6 linecolor rgb '#808080'");
    add_curves({panel, length.factor, 1}, all[c]);
  }
  return out;
}

}  // namespace asperity::plot
