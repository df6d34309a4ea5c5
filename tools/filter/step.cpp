#include "tools/filter/step.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/words.hpp"
#include "stats/filter/missing.hpp"

namespace asperity::cli {
namespace {

// Mean, and rms about it, of the points that are there.
std::pair<double, double> mean_and_rms(const Field& z) {
  const auto [sum, count] = sum_of_valid(z);
  if (count == 0) return {0, 0};
  const double mean = sum / count;
  return {mean, std::sqrt(sum_of_valid((z - mean).square()).sum / count)};
}

}  // namespace

std::string figure(double value, const std::string& units) {
  const std::string four = in_digits(value, 4);
  return units == "m" ? format_quantity(to_number<double>(four).value_or(value), units) : four + " " + units;
}

std::string removed(const Field& before, const Field& after, const std::string& units) {
  const auto [mean, rms] = mean_and_rms(before - after);
  const std::string left = figure(mean_and_rms(after).second, units) + " rms is left";
  return fmt::format("removed {} rms about a mean of {}; {}", figure(rms, units), figure(mean, units), left);
}

std::string share_of(Index points, Index all) {
  return std::to_string(points) + " of " + counted(static_cast<std::size_t>(all), "point");
}

Index missing_in(const Field& z) { return has_missing(z) ? z.isNaN().count() : 0; }

}  // namespace asperity::cli
