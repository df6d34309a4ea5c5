#include "spectrum_points.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "stats/measure/spectra.hpp"

namespace asperity {
namespace {

// By Simpson's rule.
double variance_of_heights(const textures::Texture& texture) {
  if (!texture.heights) return 1;
  constexpr int steps = 20000;
  constexpr double end = 8;
  double all = 0, mean = 0, square = 0;
  for (int i = 0; i <= steps; ++i) {
    const double y = end * (2.0 * i / steps - 1), z = texture.heights(y);
    const double weight = (i == 0 || i == steps ? 1 : 2 + 2 * (i % 2)) * std::exp(-y * y / 2);
    all += weight, mean += weight * z, square += weight * z * z;
  }
  return square / all - std::pow(mean / all, 2);
}

// Lags -P … P.
Eigen::ArrayXd cosines(const Eigen::ArrayXd& lags, Index n) {
  Eigen::ArrayXd out(n / 2 + 1);
  for (Index k = 0; k < out.size(); ++k) {
    out(k) = lags(0);
    for (Index p = 1; p < lags.size(); ++p)
      out(k) += 2 * lags(p) *
                std::cos(2 * std::numbers::pi * static_cast<double>(k * p % n) / static_cast<double>(n));
  }
  return out;
}

// R wrapped onto the field, whose transform is C at the field's wave numbers.
AlignedVector<double> wrapped(const LagField& lags, Shape shape) {
  AlignedVector<double> out(static_cast<std::size_t>(shape.cells()));
  auto within = [](Index i, Index n) { return (i % n + n) % n; };
  for (Index p = -lags.max_p(); p <= lags.max_p(); ++p)
    for (Index q = -lags.max_q(); q <= lags.max_q(); ++q)
      out[static_cast<std::size_t>(within(p, shape.nx) * shape.ny + within(q, shape.ny))] += lags(p, q);
  return out;
}

// The first of a spectrum is at wave number `first`.
void add(Parameters& out, const std::string& name, const std::vector<SpectrumPoint>& spectrum, Index first) {
  for (const Index k : {2, 3, 5, 12, 40})
    if (const auto at = static_cast<std::size_t>(k - first); at < spectrum.size())
      out.push_back({.name = fmt::format("{}_{}", name, k),
                     .value = spectrum[at].density,
                     .unit = "",
                     .standard_error = spectrum[at].standard_error,
                     .meaning = "",
                     .interval = spectrum[at].interval()});
}

std::vector<SpectrumPoint> points(const Eigen::ArrayXd& densities) {
  std::vector<SpectrumPoint> out;
  for (const double density : densities) out.push_back({.density = density});
  return out;
}

}  // namespace

Parameters spectrum_points(const Sample& sample) {
  const DataWindows windows = default_windows(sample.grid());
  Parameters out;
  add(out, "psd_x", profile_spectrum(sample, Axis1D::x, windows.x), 0);
  add(out, "psd_y", profile_spectrum(sample, Axis1D::y, windows.y), 0);
  add(out, "psd_ring", radial_spectrum(sample, windows), 1);
  return out;
}

Parameters true_spectrum_points(const textures::Texture& texture, Shape shape, double spacing, Index reach) {
  const LagField rho = textures::correlation_of_heights(texture, {reach, reach}, reach);
  const RealTransform2D transform(shape);
  AlignedVector<Complex> power(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(wrapped(rho, shape).data(), power.data());
  const double square = variance_of_heights(texture) * spacing * spacing;
  const LagField surface = LagField::of({shape.nx / 2, shape.ny / 2}, [&](Index p, Index q) {
    const Index k = q < 0 ? (shape.nx - p) % shape.nx : p;
    return square * spacing * spacing *
           power[static_cast<std::size_t>(k * transform.spectrum_columns() + std::abs(q))].real();
  });
  Parameters out;
  add(out, "psd_x", points(square * spacing * cosines(rho.along_x(), shape.nx)), 0);
  add(out, "psd_y", points(square * spacing * cosines(rho.along_y(), shape.ny)), 0);
  const SharedPower any = shared_power(Field::Zero(shape.nx, shape.ny), {});
  add(out, "psd_ring", radial_spectrum(surface, {shape, spacing, spacing, false}, any), 1);
  return out;
}

}  // namespace asperity
