#include "stats/measure/spectra.hpp"

#include "stats/spectrum/leakage.hpp"
#include "stats/spectrum/power_excess.hpp"

namespace asperity {

std::vector<SpectrumPoint> profile_spectrum(const Sample& sample, Axis1D axis, DataWindow window) {
  const Field& z = sample.surface().heights;
  auto out = profile_spectrum(z, sample.grid(), axis, window, sample.threads());
  if (sample.distribution())
    add_excess(out, profile_excess(z, sample.grid(), axis, window, sample.extent(), sample.threads()));
  const Periodic periodic = sample.grid().periodic;
  if (!(axis == Axis1D::x ? periodic.x : periodic.y)) withhold_leakage(out, 0, window);
  return out;
}

std::vector<SpectrumPoint> radial_spectrum(const Sample& sample, DataWindows windows) {
  const Field& z = sample.surface().heights;
  auto out = radial_spectrum(power_spectrum(z, sample.grid(), windows, sample.threads()), sample.grid(),
                             shared_power(z, windows));
  if (sample.distribution())
    add_excess(out, radial_excess(z, sample.grid(), windows, sample.extent(), sample.threads()));
  const Periodic periodic = sample.grid().periodic;
  if (!periodic.both()) withhold_leakage(out, 1, periodic.x ? windows.y : windows.x);
  return out;
}

}  // namespace asperity
