#include "contact_scenes.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include "transform/plan.hpp"

namespace asperity {
namespace {

constexpr double side = 3e-3, pi = std::numbers::pi;
constexpr double none = std::numeric_limits<double>::infinity();

/// Gaussian heights whose spectrum is `amplitude(transform)` times that of white noise, sampled at n × n
/// points.
Field filtered_noise(Index fine, Index n, unsigned seed,
                     const std::function<AlignedVector<double>(const RealTransform2D&)>& amplitude) {
  const RealTransform2D transform({fine, fine});
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Field noise = Field::NullaryExpr(fine, fine, [&](Index, Index) { return normal(generator); });
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(noise.data(), spectrum.data());
  const AlignedVector<double> factor = amplitude(transform);
  for (std::size_t k = 0; k < spectrum.size(); ++k) spectrum[k] *= factor[k];
  transform.inverse(spectrum.data(), noise.data());
  noise -= noise.mean();
  return noise(Eigen::seqN(0, n, fine / n), Eigen::seqN(0, n, fine / n));
}

Field exponential_roughness(Index n) {
  const Index fine = std::max<Index>(n, 1024);
  const double length = 0.328125e-3, step = side / static_cast<double>(fine);
  auto lag = [&](Index k) { return step * static_cast<double>(std::min(k, fine - k)); };
  const Field z = filtered_noise(fine, n, 5, [&](const RealTransform2D& transform) {
    const Field acf = Field::NullaryExpr(fine, fine, [&](Index i, Index j) {
      return std::exp(-std::numbers::ln10 * std::hypot(lag(i), lag(j)) / length);
    });
    AlignedVector<Complex> power(static_cast<std::size_t>(transform.spectrum_size()));
    transform.forward(acf.data(), power.data());
    AlignedVector<double> root(power.size());
    for (std::size_t k = 0; k < root.size(); ++k) root[k] = std::sqrt(std::max(0.0, power[k].real()));
    return root;
  });
  return z / std::sqrt(z.square().mean());
}

// Unit rms slope, of the spectrum, on a unit square.
Field self_affine(Index n) {
  const Index fine = std::max<Index>(n, 1024);
  const double hurst = 0.8, roll_off = 4, cut_off = 32;
  auto wave = [&](Index i, Index j) {
    return std::hypot(static_cast<double>(i <= fine / 2 ? i : i - fine), static_cast<double>(j));
  };
  auto filter = [&](double k) {
    return k > 0 && k <= cut_off ? std::pow(std::max(k, roll_off) / roll_off, -1 - hurst) : 0;
  };
  const Field z = filtered_noise(fine, n, 7, [&](const RealTransform2D& transform) {
    AlignedVector<double> amplitude;
    amplitude.reserve(static_cast<std::size_t>(transform.spectrum_size()));
    for (Index i = 0; i < fine; ++i)
      for (Index j = 0; j < transform.spectrum_columns(); ++j) amplitude.push_back(filter(wave(i, j)));
    return amplitude;
  });
  // The expected ratio of slope to height.
  double height = 0, slope = 0;
  for (Index i = -32; i <= 32; ++i)
    for (Index j = -32; j <= 32; ++j) {
      const double k = std::hypot(static_cast<double>(i), static_cast<double>(j)),
                   power = std::pow(filter(k), 2);
      height += power;
      slope += power * std::pow(2 * pi * k, 2);
    }
  return z / std::sqrt(z.square().mean() * slope / height);
}

ContactScene periodic_scene(const std::string& name, Index n) {
  const double step = 1.0 / static_cast<double>(n), pressure = name == "periodic, tenth" ? 0.045 : 0.8;
  return {name, {{n, n}, step, step, true}, -self_affine(n), 1, pressure, none};
}

}  // namespace

ContactScene contact_scene(const std::string& name, Index n) {
  if (name.starts_with("periodic")) return periodic_scene(name, n);
  const Index nx = name == "smooth, oblong" ? 4 * n : n;
  ContactScene scene{name, {{nx, n}, side / static_cast<double>(nx), side / static_cast<double>(n)}};
  scene.gap = undeformed_gap(scene.grid, scene_bodies);
  if (name.starts_with("rough")) scene.gap -= 0.4e-6 * exponential_roughness(n);
  scene.composite_modulus = scene_bodies.composite_modulus();
  scene.load = scene_load;
  scene.limit_pressure = name == "rough, limited" ? 3.6e9 : none;
  return scene;
}

}  // namespace asperity
