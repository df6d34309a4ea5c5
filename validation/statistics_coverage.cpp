/// Coverage of the 95 % intervals of the moments against the correlation length, false alarms of the test of a
/// prescription, and the cost of the statistics in transforms of the same size.
///
///     statistics_coverage [FIELDS]        fields a row, 400 unless given
///
/// First table: how many of FIELDS fields of 128 × 128 points, in per cent, have an interval (stats/moment_interval.hpp)
/// that holds the truth, with the `correlation` known or estimated from the same field. Fields are white noise averaged
/// over w × w neighbours, w the `width`, of correlation (1 - |p|/w)(1 - |q|/w); and such with an exponential
/// correlation of that length. The standard error of a count is √(0.05 · 0.95 / FIELDS), 1.1 % for 400.
///
/// Second table: single surfaces that are as prescribed and yet fail at a stated 1 and 5 %, in per cent of FIELDS.
///
/// Third table: seconds of one real transform, and the statistics in these; one thread.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include <fmt/format.h>

#include "stats/acf.hpp"
#include "stats/effective_size.hpp"
#include "stats/moment_interval.hpp"
#include "stats/moments.hpp"
#include "stats/prescription.hpp"
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

void count(Coverage& covered, const Moments& m, const EffectiveSize& size) {
  auto holds = [](const Interval& i, double truth) { return i.low <= truth && truth <= i.high; };
  const MomentIntervals i = confidence_intervals(m, size);
  covered[0] += holds(i.mean, 0);
  covered[1] += holds(i.sa, std::sqrt(2 / M_PI));
  covered[2] += holds(i.sq, 1);
  covered[3] += holds(i.ssk, 0);
  covered[4] += holds(i.sku, 3);
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
  const EffectiveSize known(correlation, grid);
  Coverage with_known{}, with_estimate{};
  for (int f = 0; f < fields; ++f) {
    const Field z = draw(grid.shape, width, generator);
    const Moments m = moments(z);
    const LagField acf = estimate_autocorrelation(z, grid, {.max_lag = default_max_lag(grid)});
    count(with_known, m, known);
    count(with_estimate, m, EffectiveSize::of_estimate(acf, grid));
  }
  print(field, width, known.effective(2), "known", with_known, fields);
  print(field, width, known.effective(2), "estimated", with_estimate, fields);
}

// Of single surfaces that are as prescribed, at a stated 1 and 5 %.
void false_alarms(Index n, Index width, int fields) {
  std::mt19937_64 generator(static_cast<unsigned>(width));
  const Grid grid{{n, n}, 1, 1, false};
  const LagField correlation = triangular_correlation(width);
  const PrescriptionTest untried({.correlation = correlation, .sq = 1}, grid);
  int of_one = 0, of_five = 0;
  for (int f = 0; f < fields; ++f) {
    PrescriptionTest test = untried;
    test.add(moving_average(grid.shape, width, generator), grid);
    const double p = joint_p(test.claims());
    of_one += p <= 0.01;
    of_five += p <= 0.05;
  }
  fmt::print("{}\t{}\t{:.0f}\t{:.2f}\t{:.2f}\n", n, width, EffectiveSize(correlation, grid).effective(2),
             100.0 * of_one / fields, 100.0 * of_five / fields);
}

void cost(Index n) {
  std::mt19937_64 generator(1);
  const Grid grid{{n, n}, 1, 1, false};
  const Field z = white_noise(grid.shape, generator);
  const RealTransform2D transform(grid.shape);
  AlignedVector<double> in(z.data(), z.data() + z.size());
  AlignedVector<Complex> out(static_cast<std::size_t>(transform.spectrum_size()));
  const AcfParameters half{.max_lag = default_max_lag(grid)};
  const LagField acf = estimate_autocorrelation(z, grid, half);

  const double one = seconds_of([&] { transform.forward(in.data(), out.data()); });
  fmt::print("{}\t{:.2e}\t{:.2f}\t{:.2f}\t{:.2f}\n", n, one, seconds_of([&] { moments(z); }) / one,
             seconds_of([&] { estimate_autocorrelation(z, grid, half); }) / one,
             seconds_of([&] { EffectiveSize::of_estimate(acf, grid); }) / one);
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const int fields = argc > 1 ? std::max(1, std::atoi(argv[1])) : 400;
  const Grid grid{{128, 128}, 1, 1, false};
  fmt::print("# field\twidth\tN_eff\tcorrelation\tmean\tSa\tSq\tSsk\tSku\n");
  for (Index width : {1, 4, 8, 16, 32})
    coverage("average", grid, width, triangular_correlation(width), moving_average, fields);
  for (Index length : {1, 3, 6, 12})
    coverage("exponential", grid, length, exponential_correlation(length), exponential_field, fields);
  fmt::print("\n# n\twidth\tN_eff\tat_1\tat_5\n");
  for (const auto& [n, width] : {std::pair<Index, Index>{128, 11}, {64, 3}, {96, 4}})
    false_alarms(n, width, fields);
  fmt::print("\n# n\ttransform\tmoments\tACF\tN_eff\n");
  for (Index n : {128, 256, 512, 1024}) cost(n);
  return 0;
}
