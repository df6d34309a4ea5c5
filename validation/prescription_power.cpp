/// How often the test of a prescription (stats/hypothesis/specification.hpp) sees a fault.
///
///     prescription_power [FIELDS [TABLE]]     single surfaces a figure, 2000 unless given; a quarter as many
///                                             ensembles; the table of gaussian or of shaped heights alone
///
/// The share, in per cent, of surfaces and of ensembles of 12 that differ at 1 %. Surfaces of 128 × 128 points
/// are tested for σ = 1 and the exponential correlation exp(-(|p|+|q|)/length). Columns: N_eff of that
/// correlation, surfaces a test, tests, and the faults
///     none        as prescribed: false alarms
///     Sq          1.1 σ
///     lengths     both 1.2 times as long
///     length_x    the one along x
///     skewness    0.3: z + c (z² - 1), c = 0.0503, scaled to σ = 1; its correlation is within 0.005
///     Gaussian    exp(-(p²+q²)/length²) instead: the same lengths at 1/e
/// The standard error of a share P is √(P (100 - P)/tests).
///
/// Second table: the same where a skewness and a kurtosis are prescribed, of translations of such fields; the
/// surfaces that errors come from are drawn anew for every 25 tests. A quarter as many tests. Further faults:
///     less, more  a skewness that is 0.3 nearer to zero or farther from it, of the same kurtosis
///     normal      Gaussian heights
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "marginal/correlation_map.hpp"
#include "marginal/prescribed.hpp"
#include "stats/hypothesis/specification.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

const Grid grid{{128, 128}, 1, 1, false};

Field white_noise(Shape shape, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index, Index) { return normal(generator); });
}

// By recursion from noise that is left behind.
Field exponential_field(double length_x, double length_y, std::mt19937_64& generator) {
  auto run_in = [](double length) { return static_cast<Index>(8 * length) + 1; };
  Field z = white_noise({grid.shape.nx + run_in(length_x), grid.shape.ny + run_in(length_y)}, generator);
  const double ax = std::exp(-1 / length_x), ay = std::exp(-1 / length_y);
  for (Index i = 1; i < z.rows(); ++i) z.row(i) = ax * z.row(i - 1) + std::sqrt(1 - ax * ax) * z.row(i);
  for (Index j = 1; j < z.cols(); ++j) z.col(j) = ay * z.col(j - 1) + std::sqrt(1 - ay * ay) * z.col(j);
  return z.bottomRightCorner(grid.shape.nx, grid.shape.ny);
}

LagField exponential_correlation(double length) {
  const auto reach = static_cast<Index>(18 * length);
  return LagField::of({reach, reach}, [=](Index p, Index q) {
    return std::exp(-static_cast<double>(p + std::abs(q)) / length);
  });
}

// White noise filtered by the Gaussian whose convolution with itself is the correlation.
Field gaussian_field(double length, std::mt19937_64& generator) {
  const auto reach = static_cast<Index>(3 * length) + 1;
  const Field noise = white_noise({grid.shape.nx + 2 * reach, grid.shape.ny + 2 * reach}, generator);
  auto weight = [&](Index k) { return std::exp(-2 * static_cast<double>(k * k) / (length * length)); };
  Field rows = Field::Zero(grid.shape.nx, noise.cols()), z = Field::Zero(grid.shape.nx, grid.shape.ny);
  double squares = 0;
  for (Index k = -reach; k <= reach; ++k) {
    rows += weight(k) * noise.middleRows(reach + k, grid.shape.nx);
    squares += weight(k) * weight(k);
  }
  for (Index l = -reach; l <= reach; ++l) z += weight(l) * rows.middleCols(reach + l, grid.shape.ny);
  return z / squares;
}

Field skewed(const Field& z) {
  const double c = 0.0503;
  return (z + c * (z.square() - 1)) / std::sqrt(1 + 2 * c * c);
}

// Per cent of the tests that differ; `untried` makes a test for the t-th.
double seen(const auto& untried, int surfaces, int tests, const auto& draw) {
  std::mt19937_64 generator(static_cast<unsigned>(surfaces));
  int differ = 0;
  for (int t = 0; t < tests; ++t) {
    SpecificationTest test = untried(t);
    for (int m = 0; m < surfaces; ++m) test.add(draw(generator), grid);
    differ += joint_p(test.results()) <= 0.01;
  }
  return 100.0 * differ / tests;
}

