#include "stats/filter/row_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

constexpr const char* option = "align-rows";
constexpr double bound_of_jumps = 5, deviation_of_median_size = 1.4826;  // K; 1/Φ⁻¹(3/4)

// Of numbers that are there; NaN of none.
template <class Numbers>
double median_of(const Numbers& numbers) {
  std::vector<double> there;
  for (const double x : numbers)
    if (!std::isnan(x)) there.push_back(x);
  if (there.empty()) return NAN;
  const auto middle = there.begin() + std::ssize(there) / 2;
  std::ranges::nth_element(there, middle);
  return there.size() % 2 == 1 ? *middle : (*middle + *std::max_element(there.begin(), middle)) / 2;
}

// As a user counts and sees them: "line 3 along x".
std::string line_word(Index line, Axis1D along) {
  return "line " + std::to_string(line) + " along " + (along == Axis1D::x ? "x" : "y");
}

void check_rows(const Grid& grid, const RowAlignment& how) {
  const bool x = how.along == Axis1D::x;
  const Index points = x ? grid.shape.nx : grid.shape.ny, lines = x ? grid.shape.ny : grid.shape.nx;
  const std::string axis = x ? "x" : "y";
  if (grid.periodic.any())
    throw ParameterError(option, std::string("the map is periodic along ") + (grid.periodic.x ? "x" : "y") +
                                     ", and scan lines are not: align them before the map is made so");
  if (lines < 2)
    throw ParameterError(option, "there is one line along " + axis + ", and none to align it with");
  if (points < how.degree + 2)
    throw ParameterError(option, "of lines along " + axis + " of " + counted(points, "point") +
                                     " a polynomial of degree " + std::to_string(how.degree) +
                                     " leaves nothing: " + std::to_string(how.degree + 2) +
                                     " points are needed");
}

// The lines with points.
std::vector<Index> lines_there(const Field& lines) {
  std::vector<Index> out;
  for (Index j = 0; j < lines.rows(); ++j)
    if (!lines.row(j).isNaN().all()) out.push_back(j);
  if (out.size() < 2)
    throw ParameterError(option, std::to_string(out.size()) + " of the lines has points: two are needed");
  return out;
}

void take_polynomials(Field& lines, const std::vector<Index>& there, const RowAlignment& how) {
  for (const Index j : there) try {
      lines.row(j) = remove_form(Field(lines.row(j)), how.degree);
    } catch (const ParameterError& error) {
      throw ParameterError(option, line_word(j, how.along) + ": " + error.what() +
                                       ": give a lower one, or fill or crop the map");
    }
}

// A step to line `to` from the one with points before it.
struct LineStep {
  Index to = 0;
  double lines = 1, height = 0;  // how far and how high
};

std::vector<LineStep> steps_between(const Field& lines, const std::vector<Index>& there, Axis1D along) {
  std::vector<LineStep> out;
  for (std::size_t k = 1; k < there.size(); ++k) {
    const Index from = there[k - 1], to = there[k];
    out.push_back({to, static_cast<double>(to - from), median_of(lines.row(to) - lines.row(from))});
    if (std::isnan(out.back().height))
      throw ParameterError(option, line_word(to, along) + " has no place in common with line " +
                                       std::to_string(from) + ": align by the median, or fill or crop the map");
  }
  return out;
}

// (4): leaves of the steps those that jump, less c.
void keep_jumps(std::vector<LineStep>& steps, AlignedRows& out, double least) {
  std::vector<double> heights;
  for (const LineStep& s : steps) heights.push_back(s.height / s.lines);
  const double usual = median_of(heights);
  for (double& height : heights) height = std::abs(height - usual);
  const double deviation = std::max(deviation_of_median_size * median_of(heights), least);
  double shares = 0;
  std::size_t behind = steps.size();  // lines from this step on
  for (LineStep& s : steps) {
    s.height -= usual * s.lines;
    const double f = static_cast<double>(behind--) / static_cast<double>(out.lines);
    if (std::abs(s.height) <= bound_of_jumps * deviation * s.lines) {
      s.height = 0;
      continue;
    }
    ++out.jumps, shares += f * (1 - f);
    out.largest = std::max(out.largest, std::abs(s.height));
  }
  out.taken = deviation * std::sqrt(shares);
}

void take_steps(Field& lines, const std::vector<LineStep>& steps) {
  double offset = 0;
  for (const LineStep& s : steps) lines.row(s.to) -= offset += s.height;
}

double round_off_in(const Field& z) {
  return 4 * std::numeric_limits<double>::epsilon() * z.isNaN().select(0, z).abs().maxCoeff();
}

}  // namespace

AlignedRows aligned_rows(const Field& z, const Grid& grid, const RowAlignment& how) {
  using enum RowAlignment::Method;
  check_rows(grid, how);
  Field lines = lines_of(z, how.along);
  const std::vector<Index> there = lines_there(lines);
  AlignedRows out{.heights = {}, .lines = std::ssize(there)};
  if (how.method == median) {
    for (const Index j : there) lines.row(j) -= median_of(lines.row(j));
  } else if (how.method == polynomial) {
    take_polynomials(lines, there, how);
  } else {
    std::vector<LineStep> steps = steps_between(lines, there, how.along);
    const double least = std::max(how.step / std::sqrt(12.0), round_off_in(z));
    if (how.method == jumps) keep_jumps(steps, out, least);
    take_steps(lines, steps);
  }
  out.heights = lines_of(lines, how.along);
  const ValidSum squares = sum_of_valid(remove_form(z - out.heights).square());
  out.removed = std::sqrt(squares.sum / squares.count);
  return out;
}

}  // namespace asperity
