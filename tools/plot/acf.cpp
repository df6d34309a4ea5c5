#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/spatial/acf_length.hpp"
#include "tools/plot/curves.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

using Column = Curves::Column;
constexpr Range everywhere{-unlimited, unlimited};

// Along x or along y, from lag zero; lags in metres, or in samples if the spacing is unknown.
struct Profile {
  Column lag = {}, rho = {}, error = {};

  double end() const { return lag.size() > 0 ? lag(lag.size() - 1) : 0; }
  /// Whether a line joins two of its points within the range.
  bool drawn_in(Range range) const {
    const auto there = rho.isFinite() && lag >= range.low && lag <= range.high;
    return (there.head(std::max<Index>(there.size() - 1, 0)) &&
            there.tail(std::max<Index>(there.size() - 1, 0)))
        .any();
  }
};
// Both of a case: the target and the curve compared with it.
struct Profiles {
  Profile target[2], found[2];
  bool estimated = false;    ///< from the heights; otherwise from the kernel
  bool with_errors = false;  ///< standard errors are known
  bool in_metres = true;
};

Column lags_of(const Dataset& data, const char* name, bool& in_metres) {
  const Variable& axis = data.at(name);
  const auto metres = asperity::lags_of(axis);
  const std::vector<double> lags = metres ? *metres : numbers(axis.values);
  const Column out = Eigen::Map<const Column>(lags.data(), std::ssize(lags));
  if (metres) return out;
  in_metres = in_metres && data.has("x");
  return data.has("x") ? Column(out * (name[0] == 'p' ? grid_of(data).dx : grid_of(data).dy)) : out;
}

Index zero_of(const Column& lags, const char* name) {
  Index at = 0;
  const double step = lags.size() > 1 ? std::abs(lags(1) - lags(0)) : 1;
  if (lags.size() == 0 || !(lags.abs().minCoeff(&at) <= 1e-6 * step))
    throw DataError(name, "lag 0 is missing");
  return at;
}

// Of a function over the half-plane of lags, divided by its value at lag zero; NaN is beyond its table.
void read_profiles(const Dataset& data, const char* name, Profile (&out)[2], bool& in_metres) {
  const Field table = table_of(data, name, "", Missing::not_a_number);
  const Column p = lags_of(data, "p", in_metres), q = lags_of(data, "q", in_metres);
  const Index p0 = zero_of(p, "p"), q0 = zero_of(q, "q");
  const auto from_zero = [&](const Column& lags, const Column& values, Index zero) {
    const Index n = (values.tail(lags.size() - zero).isFinite()).count();
    return Profile{lags.segment(zero, n), values.segment(zero, n) / table(p0, q0), Column::Zero(n)};
  };
  out[0] = from_zero(p, table.col(q0), p0);
  out[1] = from_zero(q, table.row(p0), q0);
}

// Without a target, four 10 % lengths show the whole decay.
double lag_worth_showing(const Profiles& profiles, const LagField& rho, const Grid& grid) {
  if (const double end = std::max(profiles.target[0].end(), profiles.target[1].end()); end > 0)
    return 1.25 * end;
  const auto x = first_crossing(rho.along_x(), 0.1), y = first_crossing(rho.along_y(), 0.1);
  return x && y ? 4 * std::max(x->lag * grid.dx, y->lag * grid.dy) : unlimited;
}

void estimate_profiles(const Dataset& data, Profiles& profiles) {
  const Grid grid = grid_of(data);
  const Field z = field_of(data, "heights", Missing::not_a_number);
  const Surface surface{.grid = grid, .heights = remove_form(z)};
  const AcfEstimate estimate = AcfEstimate::of(surface, {.max_lag = default_max_lag(grid)});
  profiles.estimated = true;
  profiles.with_errors = estimate.size.gives_errors();
  const double most = lag_worth_showing(profiles, estimate.rho, grid);
  for (const bool along_x : {true, false}) {
    const Column rho = along_x ? estimate.rho.along_x() : estimate.rho.along_y(),
                 lags = Column::LinSpaced(rho.size(), 0, static_cast<double>(rho.size() - 1)) *
                        (along_x ? grid.dx : grid.dy);
    const Index n = (lags <= most).count();
    Column errors = Column::Zero(rho.size());
    if (profiles.with_errors) errors = profile_errors(estimate, surface.heights, along_x, false).acf;
    profiles.found[along_x ? 0 : 1] = {lags.head(n), rho.head(n), errors.head(n)};
  }
}

