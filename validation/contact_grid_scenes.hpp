/// Random contacts whose surface is known between the samples: a sum of waves, or smooth.
///
/// Scene k is of one of seven kinds: smooth bodies off the grid's middle, rough spheres, the same at a limit
/// pressure, periodic surfaces at 2 to 60 % contact, oblong cells and bodies, rough spheres under a prescribed
/// approach, and spheres with the heights of two instruments (tests/data), short waves filtered out up to 4 to
/// 10 cells and refined by their own band limit. Other roughness is self-affine (H 0.3 to 0.8) or Gaussian,
/// with a shortest wave of 3.5 to 32 cells, sampled at the cells' centres. The cells are 64 to 512 a side.
/// Every other smooth and oblong scene is under a prescribed approach as well.
///
/// Hard scenes are of nine other kinds, on 48 to 128 cells a side: spheres and ellipsoids at a limit pressure
/// of 0.5 to 0.95 of Hertz's largest (cap, capped-ellipsoid), ellipsoids of radii 1 : 5 to 5 : 1, lays 3 to 10
/// times as long as wide and turned, waves of 3 to 5 cells, contacts of a radius of 3 to 6 cells, periodic
/// surfaces at a limit pressure of 0.3 to 1.5 of modulus times slope, cells three times as long as wide, and
/// sliding spheres, μ to 0.5. Every other scene of short-waves, small and thin-cells is at a limit pressure too,
/// every other lay is periodic.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "contact/bodies.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "transform/plan.hpp"
#include "transform/refinement.hpp"

namespace asperity::grid_scenes {

inline constexpr double pi = std::numbers::pi, side = 1e-3, modulus = 1e11;
inline constexpr double none = std::numeric_limits<double>::infinity();
inline constexpr Index finer = 4;
inline const char* const kinds[] = {"smooth",    "rough",        "capped",           "periodic",
                                    "oblong",    "approach",     "measured",         "cap",
                                    "ellipsoid", "lay",          "capped-ellipsoid", "short-waves",
                                    "small",     "capped-flats", "thin-cells",       "sliding"};
enum Kind : std::size_t {
  smooth,
  rough,
  capped,
  flats,
  oblong,
  approach,
  measured,
  cap,
  ellipsoid,
  lay,
  capped_ellipsoid,
  short_waves,
  small,
  capped_flats,
  thin_cells,
  sliding
};
inline constexpr std::size_t first_hard = cap, hard_kinds = std::size(kinds) - first_hard;

/// Cells along a side, round by round of the kinds.
inline constexpr Index sides[] = {256, 64, 512, 96, 256, 128, 256, 64, 256};
inline constexpr Index hard_sides[] = {64, 96, 48, 128, 96, 64, 128, 48};

/// Those of scene k, with which `finer` times as many do not exceed `largest`.
inline Index cells_of(std::size_t k, Index largest) {
  std::vector<Index> some;
  for (Index n : sides)
    if (finer * n <= largest) some.push_back(n);
  return some.empty() ? largest / finer : some[k / first_hard % some.size()];
}

/// The heights of a file in tests/data.
Field measured_map(const std::string& name);

// A surface as waves of the domain, which repeats.
class Waves {
 public:
  // A lay is `stretch` times as long as wide, turned by `angle`.
  Waves(std::mt19937_64& random, Index longest, Index shortest, double hurst, bool gaussian,
        double stretch = 1, double angle = 0)
      : most_(shortest) {
    std::normal_distribution<double> normal;
    for (Index i = -most_; i <= most_; ++i)
      for (Index j = 0; j <= most_; ++j) {
        const double x = static_cast<double>(i), y = static_cast<double>(j), c = std::cos(angle),
                     sine = std::sin(angle);
        const double k = std::hypot(c * x + sine * y, stretch * (c * y - sine * x)),
                     low = static_cast<double>(longest), high = static_cast<double>(shortest);
        const Complex phase{normal(random), normal(random)};
        if (k == 0 || k > high) continue;
        const double amplitude =
            gaussian ? std::exp(-2 * std::pow(k / high, 2)) : std::pow(std::max(k, low), -1 - hurst);
        waves_.push_back({i, j, amplitude * phase});
      }
    double sum = 0;
    for (const Wave& w : waves_) sum += std::norm(w.amplitude) * (w.j == 0 ? 1 : 2);
    for (Wave& w : waves_) w.amplitude /= std::sqrt(sum);
  }

