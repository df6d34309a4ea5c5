// Medians of windows.
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
