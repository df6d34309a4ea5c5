#include "tools/filter/step.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/words.hpp"
#include "stats/filter/missing.hpp"

namespace asperity::cli {

std::string figure(double value, const std::string& units) {
  if (units != "m") return in_digits(value, 4) + " " + units;
  return format_quantity(to_number<double>(in_digits(value, 4)).value_or(value), units);
}

// About the first value, so that an offset costs no digits.
void Removal::Spread::add(const Field& z) {
  if (z.isNaN().all()) return;
  if (count == 0)
    for (const double value : z.reshaped<Eigen::RowMajor>())
      if (!std::isnan(value)) {
        base = value;
        break;
      }
  for (Index i = 0; i < z.rows(); ++i) {
    const Eigen::ArrayXd above = z.row(i).transpose() - base;
    const ValidSum row = sum_of_valid(above);
    sum += row.sum;
    count += row.count;
    squares += sum_of_valid(above.square()).sum;
  }
}

double Removal::Spread::rms() const {
  const double mean = sum / count;
  return count > 0 ? std::sqrt(std::max(0.0, squares / count - mean * mean)) : 0;
}

void Removal::add(const Field& before, const Field& after) {
  gone_.add(before - after);
  left_.add(after);
}

std::string Removal::words(const std::string& units) const {
  const double rms = gone_.rms(), mean = gone_.mean(), left = left_.rms();
  const std::string rest = figure(left, units) + " rms is left";
  if (rms + std::abs(mean) <= 1e-12 * (left + std::abs(left_.mean())))
    return "removed nothing but round-off; " + rest;
  return fmt::format("removed {} rms about a mean of {}; {}", figure(rms, units),
                     figure(std::abs(mean) > 1e-9 * rms ? mean : 0, units), rest);
}

std::string removed(const Field& before, const Field& after, const std::string& units) {
  Removal out;
  out.add(before, after);
  return out.words(units);
}

std::string share_of(Index points, Index all) {
  return std::to_string(points) + " of " + counted(static_cast<std::size_t>(all), "point");
}

Index missing_in(const Field& z) { return has_missing(z) ? z.isNaN().count() : 0; }

}  // namespace asperity::cli