  // Of unit rms, or nearly, at the centres of these cells.
  Field on(Shape shape) const {
    const RealTransform2D transform(shape);
    AlignedVector<Complex> spectrum(size(transform.spectrum_size()));
    for (const auto& [i, j, amplitude] : waves_) {
      const double shift = pi * (static_cast<double>(i) / static_cast<double>(shape.nx) +
                                 static_cast<double>(j) / static_cast<double>(shape.ny));
      auto add = [&](Index row, const Complex& value) {
        spectrum[size((row + shape.nx) % shape.nx * transform.spectrum_columns() + j)] += value;
      };
      const Complex value = amplitude * std::polar(1.0, shift);
      add(i, j == 0 ? 0.5 * value : value);
      if (j == 0) add(-i, 0.5 * std::conj(value));
    }
    Field out(shape.nx, shape.ny);
    transform.inverse(spectrum.data(), out.data());
    return out;
  }

 private:
  struct Wave {
    Index i, j;
    Complex amplitude;
  };
  Index most_;
  std::vector<Wave> waves_;
};

struct Scene {
  std::size_t kind = 0;
  Shape shape;
  double size_x = side, size_y = side;
  Bodies bodies;
  double rms = 0;
  std::optional<Waves> waves = {};
  Field measured = {};  // of unit rms, on the coarse cells
  double load = 0, limit = none;
  double shift_x = 0, shift_y = 0;  // of the bodies from the middle
  double approach = 0;              // instead of the load, if above 0
  bool periodic = false;
  double friction = 0;
  Grid grid(Index times) const {
    const Shape cells{shape.nx * times, shape.ny * times};
    return {cells, size_x / static_cast<double>(cells.nx), size_y / static_cast<double>(cells.ny), periodic};
  }
  Field heights(Index times) const {
    const Shape cells = grid(times).shape;
    if (measured.size() > 0) return rms * refined(measured, grid(1), {times, times});
    if (!waves) return Field::Zero(cells.nx, cells.ny);
    return rms * waves->on(cells);
  }
  // Off the middle the paraboloid is one in the middle, and a plane.
  Field gap(Index times) const {
    const Grid cells = grid(times);
    const double cx = bodies.curvature_x() * shift_x, cy = bodies.curvature_y() * shift_y;
    return undeformed_gap(cells, bodies) - heights(times) -
           sample(cells, [=](double x, double y) { return cx * x + cy * y; });
  }
};

class Draw {
 public:
  /// Scenes on n cells a side, if above 0.
  explicit Draw(std::uint64_t seed, Index n = 0) : cells_(n), random_(seed) {}

  Scene scene(std::size_t number, Index largest) {
    Scene s = blank(number % first_hard, cells_ > 0 ? cells_ : cells_of(number, largest));
    const Index n = s.shape.nx;
    if (s.kind == oblong) s.shape.ny = n / 4 * 3 / 4 * 4, s.size_y = side * between(0.5, 0.9);
    if (s.kind == measured)
      instrument(s, n);
    else if (s.kind != smooth)
      roughness(s, 3.5, 32);
    if (s.kind == flats) {
      press_flats(s);
      return s;
    }
    const double radius = side * between(4, 30);
    s.bodies.radius[0] = s.kind == oblong ? Radii(radius, radius * between(0.4, 2)) : Radii(radius);
    const double a = between(0.12, 0.3) * std::min(s.size_x, s.size_y);
    press(s, radius, a);
    if (s.kind == capped) s.limit = hertz_pressure_of(s, a) * between(0.7, 1.5);
    const bool every_other = number / first_hard % 2 == 1;
    if (s.kind == approach || (every_other && (s.kind == smooth || s.kind == oblong)))
      s.approach = a * a / radius * between(0.7, 1.3);
    return s;
  }