void row(double length, int surfaces, int tests) {
  const LagField correlation = exponential_correlation(length);
  const SpecificationTest untried({.correlation = correlation, .sq = 1}, grid);
  auto share = [&](const auto& draw) { return seen([&](int) { return untried; }, surfaces, tests, draw); };
  auto as_asked = [&](std::mt19937_64& g) { return exponential_field(length, length, g); };
  fmt::print("{:.0f}\t{}\t{}", EffectiveSampleSize(correlation, grid).effective(2), surfaces, tests);
  fmt::print("\t{:.1f}", share(as_asked));
  fmt::print("\t{:.1f}", share([&](auto& g) { return Field(1.1 * as_asked(g)); }));
  fmt::print("\t{:.1f}", share([&](auto& g) { return exponential_field(1.2 * length, 1.2 * length, g); }));
  fmt::print("\t{:.1f}", share([&](auto& g) { return exponential_field(1.2 * length, length, g); }));
  fmt::print("\t{:.1f}", share([&](auto& g) { return skewed(as_asked(g)); }));
  fmt::print("\t{:.1f}\n", share([&](auto& g) { return gaussian_field(length, g); }));
}

Translation of_moments(double skewness, double kurtosis) {
  return PrescribedHeights{skewness, kurtosis, InfeasiblePolicy::error}.translation();
}

Field translated(Field z, const Translation& g) {
  g.apply({z.data(), static_cast<std::size_t>(z.size())});
  return z;
}

// Tests of a prescription with the surfaces that it draws, 25 of each seed.
class Renewed {
 public:
  explicit Renewed(Specification asked) : asked_(std::move(asked)) {}
  const SpecificationTest& operator()(int t) {
    for (asked_.seed = 1 + static_cast<std::uint64_t>(t / 25); tests_.size() < asked_.seed;)
      tests_.emplace_back(asked_, grid);
    return tests_[asked_.seed - 1];
  }

 private:
  Specification asked_;
  std::vector<SpecificationTest> tests_ = {};
};

struct Shaped {
  double length, skewness, kurtosis;
  int surfaces;
};

void row(const Shaped& of, int tests) {
  const Translation g = of_moments(of.skewness, of.kurtosis);
  const double farther = of.skewness > 0 ? 0.3 : -0.3, length = of.length;
  const LagField correlation(exponential_correlation(length).half_plane().unaryExpr(
      [map = CorrelationMap(g)](double r) { return map(r); }));
  Renewed untried({.correlation = correlation, .sq = 1, .ssk = of.skewness, .sku = of.kurtosis});
  auto share = [&](const auto& draw) {
    fmt::print("\t{:.1f}", seen([&](int t) { return untried(t); }, of.surfaces, tests, draw));
  };
  auto drawn = [&](const Translation& heights, double longer, double longer_x) {
    return [&, longer, longer_x](std::mt19937_64& generator) {
      return translated(exponential_field(longer_x * length, longer * length, generator), heights);
    };
  };
  fmt::print("{:.0f}\t{}\t{}\t{}\t{}", EffectiveSampleSize(correlation, grid).effective(2), of.skewness,
             of.kurtosis, of.surfaces, tests);
  share(drawn(g, 1, 1));
  share([&](auto& generator) { return Field(1.1 * drawn(g, 1, 1)(generator)); });
  share(drawn(g, 1.2, 1.2));
  share(drawn(g, 1, 1.2));
  share(drawn(of_moments(of.skewness - farther, of.kurtosis), 1, 1));
  share(drawn(of_moments(of.skewness + farther, of.kurtosis), 1, 1));
  share([&](auto& generator) { return exponential_field(length, length, generator); });
  fmt::print("\n");
}

void gaussian_heights(int fields) {
  fmt::print("# N_eff\tsurfaces\ttests\tnone\tSq\tlengths\tlength_x\tskewness\tGaussian\n");
  for (const double length : {10.0, 5.0, 2.5}) row(length, 1, fields);
  for (const double length : {10.0, 5.0, 2.5}) row(length, 12, fields / 4);
}

void shaped_heights(int fields) {
  fmt::print(
      "\n# N_eff\tskewness\tkurtosis\tsurfaces\ttests\tnone\tSq\tlengths\tlength_x\tless\tmore\tnormal\n");
  for (const int surfaces : {1, 12})
    for (const auto& [skewness, kurtosis] : {std::pair{1.0, 5.0}, {-1.0, 4.5}, {-2.0, 8.0}})
      for (const double length : {8.0, 4.0})
        row(Shaped{length, skewness, kurtosis, surfaces}, std::max(1, fields / (surfaces == 1 ? 4 : 16)));
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const int fields = argc > 1 ? std::max(4, std::atoi(argv[1])) : 2000;
  const std::string table = argc > 2 ? argv[2] : "";
  if (table == "" || table == "gaussian") gaussian_heights(fields);
  if (table == "" || table == "shaped") shaped_heights(fields);
  return 0;
}
