// Medians of windows, and outliers.
#include "stats/filter/median_filter.hpp"

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double brute_force(const Field& z, const Grid& grid, Shape window, Index i, Index j) {
  std::vector<double> values;
  const auto [nx, ny] = grid.shape;
  for (Index k = i - window.nx / 2; k <= i + window.nx / 2; ++k)
    for (Index l = j - window.ny / 2; l <= j + window.ny / 2; ++l) {
      if ((!grid.periodic.x && (k < 0 || k >= nx)) || (!grid.periodic.y && (l < 0 || l >= ny))) continue;
      if (const double value = z((k + nx) % nx, (l + ny) % ny); !std::isnan(value)) values.push_back(value);
    }
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

const std::array periods{Periodic{}, Periodic{true}, Periodic{true, false}, Periodic{false, true}};

}  // namespace

TEST_CASE("the median filter gives the median of each window", "[filter][exact]") {
  for (const Periodic periodic : periods)
    for (const Shape window :
         {Shape{1, 1}, Shape{3, 3}, Shape{5, 1}, Shape{1, 9}, Shape{41, 7}, Shape{41, 35}}) {
      const Grid grid{{42, 35}, 1, 1, periodic};
      Field z = with_holes(random_field(grid.shape, 51), 0.2, 52);
      z = (z.abs() < 0.2).select(0, z);  // ties
      const Field medians = median_surface(z, grid, window);
      bool equal = true;
      for (Index i = 0; i < 42; ++i)
        for (Index j = 0; j < 35; ++j)
          equal &= std::isnan(z(i, j)) ? std::isnan(medians(i, j))
                                       : medians(i, j) == brute_force(z, grid, window, i, j);
      CAPTURE(window.nx, window.ny, periodic.x, periodic.y);
      CHECK(equal);
      CHECK(largest_difference(median_surface(z, grid, window, 3), medians) == 0);
    }
}

TEST_CASE("a window has an odd number of points, as many as its width holds", "[filter][exact]") {
  const Grid grid{{100, 10}, 0.1, 0.2};
  CHECK(median_window(grid, 0.5) == Shape{5, 3});
  CHECK(median_window(grid, 0.6) == Shape{7, 3});
  CHECK(median_window(grid, 0.2) == Shape{3, 1});
  CHECK(median_window(grid, 1e9) == Shape{99, 9});
  for (double width : {0.1, 0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(median_window(grid, width), ParameterError);
  for (const Shape window : {Shape{2, 3}, Shape{3, 0}, Shape{101, 1}, Shape{-1, 1}})
    CHECK_THROWS_AS(median_surface(Field::Ones(100, 10), grid, window), ParameterError);
}

// z - m of Gaussian heights and the median of 25, z among them, has the variance 1 + (π/2)/25 - 2/25 = 0.98. The
// chance of a point beyond 6 is 2e-9.
TEST_CASE("spikes are outliers, Gaussian heights are not", "[filter][statistics]") {
  const Grid grid{{80, 80}, 1, 1};
  Field z = white_noise(grid.shape, 53);
  z(3, 4) = 30, z(70, 2) = -25, z(40, 40) = 12, z(10, 10) = none;
  const WithoutOutliers clean = without_outliers(z, grid, {5, 5}, 6);
  CHECK(clean.removed == 3);
  CHECK(relative_error(clean.deviation, 0.99) <=
        4 * 1.17 / 80);  // the median's deviation has an error of 1.17/√N
  CHECK(std::abs(clean.furthest - 30) <= 2);
  CHECK(std::isnan(clean.heights(3, 4)));
  CHECK(clean.heights.isNaN().count() == 4);
  CHECK(largest_difference(clean.heights, clean.heights.isNaN().select(none, z)) == 0);
}

TEST_CASE("heights without a scale have no outliers that could be told", "[filter][contract]") {
  const Grid grid{{20, 20}, 1, 1};
  Field z = Field::Constant(20, 20, 3);
  CHECK(without_outliers(z, grid, {3, 3}, 5).removed == 0);
  z(5, 5) = 4;
  CHECK_THROWS_AS(without_outliers(z, grid, {3, 3}, 5), DataError);
  CHECK(without_outliers(Field::Constant(20, 20, none), grid, {3, 3}, 5).removed == 0);
  for (double k : {0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(without_outliers(z, grid, {3, 3}, k), ParameterError);
}
