#include "stats/measure/spectra.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "stats/filter/missing.hpp"
#include "stats/spectrum/power_excess.hpp"
#include "stats/spectrum/resolution.hpp"

namespace asperity {
namespace {

constexpr double rounded_off = 1e-6;

}  // namespace

std::vector<SpectrumPoint> profile_spectrum(const Sample& sample, Axis1D axis, DataWindow window) {
  const Surface& surface = sample.surface();
  const Grid& grid = sample.grid();
  const DataWindows windows = windows_along(axis, window);
  const LagField psd = power_spectrum(surface.heights, grid, windows, sample.threads());
  const SharedPower shared = shared_power(surface.heights, windows);
  auto out = profile_spectrum(psd, grid, axis, shared);
  pool_degrees(out, PointKind::profile);
  if (sample.amplitudes_may_vary())
    add_excess(out,
               profile_excess(surface.heights, grid, axis, psd, shared, sample.extent(), sample.threads()));
  const bool along_x = axis == Axis1D::x;
  if (!(along_x ? grid.periodic.x : grid.periodic.y))
    judge_resolution(out,
                     {PointKind::profile, window, surface.degree, along_x ? grid.shape.nx : grid.shape.ny});
  if (has_missing(surface.heights))
    judge_holes(out, profile_spectrum(spread_by_holes(psd, surface.heights), grid, axis, shared),
                PointKind::profile);
  if ((along_x ? grid.shape.nx : grid.shape.ny) % 2 == 0)
    out.back().density /= 2, out.back().standard_error /= 2;
  return out;
}

std::vector<SpectrumPoint> radial_spectrum(const Sample& sample, DataWindows windows) {
  const Surface& surface = sample.surface();
  const Grid& grid = sample.grid();
  const LagField psd = power_spectrum(surface.heights, grid, windows, sample.threads());
  const SharedPower shared = shared_power(surface.heights, windows);
  auto out = radial_spectrum(psd, grid, shared);
  pool_degrees(out, PointKind::ring);
  if (sample.amplitudes_may_vary())
    add_excess(out, radial_excess(surface.heights, grid, psd, shared, sample.extent(), sample.threads()));
  if (!grid.periodic.both())
    judge_resolution(out, {PointKind::ring, grid.periodic.x ? windows.y : windows.x, surface.degree});
  if (has_missing(surface.heights))
    judge_holes(out, radial_spectrum(spread_by_holes(psd, surface.heights), grid, shared), PointKind::ring);
  return out;
}

// ---- of several maps ----

CommonWaveNumbers::Reach CommonWaveNumbers::Reach::of(double step, double spacing, double finest) {
  const double shortest = std::numbers::pi / spacing;
  return {step, spacing > finest * (1 + rounded_off) ? shortest / 3 : shortest};
}

CommonWaveNumbers::CommonWaveNumbers(std::vector<Reach> maps) {
  std::ranges::sort(maps, std::greater<>(), &Reach::step);
  double low = INFINITY, high = -INFINITY;
  for (const auto& [step, last] : maps) {
    const double number = std::floor(last / step * (1 + rounded_off));
    for (double k = 1; k <= number; ++k) {
      const double from = (k - 0.5) * step, to = from + step;
      if (k * step < low) classes_.push_back({from, std::min(to, low)});
      if (k * step > high) classes_.push_back({std::max(from, high), to});
      if (!(low < INFINITY)) classes_.pop_back();  // of the first it is both
    }
    low = std::min(low, step / 2), high = std::max(high, (number + 0.5) * step);
  }
  std::ranges::sort(classes_, {}, &Class::from);
}

std::vector<SpectrumPoint> CommonWaveNumbers::means(const std::vector<SpectrumPoint>& points,
                                                    const Reach& of) const {
  const auto& [step, last] = of;
  std::vector<SpectrumPoint> out;
  for (const auto& [from, to] : classes_) {
    SpectrumPoint mean{.wave_number = (from + to) / 2};
    double reached = 0, number = 0;
    for (const SpectrumPoint& point : points) {
      const double centre = std::round(point.wave_number / step) * step,
                   part = std::min(to, centre + step / 2) - std::max(from, centre - step / 2);
      if (!(part > rounded_off * step) || centre > last * (1 + rounded_off)) continue;
      const double weight = part * point.count;
      mean.density += weight * (point.no_error == NoError::none ? point.density : NAN);
      mean.standard_error = number == 0 ? point.standard_error : NAN;
      reached += part, mean.count += weight, ++number;
    }
    mean.density = reached < (1 - rounded_off) * (to - from) ? NAN : mean.density / mean.count;
    out.push_back(mean);
  }
  return out;
}

}  // namespace asperity
