/// Fields whose statistics are known.
#pragma once

#include <numbers>

#include "stats/spatial/pairs.hpp"
#include "support.hpp"
#include "transform/plan.hpp"

namespace asperity::test {

inline Grid grid(Index nx, Index ny, bool periodic = false) { return {{nx, ny}, 1.0, 1.0, periodic}; }

/// A sin(2π c (i+½)/nx): whole periods in x, the same in every column.
inline Field sine(Shape shape, double amplitude, int periods) {
  const double q = 2 * std::numbers::pi * periods / static_cast<double>(shape.nx);
  return Field::NullaryExpr(shape.nx, shape.ny, [=](Index i, Index) {
    return amplitude * std::sin(q * (static_cast<double>(i) + 0.5));
  });
}

/// Independent Gaussian heights of variance 1.
inline Field white_noise(Shape shape, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index, Index) { return normal(generator); });
}

/// The sum of a × b neighbours of white noise, over √(ab): a Gaussian field of variance 1.
inline Field moving_average(Shape shape, Shape window, unsigned seed) {
  const Field noise = white_noise({shape.nx + window.nx - 1, shape.ny + window.ny - 1}, seed);
  Field z = Field::Zero(shape.nx, shape.ny);
  for (Index k = 0; k < window.nx; ++k)
    for (Index l = 0; l < window.ny; ++l) z += noise.block(k, l, shape.nx, shape.ny);
  return z / std::sqrt(static_cast<double>(window.cells()));
}

/// Its correlation, (1 - |p|/a)(1 - |q|/b).
inline LagField triangular_correlation(Shape window) {
  auto share = [](Index lag, Index n) {
    return 1 - static_cast<double>(std::abs(lag)) / static_cast<double>(n);
  };
  return LagField(Field::NullaryExpr(window.nx, 2 * window.ny - 1, [&](Index p, Index column) {
    return share(p, window.nx) * share(column - (window.ny - 1), window.ny);
  }));
}

/// A periodic Gaussian field of variance 1 with the correlation exp(-r²/length²), length in samples: white
/// noise filtered by exp(-q² length²/8).
inline Field gaussian_acf_field(Shape shape, double length, unsigned seed) {
  const RealTransform2D transform(shape);
  const Field noise = white_noise(shape, seed);
  AlignedVector<double> z(noise.data(), noise.data() + noise.size());
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(z.data(), spectrum.data());
  auto wave = [](Index k, Index n) {
    return 2 * std::numbers::pi * static_cast<double>(2 * k > n ? k - n : k) / static_cast<double>(n);
  };
  double power = 0;
  for (Index k = 0; k < shape.nx; ++k)
    for (Index l = 0; l < transform.spectrum_columns(); ++l) {
      const double q = std::hypot(wave(k, shape.nx), wave(l, shape.ny));
      const double filter = std::exp(-q * q * length * length / 8);
      spectrum[static_cast<std::size_t>(k * transform.spectrum_columns() + l)] *= filter;
      power += (l == 0 || 2 * l == shape.ny ? 1 : 2) * filter * filter;
    }
  transform.inverse(spectrum.data(), z.data());
  return Eigen::Map<const Field>(z.data(), shape.nx, shape.ny) /
         std::sqrt(power * static_cast<double>(shape.cells()));
}

/// The mean and the variance of numbers that come one by one.
struct Spread {
  double count = 0, sum = 0, squares = 0;

  void add(double x) { ++count, sum += x, squares += x * x; }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt((squares - sum * sum / count) / (count - 1)); }
};

}  // namespace asperity::test
