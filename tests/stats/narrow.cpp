// Surfaces as narrow as they are correlated, of which sums over the plane's lags say little.
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/hypothesis/specification.hpp"
#include "stats/uncertainty/effective_size.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Oblique, and longer than most fields here.
LagField oblique() {
  return LagField(Field::NullaryExpr(7, 11, [](Index p, Index column) {
    const auto x = static_cast<double>(p), y = static_cast<double>(column - 5);
    return std::exp(-0.05 * x * x - 0.03 * x * y - 0.1 * y * y) - 0.02 * x;
  }));
}

// The points (i,j), and the covariance of each with each.
Eigen::MatrixXd covariance(const LagField& rho, const Grid& g) {
  const Index nx = g.shape.nx, ny = g.shape.ny;
  auto lag = [&](Index d, Index n) {
    if (!g.periodic.both()) return d;
    const Index within = (d % n + n) % n;
    return 2 * within > n ? within - n : within;
  };
  return Eigen::MatrixXd::NullaryExpr(nx * ny, nx * ny, [=](Index a, Index b) {
    return rho(lag(a / ny - b / ny, nx), lag(a % ny - b % ny, ny));
  });
}

double mean_trace(const Eigen::MatrixXd& m) { return m.trace() / static_cast<double>(m.rows()); }

const std::vector<Shape> narrow_shapes{{1, 1}, {1, 9}, {8, 1}, {2, 7}, {6, 2}, {3, 11}, {4, 6}, {12, 9}};

// Of a field of this shape that is a moving average over `window`, against that prescription.
std::vector<TestResult> results_of(const SpecificationTest& fresh, Shape shape, Shape window, unsigned seed) {
  SpecificationTest test = fresh;
  test.add(moving_average(shape, window, seed), grid(shape.nx, shape.ny));
  return test.results();
}

constexpr int seeds = 200;

// Tests of such a prescription, of another simulation for every 40 surfaces.
class Renewed {
 public:
  Renewed(Shape window, Shape shape)
      : asked_{.correlation = triangular_correlation(window), .sq = 1}, grid_(grid(shape.nx, shape.ny)) {}
  const SpecificationTest& operator()(unsigned t) {
    if (t % 40 == 0) asked_.seed = t, test_.emplace(asked_, grid_);
    return *test_;
  }

 private:
  Specification asked_;
  Grid grid_;
  std::optional<SpecificationTest> test_ = {};
};

// Of p-values from the even distribution, Kolmogorov's and Smirnov's.
double distance_from_even(std::vector<double> p) {
  std::ranges::sort(p);
  const auto n = static_cast<double>(p.size());
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    largest = std::max({largest, static_cast<double>(i + 1) / n - p[i], p[i] - static_cast<double>(i) / n});
  return largest;
}

// The number of successes among n of probability p that is exceeded by three standard errors.
double most_of(double n, double p) { return n * p + 3 * std::sqrt(n * p * (1 - p)); }

}  // namespace

// Odd periods: at half an even one an oblique correlation has two values. Lags beyond half a period once
// counted again in S_k.
TEST_CASE("of a periodic field each lag counts once, however long the correlation", "[pairs][exact]") {
  for (const Shape shape : {Shape{1, 1}, {1, 9}, {7, 1}, {3, 7}, {9, 7}, {25, 3}})
    for (const LagField& rho : {oblique(), triangular_correlation({4, 3})}) {
      const Grid torus = grid(shape.nx, shape.ny, true);
      const Eigen::MatrixXd C = covariance(rho, torus);
      CAPTURE(shape.nx, shape.ny);
      CHECK(relative_error(EffectiveSampleSize(rho, torus).sum(2), mean_trace(C * C)) <= 1e-13);
    }
}

// Lags that the field does not have once counted: 7.5 in place of 1.9 of a row, of a correlation of four
// points.
TEST_CASE("a correlation longer than the field has the pairs of its field", "[pairs][exact]") {
  for (const Shape shape : narrow_shapes)
    for (const LagField& rho :
         {oblique(), triangular_correlation({5, 4}), triangular_correlation({40, 40})}) {
      const Grid g = grid(shape.nx, shape.ny);
      const Eigen::MatrixXd C = covariance(rho, g);
      CAPTURE(shape.nx, shape.ny);
      CHECK(relative_error(EffectiveSampleSize(rho, g).sum(2), mean_trace(C * C)) <= 1e-13);
    }
}

// 1 × 512 of a correlation of 17 points was refused in every case, at p = 5e-4 for 0.56 standard errors. Each
// claim's p-values stray from the even distribution by the sampling of 200 surfaces and of the 200 that are drawn,
// at the most 1.95 √(2/200) with probability 0.999. A simulation serves 40.
TEST_CASE("narrow surfaces are refused at the stated rate, and the p-values of each claim are even",
          "[prescription][statistics]") {
  const Shape window{4, 4};
  for (const Shape shape : {Shape{1, 512}, {512, 1}, {2, 512}, {3, 512}, {64, 64}, {8, 300}}) {
    Renewed fresh(window, shape);
    std::array<std::vector<double>, 4> p;
    int at_5 = 0, at_1 = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const std::vector<TestResult> results = results_of(fresh(seed), shape, window, 1000 + seed);
      for (std::size_t k = 0; k < 4; ++k) p[k].push_back(results[k].p);
      at_5 += joint_p(results) <= 0.05;
      at_1 += joint_p(results) <= 0.01;
    }
    CAPTURE(shape.nx, shape.ny, at_5, at_1);
    CHECK(at_5 <= most_of(seeds, 0.05));
    CHECK(at_1 <= most_of(seeds, 0.01));
    for (std::size_t k = 0; k < 4; ++k) {
      CAPTURE(k);
      CHECK(distance_from_even(p[k]) <= 1.95 * std::sqrt(2.0 / seeds));
    }
  }
}

// 26 to 64 patches.
TEST_CASE(
    "rows of few patches are refused no more often than stated, and those of another height are refused",
    "[prescription][statistics]") {
  for (const Index points : {12, 30}) {
    const Shape window{points, points};
    for (const Shape shape : {Shape{1, 512}, {512, 2}}) {
      Renewed fresh(window, shape);
      const SpecificationTest higher({.correlation = triangular_correlation(window), .sq = 0.2},
                                     grid(shape.nx, shape.ny));
      int no = 0;
      for (unsigned seed = 0; seed < seeds; ++seed)
        no += joint_p(results_of(fresh(seed), shape, window, 4000 + seed)) <= 0.05;
      CAPTURE(points, shape.nx, no);
      CHECK(no <= most_of(seeds, 0.05));
      if (points == 12) CHECK(joint_p(results_of(higher, shape, window, 1)) <= 0.05);
    }
  }
}

TEST_CASE("a field worth less than five independent points is refused", "[prescription][contract]") {
  const Specification asked{.correlation = triangular_correlation({40, 40}), .sq = 1};
  for (const Shape shape : {Shape{24, 24}, {1, 80}, {2, 2}}) {
    CAPTURE(shape.nx, shape.ny);
    CHECK_THROWS_AS(SpecificationTest(asked, grid(shape.nx, shape.ny)), DataError);
  }
}
