/// Coverage of the 95 % intervals of the moments and of the correlation lengths against the correlation
/// length, and false alarms of the test of a prescription.
///
///     statistics_coverage [FIELDS [TABLE]]     fields a row, 400 unless given; moments, lengths or alarms alone
///
/// First table: how many of FIELDS fields of 128 × 128 points, in per cent, have an interval
/// (asperity-stats) that holds the truth, with the `correlation` known or estimated
/// from the same field. Fields are white noise averaged over w × w neighbours, w the `width`, of correlation
/// (1 - |p|/w)(1 - |q|/w); and such with an exponential correlation of that length. The standard error of a
/// count is √(0.05 · 0.95 / FIELDS), 1.1 % for 400.
///
/// Second table: the same of Sal and of the lengths along x at 1/e and 10 %
/// (stats/measure/acf_estimate.hpp), and how many of these intervals lie wholly below and above the
/// truth.
///
/// Third table: surfaces, or ensembles of them, that are as prescribed and yet fail at a stated 1 and 5 %, in
/// per cent of FIELDS; with a third of the points missing; of Gaussian heights, and of heights of this skewness and kurtosis.
/// The surfaces that errors come from are drawn anew for every 50 tests; for 256 × 256 points they are parts
/// of these.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <random>
#include <string>

#include <fmt/format.h>

#include "marginal/correlation_map.hpp"
#include "marginal/prescribed.hpp"
#include "stats/filter/form.hpp"
#include "stats/hypothesis/specification.hpp"
#include "stats/measure.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

Field white_noise(Shape shape, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index, Index) { return normal(generator); });
}

// Of variance 1.
Field moving_average(Shape shape, Index width, std::mt19937_64& generator) {
  const Field noise = white_noise({shape.nx + width - 1, shape.ny + width - 1}, generator);
  Field rows = Field::Zero(shape.nx, noise.cols()), z = Field::Zero(shape.nx, shape.ny);
  for (Index k = 0; k < width; ++k) rows += noise.middleRows(k, shape.nx);
  for (Index l = 0; l < width; ++l) z += rows.middleCols(l, shape.ny);
  return z / static_cast<double>(width);
}

LagField triangular_correlation(Index width) {
  auto share = [=](Index lag) { return 1 - static_cast<double>(std::abs(lag)) / static_cast<double>(width); };
  return LagField(Field::NullaryExpr(
      width, 2 * width - 1, [&](Index p, Index column) { return share(p) * share(column - (width - 1)); }));
}

// Of variance 1 and correlation exp(-(|p|+|q|)/length), by recursion from noise that is left behind.
Field exponential_field(Shape shape, Index length, std::mt19937_64& generator) {
  const Index run_in = 8 * length;
  const double a = std::exp(-1 / static_cast<double>(length)), b = std::sqrt(1 - a * a);
  Field z = white_noise({shape.nx + run_in, shape.ny + run_in}, generator);
  for (Index i = 1; i < z.rows(); ++i) z.row(i) = a * z.row(i - 1) + b * z.row(i);
  for (Index j = 1; j < z.cols(); ++j) z.col(j) = a * z.col(j - 1) + b * z.col(j);
  return z.bottomRightCorner(shape.nx, shape.ny);
}

LagField exponential_correlation(Index length) {
  const Index reach = 18 * length;
  return LagField(Field::NullaryExpr(reach + 1, 2 * reach + 1, [=](Index p, Index column) {
    return std::exp(-static_cast<double>(p + std::abs(column - reach)) / static_cast<double>(length));
  }));
}

// Of the mean, Sa, Sq, Ssk and Sku.
using Coverage = std::array<double, 5>;

// Of the intervals of asperity-stats.
void count(Coverage& covered, const Field& z, const Grid& grid, const std::optional<LagField>& correlation) {
  const Parameters of = measure(Surface{.grid = grid, .heights = z, .correlation = correlation});
  const double truths[] = {0, std::sqrt(2 / std::numbers::pi), 1, 0, 3};
  for (std::size_t k = 0; k < covered.size(); ++k) {
    const Interval i = of[k].interval_95();
    covered[k] += i.low <= truths[k] && truths[k] <= i.high;
  }
}