Profiles profiles_of(const Case& c) {
  Profiles out;
  if (c.data.has("acf_target")) read_profiles(c.data, "acf_target", out.target, out.in_metres);
  if (c.data.length("x") == 1) out.target[0] = {};
  if (c.data.length("y") == 1) out.target[1] = {};
  if (c.data.has("heights"))
    estimate_profiles(c.data, out);
  else
    read_profiles(c.data, "acf_achieved", out.found, out.in_metres);
  if (!out.found[0].drawn_in(everywhere) && !out.found[1].drawn_in(everywhere))
    throw DataError(
        out.estimated ? "heights" : "acf_achieved",
        "the autocorrelation is known at no two neighbouring lags: measure a denser field, or draw "
        "a map");
  return out;
}

// Bands of ± 2 standard errors first, then the curves, the target on top.
Curves curves_of(const Profiles& profiles) {
  Curves out;
  for (std::size_t d = 0; d < 2 && profiles.with_errors; ++d) {
    const auto& [lag, rho, error] = profiles.found[d];
    out.band(lag, rho - 2 * error, rho + 2 * error, line_colour(d), 0.18);
  }
  for (std::size_t d = 0; d < 2; ++d)
    out.line(profiles.found[d].lag, profiles.found[d].rho, line_colour(d), 1.6);
  for (const Profile& target : profiles.target) out.line(target.lag, target.rho, "black", 1.2, "(8,5)");
  return out;
}

// Of what is drawn in any panel.
std::vector<LegendEntry> legend(const std::vector<Profiles>& all) {
  using enum LegendEntry::Key;
  std::vector<LegendEntry> out;
  for (std::size_t d = 0; d < 2; ++d)
    if (std::ranges::any_of(all, [&](const Profiles& p) { return p.found[d].drawn_in(everywhere); }))
      out.push_back({line, line_colour(d), d == 0 ? "along x" : "along y"});
  if (std::ranges::any_of(all, [](const Profiles& p) { return p.target[0].end() + p.target[1].end() > 0; }))
    out.push_back({dashes, "black", "target"});
  return out;
}

const char* words_of(const Profiles& p) {
  return !p.estimated    ? "kernel"
         : p.with_errors ? "surface ± 2 standard errors"
                         : "surface, too few independent heights for errors";
}

}  // namespace

Figure acf(const Cases& cases, const Request& request) {
  std::vector<Profiles> all;
  std::vector<Curves> curves;
  double longest = 0;
  for (const Case& c : cases) {
    curves.push_back(curves_of(all.emplace_back(profiles_of(c))));
    for (const Profile& found : all.back().found)  // a target may go on beyond
      longest = std::max(longest, found.end());
  }
  for (std::size_t c = 1; c < all.size(); ++c)
    if (all[c].in_metres != all[0].in_metres)
      throw DataError("lags", fmt::format("are in metres in one of {} and {}, and in samples in the other: "
                                          "draw them apart",
                                          cases[0].label, cases[c].label));
  const Range lags = part_of({0, longest}, request.x, "x-range");
  if (std::ranges::none_of(
          all, [&](const Profiles& p) { return p.found[0].drawn_in(lags) || p.found[1].drawn_in(lags); }))
    throw ParameterError("x-range", "contains no two lags of a curve: widen it");
  const Unit length = all[0].in_metres ? unit_for(lags.high, "m") : Unit{1, "samples"};
  const double lowest = range_of(curves, &Curves::y).low;
  const Axis rho{{lowest < 0 ? std::floor(lowest * 10 - 0.2) / 10 : 0, 1.04}, "autocorrelation ρ"};
  Figure out = side_by_side(request, cases);
  const std::string first = words_of(all[0]);
  const bool alike = std::ranges::all_of(all, [&](const Profiles& p) { return words_of(p) == first; });
  if (alike) out.title = first;
  out.legend = legend(all);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Panel& panel = out.panels[c];
    if (!alike) panel.label += std::string(", ") + words_of(all[c]);
    panel.commands.line("set xzeroaxis linewidth 0.6 linecolor rgb '#808080'");
    place(panel, curves[c], axis_of(lags, length, "lag"), rho);
  }
  return out;
}

}  // namespace asperity::plot
