// The size of a grid, where lengths and points say different things.

#include "dataset/layout.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// 96 points of 3 mm.
Dataset with_axis(const Values& length) {
  Dataset out;
  set_grid(out, {{96, 1}, 3e-3 / 96, 1e-6, false});
  out.find("x")->attributes.set_values("length", length);
  return out;
}

void in_single_precision(Variable& axis) {
  const std::vector<double> points = numbers(axis.values);
  axis.values = std::vector<float>(points.begin(), points.end());
}

}  // namespace

// The attribute was taken whatever its type: cells were 1e-8 too large. Of n points within ±L/2 the two ends
// are each known to ε L/4, and the step between n - 1 of them to ε/2 of L/(n - 1).
TEST_CASE("of a length in single precision beside points in double the points are taken", "[layout][exact]") {
  const std::vector<float> length{3e-3F};
  REQUIRE(relative_error(static_cast<double>(length[0]), 3e-3) >= 1e-9);
  CHECK(relative_error(grid_of(with_axis(length)).dx, 3e-3 / 96) <= 2 * epsilon);
  Dataset data = with_axis(length);
  CHECK(settle_lengths(data).empty());
}

TEST_CASE("of points in single precision beside a length in double the length is taken", "[layout][exact]") {
  Dataset data = with_axis(std::vector<double>{3e-3});
  in_single_precision(*data.find("x"));
  CHECK(relative_error(grid_of(data).dx, 3e-3 / 96) <= epsilon);
  // far from the origin single precision leaves more open: 1e-8 m at 0.1 m, a third of a thousandth of a cell
  std::vector<float> far;
  for (int i = 0; i < 96; ++i) far.push_back(static_cast<float>(0.1 + i * 3e-3 / 96));
  data.find("x")->values = far;
  CHECK(settle_lengths(data).empty());
  CHECK(relative_error(grid_of(data).dx, 3e-3 / 96) <= epsilon);
}

// A program that cuts a dataset and does not know the attribute leaves it as it was: slopes halved, a load of
// 100 N became one of 25 N.
TEST_CASE("a length that disagrees with the points is not taken, and a line says so once",
          "[layout][exact]") {
  for (const double stale : {6e-3, 3e-3 * 97 / 96, 3e-3 * 95 / 96}) {
    Dataset data = with_axis(std::vector<double>{stale});
    CAPTURE(stale);
    CHECK(relative_error(grid_of(data).dx, 3e-3 / 96) <= 2 * epsilon);
    const std::vector<std::string> lines = settle_lengths(data);
    REQUIRE(lines.size() == 1);
    CHECK_THAT(lines[0], Catch::Matchers::StartsWith("x: attribute length 0.00"));
    CHECK_THAT(lines[0], ContainsSubstring("replaced by that of its 96 points, 0.003"));
    CHECK(relative_error(data.at("x").attributes.number("length", 0), 3e-3) <= 2 * epsilon);
    CHECK(settle_lengths(data).empty());
  }
  // What was cut from a period does not continue itself along that axis.
  Dataset period;
  set_grid(period, {{96, 8}, 3e-3 / 96, 1e-3, true});
  period.find("x")->attributes.set("length", 6e-3);
  CHECK(grid_of(period).periodic == Periodic{false, true});
  CHECK_THAT(settle_lengths(period).at(0), ContainsSubstring("a part of a period is not periodic"));
  CHECK(grid_of(period).periodic == Periodic{false, true});
  Dataset single;  // of one point the length is all there is
  set_grid(single, {{1, 1}, 1e-3, 1e-3, false});
  CHECK(settle_lengths(single).empty());
  CHECK(grid_of(single).dx == 1e-3);
}

// ---- other points ----