void print(const char* field, Index width, double n_eff, const char* correlation, const Coverage& covered,
           int fields) {
  fmt::print("{}\t{}\t{:.0f}\t{}", field, width, n_eff, correlation);
  for (double hits : covered) fmt::print("\t{:.1f}", 100 * hits / fields);
  fmt::print("\n");
}

template <class Draw>
void coverage(const char* field, const Grid& grid, Index width, const LagField& correlation, Draw draw,
              int fields) {
  std::mt19937_64 generator(static_cast<unsigned>(width));
  const EffectiveSampleSize known(correlation, grid);
  Coverage with_known{}, with_estimate{};
  for (int f = 0; f < fields; ++f) {
    const Field z = draw(grid.shape, width, generator);
    count(with_known, z, grid, correlation);
    count(with_estimate, z, grid, std::nullopt);
  }
  print(field, width, known.effective(2), "known", with_known, fields);
  print(field, width, known.effective(2), "estimated", with_estimate, fields);
}

// Of Sal and the lengths along x at 1/e and 10 %.
struct Lengths {
  double sal, at_e, at_tenth;
};

Lengths lengths_of(const LagField& rho, const Grid& grid) {
  auto along_x = [&](double level) { return first_crossing(rho, grid, 0, level)->lag; };
  return {central_lobe(rho, grid).r_min->length, along_x(1 / std::numbers::e), along_x(0.1)};
}

// How often an interval holds the truth, lies below it, and above it.
struct Held {
  int inside = 0, below = 0, above = 0;

  void add(const Interval& i, double truth) {
    ++(!(i.low <= truth) ? above : truth > i.high ? below : inside);
  }
};

template <class Draw>
void length_coverage(const char* field, const Grid& grid, Index width, const LagField& correlation, Draw draw,
                     int fields) {
  std::mt19937_64 generator(static_cast<unsigned>(width));
  const Index far = default_max_lag(grid).nx;
  const Lengths truth = lengths_of(
      LagField(Field::NullaryExpr(far + 1, 2 * far + 1,
                                  [&](Index p, Index column) { return correlation(p, column - far); })),
      grid);
  std::array<std::array<Held, 3>, 2> held{};
  for (int f = 0; f < fields; ++f) {
    const Field z = draw(grid.shape, width, generator);
    const LagField acf = estimate_autocorrelation(z, grid, {.max_lag = default_max_lag(grid)});
    for (std::size_t which = 0; which < 2; ++which) {
      const AcfEstimate estimate(acf, {which == 0 ? correlation : acf, which == 1, grid});
      const LengthErrors of(estimate, remove_form(z), 0.1);
      auto along_x = [&](double level) {
        const auto at = first_crossing(estimate.rho, grid, 0, level);
        return at ? of.along(0, level, at->lag).interval.value_or(Interval()) : Interval();
      };
      const auto fastest = of.lobe(0.2).r_min;
      held[which][0].add(fastest ? fastest->interval.value_or(Interval()) : Interval(), truth.sal);
      held[which][1].add(along_x(1 / std::numbers::e), truth.at_e);
      held[which][2].add(along_x(0.1), truth.at_tenth);
    }
  }
  const double percent = 100.0 / fields;
  for (std::size_t which = 0; which < 2; ++which) {
    fmt::print("{}\t{}\t{:.0f}\t{}", field, width, EffectiveSampleSize(correlation, grid).effective(2),
               which == 0 ? "known" : "estimated");
    for (const Held& h : held[which])
      fmt::print("\t{:.1f}\t{:.1f}\t{:.1f}", percent * h.inside, percent * h.below, percent * h.above);
    fmt::print("\n");
  }
}

// A quarter of the field and a tenth of the other points.
Field with_holes(Field z, std::mt19937_64& generator) {
  std::bernoulli_distribution missing(0.1);
  z = z.unaryExpr([&](double height) { return missing(generator) ? NAN : height; });
  z.topLeftCorner(z.rows() / 2, z.cols() / 2).setConstant(NAN);
  return z;
}

struct Alarms {
  Index n, width;
  double ssk = 0, sku = 3;
  int surfaces = 1;
  bool holes = false;

  bool gaussian() const { return ssk == 0 && sku == 3; }
};

Field translated(Field z, const std::optional<Translation>& g) {
  if (g) g->apply({z.data(), static_cast<std::size_t>(z.size())});
  return z;
}

