#include "transform/zero_phase.hpp"

#include <numbers>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Case {
  Shape lags, torus;
};
const std::vector<Case> cases{{{1, 1}, {8, 8}},   {{1, 6}, {8, 16}},  {{7, 1}, {20, 8}},
                              {{5, 3}, {16, 10}}, {{8, 9}, {32, 40}}, {{10, 8}, {20, 16}}};

template <class Claim>
void for_both_kinds(Claim claim) {
  for (const Case& c : cases) {
    CAPTURE(c.lags.nx, c.lags.ny, c.torus.nx, c.torus.ny);
    for (bool oriented : {false, true}) claim(*zero_phase_transform(c.lags, c.torus, oriented));
  }
}

std::vector<double> random_part(const ZeroPhaseTransform& transform) {
  const auto n = static_cast<Index>(transform.multiplicity().size());
  const Field f = random_field({n, 1}, 3);
  return {f.data(), f.data() + n};
}

}  // namespace

// The transforms add ε log2 of their length, at most 10 ε here, of Σ|a|.
TEST_CASE("a zero-phase spectrum is the sum of cosines over the whole field", "[transform][exact]") {
  for_both_kinds([](ZeroPhaseTransform& transform) {
    const std::vector<double> part = random_part(transform);
    const Field whole = transform.whole(part);
    AlignedVector<double> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
    transform.forward(part, spectrum);
    const auto [n, m] = transform.lags();
    const auto [rows, columns] = transform.torus();
    double error = 0;
    for (Index kx = 0; kx <= rows / 2; ++kx)
      for (Index ky = 0; ky <= columns / 2; ++ky) {
        double sum = 0;
        for (Index i = 0; i < whole.rows(); ++i)
          for (Index j = 0; j < whole.cols(); ++j)
            sum += whole(i, j) *
                   std::cos(2 * std::numbers::pi *
                            (static_cast<double>((i - n + 1) * kx) / static_cast<double>(rows) +
                             static_cast<double>((j - m + 1) * ky) / static_cast<double>(columns)));
        const Index at = ky / 2 * transform.pair_size() + 2 * kx + ky % 2;
        error = std::max(error, std::abs(sum - spectrum[static_cast<std::size_t>(at)]));
      }
    CHECK(error <= 16 * epsilon * whole.abs().sum());
  });
}

TEST_CASE("forward then inverse, and a filter that does nothing, give the part back", "[transform][law]") {
  for_both_kinds([](ZeroPhaseTransform& transform) {
    const std::vector<double> part = random_part(transform);
    AlignedVector<double> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
    std::vector<double> back(part.size()), filtered(part);
    transform.forward(part, spectrum);
    transform.inverse(spectrum, back);
    const double scale = 1 / static_cast<double>(transform.torus().cells());
    transform.filter(filtered, filtered, [&](Index offset, std::span<double> block) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        CHECK(block[i] == spectrum[static_cast<std::size_t>(offset) + i]);
        block[i] *= scale;
      }
    });
    const double bound = 16 * epsilon * transform.whole(part).abs().sum();
    for (std::size_t i = 0; i < part.size(); ++i) {
      CHECK(std::abs(back[i] - part[i]) <= bound);
      CHECK(std::abs(filtered[i] - part[i]) <= bound);
    }
  });
}

TEST_CASE("the multiplicities count every value of the whole field", "[transform][exact]") {
  for_both_kinds([](ZeroPhaseTransform& transform) {
    const std::vector<double> part = random_part(transform), w = transform.multiplicity();
    double sum = 0;
    for (std::size_t i = 0; i < part.size(); ++i) sum += w[i] * part[i];
    const Field whole = transform.whole(part);
    CHECK(std::abs(sum - whole.sum()) <= 8 * epsilon * whole.abs().sum());
    CHECK((whole == whole.reverse()).all());
  });
}

TEST_CASE("lanes beyond the last column hold no other values than the columns", "[transform][contract]") {
  for_both_kinds([](ZeroPhaseTransform& transform) {
    const std::vector<double> part = random_part(transform);
    AlignedVector<double> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
    transform.forward(part, spectrum);
    double least = 1e300, all = 1e300;
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
      const auto at = static_cast<Index>(i), column = at / transform.pair_size() * 2 + at % 2;
      all = std::min(all, spectrum[i]);
      if (column <= transform.torus().ny / 2) least = std::min(least, spectrum[i]);
    }
    CHECK(all >= least - 16 * epsilon * transform.whole(part).abs().sum());
  });
}
