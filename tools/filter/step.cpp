#include "tools/filter/step.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"

namespace asperity::cli {

std::string figure(double value, const std::string& units) {
  if (units != "m") return in_digits(value, 4) + " " + units;
  return format_quantity(to_number<double>(in_digits(value, 4)).value_or(value), units);
}

// About its mean, so that an offset costs no digits.
Spread::Spread(const Field& z) {
  if (z.isNaN().all()) return;
  mean = asperity::mean(z);
  const ValidSum squares = sum_of_valid((z - mean).square());
  rms = std::sqrt(squares.sum / squares.count);
}

std::string Removal::words(const std::string& units) const {
  const auto [mean, rms] = gone;
  const std::string rest = figure(left.rms, units) + " rms is left";
  if (rms + std::abs(mean) <= 1e-12 * (left.rms + std::abs(left.mean)))
    return "removed nothing but round-off; " + rest;
  return fmt::format("removed {} rms about a mean of {}; {}", figure(rms, units),
                     figure(std::abs(mean) > 1e-9 * rms ? mean : 0, units), rest);
}

std::string removed(const Field& before, const Field& after, const std::string& units) {
  return Removal(before, after).words(units);
}

std::string share_of(Index points, Index all) {
  const double percent = 100 * static_cast<double>(points) / static_cast<double>(all);
  return std::to_string(points) + " of " + counted(all, "point") +
         (points > 0 ? " (" + in_digits(percent, 2) + " %)" : "");
}

Index missing_in(const Field& z) { return has_missing(z) ? z.isNaN().count() : 0; }

}  // namespace asperity::cli
