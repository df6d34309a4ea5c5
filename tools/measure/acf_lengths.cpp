#include "tools/measure/acf_lengths.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "stats/spatial/acf_length.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/series.hpp"

namespace asperity::cli {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double share_of(const std::string& word) {
  double value = unknown;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !(value > 0 && value < 1))
    throw UsageError("acf-level", "value \"" + word + "\" is neither a number between 0 and 1 nor 1/e");
  return value;
}

AcfLevel level_of(const std::string& word) {
  if (word == "1/e") return {1 / std::numbers::e, "e", "1/e"};
  const double value = share_of(word), percent = std::round(1e12 * value) / 1e10;
  return {value, shortest(percent), shortest(percent) + " %"};
}

/// What is measured at one level, of the estimate or of the target.
class LengthRows {
 public:
  LengthRows(Quantities& out, std::string prefix, const AcfLevel& level, const LagField& rho,
             const Grid& grid)
      : out_(out), prefix_(std::move(prefix)), level_(level), rho_(rho), grid_(grid) {}

  /// The length along an axis or in a direction; its error from that of ρ at the nearest lag.
  std::optional<Crossing> add(const std::string& name, double angle, const AcfEstimate* errors) {
    const auto crossing = first_crossing(rho_, grid_, angle, level_.value);
    if (!crossing) return std::nullopt;
    double error = unknown;
    std::optional<Interval> interval;
    if (errors) {
      interval = errors->lengths.along(angle, level_.value);
      const auto [p, q] = nearest_lag(grid_, angle, crossing->lag);
      error = errors->standard_error(p, q, false) / -crossing->slope;
    }
    out_.rows.push_back({prefix_ + "length_" + level_.tag + "_" + name, crossing->lag, "m", error,
                         "where the ACF has fallen to " + level_.text, interval,
                         errors ? untold(errors->size) : ""});
    return Crossing{crossing->lag, error};
  }
  /// Of the first two: length and error each.
  void add_ratio(const std::optional<Crossing>& x, const std::optional<Crossing>& y) {
    if (!x || !y) return;
    const double ratio = x->lag / y->lag, relative = std::hypot(x->slope / x->lag, y->slope / y->lag);
    out_.rows.push_back({prefix_ + "gamma_" + level_.tag, ratio, "1", ratio * relative,
                         "ellipticity, length in x over length in y",
                         Interval::of_ratio(ratio, half_width_95 * relative)});
  }
  void add_ellipse() {
    const auto ellipse = central_lobe(rho_, grid_, level_.value).ellipse;
    if (!ellipse) return;
    out_.rows.push_back({prefix_ + "ellipticity_" + level_.tag, ellipse->gamma(), "1", unknown,
                         "long over short axis of the contour at " + level_.text});
    out_.rows.push_back({prefix_ + "ellipticity_" + level_.tag + "_direction", ellipse->major.angle, "rad",
                         unknown, "of the long axis, from +x towards +y"});
  }

 private:
  Quantities& out_;
  std::string prefix_;
  const AcfLevel& level_;
  const LagField& rho_;
  const Grid& grid_;
};

/// Whether both axes reach the level.
bool add_lengths(LengthRows rows, const std::optional<double>& direction, const AcfEstimate* errors) {
  const auto x = rows.add("x", 0, errors), y = rows.add("y", std::numbers::pi / 2, errors);
  if (direction) rows.add("direction", *direction, errors);
  rows.add_ratio(x, y);
  rows.add_ellipse();
  return x && y;
}

}  // namespace

AcfEstimate AcfEstimate::of(const Measured& measured, const AcfParameters& parameters) {
  const Pairs pairs = Pairs::of(measured.heights, measured.grid, parameters.threads);
  const LagField acf = estimate_autocorrelation(measured.heights, pairs, parameters);
  const LagField known = measured.drawn ? *measured.drawn : significant_lags(acf, pairs);
  return {acf.normalised(),
          AcfError(known, pairs),
          acf(0, 0),
          pairs,
          parameters.biased,
          LengthIntervals(acf, pairs, measured.drawn),
          measured.drawn ? EffectiveSampleSize(*measured.drawn, pairs)
                         : EffectiveSampleSize::of_estimate(acf, pairs)};
}

double AcfEstimate::standard_error(Index p, Index q, bool absolute) const {
  if (!size.tells_errors()) return unknown;
  return (biased ? pairs.pair_fraction(p, q) : 1) *
         (absolute ? error.absolute(p, q) : error.normalised(p, q));
}

std::vector<AcfLevel> acf_levels(const std::string& list) {
  std::vector<AcfLevel> out;
  for (const std::string& word : split(list, ',')) {
    const AcfLevel level = level_of(word);
    if (std::ranges::find(out, level.tag, &AcfLevel::tag) != out.end())
      throw UsageError("acf-level", "value \"" + word + "\" is given twice");
    out.push_back(level);
  }
  return out;
}

Quantities lengths_of(const Tool& tool, const Measured& measured, const AcfEstimate& estimate,
                      const LengthsRequest& request) {
  std::optional<double> direction;
  if (!request.direction.empty()) direction = parse_angle("direction", request.direction);
  Quantities out;
  for (const AcfLevel& level : acf_levels(request.levels)) {
    if (!add_lengths({out, "", level, estimate.rho, measured.grid}, direction, &estimate))
      tool.warn("no lag has an ACF of " + level.text + " or less in some direction; see --max-lag");
    if (measured.target)
      add_lengths({out, "target_", level, *measured.target, measured.grid}, direction, nullptr);
  }
  warn_of_few(tool, estimate.size);
  for (const Quantities::Row& row : out.rows)
    if (row.name.starts_with("length_") && !warn_of_length(tool, row.name, row.value, measured.grid)) break;
  return out;
}

}  // namespace asperity::cli