  Scene hard_scene(std::size_t number) {
    const std::size_t round = number / hard_kinds;
    const std::size_t kind = first_hard + number % hard_kinds;
    Scene s = blank(kind, cells_ > 0 ? cells_ : hard_sides[round % std::size(hard_sides)]);
    const bool every_other = round % 2 == 1;
    if (kind == thin_cells) s.size_y = side / 3;
    const double angle = kind == lay ? between(0, pi) : 0, stretch = kind == lay ? between(3, 10) : 1;
    if (kind == lay)
      roughness(s, 3, 5, stretch, angle);
    else if (kind == short_waves || kind == capped_flats)
      roughness(s, 3, 5);
    else if (kind == thin_cells || kind == sliding)
      roughness(s, 4, 16);
    if (kind == sliding) s.friction = between(0, 0.5);
    if (kind == capped_flats || (kind == lay && every_other)) {
      press_flats(s);
      if (kind == capped_flats) s.limit = modulus * slope_of(s) * between(0.3, 1.5);
      return s;
    }
    const double radius = side * between(4, 30);
    const bool ellipse = kind == ellipsoid || kind == capped_ellipsoid;
    const double ratio = ellipse ? std::exp(between(-1, 1) * std::log(5)) : 1;
    s.bodies.radius[0] = Radii(radius, radius * ratio);
    const double mean = radius * std::sqrt(ratio), width = std::min(s.size_x, s.size_y);
    const double a =
        kind == small ? between(3, 6) * s.grid(1).dx : between(0.08, ellipse ? 0.22 : 0.3) * width;
    press(s, mean, a);
    const bool at_limit = kind == cap || kind == capped_ellipsoid || (every_other && kind != ellipsoid);
    if (at_limit && kind != sliding) s.limit = hertz_pressure_of(s, a) * between(0.5, 0.95);
    return s;
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

  static Scene blank(std::size_t kind, Index n) {
    Scene s;
    s.kind = kind;
    s.shape = {n, n};
    s.bodies.young = {2 * modulus, 2 * modulus};
    s.bodies.poisson = {0, 0};
    return s;
  }

  void roughness(Scene& s, double least_cells, double most_cells, double stretch = 1, double angle = 0) {
    const Index n = std::min(s.shape.nx, s.shape.ny);
    const double cells = std::exp(between(std::log(least_cells), std::log(most_cells)));
    const auto shortest = std::max<Index>(2, static_cast<Index>(static_cast<double>(n) / cells));
    const Index longest = std::max<Index>(1, shortest / 8);
    const bool gaussian = between(0, 1) < 0.3;
    s.waves.emplace(random_, longest, shortest, between(0.3, 0.8), gaussian, stretch, angle);
    s.rms = s.kind == flats ? 1e-6 : std::exp(between(std::log(0.005), std::log(0.1)));
  }

  void press_flats(Scene& s) {
    s.periodic = true;
    s.rms = 1e-6;
    s.load = between(0.01, 0.3) * modulus * slope_of(s) * s.size_x * s.size_y;
  }

  // With Hertz's radius a; roughness is told in the depth of the cap.
  void press(Scene& s, double radius, double a) {
    s.load = 4.0 / 3 * modulus * std::pow(a, 3) / radius;
    s.shift_x = between(-0.5, 0.5) * s.grid(1).dx, s.shift_y = between(-0.5, 0.5) * s.grid(1).dy;
    if (s.rms > 0) s.rms *= a * a / radius;
  }

  static double hertz_pressure_of(const Scene& s, double a) { return 1.5 * s.load / (pi * a * a); }

  // On its own cells, or refined to 128 of n or more.
  void instrument(Scene& s, Index n) {
    const Field map = measured_map(between(0, 1) < 0.5 ? "afm-64x64.nc" : "profiler-96x96.x3p");
    s.shape = shape_of(map);
    const Grid cells = s.grid(1);
    const Index times = std::max<Index>(1, n / s.shape.nx);
    s.measured = remove_form(gaussian_mean_surface(map, cells, between(4, 10) * cells.dx), 2);
    s.measured = refined(s.measured, cells, {times, times});
    s.shape = shape_of(s.measured);
    s.measured /= std::sqrt(s.measured.square().mean());
    if (between(0, 1) < 0.5) s.measured = Field(-s.measured);
    s.rms = std::exp(between(std::log(0.005), std::log(0.1)));
  }

  static double slope_of(const Scene& s) {
    const Grid grid = s.grid(1);
    const Field z = s.heights(1);
    const Index n = z.rows() - 1;
    return std::sqrt(2 * ((z.bottomRows(n) - z.topRows(n)) / grid.dx).square().mean());
  }

  Index cells_;
  std::mt19937_64 random_;
};

}  // namespace asperity::grid_scenes
