/// Surfaces of prescribed skewness and kurtosis: what they achieve, and what they cost.
///
/// A row a pair and target, of 15 samples to 10 %. `family` is Johnson's; `orders` the Hermite terms; `fit`
/// the seconds of the distribution and its correlation, `solve` those of the predistorted kernel; `surface`
/// is the time of a surface of 512 × 512 over that of the Gaussian one, `whole` the same with everything
/// before it. `answer` is the kernel's, `acf_error` the largest error over all lags that is predicted,
/// `naive` the one of a Gaussian kernel translated.
///
/// Of an ensemble of surfaces of 512 × 512: mean skewness and kurtosis about the known mean and variance,
/// with standard errors of the spread; `acf_z` the largest deviation of the mean autocorrelation from the
/// prediction, `target_z` from the target, over the lags up to 24, in standard errors. `filter` is what
/// averaging skewed noise would say.
///
///     heights_error_time [SURFACES]
#include <cstdlib>

#include "core/error.hpp"
#include "marginal/predistortion.hpp"
#include "marginal/prescribed.hpp"
#include "stats/sample/ensemble.hpp"
#include "stats/spatial/acf.hpp"
#include "surface/synthesis.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr Shape shape{512, 512}, lags{25, 25};

struct Named {
  const char* name;
  EllipticTarget target;
};
const Named targets[] = {
    {"exponential", {.length_x = 15, .length_y = 15}},
    {"gaussian", {.model = Model::gaussian, .length_x = 15, .length_y = 15}},
    {"oriented", {.length_x = 20, .length_y = 8, .angle = 0.5}},
};
constexpr std::array<std::array<double, 2>, 9> pairs{
    {{0, 3}, {-0.5, 4}, {1, 6}, {-1.3, 6}, {0, 1.8}, {-2, 10}, {3, 15}, {-3, 16}, {0, 1.1}}};

Field centre(const Field& half_plane, Index first_q) {
  return half_plane.block(0, -first_q - lags.ny + 1, lags.nx, 2 * lags.ny - 1);
}

// z³, z⁴ and the autocorrelation of the surfaces.
Ensemble drawn(const Kernel& kernel, const Translation& g, int surfaces) {
  const Synthesis synthesis(kernel.values, shape, {.translation = g.apply});
  Ensemble out;
  for (int n = 0; n < surfaces; ++n) {
    const Field z = synthesis.surface(WhiteNoise(7, static_cast<std::uint64_t>(n)));
    const Field acf =
        estimate_autocorrelation(z, {shape, 1, 1}, {.max_lag = {lags.nx - 1, lags.ny - 1}, .level = 0})
            .half_plane();
    Eigen::ArrayXd figures(2 + acf.size());
    figures << z.cube().mean(), z.square().square().mean(), acf.reshaped<Eigen::RowMajor>();
    out.add(figures);
  }
  return out;
}

double largest_z(const Ensemble& ensemble, const Field& expected) {
  const Index n = expected.size();
  return ((ensemble.mean().tail(n) - expected.reshaped<Eigen::RowMajor>()) /
          ensemble.standard_error().tail(n))
      .abs()
      .maxCoeff();
}

Seconds surface_seconds(const Kernel& kernel, const Pointwise& translation) {
  const Synthesis synthesis(kernel.values, shape, {.translation = translation});
  return seconds_of([&] { synthesis.surface(WhiteNoise(1)); });
}

const char* filtered(const PrescribedHeights& heights, const Kernel& kernel) {
  try {
    heights.noise(kernel.values);
    return "yes";
  } catch (const ParameterError&) {
    return "no noise";
  }
}

void print_row(const Named& named, const PrescribedHeights& heights, const Kernel& gaussian,
               double gaussian_seconds, int surfaces) {
  const Translation g = heights.translation();
  const Predistortion predistortion(g);
  const Seconds fit = seconds_of([&] { Predistortion again(heights.translation()); });
  KernelRequest request;
  request.target = named.target.target();
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel kernel = predistortion.solve(request);
  const Field naive = gaussian.acf_achieved.unaryExpr([&](double r) { return predistortion.map()(r); });
  const Seconds solve = seconds_of([&] { predistortion.solve(request); }),
                surface = surface_seconds(kernel, g.apply);
  fmt::print(
      "{}\t{}\t{}\t{}\t{}\t{:.1e}\t{:.1e}\t{:.2f}\t{:.2f}\t{}\t{:.1e}\t{:.1e}", named.name, heights.skewness,
      heights.kurtosis, g.family, predistortion.map().orders() - 1, fit, solve, surface / gaussian_seconds,
      (fit + solve + surface) / (gaussian.report.seconds + gaussian_seconds), name_of(kernel.report.answer),
      kernel.report.error, (naive - gaussian.acf_target).abs().maxCoeff());
  const Ensemble ensemble = drawn(kernel, g, surfaces);
  const Eigen::ArrayXd mean = ensemble.mean(), error = ensemble.standard_error();
  fmt::print("\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.1f}\t{:.1f}\t{}\n", mean(0), error(0), mean(1), error(1),
             largest_z(ensemble, centre(kernel.acf_achieved, kernel.first_q())),
             largest_z(ensemble, centre(kernel.acf_target, kernel.first_q())), filtered(heights, gaussian));
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const int surfaces = argc > 1 ? std::atoi(argv[1]) : 40;
  fmt::print(
      "# "
      "target\tskewness\tkurtosis\tfamily\torders\tfit\tfit_spread\tsolve\tsolve_"
      "spread\tsurface\twhole\tanswer\tacf_error\tnaive"
      "\tmean_skewness\tskewness_error\tmean_kurtosis\tkurtosis_error\tacf_z\ttarget_z\tfilter\n");
  for (const Named& named : targets) {
    KernelRequest request;
    request.target = named.target.target();
    const Kernel gaussian = solve_kernel(request);
    const double seconds = surface_seconds(gaussian, {});
    for (const auto& [skewness, kurtosis] : pairs)
      print_row(named, {skewness, kurtosis}, gaussian, seconds, surfaces);
  }
  return 0;
}
