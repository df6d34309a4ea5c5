#include "acf/table.hpp"

#include <cmath>
#include <limits>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// 3 lags in x, 2 in y each way, R(0,0) = 4, R(p,-q) ≠ R(p,q).
Field oblique() {
  Field table(3, 5);
  table << 0.5, 2, 4, 2, 0.5,  //
      0.25, 1, 2, 3, 1,        //
      0, 0.125, 1, 1, -0.5;
  return table;
}

Field with(Field table, Index row, Index column, double value) {
  table(row, column) = value;
  return table;
}

// Every lag of the half plane, a step of 0.5 in x and 0.3 in y, rounded to six digits.
std::vector<LagValue> lags_of(const Field& table) {
  std::vector<LagValue> out;
  const Index middle = table.cols() / 2;
  for (Index p = 0; p < table.rows(); ++p)
    for (Index q = -middle; q <= middle; ++q)
      out.push_back({0.5 * static_cast<double>(p), std::round(3e5 * static_cast<double>(q)) / 1e6,
                     table(p, middle + q)});
  return out;
}

}  // namespace

TEST_CASE("a table is a target known at its own lags, even under point reflection, with R(0,0) taken out",
          "[table][exact]") {
  const Field table = oblique();
  const Target target = target_of_table(table);
  CHECK(target.oriented);
  REQUIRE(target.known);
  CHECK(*target.known == Shape{3, 3});
  for (Index p = 0; p < 3; ++p)
    for (Index q = -2; q <= 2; ++q) {
      const auto x = static_cast<double>(p), y = static_cast<double>(q);
      CHECK(target(x, y) == table(p, q + 2) / 4);
      CHECK(target(-x, -y) == target(x, y));
    }
}

// The bound of 1e-12 R(0,0), from both sides.
TEST_CASE("a table is oriented when R(p,-q) differs from R(p,q) by more than 1e-12 of R(0,0)",
          "[table][contract]") {
  Field even = oblique();
  even.leftCols(2) = even.rightCols(2).rowwise().reverse().eval();
  CHECK_FALSE(target_of_table(even).oriented);
  CHECK_FALSE(target_of_table(with(even, 1, 1, 3 + 3e-12)).oriented);
  const Target rounded = target_of_table(with(even, 1, 1, 3 + 3e-12));
  CHECK(rounded(1, -1) == rounded(1, 1));
  CHECK(target_of_table(with(even, 1, 1, 3 + 5e-12)).oriented);
}

TEST_CASE("what can be no autocorrelation is refused by the name acf", "[table][contract]") {
  const Field good = oblique();
  REQUIRE_NOTHROW(target_of_table(good));
  const Field bad[] = {Field(0, 0),
                       Field(0, 5),
                       Field::Zero(3, 5),
                       good.leftCols(4),
                       with(good, 0, 2, -4),
                       with(good, 0, 2, not_a_number),
                       with(good, 0, 2, std::numeric_limits<double>::infinity()),
                       with(good, 1, 0, not_a_number),
                       with(good, 2, 4, 4 * (1 + 1e-11)),
                       with(good, 2, 4, -5),
                       with(good, 0, 1, 2 + 1e-8)};
  for (const Field& table : bad) {
    CAPTURE(table);
    CHECK_THROWS_MATCHES(
        target_of_table(table), DataError,
        Catch::Matchers::Predicate<DataError>([](const DataError& e) { return e.name == "acf"; }));
  }
}

TEST_CASE("a quadrant becomes the half plane of an even autocorrelation", "[table][exact]") {
  Field quadrant(2, 3);
  quadrant << 1, 0.5, 0.25, 0.75, 0.4, 0.2;
  Field half(2, 5);
  half << 0.25, 0.5, 1, 0.5, 0.25, 0.2, 0.4, 0.75, 0.4, 0.2;
  CHECK((half_plane_of_quadrant(quadrant) == half).all());
  CHECK_FALSE(target_of_table(half).oriented);
}

TEST_CASE("lags in any order, on either side of the origin, make the same table", "[table][exact]") {
  const Field table = oblique();
  std::vector<LagValue> values = lags_of(table);
  for (int order = 0; order < 3; ++order) {
    const LagTable out = table_of_lags(values);
    CHECK((out.half_plane == table).all());
    CHECK(out.step_x == 0.5);
    CHECK(out.step_y == Approx(0.3).epsilon(1e-15));
    std::ranges::reverse(values);
    if (order == 1)
      for (LagValue& v : values) v = {-v.lag_x, -v.lag_y, v.value};
  }
  std::vector<LagValue> whole = lags_of(table);
  for (const LagValue& v : lags_of(table)) whole.push_back({-v.lag_x, -v.lag_y, v.value});
  CHECK((table_of_lags(whole).half_plane == table).all());
}

TEST_CASE("lags of one quadrant are taken to be even, those of a profile are a profile", "[table][exact]") {
  const std::vector<LagValue> quadrant{{0, 0, 1}, {0, 2, 0.5}, {3, 0, 0.4}, {3, 2, 0.2}};
  Field half(2, 3);
  half << 0.5, 1, 0.5, 0.2, 0.4, 0.2;
  CHECK((table_of_lags(quadrant).half_plane == half).all());
  const LagTable profile = table_of_lags({{0, 0, 1}, {2, 0, 0.5}, {1, 0, 0.75}});
  CHECK(shape_of(profile.half_plane) == Shape{3, 1});
  CHECK((profile.step_x == 1 && std::isnan(profile.step_y)));
}

TEST_CASE("lags that leave a gap, stand twice, or are not evenly spaced are refused", "[table][contract]") {
  const std::vector<LagValue> good = lags_of(oblique());
  auto changed = [&](std::size_t i, LagValue to) {
    std::vector<LagValue> out = good;
    out[i] = to;
    return out;
  };
  std::vector<LagValue> short_one = good;
  short_one.erase(short_one.begin() + 6);
  const std::vector<LagValue> bad[] = {{},
                                       short_one,
                                       changed(6, good[7]),
                                       changed(6, {0.5, -0.301, 1}),
                                       changed(6, {1e-300, -0.3, 1}),
                                       changed(6, {1e300, -0.3, 1}),
                                       changed(6, {not_a_number, -0.3, 1}),
                                       changed(6, {0.5, -0.3, not_a_number}),
                                       changed(0, {0, -0.6, 0.6})};
  for (const auto& values : bad) CHECK_THROWS_AS(table_of_lags(values), DataError);
}
