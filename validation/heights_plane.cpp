/// The plane of skewness and kurtosis: what becomes of every cell.
///
/// A row is a skewness and a distance above the edge, K = Sk² + 1 + distance. A cell nearer to the edge than
/// Johnson's system is taken is "refused", one above its bounds left out; negative skewness is the mirror
/// image.
///     family, gamma, delta      Johnson's
///     of_mean … of_kurtosis     errors of the moments, the last two relative to the moment or to 1, by the trapezoidal
///                               rule in y, which has nothing in common with the rule of the fit
///     fit, apply                seconds of the fit, and of a height, copied and transformed
///     orders, tail, map         of the Hermite series, the variance beyond it, and its seconds
///     least                     the lowest correlation of the heights
///     exponential, gaussian     largest error over all lags of the kernel for this target, 15 samples to 10 %; with its
///                               answer where it is not exact
///     filter                    the widest of 3, 7, 13, 31, 63 lags (the kernels of an exponential of a tenth) whose
///                               noise there is; 0: none of them
///
///     heights_plane [LARGEST_SKEWNESS]         50 unless given
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/error.hpp"
#include "marginal/johnson.hpp"
#include "marginal/predistortion.hpp"
#include "marginal/prescribed.hpp"
#include "reference/exponential_target.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

Seconds seconds_of_a_height(const Translation& g) {
  const Eigen::ArrayXd y = Eigen::ArrayXd::LinSpaced(4096, -4, 4);
  Eigen::ArrayXd z = y;
  const std::span<double> heights(z.data(), static_cast<std::size_t>(z.size()));
  const Seconds all = seconds_of([&] {
    z = y;
    g.apply(heights);
  });
  return {all.shortest / static_cast<double>(z.size()), all.median / static_cast<double>(z.size())};
}

void print_fit(double skewness, double kurtosis, const Translation& g) {
  const Johnson j = fit_johnson(skewness, kurtosis);
  const HeightMoments m = height_moments(g);
  const Seconds fit = seconds_of([&] { fit_johnson(skewness, kurtosis); });
  fmt::print("\t{}\t{:.6g}\t{:.6g}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.1e}", g.family, j.gamma,
             j.delta, m.mean, m.variance - 1, (m.skewness - skewness) / std::max(1.0, skewness),
             m.kurtosis / kurtosis - 1, fit, seconds_of_a_height(g));
}

void print_kernel(const Predistortion& predistortion, Model model) {
  KernelRequest request;
  request.target = EllipticTarget{.model = model, .length_x = 15, .length_y = 15}.target();
  request.infeasible = InfeasiblePolicy::nearest;
  const KernelReport report = predistortion.solve(request).report;
  fmt::print("\t{:.1e}", report.error);
  if (report.answer != Answer::exact) fmt::print(" {}", name_of(report.answer));
}

const std::vector<Kernel>& gaussian_kernels() {
  static const std::vector<Kernel> kernels = [] {
    std::vector<Kernel> out;
    for (Index n : {3, 7, 13, 31, 63}) {
      KernelRequest request;
      request.target = ExponentialTarget{static_cast<double>(n) / 2, static_cast<double>(n) / 2};
      request.lags = {n, n};
      out.push_back(solve_kernel(request));
    }
    return out;
  }();
  return kernels;
}

Index widest_filter(const PrescribedHeights& heights) {
  Index widest = 0;
  for (const Kernel& kernel : gaussian_kernels()) {
    try {
      heights.noise(kernel.values);
      widest = kernel.lags.nx;
    } catch (const ParameterError&) {
    }
  }
  return widest;
}

void print_cell(double skewness, double kurtosis) {
  fmt::print("{:g}\t{:.7g}", skewness, kurtosis);
  const PrescribedHeights heights{skewness, kurtosis, InfeasiblePolicy::error};
  try {
    const Translation g = heights.translation();
    print_fit(skewness, kurtosis, g);
    const Predistortion predistortion(g);
    fmt::print("\t{}\t{:.0e}\t{:.1e}\t{:.4f}", predistortion.map().orders() - 1, predistortion.map().tail(),
               seconds_of([&] { Predistortion again(g); }), predistortion.map().lowest());
    print_kernel(predistortion, Model::exponential);
    print_kernel(predistortion, Model::gaussian);
    fmt::print("\t{}\n", widest_filter(heights));
  } catch (const ParameterError&) {
    fmt::print("\trefused\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const double largest = argc > 1 ? std::atof(argv[1]) : 50;
  fmt::print(
      "# skewness\tkurtosis\tfamily\tgamma\tdelta\tof_mean\tof_variance\tof_skewness\tof_kurtosis\tfit\t"
      "fit_spread\tapply\tapply_spread\torders\ttail\tmap\tmap_"
      "spread\tleast\texponential\tgaussian\tfilter\n");
  for (const double skewness : {0.0, 1e-6, 0.3, 1.0, 2.0, 3.0, 5.0, 10.0, 50.0})
    for (const double distance :
         {0.01, 0.02, 0.05, 0.1, 0.3, 0.8, 1.5, 2.0, 3.0, 10.0, 30.0, 100.0, 1e3, 7e3})
      if (const double kurtosis = skewness * skewness + 1 + distance;
          skewness <= largest && kurtosis <= largest_kurtosis)
        print_cell(skewness, kurtosis);
  return 0;
}
