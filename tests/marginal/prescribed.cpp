#include "marginal/prescribed.hpp"

#include "core/error.hpp"
#include "marginal/johnson.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("an average of n equal terms keeps 1/sqrt(n) of the skewness and 1/n of the excess kurtosis",
          "[prescribed][exact]") {
  for (Index n : {1, 4, 15}) {
    const KernelCumulants f = KernelCumulants::of(Field::Constant(n, 1, 3e-7));
    CHECK(relative_error(f.third, 1 / std::sqrt(static_cast<double>(n))) <= 8 * epsilon);
    CHECK(relative_error(f.fourth, 1 / static_cast<double>(n)) <= 8 * epsilon);
  }
}

// The moments of Johnson's distributions are matched to 1e-10.
TEST_CASE("the noise for a kernel gives the average the skewness and kurtosis prescribed",
          "[prescribed][exact]") {
  const Field kernel = (Field(2, 3) << 1, 2, 1, 0.5, 1, 0.25).finished();
  for (const PrescribedHeights& heights :
       {PrescribedHeights{0, 3}, PrescribedHeights{0.5, 4}, PrescribedHeights{-0.9, 4.5}}) {
    const HeightMoments moments = KernelCumulants::of(kernel).heights(height_moments(heights.noise(kernel)));
    CHECK(std::abs(moments.skewness - heights.skewness) <= 1e-9);
    CHECK(std::abs(moments.kurtosis - heights.kurtosis) <= 1e-9);
  }
}

TEST_CASE("a kurtosis that no noise gives is refused with the least one that it gives, which is then taken",
          "[prescribed][contract]") {
  const Field kernel = Field::Constant(3, 3, 1);
  PrescribedHeights heights{0, 1.8};
  std::string message;
  try {
    heights.noise(kernel);
  } catch (const ParameterError& e) {
    CHECK(e.name == "kurtosis");
    message = e.what();
  }
  const double least = 3 + (least_kurtosis(0) - 3) / 9;
  CAPTURE(message, least);
  CHECK_THAT(message, ContainsSubstring("is 2.78"));
  heights.kurtosis = least + 1e-6;
  CHECK_NOTHROW(heights.noise(kernel));
  heights = {0, 1.8, InfeasiblePolicy::nearest};
  const HeightMoments moments = KernelCumulants::of(kernel).heights(height_moments(heights.noise(kernel)));
  CHECK(std::abs(moments.kurtosis - least) <= 1e-9);
  CHECK(std::abs(moments.skewness) <= 1e-9);
}

TEST_CASE(
    "a kurtosis below the least of its skewness is refused, raised by 1e-2 at most, or by any amount, as "
    "asked",
    "[prescribed][contract]") {
  for (double skewness : {0.0, -1.5, 4.0}) {
    CAPTURE(skewness);
    const double least = least_kurtosis(skewness);
    auto kurtosis = [&](double below, InfeasiblePolicy answer) {
      return height_moments(PrescribedHeights{skewness, least - below, answer}.translation()).kurtosis;
    };
    CHECK(std::abs(kurtosis(5e-3, InfeasiblePolicy::automatic) - least) <= 1e-9 * least);
    CHECK(std::abs(kurtosis(0.5, InfeasiblePolicy::nearest) - least) <= 1e-9 * least);
    CHECK_THROWS_AS(kurtosis(5e-3, InfeasiblePolicy::error), ParameterError);
    CHECK_THROWS_AS(kurtosis(0.5, InfeasiblePolicy::automatic), ParameterError);
  }
}

TEST_CASE("a kernel whose cubes cancel leaves no skewness, whatever the noise", "[prescribed][contract]") {
  const Field odd = (Field(1, 2) << 1, -1).finished();
  CHECK_THROWS_AS((PrescribedHeights{0.5, 4}.noise(odd)), ParameterError);
  CHECK_NOTHROW(PrescribedHeights{0, 4}.noise(odd));
}
