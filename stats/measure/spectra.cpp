#include "stats/measure/spectra.hpp"

#include "stats/filter/missing.hpp"
#include "stats/spectrum/power_excess.hpp"
#include "stats/spectrum/resolution.hpp"

namespace asperity {

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

}  // namespace asperity
