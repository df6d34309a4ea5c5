/// The plane of skewness and kurtosis: which Johnson distribution takes each cell, how exactly, in what time.
///
/// A row is a skewness and a distance above the edge, K = Sk² + 1 + distance. `of_mean`, `of_variance`,
/// `of_skewness` and `of_kurtosis` are the errors of the moments, the last two relative to the moment or to 1, as
/// found by the trapezoidal rule in y with a spacing of min(δ, 1)/4 over ±24, which has nothing in common with the rule
/// of the fit. `apply_ns` is the time of a height, copied and transformed. A cell nearer to the edge than
/// johnson_with() goes is "refused", one above its bounds left out; negative skewness is the mirror image.
///
///     johnson_plane [LARGEST_SKEWNESS]         50 unless given
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "marginal/johnson.hpp"
#include "marginal/johnson_moments.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

MarginalMoments integrated(const Johnson& j) {
  const Index points = static_cast<Index>(48 * 4 / std::min(j.delta, 1.0));
  const Eigen::ArrayXd y = Eigen::ArrayXd::LinSpaced(points, -24, 24);
  Eigen::ArrayXd weight = (-y.square() / 2).exp();
  weight /= weight.sum();
  const Eigen::ArrayXd z = y.unaryExpr([&](double value) { return j(value); });
  const double mean = (weight * z).sum();
  const Eigen::ArrayXd d = z - mean;
  const double variance = (weight * d.square()).sum();
  return {mean, variance, (weight * d.cube()).sum() / std::pow(variance, 1.5),
          (weight * d.square().square()).sum() / (variance * variance)};
}

double nanoseconds_of_apply(const Johnson& j) {
  const Eigen::ArrayXd y = Eigen::ArrayXd::LinSpaced(4096, -4, 4);
  Eigen::ArrayXd z = y;
  const std::span<double> heights(z.data(), static_cast<std::size_t>(z.size()));
  return 1e9 / static_cast<double>(z.size()) * seconds_of([&] {
           z = y;
           j.apply(heights);
         });
}

void print_cell(double skewness, double kurtosis) {
  fmt::print("{:g}\t{:.7g}\t", skewness, kurtosis);
  try {
    const Johnson j = johnson_with(skewness, kurtosis);
    const MarginalMoments m = integrated(j);
    const double fit = seconds_of([&] { johnson_with(skewness, kurtosis); });
    fmt::print("{}\t{:.6g}\t{:.6g}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.0f}\t{:.1f}\n", name_of(j.family),
               j.gamma, j.delta, m.mean, m.variance - 1, (m.skewness - skewness) / std::max(1.0, skewness),
               m.kurtosis / kurtosis - 1, 1e6 * fit, nanoseconds_of_apply(j));
  } catch (const ParameterError&) {
    fmt::print("refused\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const double largest = argc > 1 ? std::atof(argv[1]) : 50;
  fmt::print(
      "# "
      "skewness\tkurtosis\tfamily\tgamma\tdelta\tof_mean\tof_variance\tof_skewness\tof_kurtosis\tfit_"
      "us\tapply_ns\n");
  for (const double skewness : {0.0, 1e-6, 0.01, 0.3, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0})
    for (const double distance :
         {0.01, 0.02, 0.05, 0.1, 0.3, 0.8, 1.5, 2.0, 3.0, 10.0, 30.0, 100.0, 1e3, 7e3})
      if (const double kurtosis = skewness * skewness + 1 + distance;
          skewness <= largest && kurtosis <= largest_kurtosis)
        print_cell(skewness, kurtosis);
  return 0;
}
