#include "stats/hypothesis/specification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/hypothesis/gaussianity.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"

namespace asperity {
namespace {

constexpr Index most_rows = 9, most_columns = 17;
constexpr double least_density = 0.1;

Index stride(Index lags, Index most) { return (lags + most - 1) / most; }

// R(h) at the lags that are tested needs no others.
Shape longest_lag(const LagField& rho, const Grid& grid) {
  return {std::min(rho.max_p(), grid.shape.nx / 4), std::min(rho.max_q(), grid.shape.ny / 4)};
}

// Of the surfaces that are drawn: a part of the field that tells as much of its law, if there is one.
Grid drawn_part(const LagField& rho, const Grid& grid) {
  constexpr double independent = 500, points = 128 * 128, most = 0.5;
  constexpr Index shortest = 64;
  const auto cells = static_cast<double>(grid.shape.cells());
  const double share = std::max(independent / EffectiveSampleSize(rho, grid).effective(2), points / cells);
  const Shape far = reach_of({.grid = grid, .correlation = rho});
  auto side = [&](Index n, Index lag) {
    return std::min(n, fast_length(std::max({std::lround(std::sqrt(share) * double(n)), 4 * lag, shortest})));
  };
  Grid part = grid;
  part.shape = {side(grid.shape.nx, far.nx), side(grid.shape.ny, far.ny)};
  return static_cast<double>(part.shape.cells()) <= most * cells ? part : grid;
}

LagField without_rounding_at_zero(const LagField& acf, double step) {
  return LagField::of(
      acf.max_lag(), [&](Index p, Index q) { return acf(p, q) - (p == 0 && q == 0 ? step * step / 12 : 0); });
}

// (1), NaN where the table lacks the lags or tells no slope.
double expected_square(const LagField& rho, const Grid& grid) {
  if (rho.max_p() < 1 || rho.max_q() < 1 || grid.shape.nx < 2 || grid.shape.ny < 2) return NAN;
  const double out = 2 * ((1 - rho(1, 0)) / (grid.dx * grid.dx) + (1 - rho(0, 1)) / (grid.dy * grid.dy));
  return out > 0 ? out : NAN;
}

// Whether the table has the lags between neighbours of a point, and these differ from the point.
bool tells_summits(const LagField& rho, const Grid& grid) {
  constexpr double least = 1e-12;  // of 1 - ρ; below it rounding makes summits
  return rho.max_p() >= 2 && rho.max_q() >= 2 && grid.shape.nx > 2 && grid.shape.ny > 2 &&
         std::max({rho(1, 0), rho(0, 1), rho(1, 1), rho(1, -1)}) < 1 - least;
}

// Sdq², and summits per point; NaN without a cell of 2 × 2 points, or 3 × 3 points, that are all there.
struct Slopes {
  double square = NAN, share = NAN;
  double plateaus = 0;  // share of the summits
};

Slopes slopes_of(const Field& z, const Grid& grid, int threads) {
  Slopes out;
  try {
    out.square = std::pow(slope_parameters(z, grid, threads).sdq, 2);
    const CountedSummits found = counted_summits(z, grid, 0, threads);
    out.share = found.count / found.points;
    if (found.count > 0) out.plateaus = found.plateaus / found.count;
  } catch (const DataError&) {  // no cell, or no neighbourhood
  }
  return out;
}

// Sdq² of heights on steps before they were rounded, where their differences tell it; no summits that are
// plateaus. Rounding adds s²/12 to the variance of a height. It is independent of that of the next, to 2e-4,
// where steps are below 1.5 rms differences.
Slopes before_steps(Slopes slopes, double step, double variance, const LagField& rho, const Grid& grid) {
  constexpr double most_steps = 1.5, most_plateaus = 1e-3;
  if (!(step > 0)) return slopes;
  const double difference = std::sqrt(2 * variance * (1 - std::max(rho(1, 0), rho(0, 1)))),
               rounding = step * step / 6 * (1 / (grid.dx * grid.dx) + 1 / (grid.dy * grid.dy));
  slopes.square = step < most_steps * difference ? slopes.square - rounding : NAN;
  if (slopes.plateaus > most_plateaus) slopes.share = NAN;
  return slopes;
}

void check(const Specification& asked) {
  if (!(asked.sku >= 1 + asked.ssk * asked.ssk))
    throw ParameterError(
        "kurtosis", "'" + shortest(asked.sku) + "' is below 1 + skewness², the least of any distribution");
}

}  // namespace

SpecificationTest::SpecificationTest(const Specification& asked, const Grid& grid)
    : asked_(asked), grid_(grid), part_(grid) {
  check(asked);
  asked_.correlation = asked.correlation.normalised();
  const LagField& rho = asked_.correlation;
  check_reach(grid);
  part_ = drawn_part(rho, grid);
  stretch_.emplace(rho, part_, longest_lag(rho, part_));
  choose_lags();
  for (const std::string& name : stretch_->names()) lengths_.push_back({.quantity = name, .prescribed = 1});
  square_ = expected_square(rho, grid);
  summits_ = tells_summits(rho, grid);
  simulation_ = std::make_shared<Simulation>();
}

void SpecificationTest::choose_lags() {
  const LagField& rho = asked_.correlation;
  const Shape most = longest_lag(rho, part_);
  const Index dp = stride(most.nx + 1, most_rows), dq = stride(2 * most.ny + 1, most_columns);
  for (Index p = 0; p <= most.nx; p += dp)
    for (Index q = p == 0 ? dq : -(most.ny / dq) * dq; q <= most.ny; q += dq)
      lags_.push_back({.quantity = "ACF", .prescribed = rho(p, q), .lag_x = p, .lag_y = q});
}

void SpecificationTest::check_reach(const Pairs& pairs) const {
  const EffectiveSampleSize size(asked_.correlation, pairs);
  auto refuse = [](const std::string& why) {
    throw DataError("acf_target", "it reaches too far for the field: " + why + "; use a larger field");
  };
  if (!size.gives_errors())
    refuse("N_eff = " + shortest(std::round(10 * size.effective(2)) / 10) + " is below " +
           shortest(size.least_effective()) + ", the least with which there are errors");
  if (!(size.mean_power(1) < 0.5)) refuse("subtracting its mean removes half of the variance or more");
}

Eigen::ArrayXd SpecificationTest::measured(const Field& z, const Pairs& pairs,
                                           const std::vector<LagField>& stretches, int threads,
                                           double step) const {
  const Moments rounded = moments(z), m = step > 0 ? before_rounding(rounded, step) : rounded;
  if (!(m.sq > 0))
    throw DataError("heights", "they stand on steps of " + in_digits(step / rounded.sq, 3) +
                                   " Sq, which are too coarse for the tests");
  const LagField& rho = asked_.correlation;
  LagField acf = estimate_autocorrelation(z, pairs, {.max_lag = longest_lag(rho, part_), .threads = threads});
  if (step > 0) acf = without_rounding_at_zero(acf, step);
  Slopes slopes;
  if (std::isfinite(square_))
    slopes = before_steps(slopes_of(z, pairs.grid(), threads), step, m.sq * m.sq, rho, grid_);
  Eigen::ArrayXd values(at_shapes + lags() + static_cast<Index>(stretches.size()));
  values << acf(0, 0), m.ssk, m.sku, slopes.square, slopes.share, shapes(acf, pairs, stretches);
  return values;
}

Eigen::ArrayXd SpecificationTest::shapes(const LagField& acf, const Pairs& pairs,
                                         const std::vector<LagField>& stretches) const {
  Eigen::ArrayXd values(lags() + static_cast<Index>(stretches.size()));
  Index i = 0;
  for (const TestResult& lag : lags_) {
    const bool counts = pairs.density(lag.lag_x, lag.lag_y) > least_density;
    values(i++) = counts ? acf(lag.lag_x, lag.lag_y) / acf(0, 0) : NAN;
  }
  for (const LagField& weights : stretches) values(i++) = LengthStretch::estimate(weights, acf) / acf(0, 0);
  return values;
}

Eigen::ArrayXd SpecificationTest::limits(const RandomFields& fields) const {
  const LagField rho = fields.correlation(longest_lag(asked_.correlation, part_));
  const HeightMoments heights = fields.moments();
  const std::vector<LagField> stretches = stretch_->weights(part_);
  Eigen::ArrayXd values(at_shapes + lags() + static_cast<Index>(stretches.size()));
  values << rho(0, 0), heights.skewness, heights.kurtosis, expected_square(rho, part_), NAN,
      shapes(rho, part_, stretches);
  return values;
}

Eigen::ArrayXd SpecificationTest::worth() const {
  const LagField& rho = asked_.correlation;
  const double patches =
      EffectiveSampleSize(rho, grid_).effective(2) / EffectiveSampleSize(rho, part_).effective(2);
  auto of_lag = [&](const TestResult& of) {
    return patches * overlap(grid_, of.lag_x, of.lag_y) / overlap(part_, of.lag_x, of.lag_y);
  };
  const Eigen::ArrayXd of_stretches = stretch_->variances(part_) / stretch_->variances(grid_);
  Eigen::ArrayXd values = Eigen::ArrayXd::Constant(at_shapes + lags() + of_stretches.size(), patches);
  std::ranges::transform(lags_, values.begin() + at_shapes, of_lag);
  values.tail(of_stretches.size()) = of_stretches;
  return values;
}

void SpecificationTest::add(const Field& z, const Grid& grid) {
  auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
  if (shape_of(z) != grid_.shape || !same(grid.dx, grid_.dx) || !same(grid.dy, grid_.dy) ||
      grid.periodic != grid_.periodic)
    throw DataError("heights", "the grid differs from that of the first surface");
  const Pairs pairs = Pairs::of(z, grid_, asked_.threads);
  if (!pairs.complete()) check_reach(pairs);
  observed_.push_back(measured(z, pairs, stretch_->weights(pairs), asked_.threads, height_steps(z).step));
  count_missing(z);
}

double joint_p(const std::vector<TestResult>& results) {
  double least = 1;
  for (const TestResult& c : results) least = std::min(least, c.p);
  return std::min(1.0, least * static_cast<double>(results.size()));
}

}  // namespace asperity
