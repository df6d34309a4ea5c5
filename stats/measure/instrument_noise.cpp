#include "stats/measure/instrument_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/hybrid/spectral_moments.hpp"

namespace asperity {
namespace {

// What white noise of this mean square adds.
SpectralMoments moments_of_noise(double square, const Grid& grid) {
  const double x = 1 / (grid.dx * grid.dx), y = 1 / (grid.dy * grid.dy);
  return {.m00 = square,
          .m20 = 2 * x * square,
          .m11 = 0,
          .m02 = 2 * y * square,
          .m40 = 6 * x * x * square,
          .m31 = 0,
          .m22 = 4 * x * y * square,
          .m13 = 0,
          .m04 = 6 * y * y * square};
}

// To a figure, or to its square.
struct Share {
  double of_noise = unknown;  // none: not a figure of these
  bool root = false;
};

Share share_of(const std::string& name, const SpectralMoments& noise, double direction) {
  const double angle = name.ends_with("_y") ? std::numbers::pi / 2 : name.ends_with("_x") ? 0 : direction;
  if (name == "Sq") return {noise.m00, true};
  if (name == "m0") return {noise.m00};
  if (name == "Sdq") return {noise.m20 + noise.m02, true};
  if (name.starts_with("m2_")) return {noise.along(angle).m2};
  if (name.starts_with("m4_")) return {noise.along(angle).m4};
  return {};
}

Parameter freed(const Parameter& of, const Share& share) {
  auto without = [&](double v) {
    return share.root ? std::sqrt(std::max(0.0, v * v - share.of_noise)) : std::max(0.0, v - share.of_noise);
  };
  Parameter out = of;
  out.name += "_without_noise";
  out.meaning += ", without the instrument's noise";
  out.value = without(of.value), out.interval.reset();
  if (!(out.value > 0)) {
    const double noise = share.root ? std::sqrt(share.of_noise) : share.of_noise;
    out.why = "no value: " + number(noise) + " of noise alone is not below " + of.name;
    out.value = out.standard_error = unknown;
    return out;
  }
  const Interval ends = of.interval_95();
  if (share.root) out.standard_error *= of.value / out.value;
  if (ends.known()) out.interval = Interval::of(out.value, without(ends.low), without(ends.high));
  return out;
}

}  // namespace

std::optional<double> noise_of_repeated(const Field& a, const Field& b) {
  const auto there = a.isFinite() && b.isFinite();
  const auto n = static_cast<double>(there.count());
  if (n < 2) return {};
  auto square = [&](const Field& z) {
    const double mean = there.select(z, 0).sum() / n;
    return there.select(z - mean, 0).square().sum() / (n - 1);
  };
  const double of_difference = square(a - b);
  if (!(of_difference > 0 && of_difference < (square(a) + square(b)) / 2)) return {};
  return std::sqrt(of_difference / 2);
}

void check_noise(double noise, const Sample& sample) {
  const std::string& unit = sample.surface().units;
  if (!(noise > 0)) throw ParameterError("noise", "is not above 0 " + unit);
  if (const double sq = sample.moments().sq; !(noise < sq))
    throw ParameterError("noise", "is not below the Sq of " + sample.surface().variable + ", " + number(sq) +
                                      " " + unit + ": it is the rms difference of two maps of one place " +
                                      "over the root of 2");
}

Parameters without_noise(const Parameters& rows, double noise, const Grid& grid,
                         const std::optional<Direction>& direction) {
  const SpectralMoments of_noise = moments_of_noise(noise * noise, grid);
  Parameters out;
  for (const Parameter& row : rows)
    if (const Share share = share_of(row.name, of_noise, direction ? direction->angle : 0);
        std::isfinite(share.of_noise) && std::isfinite(row.value))
      out.push_back(freed(row, share));
  return out;
}

}  // namespace asperity
