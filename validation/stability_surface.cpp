#include <limits>

#include "acf/kernel.hpp"
#include "stability.hpp"
#include "surface/running_moments.hpp"
#include "surface/synthesis.hpp"

namespace asperity {
namespace {

Field kernel(Index n, Index m) {
  return Field::NullaryExpr(n, m, [&](Index k, Index l) {
    return std::exp(-std::hypot(static_cast<double>(k - n / 2), static_cast<double>(l - m / 2)) / 3);
  });
}

// By transform against the sum (1) of surface/synthesis.hpp, within ε log2(P Q) Σ|kernel| max|η|, taken as 20
// and 5.
Finding two_ways(Shape kernel_shape, Shape surface, bool periodic) {
  const Field a = kernel(kernel_shape.nx, kernel_shape.ny);
  const WhiteNoise noise(11);
  const Field sum = Synthesis(a, surface, {periodic, Summation::direct}).surface(noise),
              transform = Synthesis(a, surface, {periodic, Summation::transform}).surface(noise);
  const double bound = 20 * 5 * std::numeric_limits<double>::epsilon() * a.sum();
  return {"drawn", "difference of sum and transform", (sum - transform).abs().maxCoeff(), bound};
}

void shapes(const StabilityTable& table) {
  struct Case {
    const char* hard;
    Shape kernel, surface;
  };
  for (const Case& c : {Case{"one row", {9, 9}, {1, 1024}},
                        {"one column", {9, 9}, {1024, 1}},
                        {"one point", {9, 9}, {1, 1}},
                        {"primes", {7, 13}, {127, 131}},
                        {"powers of two", {8, 16}, {128, 256}},
                        {"kernel larger than the surface", {61, 45}, {17, 23}},
                        {"kernel of one row", {1, 63}, {64, 64}},
                        {"white noise", {1, 1}, {64, 64}}})
    for (bool periodic : {false, true})
      table.answered(fmt::format("{} x {} by {} x {}{}", c.surface.nx, c.surface.ny, c.kernel.nx, c.kernel.ny,
                                 periodic ? ", periodic" : ""),
                     c.hard, [&] { return two_ways(c.kernel, c.surface, periodic); });
  table.refused("0 x 64 points", "no surface", [] { Synthesis(kernel(3, 3), {0, 64}, {}); });
  table.refused("2048 x 2048 points in 1 kB", "not a band fits", [] {
    Synthesis(kernel(61, 61), {2048, 2048}, {.memory = 1024});
  });
}

void heights(const StabilityTable& table) {
  const Shape shape{64, 64};
  const Field a = kernel(9, 9);
  const Field plain = Synthesis(a, shape, {}).surface(WhiteNoise(2));
  // 2^-40 = 0.9e-12 and 2^10 m; a power of two leaves every digit as it is.
  for (int power : {-1000, -40, 10, 1000})
    table.answered(fmt::format("rms scaled by 2^{}", power), "scale of the heights", [&] {
      const double scale = std::ldexp(1, power);
      const Field z = Synthesis(scale * a, shape, {}).surface(WhiteNoise(2));
      return Finding{"drawn", "difference / rms", (z / scale - plain).abs().maxCoeff(), 0};
    });
  auto rescaled = [](const Field& z, double rms) {
    RunningMoments survey;
    survey.add(z);
    Field out = z;
    exact_rms(survey, rms).apply(out);
    RunningMoments result;
    result.add(out);
    return Finding{"rescaled", "error of Sq", std::abs(result.rms() / rms - 1), 1e-9};
  };
  table.answered("exact rms, offset 1e6 rms", "cancellation", [&] { return rescaled(plain + 1e6, 1e-6); });
  table.answered("exact rms of 1e-12 m", "scale of the heights", [&] { return rescaled(plain, 1e-12); });
  table.refused("exact rms of a plane", "nothing to scale", [&] { rescaled(Field::Ones(8, 8), 1e-6); });
  table.refused("exact rms of denormal heights", "squares vanish", [&] { rescaled(1e-310 * plain, 1e-6); });
}

void noise(const StabilityTable& table) {
  table.answered("noise, row 2^62 and -2^62", "ends of the rows' range", [] {
    WhiteNoise a(1);
    Eigen::ArrayXd row(4096);
    double worst = 0;
    for (std::int64_t i : {std::int64_t{1} << 62, -(std::int64_t{1} << 62)}) {
      a.row(i, {row.data(), 4096});
      worst = std::max(
          {worst, std::abs(row.mean()) * 64, std::abs(row.square().mean() - 1) * 64 / std::sqrt(2.0)});
    }
    return Finding{"drawn", "mean and variance in standard errors", worst, 4};
  });
  table.answered("seeds 0, 1, 2^64 - 1", "neighbouring and extreme seeds", [] {
    Eigen::Array<double, 3, 4096, Eigen::RowMajor> rows;
    std::uint64_t seeds[] = {0, 1, ~std::uint64_t{0}};
    for (Index k = 0; k < 3; ++k) WhiteNoise(seeds[k]).row(0, {rows.row(k).data(), 4096});
    double worst = 0;
    for (Index k = 0; k < 3; ++k)
      worst = std::max(worst, std::abs((rows.row(k) * rows.row((k + 1) % 3)).mean()) * 64);
    return Finding{"drawn", "correlation in standard errors", worst, 4};
  });
}

}  // namespace

void surface_stability() {
  const StabilityTable table("surface");
  shapes(table);
  heights(table);
  noise(table);
}

}  // namespace asperity
