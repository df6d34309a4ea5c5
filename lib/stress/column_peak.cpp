// Above one cell: the columns through the cells' centres.
#include <algorithm>
#include <cmath>
#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include "core/calibration.hpp"
#include "stress/peak.hpp"

namespace asperity {
namespace {

using calibration::stress::scan_ratio;
constexpr double settled = 1e-4;  // of the depth: 1e-8 of the value
constexpr int most_steps = 24;
const double beside_ratio = std::sqrt(scan_ratio);

// Of the cell that holds a place.
double centre_near(double place, double length, double spacing, Index n, bool periodic) {
  if (periodic) place = std::remainder(place, length);
  const auto cell = static_cast<Index>(std::floor((place + 0.5 * length) / spacing));
  return (static_cast<double>(std::clamp<Index>(cell, 0, n - 1)) + 0.5) * spacing - 0.5 * length;
}

// The maximum of a column between a and c, of which b is higher than both, by Brent's method.
template <class Value>
double peak_between(const Value& value, const StressPlace& a, const StressPlace& b, const StressPlace& c) {
  const gsl_function depth_below = {[](double z, void* of) { return -(*static_cast<const Value*>(of))(z); },
                                    const_cast<void*>(static_cast<const void*>(&value))};
  const std::unique_ptr<gsl_min_fminimizer, void (*)(gsl_min_fminimizer*)> brent(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
  gsl_min_fminimizer_set_with_values(brent.get(), const_cast<gsl_function*>(&depth_below), b.z, -b.value, a.z,
                                     -a.value, c.z, -c.value);
  for (int k = 0; k < most_steps; ++k) {
    if (gsl_min_fminimizer_iterate(brent.get()) != GSL_SUCCESS) break;
    if (gsl_min_fminimizer_x_upper(brent.get()) - gsl_min_fminimizer_x_lower(brent.get()) < settled * c.z)
      break;
  }
  return gsl_min_fminimizer_x_minimum(brent.get());
}

}  // namespace

// From the depth of a place the next maximum up or down: brackets by steps, then the maximum between.
StressPlace PeakClimber::column_peak(const StressPlace& from) const {
  const Grid& g = body_.grid;
  const double x = centre_near(from.x, g.size_x(), g.dx, g.shape.nx, g.periodic.x),
               y = centre_near(from.y, g.size_y(), g.dy, g.shape.ny, g.periodic.y);
  auto value_at = [&](double z) { return value(x, y, z); };
  auto at = [&](double z) { return StressPlace{value_at(z), x, y, z}; };
  auto over = [&](double z) { return std::max(below_, z > 2 * shallowest_ ? z / scan_ratio : 0); };
  auto under = [&](double z) { return std::min(field_, std::max(scan_ratio * z, 2 * shallowest_)); };
  StressPlace b = at(std::clamp(from.z, below_, field_)), a = at(over(b.z)), c = at(under(b.z));
  while (c.value > b.value && c.z < field_) a = b, b = c, c = at(under(b.z));
  while (a.value > b.value && a.z > below_) c = b, b = a, a = at(over(b.z));
  // Highest at an end: nearer to it until a place between is higher.
  const bool at_top = a.value >= b.value;
  const StressPlace end = at_top ? a : c;
  while (!(b.value > a.value && b.value > c.value)) {
    StressPlace& other = at_top ? c : a;
    if (b.z != end.z) other = b;
    if (std::abs(other.z - end.z) < 1e-3 * shallowest_) return end;
    b = at(end.z + 0.2 * (other.z - end.z));
  }
  return at(peak_between(value_at, a, b, c));
}

// From column to higher column beside it, there at three depths: a ridge may lead across both.
StressPlace PeakClimber::centres_peak(const StressPlace& from) const {
  const Grid& g = body_.grid;
  StressPlace top = column_peak(from);
  for (int steps = 0; steps < most_steps; ++steps) {
    StressPlace beside = top;
    for (int p = -1; p <= 1; ++p)
      for (int q = -1; q <= 1; ++q)
        for (double z : {top.z / beside_ratio, top.z, std::min(top.z * beside_ratio, field_)}) {
          if ((p == 0 && q == 0) || z < below_) continue;
          const double x = centre_near(top.x + p * g.dx, g.size_x(), g.dx, g.shape.nx, g.periodic.x),
                       y = centre_near(top.y + q * g.dy, g.size_y(), g.dy, g.shape.ny, g.periodic.y);
          if (const double f = value(x, y, z); f > beside.value) beside = {f, x, y, z};
        }
    if (!(beside.value > top.value)) break;
    top = column_peak(beside);
  }
  return top;
}

}  // namespace asperity
