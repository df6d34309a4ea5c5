#include "acf/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/words.hpp"

namespace asperity {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double oriented_beyond = 1e-12, agree_within = 1e-9;  // of R(0,0)
constexpr double rounded_within = 1e-3;                         // of a step

[[noreturn]] void refuse(const std::string& message) { throw DataError("acf", message); }

std::string at(Index p, Index q) { return "at lag (" + std::to_string(p) + ", " + std::to_string(q) + ")"; }

void check_table(const Field& table) {
  if (table.rows() < 1 || table.cols() < 1) refuse("the table is empty");
  if (table.cols() % 2 == 0)
    refuse("the table has " + std::to_string(table.cols()) + " columns: lags -Q ... Q are odd in number");
  const Index middle = table.cols() / 2;
  const double variance = table(0, middle);
  if (!(variance > 0 && std::isfinite(variance)))
    refuse("R(0,0) is " + number(variance) + ": must be positive and finite");
  for (Index p = 0; p < table.rows(); ++p)
    for (Index q = -middle; q <= middle; ++q)
      if (std::isnan(table(p, middle + q)))
        refuse("a number is missing " + at(p, q) + " between lags that have one: use fewer lags");
      else if (!(std::abs(table(p, middle + q)) <= variance * (1 + oriented_beyond)))
        refuse("R/R(0,0) is " + number(table(p, middle + q) / variance) + " " + at(p, q) +
               ": it cannot exceed 1");
  for (Index q = 1; q <= middle; ++q)
    if (!(std::abs(table(0, middle + q) - table(0, middle - q)) <= agree_within * variance))
      refuse("R(0,-q) differs from R(0,q) at q = " + std::to_string(q) + ": not an autocorrelation");
}

// Largest |R(p,-q) - R(p,q)|.
double skew(const Field& table) { return (table - table.rowwise().reverse()).abs().maxCoeff(); }

// ---- lags in any order ----

// The step of lags that are whole multiples of it, from the least and the largest of them.
double step_of(const std::vector<LagValue>& values, double LagValue::*lag) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const LagValue& v : values) {
    const double size = std::abs(v.*lag);
    most = std::max(most, size);
    if (size > 0) least = std::min(least, size);
  }
  return most > 0 ? most / std::round(most / least) : unknown;
}

// The number of steps in a lag.
double steps_in(double lag, double step, const char* name) {
  if (lag == 0) return 0;
  const double steps = std::round(lag / step);
  if (!(std::abs(lag / step - steps) <= rounded_within))
    refuse(std::string(name) + " " + number(lag) + " is not a multiple of the step " + number(step) +
           ": lags must be evenly spaced from 0");
  return steps;
}

// The table of values at whole lags up to these; `largest` of their sizes is R(0,0), or the table is none.
struct WholeLag {
  double p, q, value;
};
Field filled(const std::vector<WholeLag>& values, double most_p, double most_q, double largest) {
  // A quadrant fills half of the half plane, and a little more.
  if (!((most_p + 1) * (2 * most_q + 1) <= 2 * static_cast<double>(values.size())))
    refuse("values are missing: lags up to (" + number(most_p) + ", " + number(most_q) + ") need more than " +
           std::to_string(values.size()));
  const auto middle = static_cast<Index>(most_q);
  Field table = Field::Constant(static_cast<Index>(most_p) + 1, 2 * middle + 1, unknown);
  bool quadrant = true;
  auto set = [&](Index p, Index q, double value) {
    double& entry = table(p, middle + q);
    if (!std::isnan(entry) && !(std::abs(entry - value) <= agree_within * largest))
      refuse("there are two values " + at(p, q));
    entry = value;
  };
  for (const WholeLag& lag : values) {
    const double sign = lag.p < 0 ? -1 : 1;
    const auto p = static_cast<Index>(sign * lag.p), q = static_cast<Index>(sign * lag.q);
    if (!std::isfinite(lag.value)) refuse("the value " + at(p, q) + " is not finite");
    quadrant &= p == 0 || q >= 0;
    set(p, q, lag.value);
    if (p == 0) set(0, -q, lag.value);
  }
  if (quadrant) table.leftCols(middle) = table.rightCols(middle).rowwise().reverse().eval();
  for (Index p = 0; p < table.rows(); ++p)
    for (Index q = -middle; q <= middle; ++q)
      if (std::isnan(table(p, middle + q))) refuse("there is no value " + at(p, q));
  return table;
}

}  // namespace

Target target_of_table(Field half_plane) {
  check_table(half_plane);
  const Index middle = half_plane.cols() / 2;
  const double variance = half_plane(0, middle);
  half_plane /= variance;
  const bool oriented = skew(half_plane) > oriented_beyond;
  const Shape known{half_plane.rows(), middle + 1};
  const auto table = std::make_shared<const Field>(std::move(half_plane));
  Target target([table, middle, oriented](double p, double q) {
    const Index row = std::lround(std::abs(p));
    Index column = std::lround(p < 0 ? -q : q);
    if (!oriented || row == 0) column = std::abs(column);
    return row < table->rows() && std::abs(column) <= middle ? (*table)(row, middle + column) : 0.0;
  });
  target.oriented = oriented;
  target.known = known;
  target.table = table;
  return target;
}

Field known_lags(const Field& half_plane) {
  const Index middle = half_plane.cols() / 2;
  Index rows = half_plane.rows(), columns = middle + 1;
  while (rows > 1 && std::isnan(half_plane(rows - 1, middle))) rows -= 1;
  while (columns > 1 && std::isnan(half_plane(0, middle + columns - 1))) columns -= 1;
  return half_plane.block(0, middle - columns + 1, rows, 2 * columns - 1);
}

Field half_plane_of_quadrant(const Field& quadrant) {
  if (quadrant.size() == 0) refuse("the table is empty");
  const Index middle = quadrant.cols() - 1;
  Field out(quadrant.rows(), 2 * middle + 1);
  out.rightCols(middle + 1) = quadrant;
  out.leftCols(middle) = quadrant.rightCols(middle).rowwise().reverse();
  return out;
}

LagTable table_of_lags(const std::vector<LagValue>& values) {
  if (values.empty()) refuse("the table is empty");
  for (const LagValue& v : values)
    if (!std::isfinite(v.lag_x) || !std::isfinite(v.lag_y)) refuse("a lag is not finite");
  const double dx = step_of(values, &LagValue::lag_x), dy = step_of(values, &LagValue::lag_y);
  std::vector<WholeLag> whole;
  double most_p = 0, most_q = 0, largest = 0;
  for (const LagValue& v : values) {
    whole.push_back({steps_in(v.lag_x, dx, "lag_x"), steps_in(v.lag_y, dy, "lag_y"), v.value});
    largest = std::max(largest, std::abs(v.value));
    most_p = std::max(most_p, std::abs(whole.back().p));
    most_q = std::max(most_q, std::abs(whole.back().q));
  }
  return {filled(whole, most_p, most_q, largest), dx, dy};
}

}  // namespace asperity
