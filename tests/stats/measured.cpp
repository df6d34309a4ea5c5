// A measured surface against sums in long double that share no code with the library.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "fields.hpp"
#include "stats/measure.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Long = long double;

struct Map {
  Grid grid;
  Field z;

  explicit Map(const char* name) {
    std::ifstream file(ASPERITY_TEST_DATA "/" + std::string(name), std::ios::binary);
    std::stringstream bytes;
    bytes << file.rdbuf();
    const Dataset data = decode_netcdf(bytes.str());
    grid = grid_of(data);
    z = field_of(data, "heights");
  }
  Long operator()(Index i, Index j) const { return z(i, j); }
  Index nx() const { return z.rows(); }
  Index ny() const { return z.cols(); }

  Long mean() const {
    return sum(nx(), ny(), [&](Index i, Index j) { return (*this)(i, j); }) / static_cast<Long>(z.size());
  }
  /// Σ f(i,j) over the first rows and columns.
  template <class Function>
  static Long sum(Index rows, Index columns, Function f) {
    Long total = 0;
    for (Index i = 0; i < rows; ++i)
      for (Index j = 0; j < columns; ++j) total += f(i, j);
    return total;
  }
};

double off(double value, Long exact) { return static_cast<double>(std::abs((value - exact) / exact)); }

}  // namespace

// 1e-12 is asked; what the sums' roundings amount to, ε (nx + ny) times the condition of the third moment, is
// 1e-13.
TEST_CASE("moments of a measured surface are those of long double to 1e-12", "[measured][exact]") {
  const Map map("afm-64x64.nc");
  const Long mean = map.mean(), n = static_cast<Long>(map.z.size());
  auto moment = [&](int power) {
    return Map::sum(map.nx(), map.ny(), [&](Index i, Index j) { return std::pow(map(i, j) - mean, power); }) /
           n;
  };
  const Long sa =
      Map::sum(map.nx(), map.ny(), [&](Index i, Index j) { return std::abs(map(i, j) - mean); }) / n;
  const Long sq = std::sqrt(moment(2));
  const Moments m = moments(map.z);
  CHECK(off(m.mean, mean) <= 1e-12);
  CHECK(off(m.sa, sa) <= 1e-12);
  CHECK(off(m.sq, sq) <= 1e-12);
  CHECK(off(m.ssk, moment(3) / (sq * sq * sq)) <= 1e-12);
  CHECK(off(m.sku, moment(4) / (sq * sq * sq * sq)) <= 1e-12);
  CHECK(off(m.sp, map.z.maxCoeff() - mean) <= 1e-12);
  CHECK(off(m.sv, mean - map.z.minCoeff()) <= 1e-12);
}

// Slopes are differences of neighbours, exact but for the rounding of heights that the file already has.
TEST_CASE("slopes, areas and spectral moments of a measured surface are those of long double to 1e-12",
          "[measured][exact]") {
  const Map map("afm-64x64.nc");
  const Long dx = map.grid.dx, dy = map.grid.dy;
  auto a = [&](Index i, Index j) { return (map(i + 1, j) - map(i, j)) / dx; };
  auto b = [&](Index i, Index j) { return (map(i, j + 1) - map(i, j)) / dy; };
  const Index rows = map.nx(), columns = map.ny();
  const Long m20 = Map::sum(rows - 1, columns, [&](Index i, Index j) { return a(i, j) * a(i, j); }) /
                   static_cast<Long>((rows - 1) * columns);
  const Long m02 = Map::sum(rows, columns - 1, [&](Index i, Index j) { return b(i, j) * b(i, j); }) /
                   static_cast<Long>(rows * (columns - 1));
  auto area = [](Long gx, Long gy) { return std::sqrt(1 + gx * gx + gy * gy); };
  const Long sdr = Map::sum(rows - 1, columns - 1,
                            [&](Index i, Index j) {
                              const Long ax = (a(i, j) + a(i, j + 1)) / 2, by = (b(i, j) + b(i + 1, j)) / 2;
                              return (area(a(i, j), by) + area(a(i, j + 1), by) + area(ax, b(i, j)) +
                                      area(ax, b(i + 1, j))) /
                                         4 -
                                     1;
                            }) /
                   static_cast<Long>((rows - 1) * (columns - 1));
  const Long m40 = Map::sum(rows - 2, columns,
                            [&](Index i, Index j) { return std::pow((a(i + 1, j) - a(i, j)) / dx, 2); }) /
                   static_cast<Long>((rows - 2) * columns);
  const SlopeParameters slopes = slope_parameters(map.z, map.grid);
  const SpectralMoments m = spectral_moments(map.z, map.grid);
  CHECK(off(slopes.sdq, std::sqrt(m20 + m02)) <= 1e-12);
  CHECK(off(slopes.sdr, sdr) <= 1e-12);
  CHECK(off(m.m20, m20) <= 1e-12);
  CHECK(off(m.m02, m02) <= 1e-12);
  CHECK(off(m.m40, m40) <= 1e-12);
}

// Relative to the variance: far lags of an estimate pass through zero.
TEST_CASE("the ACF and the structure function of a measured surface are the sums over pairs to 1e-12",
          "[measured][exact]") {
  const Map map("afm-64x64.nc");
  const Shape most{20, 20};
  const Long mean = map.mean();
  const LagField acf = estimate_autocorrelation(map.z, map.grid, {.max_lag = most});
  const LagField structure = structure_function(map.z, map.grid, most);
  const double variance = acf(0, 0);
  double worst = 0, worst_structure = 0;
  for (Index p = 0; p <= most.nx; ++p)
    for (Index q = -most.ny; q <= most.ny; ++q) {
      const Index left = std::max<Index>(0, -q), rows = map.nx() - p, columns = map.ny() - std::abs(q);
      const Long pairs = static_cast<Long>(rows * columns);
      const Long product = Map::sum(rows, columns, [&](Index i, Index j) {
        return (map(i, j + left) - mean) * (map(i + p, j + left + q) - mean);
      });
      const Long square = Map::sum(rows, columns, [&](Index i, Index j) {
        return std::pow(map(i, j + left) - map(i + p, j + left + q), 2);
      });
      worst = std::max(worst, static_cast<double>(std::abs(acf(p, q) - product / pairs)));
      worst_structure =
          std::max(worst_structure, static_cast<double>(std::abs(structure(p, q) - square / pairs)));
    }
  CHECK(worst <= 1e-12 * variance);
  CHECK(worst_structure <= 1e-12 * variance);
}

// Memory behind the field was written.
TEST_CASE("a field that is not of its grid's shape is refused", "[measured][contract]") {
  const Field z = white_noise({16, 8}, 3);
  for (const Grid& other : {grid(8, 16), grid(16, 16), grid(16, 7)}) {
    CHECK_THROWS_AS(measure({other, z}), DataError);
    CHECK_THROWS_AS(Sample(Surface{other, z}), DataError);
  }
}
