#include "marginal/prescribed.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "marginal/johnson.hpp"

namespace asperity {

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
  check_parameter(std::abs(skewness_of_noise) <= largest_skewness, "skewness",
                  number(skewness) + ": needs noise of skewness " + number(skewness_of_noise) + ", beyond " +
                      number(largest_skewness) + "; the kernel leaves " + number(f.third) + " of it");
  check_parameter(kurtosis_of_noise <= largest_kurtosis, "kurtosis",
                  number(kurtosis) + ": needs noise of kurtosis " + number(kurtosis_of_noise) + ", beyond " +
                      number(largest_kurtosis) + "; the kernel leaves " + number(f.fourth) +
                      " of its excess");
  const double least = least_kurtosis(skewness_of_noise), short_by = std::max(0.0, least - kurtosis_of_noise);
  check_parameter(allows(infeasible, short_by * f.fourth), "kurtosis",
                  number(kurtosis) + ": needs noise of skewness " + number(skewness_of_noise) +
                      " and kurtosis " + number(kurtosis_of_noise) +
                      ", which does not exist; the least kurtosis with this kernel and skewness is " +
                      number(3 + (least - 3) * f.fourth));
  return johnson_translation(skewness_of_noise, kurtosis_of_noise + short_by);
}

}  // namespace asperity
