#include "marginal/prescribed.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "marginal/johnson.hpp"

namespace asperity {
namespace {

// By how much this kurtosis lies below the least one of its skewness.
double shortfall(double skewness, double kurtosis) {
  return std::max(0.0, least_kurtosis(skewness) - kurtosis);
}

}  // namespace

PrescribedHeights PrescribedHeights::feasible() const {
  const double least = least_kurtosis(skewness);
  return {skewness, kurtosis < least && allows(infeasible, least - kurtosis) ? least : kurtosis, infeasible};
}

Translation PrescribedHeights::translation() const {
  const PrescribedHeights heights = feasible();
  return johnson_translation(heights.skewness, heights.kurtosis);
}

KernelCumulants KernelCumulants::of(const Field& kernel) {
  const double variance = kernel.square().sum();
  return {kernel.cube().sum() / std::pow(variance, 1.5),
          kernel.square().square().sum() / (variance * variance)};
}

HeightMoments KernelCumulants::heights(const HeightMoments& noise) const {
  return {0, noise.variance, noise.skewness * third, 3 + (noise.kurtosis - 3) * fourth};
}

Translation PrescribedHeights::noise(const Field& kernel) const {
  const KernelCumulants f = KernelCumulants::of(kernel);
  const double skewness_of_noise = skewness == 0 ? 0 : skewness / f.third,
               kurtosis_of_noise = 3 + (kurtosis - 3) / f.fourth;
  if (!(std::abs(skewness_of_noise) <= largest_skewness))
    throw ParameterError("skewness", number(skewness) + ": would take noise of skewness " +
                                         number(skewness_of_noise) + ", beyond " + number(largest_skewness) +
                                         "; the kernel leaves " + number(f.third) + " of it");
  if (!(kurtosis_of_noise <= largest_kurtosis))
    throw ParameterError("kurtosis", number(kurtosis) + ": would take noise of kurtosis " +
                                         number(kurtosis_of_noise) + ", beyond " + number(largest_kurtosis) +
                                         "; the kernel leaves " + number(f.fourth) + " of its excess");
  const double short_by = shortfall(skewness_of_noise, kurtosis_of_noise);
  if (!allows(infeasible, short_by * f.fourth))
    throw ParameterError("kurtosis", number(kurtosis) + ": would take noise of skewness " +
                                         number(skewness_of_noise) + " and kurtosis " +
                                         number(kurtosis_of_noise) +
                                         ", which there is not; with this kernel and skewness at least " +
                                         number(3 + (least_kurtosis(skewness_of_noise) - 3) * f.fourth));
  return johnson_translation(skewness_of_noise, kurtosis_of_noise + short_by);
}

}  // namespace asperity
