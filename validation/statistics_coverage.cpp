// Coverage of the 95 % intervals of the moments against the correlation length, and the cost of the
// statistics in transforms of the same size.
//
//     statistics_coverage [FIELDS]        fields a row, 400 unless given
//
// Fields of 128 × 128 points, white noise averaged over w × w neighbours (correlation (1 - |p|/w)(1 -
// |q|/w)). Each row counts how often |estimate - truth| ≤ 1.96 standard errors, once with errors from the
// known correlation, once from the correlation estimated from the same field. The counts' own standard error
// is √(0.05 · 0.95 / FIELDS), 1.1 % for 400.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include <fmt/format.h>

#include "stats/acf.hpp"
#include "stats/effective_size.hpp"
#include "stats/moments.hpp"
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

// Of the mean, Sa, Sq, Ssk and Sku.
using Coverage = std::array<double, 5>;

void count(Coverage& covered, const Moments& m, const MomentErrors& error) {
  auto hit = [](double deviation, double standard_error) {
    return std::abs(deviation) <= 1.96 * standard_error;
  };
  covered[0] += hit(m.mean, error.mean);
  covered[1] += hit(m.sa - std::sqrt(2 / M_PI), error.sa);
  covered[2] += hit(m.sq - 1, error.sq);
  covered[3] += hit(m.ssk, error.ssk);
  covered[4] += hit(m.sku - 3, error.sku);
}

void print(Index width, double n_eff, const char* correlation, const Coverage& covered, int fields) {
  fmt::print("{:5d}  {:8.0f}  {:9s}", width, n_eff, correlation);
  for (double hits : covered) fmt::print("  {:5.1f}", 100 * hits / fields);
  fmt::print("\n");
}

void coverage(const Grid& grid, Index width, int fields) {
  std::mt19937_64 generator(static_cast<unsigned>(width));
  const EffectiveSize known(triangular_correlation(width), grid);
  Coverage with_known{}, with_estimate{};
  for (int f = 0; f < fields; ++f) {
    const Field z = moving_average(grid.shape, width, generator);
    const Moments m = moments(z);
    const LagField acf = estimate_autocorrelation(z, grid, {.max_lag = default_max_lag(grid)});
    count(with_known, m, standard_errors(m, known));
    count(with_estimate, m, standard_errors(m, EffectiveSize::of_estimate(acf, grid)));
  }
  print(width, known.effective(2), "known", with_known, fields);
  print(width, known.effective(2), "estimated", with_estimate, fields);
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
  fmt::print("{:5d}  {:13.3e}  {:7.2f}  {:7.2f}  {:7.2f}\n", n, one, seconds_of([&] { moments(z); }) / one,
             seconds_of([&] { estimate_autocorrelation(z, grid, half); }) / one,
             seconds_of([&] { EffectiveSize::of_estimate(acf, grid); }) / one);
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const int fields = argc > 1 ? std::max(1, std::atoi(argv[1])) : 400;
  fmt::print("Coverage [%] of 95 % intervals, {} fields of 128 x 128\n", fields);
  fmt::print("width     N_eff  errors      mean     Sa     Sq    Ssk    Sku\n");
  for (Index width : {1, 4, 8, 16, 32}) coverage({{128, 128}, 1, 1, false}, width, fields);
  fmt::print("\nCost in real transforms of the same size, one thread\n");
  fmt::print("    n  transform [s]  moments      ACF    N_eff\n");
  for (Index n : {128, 256, 512, 1024}) cost(n);
}
