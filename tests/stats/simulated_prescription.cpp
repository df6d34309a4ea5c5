// Surfaces that are not to be Gaussian, against surfaces drawn as prescribed.
#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "marginal/correlation_map.hpp"
#include "marginal/prescribed.hpp"
#include "stats/hypothesis/specification.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Grid field = grid(72, 64);
const Shape window{4, 3};

Translation of_moments(double ssk, double sku) {
  return PrescribedHeights{ssk, sku, InfeasiblePolicy::error}.translation();
}

// A moving average, translated: its correlation is known, and it is drawn another way than the test draws.
Field shaped(const Translation& g, Shape averaged, unsigned seed) {
  Field z = moving_average(field.shape, averaged, seed);
  g.apply({z.data(), static_cast<std::size_t>(z.size())});
  return z;
}

Specification prescribed(double ssk, double sku, Shape averaged = window) {
  const CorrelationMap map(of_moments(ssk, sku));
  return {.correlation = LagField(
              triangular_correlation(averaged).half_plane().unaryExpr([&](double r) { return map(r); })),
          .sq = 1,
          .ssk = ssk,
          .sku = sku};
}

std::vector<TestResult> results(SpecificationTest test, const Field& z) {
  test.add(z, field);
  return test.results();
}

const TestResult& of(const std::vector<TestResult>& rows, const std::string& quantity) {
  const auto found = std::ranges::find(rows, quantity, &TestResult::quantity);
  REQUIRE(found != rows.end());
  return *found;
}

}  // namespace

// 240 surfaces against eight simulations of 200: three errors √(0.05·0.95/240) above 5 %. With the errors of
// Gaussian surfaces nearly all would be refused for Sku.
TEST_CASE("single surfaces that are shaped as prescribed are refused no more often than stated",
          "[prescription][simulated][statistics]") {
  for (const auto& [ssk, sku] : {std::pair{1.0, 5.0}, {-1.0, 4.5}}) {
    const Translation g = of_moments(ssk, sku);
    int no = 0;
    for (unsigned simulation = 0; simulation < 8; ++simulation) {
      Specification asked = prescribed(ssk, sku);
      asked.seed = simulation;
      const SpecificationTest fresh(asked, field);
      for (unsigned m = 0; m < 30; ++m)
        no += joint_p(results(fresh, shaped(g, window, 30 * simulation + m))) <= 0.05;
    }
    CAPTURE(ssk, no);
    CHECK(no <= 240 * (0.05 + 3 * std::sqrt(0.05 * 0.95 / 240)));
  }
}

// N/S_2 is 1000: by (1) of stats/uncertainty/translation_error.hpp the errors of Sq and Ssk are 0.036 and 0.11, that
// of Ssk/√Sku about 0.03. A height of 1.3 is eight of these, no skewness, where Ssk/√Sku is 0.45, fifteen; lengths
// longer by 7/4 and 5/3 are 0.5 in ln, twelve of 0.04. The rows that are true agree at 1 % of one in five, or nearly.
TEST_CASE("a single shaped surface is refused for its height, its lengths, or for being Gaussian",
          "[prescription][simulated][statistics]") {
  const SpecificationTest fresh(prescribed(1, 5), field);
  const Translation g = of_moments(1, 5);
  for (unsigned seed = 500; seed < 505; ++seed) {
    CAPTURE(seed);
    CHECK(of(results(fresh, 1.3 * shaped(g, window, seed)), "Sq").p <= 0.01 / 5);
    CHECK(of(results(fresh, moving_average(field.shape, window, seed)), "Ssk").p <= 0.01 / 5);
    const TestResult lengths = results(fresh, shaped(g, {7, 5}, seed)).back();
    CHECK((lengths.quantity.starts_with("length") && lengths.p <= 0.01 / 5));
  }
}

// A spike of 60 Sq: its Sku is above 1000, and the power of Sku that has no skewness is bounded.
TEST_CASE("a spike is no surface of any kurtosis", "[prescription][simulated][contract]") {
  Field z = shaped(of_moments(1, 5), window, 3);
  z(20, 20) = 60;
  const auto rows = results(SpecificationTest(prescribed(1, 5), field), z);
  CHECK(of(rows, "Sku").p <= 1e-4);
  CHECK(of(rows, "Ssk").p <= 1e-4);
}

// Half of the field, and three quarters of it, in one piece: the errors of 200 simulated surfaces are known to 1/√398,
// 5 %, and grow as 1/√N but for the edge, less than one in twenty. Three of √2 · 5 %, and the edge.
TEST_CASE("errors are those of surfaces that miss the same points", "[prescription][simulated][law]") {
  const SpecificationTest fresh(prescribed(1, 5), field);
  const Field whole = shaped(of_moments(1, 5), window, 9);
  const double complete = of(results(fresh, whole), "Sq").standard_error;
  for (const double kept : {0.5, 0.25}) {
    Field part = whole;
    part.bottomRows(static_cast<Index>((1 - kept) * 72)).setConstant(none);
    const double error = of(results(fresh, part), "Sq").standard_error;
    CAPTURE(kept, complete, error);
    CHECK(std::abs(error / complete * std::sqrt(kept) - 1) <= 3 * std::sqrt(2.0) / std::sqrt(398.0) + 0.05);
  }
}

// One of three surfaces lacks three quarters; four fields each would be few, so 67.
TEST_CASE("surfaces with other missing points share the simulation, and no result depends on the threads",
          "[prescription][simulated][law]") {
  std::vector<TestResult> first;
  for (const int threads : {1, 3}) {
    Specification asked = prescribed(-1, 4.5);
    asked.threads = threads;
    Index told = 0;
    asked.simulated = [&](Index done, Index total) {
      CHECK(done > told);
      CHECK(total == 201);
      told = done;
    };
    SpecificationTest test(asked, field);
    const Translation g = of_moments(-1, 4.5);
    for (unsigned m = 0; m < 3; ++m) {
      Field z = shaped(g, window, m);
      if (m == 1) z.topRows(54).setConstant(none);
      test.add(z, field);
    }
    const auto rows = test.results();
    CHECK((told == 201 && test.drawn() == 201));
    if (threads == 1) first = rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(rows[i].p == first[i].p);
      CHECK(rows[i].p > 0.01 / 5);
      CHECK(rows[i].standard_error == first[i].standard_error);
    }
  }
}