// Of surfaces that are as prescribed, at a stated 1 and 5 %.
void false_alarms(const Alarms& a, int ensembles) {
  constexpr int tests_of_one = 50;
  std::mt19937_64 generator(static_cast<unsigned>(a.width));
  const Grid grid{{a.n, a.n}, 1, 1, false};
  std::optional<Translation> g;
  if (!a.gaussian()) g = PrescribedHeights{a.ssk, a.sku, InfeasiblePolicy::error}.translation();
  LagField correlation = triangular_correlation(a.width);
  if (g) correlation = LagField(correlation.half_plane().unaryExpr(CorrelationMap(*g)));
  std::optional<SpecificationTest> untried;
  int of_one = 0, of_five = 0;
  for (int e = 0; e < ensembles; ++e) {
    if (e % tests_of_one == 0)
      untried.emplace(Specification{.correlation = correlation,
                                    .sq = 1,
                                    .ssk = a.ssk,
                                    .sku = a.sku,
                                    .seed = static_cast<std::uint64_t>(1 + e / tests_of_one)},
                      grid);
    SpecificationTest test = *untried;
    std::mt19937_64 same_holes(1);  // for one simulation
    for (int m = 0; m < a.surfaces; ++m) {
      const Field z = translated(moving_average(grid.shape, a.width, generator), g);
      test.add(a.holes ? with_holes(z, same_holes) : z, grid);
    }
    const double p = joint_p(test.results());
    of_one += p <= 0.01;
    of_five += p <= 0.05;
  }
  fmt::print("{}\t{}\t{:.0f}\t{}\t{}\t{}\t{}\t{:.2f}\t{:.2f}\n", a.n, a.width,
             EffectiveSampleSize(correlation, grid).effective(2), a.ssk, a.sku, a.surfaces,
             a.holes ? "third" : "none", 100.0 * of_one / ensembles, 100.0 * of_five / ensembles);
}

void coverage_of_moments(const Grid& grid, int fields) {
  fmt::print("# field\twidth\tN_eff\tcorrelation\tmean\tSa\tSq\tSsk\tSku\n");
  for (Index width : {1, 4, 8, 16, 32})
    coverage("average", grid, width, triangular_correlation(width), moving_average, fields);
  for (Index length : {1, 3, 6, 12})
    coverage("exponential", grid, length, exponential_correlation(length), exponential_field, fields);
}

void coverage_of_lengths(const Grid& grid, int fields) {
  fmt::print("\n# field\twidth\tN_eff\tcorrelation\tSal\tSal_below\tSal_above\te\te_below\te_above");
  fmt::print("\ttenth\ttenth_below\ttenth_above\n");
  for (Index width : {4, 8, 16, 32})
    length_coverage("average", grid, width, triangular_correlation(width), moving_average, fields);
  for (Index length : {1, 3, 6, 12})
    length_coverage("exponential", grid, length, exponential_correlation(length), exponential_field, fields);
}

void all_false_alarms(int fields) {
  fmt::print("\n# n\twidth\tN_eff\tskewness\tkurtosis\tsurfaces\tmissing\tat_1\tat_5\n");
  for (const Alarms& row : {Alarms{128, 11},
                            {64, 3},
                            {96, 4},
                            {256, 6},
                            {256, 6, 1, 5},
                            {128, 11, 0, 3, 1, true},
                            {64, 3, 0, 3, 1, true},
                            {64, 3, 0, 3, 12},
                            {256, 6, 0, 3, 4},
                            {128, 12, 1, 5},
                            {128, 6, 1, 5},
                            {128, 12, -1, 4.5},
                            {128, 6, -1, 4.5},
                            {128, 12, -2, 8},
                            {128, 6, -2, 8},
                            {128, 12, 1, 5, 1, true},
                            {64, 6, 1, 5, 4},
                            {64, 6, -2, 8, 12}})
    false_alarms(row, fields);
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const int fields = argc > 1 ? std::max(1, std::atoi(argv[1])) : 400;
  const std::string part = argc > 2 ? argv[2] : "";
  const Grid grid{{128, 128}, 1, 1, false};
  if (part == "" || part == "moments") coverage_of_moments(grid, fields);
  if (part == "" || part == "lengths") coverage_of_lengths(grid, fields);
  if (part == "" || part == "alarms") all_false_alarms(fields);
}
