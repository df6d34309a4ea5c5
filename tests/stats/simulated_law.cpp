// p-values from simulated values.
#include "stats/hypothesis/simulated_law.hpp"

#include "fields.hpp"

using namespace asperity;
using namespace asperity::test;
using Eigen::ArrayXd, Eigen::ArrayXXd;

namespace {

ArrayXd normals(Index count, unsigned seed) {
  return white_noise({1, count}, seed).reshaped<Eigen::RowMajor>();
}

}  // namespace

// Skewness is odd: of values that are symmetric in ln x, √x or x² it vanishes at λ = 0, ½ and 2, and nowhere
// else. The root is where it is below 1e-6, and its slope in λ is of the order of the spread, ½ to 1 here.
TEST_CASE("the power without skewness is the one whose inverse made the values", "[simulated-law][exact]") {
  ArrayXd symmetric(6);
  symmetric << -0.9, -0.5, -0.1, 0.1, 0.5, 0.9;
  CHECK(std::abs(NormalisingPower(symmetric.exp()).lambda()) <= 1e-5);
  CHECK(std::abs(NormalisingPower((2 + symmetric).square()).lambda() - 0.5) <= 1e-5);
  CHECK(std::abs(NormalisingPower((2 + symmetric).sqrt()).lambda() - 2) <= 1e-5);
}

// Of -1, 0, 1 the mean is 0 and the deviation 1. t = 2/√(1 + 1/3) = √3 for one value of 2, and P(|t| > √3) = 1
// - √3/√(2 + 3) of two degrees; for the mean of three such, t = 2/√(2/3) = √6.
TEST_CASE("a mean is compared by Student's t of both means", "[simulated-law][exact]") {
  ArrayXd simulated(3);
  simulated << -1, 0, 1;
  CHECK(std::abs(p_of_mean(simulated, ArrayXd::Constant(1, 2)) - (1 - std::sqrt(3.0 / 5))) <= 1e-14);
  CHECK(std::abs(p_of_mean(simulated, ArrayXd::Constant(3, -2)) - (1 - std::sqrt(6.0 / 8))) <= 1e-14);
}

// A kurtosis that is as skewed as 1/x² of a normal has λ = -2: the power is below ½, whatever the value.
TEST_CASE("a value far beyond the simulated ones is as improbable as it is far",
          "[simulated-law][contract]") {
  const ArrayXd simulated = (1 + 0.2 * normals(200, 1)).max(0.2).rsqrt();
  CHECK(NormalisingPower(simulated).lambda() < -1);
  double last = 1;
  for (const double far : {2.0, 4.0, 20.0, 1000.0}) {
    const double p = p_of_skewed_mean(simulated, ArrayXd::Constant(1, far));
    CAPTURE(far, p);
    CHECK(p < last);
    last = p;
  }
  CHECK(last <= 1e-6);
  CHECK(p_of_skewed_mean(simulated, ArrayXd::Constant(1, 1e-3)) <= 1e-6);
}

// Forty quantities of forty simulated surfaces, the first twenty hardly differing, and 60 sets of them; five surfaces
// each, alone or together. Three errors √(0.05·0.95/300) above and below 5 %: 1.2 to 8.8 %; alone the five have the
// set in common, which adds half as much.
TEST_CASE("the largest of many is exceeded as often as stated, with forty simulated surfaces",
          "[simulated-law][statistics]") {
  const Index quantities = 40, surfaces = 40;
  auto drawn = [&](Index count, unsigned seed) {
    ArrayXXd x = normals(count * quantities, seed).reshaped(count, quantities);
    x.leftCols(20) = 0.1 * x.leftCols(20) + normals(count, seed + 7000).replicate(1, 20);
    return x;
  };
  int alone = 0, together = 0;
  for (unsigned set = 0; set < 60; ++set) {
    const ArrayXXd simulated = drawn(surfaces, 2 * set), observed = drawn(5, 2 * set + 1);
    for (Index m = 0; m < 5; ++m) alone += SimulatedTogether(simulated, observed.row(m)).p() <= 0.05;
    together += SimulatedTogether(simulated, observed).p() <= 0.05;
  }
  CAPTURE(alone, together);
  CHECK(alone <= 300 * (0.05 + 1.5 * 3 * std::sqrt(0.05 * 0.95 / 300)));
  CHECK(alone >= 1);
  CHECK(together <= 60 * (0.05 + 3 * std::sqrt(0.05 * 0.95 / 60)));
}

// Of one quantity |t| is the largest, and each simulated value's is that against the other eleven: by (2), without (3).
// λ is known to 1e-6, round-off of t is amplified in the tail, and 1e-4 is far below what any other t_k would change.
TEST_CASE("the simulated largest deviations are those of each surface against the others",
          "[simulated-law][exact]") {
  const ArrayXd x = normals(12, 5);
  auto t = [](const ArrayXd& of, double value) {
    const auto n = static_cast<double>(of.size());
    const double deviation = std::sqrt((of - of.mean()).square().sum() / (n - 1));
    return std::abs(value - of.mean()) / (deviation * std::sqrt(1 + 1 / n));
  };
  ArrayXd largest(12), others(11);
  for (Index k = 0; k < 12; ++k) {
    others << x.head(k), x.tail(11 - k);
    largest(k) = t(others, x(k));
  }
  const double value = 4, p = SimulatedTogether(x, ArrayXd::Constant(1, value)).p();
  CHECK(p == Approx(p_of_skewed_mean(largest, ArrayXd::Constant(1, t(x, value))) / 2).epsilon(1e-4));
}

TEST_CASE("the deviation of the quantity that strays is the largest, and its p-value small",
          "[simulated-law][law]") {
  const ArrayXXd simulated = normals(200 * 9, 3).reshaped(200, 9);
  ArrayXXd observed = ArrayXXd::Zero(1, 9);
  CHECK(SimulatedTogether(simulated, observed).p() >= 0.5);
  observed(0, 4) = -7;
  const SimulatedTogether strays(simulated, observed);
  Index most = 0;
  strays.deviations().abs().maxCoeff(&most);
  CHECK(most == 4);
  CHECK(strays.deviations()(4) < 0);
  CHECK(strays.p() <= 1e-6);
}
