#include "core/error.hpp"
#include "fields.hpp"
#include "stats/spatial/acf.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double direct(const Field& z, bool periodic, Index p, Index q) {
  const Index nx = z.rows(), ny = z.cols();
  double sum = 0, pairs = 0;
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j) {
      const Index a = i + p, b = j + q;
      if (!periodic && (a >= nx || b < 0 || b >= ny)) continue;
      sum += std::pow(z(a % nx, (b + ny) % ny) - z(i, j), 2);
      ++pairs;
    }
  return sum / pairs;
}

}  // namespace

// Transforms and partial sums add 12 ε each of Σz² to the sums; the fewest pairs are one.
TEST_CASE("the structure function equals the mean square difference of all pairs at every lag",
          "[structure-function][exact]") {
  for (Shape shape : {Shape{1, 9}, Shape{12, 1}, Shape{13, 10}, Shape{7, 33}}) {
    const Field z = 5 + random_field(shape, 101);
    const double bound = 24 * epsilon * (z - z.mean()).square().sum();
    for (const bool periodic : {false, true}) {
      const Shape lags = periodic ? Shape{shape.nx / 2, shape.ny / 2} : Shape{shape.nx - 1, shape.ny - 1};
      const LagField S = structure_function(z, grid(shape.nx, shape.ny, periodic), lags);
      for (Index p = 0; p <= lags.nx; ++p)
        for (Index q = -lags.ny; q <= lags.ny; ++q)
          CHECK(std::abs(S(p, q) - direct(z, periodic, p, q)) <= 2 * bound);
    }
  }
}

TEST_CASE("a plane of slopes a, b has the structure function (ap + bq)^2, which no stationary surface has",
          "[structure-function][exact]") {
  const Field z = sample(grid(20, 16), [](double x, double y) { return 0.2 * x - 0.1 * y; });
  const LagField S = structure_function(z, grid(20, 16), {10, 8});
  for (Index p = 0; p <= 10; ++p)
    for (Index q = -8; q <= 8; ++q) {
      const double step = 0.2 * static_cast<double>(p) - 0.1 * static_cast<double>(q);
      CHECK(std::abs(S(p, q) - step * step) <= 48 * epsilon * (z - z.mean()).square().sum());
    }
  CHECK_THROWS_AS(structure_function(z, grid(20, 16), {20, 3}), ParameterError);
}
