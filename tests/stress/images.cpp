// Stress below a load that repeats along one axis, in layers, sections and points.
#include "stress/images.hpp"

#include <Eigen/LU>

#include "layer.hpp"
#include "stress/influence.hpp"
#include "stress/maximum.hpp"
#include "stress/points.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr Periodic along_x{true, false}, along_y{false, true};
constexpr double nu = 0.3, pi = std::numbers::pi;
const Friction oblique{0.4, 0.7};

double difference(const stress::Tensor& a, const stress::Tensor& b) {
  double top = 0;
  for (auto c : stress::components) top = std::max(top, std::abs(a[c] - b[c]));
  return top;
}
using test::difference;

// Below a unit pressure on |y| ≤ b: Flamant's σ = -(2/πr) cosφ along the radius, integrated (Johnson, 2.5).
stress::Tensor below_strip(double y, double z, double b) {
  const double t1 = std::atan2(y + b, z), t2 = std::atan2(y - b, z);
  const double angle = t1 - t2, sines = (std::sin(2 * t1) - std::sin(2 * t2)) / 2;
  const double yy = -(angle - sines) / pi, zz = -(angle + sines) / pi;
  const double yz = -(std::pow(std::sin(t1), 2) - std::pow(std::sin(t2), 2)) / pi;
  return {nu * (yy + zz), yy, zz, 0, 0, yz};
}

// The sum over |m| ≤ N.
stress::Tensor image_sum(const LoadedBody& body, Index i, Index j, double z, int N) {
  const Grid& g = body.grid;
  const LoadWeights weights = body.friction.weights();
  stress::Tensor sum{};
  for (int m = -N; m <= N; ++m)
    for (Index k = 0; k < g.shape.nx; ++k)
      for (Index l = 0; l < g.shape.ny; ++l)
        for (stress::Traction t : stress::tractions) {
          const double x = g.x(i) - g.x(k) + (g.periodic.x ? m * g.size_x() : 0),
                       y = g.y(j) - g.y(l) + (g.periodic.y ? m * g.size_y() : 0);
          const stress::Tensor s = uniform_load_stress(x, y, z, g.dx / 2, g.dy / 2, nu, t);
          for (auto c : stress::components) sum[c] += weights[t] * body.pressure(k, l) * s[c];
        }
  return sum;
}

// What is left out goes as 1/R, 1/R², …, R = N + ½: four sums without the first three.
stress::Tensor all_images(const LoadedBody& body, Index i, Index j, double z) {
  Eigen::Matrix4d powers;
  Eigen::Matrix<double, 4, 6> sums;
  for (int k = 0; k < 4; ++k) {
    const int N = 50 << k;
    const double r = 50 / (N + 0.5);
    powers.row(k) << 1, r, r * r, r * r * r;
    const stress::Tensor sum = image_sum(body, i, j, z, N);
    for (auto c : stress::components) sums(k, static_cast<Index>(c)) = sum[c];
  }
  const Eigen::Matrix<double, 4, 6> found = powers.inverse() * sums;
  stress::Tensor out;
  for (auto c : stress::components) out[c] = found(0, static_cast<Index>(c));
  return out;
}

Grid turned(const Grid& g) { return {{g.shape.ny, g.shape.nx}, g.dy, g.dx, {g.periodic.y, g.periodic.x}}; }

}  // namespace

TEST_CASE("the weight of an image is 1 up to a period, 0 from ten on and falls between", "[images][exact]") {
  CHECK(image_weight(0) == 1);
  CHECK(image_weight(-1) == 1);
  CHECK(image_weight(10) == 0);
  CHECK(std::abs(image_weight(5.5) - 0.5) <= 1e-14);
  for (double t = 1; t < 10; t += 0.1) CHECK(image_weight(t) >= image_weight(t + 0.1));
}

// 1/R⁴ of the four sums, with the distances in periods to the fourth, leaves 4e-10 of a pressure.
TEST_CASE("below cells that repeat along one axis the stress is the sum over their images",
          "[images][exact]") {
  for (Periodic periodic : {along_x, along_y})
    for (Shape shape : {Shape{4, 3}, Shape{5, 2}, Shape{1, 3}}) {
      const Grid grid{shape, 0.4, 0.7, periodic};
      const LoadedBody body{grid, random_field(shape, 7), nu, oblique};
      const StressSolver solver(body);
      for (double z : {0.0, 0.05, 0.6, 3.0}) {
        const TensorField found = layer(solver, z);
        double error = 0;
        for (Index i = 0; i < shape.nx; ++i)
          for (Index j = 0; j < shape.ny; ++j)
            error = std::max(error, difference(tensor_at(found, i, j), all_images(body, i, j, z)));
        CAPTURE(periodic.x, shape.nx, shape.ny, z);
        const double farthest = periodic.x ? std::hypot(z, grid.size_y()) / grid.size_x()
                                           : std::hypot(z, grid.size_x()) / grid.size_y();
        CHECK(error <= 1e-9 * (1 + std::pow(farthest, 4)));
      }
    }
}

TEST_CASE("a load that is uniform along the periodic axis is one of strips in plane strain",
          "[images][exact]") {
  const Grid grid{{6, 40}, 0.3, 0.2, along_x};
  Field p(6, 40);
  p.rowwise() = random_field({1, 40}, 3).row(0);
  for (double z : {0.1, 0.7, 5.0, 80.0}) {
    const TensorField found = layer(StressSolver({grid, p, nu}), z),
                      other = layer(StressSolver({turned(grid), p.transpose(), nu}), z);
    double error = 0;
    for (Index j = 0; j < 40; ++j) {
      stress::Tensor exact{};
      for (Index l = 0; l < 40; ++l) {
        const stress::Tensor s = below_strip(grid.y(j) - grid.y(l), z, grid.dy / 2);
        for (auto c : stress::components) exact[c] += p(0, l) * s[c];
      }
      for (Index i = 0; i < 6; ++i) {
        error = std::max(error, difference(tensor_at(found, i, j), exact));
        error = std::max(error, difference(stress::exchanged(tensor_at(other, j, i)), exact));
      }
    }
    CAPTURE(z);
    CHECK(error <= 1e-13 * p.abs().sum());
  }
}

// Both are right to 1e-11 of the largest pressure.
TEST_CASE("sections and points below a repeating load are the layers' values, and two periods are one",
          "[images][law]") {
  for (Periodic periodic : {along_x, along_y})
    for (Shape shape : {Shape{12, 10}, Shape{7, 5}}) {
      const Grid grid{shape, 0.4, 0.3, periodic};
      const Field p = random_field(shape, 11).abs();
      const LoadedBody body{grid, p, nu, oblique};
      const StressPoints points(body);
      Grid doubled = grid;
      (periodic.x ? doubled.shape.nx : doubled.shape.ny) *= 2;
      const Field twice = Field::NullaryExpr(doubled.shape.nx, doubled.shape.ny,
                                             [&](Index i, Index j) { return p(i % shape.nx, j % shape.ny); });
      const double bound = 1e-10 * p.maxCoeff();
      for (double z : {0.0, 0.2, 2.0, 30.0}) {
        const TensorField whole = layer(StressSolver(body), z),
                          larger = layer(StressSolver({doubled, twice, nu, oblique}), z);
        const StressSolver row_of_x(body, Plane{true, 3}), row_of_y(body, Plane{false, 5});
        const TensorField in_x = layer(row_of_x, z), in_y = layer(row_of_y, z);
        CAPTURE(periodic.x, shape.nx, z);
        for (auto c : stress::components) {
          CHECK((larger[c].topLeftCorner(shape.nx, shape.ny) - whole[c]).abs().maxCoeff() <= bound);
          CHECK((larger[c].bottomRightCorner(shape.nx, shape.ny) - whole[c]).abs().maxCoeff() <= bound);
          CHECK((in_x[c].reshaped() - whole[c].col(3)).abs().maxCoeff() <= bound);
          CHECK((in_y[c].reshaped() - whole[c].row(5).transpose()).abs().maxCoeff() <= bound);
        }
        for (Index i : {Index{0}, Index{3}})
          for (Index j : {Index{1}, Index{4}})
            CHECK(difference(points.at(grid.x(i), grid.y(j), z), tensor_at(whole, i, j)) <= bound);
      }
    }
}

// 2e-6 of the largest pressure, stress/resolution.hpp.
TEST_CASE("deep layers below a repeating load come from wider cells as well", "[images][order]") {
  for (Periodic periodic : {along_x, along_y}) {
    const Grid grid{{128, 192}, 0.1, 0.1, periodic};
    const Field p = random_field(grid.shape, 2).abs();
    const LoadedBody body{grid, p, nu, oblique};
    const StressSolver full(body), adapted(body, 1, DepthResolution::adapted);
    REQUIRE(Resolution::possible(grid, 2));
    for (double z : {1.01 * Resolution::least_depth(grid, 2), 4.0}) {
      const TensorField exact = layer(full, z), wide = layer(adapted, z);
      CAPTURE(periodic.x, z);
      CHECK(difference(exact, wide) <= 2e-6 * p.maxCoeff());
    }
  }
}

// Johnson, (4.45): on the axis below a Hertz line contact, in b = p₀ = 1. Cells leave order 2, as
// stress/layers.hpp tells of a point contact.
TEST_CASE("below a Hertz line contact the stress is Johnson's, and so is the largest von Mises",
          "[images][hertz][order]") {
  auto on_axis = [](double z) -> stress::Tensor {
    const double root = std::sqrt(1 + z * z), yy = -((1 + 2 * z * z) / root - 2 * z), zz = -1 / root;
    return {nu * (yy + zz), yy, zz, 0, 0, 0};
  };
  auto mises = [&](double z) { return von_mises(on_axis(z)); };
  double exact = 0;
  for (double z = 0.5; z < 1; z += 1e-4) exact = std::max(exact, mises(z));
  double coarse = 0;
  for (Index n : {31, 61, 121, 241}) {
    const double h = 3 / static_cast<double>(n);
    const Grid grid{{4, n}, h, h, along_x};
    auto area = [](double y) {  // ∫ √(1-y²)
      y = std::clamp(y, -1.0, 1.0);
      return (y * std::sqrt(1 - y * y) + std::asin(y)) / 2;
    };
    const Field p = sample(grid, [&](double, double y) { return (area(y + h / 2) - area(y - h / 2)) / h; });
    const StressSolver solver({grid, p, nu});
    const double fine = difference(tensor_at(layer(solver, 0.786), 1, n / 2), on_axis(0.786));
    const StressMaximum top = maximum_stress(solver);
    CAPTURE(n, fine, coarse, top.value / exact - 1, top.depth, top.y);
    CHECK(fine <= 0.3 * h * h);
    if (coarse > 0) CHECK(fine <= 0.3 * coarse);
    CHECK(std::abs(top.value / exact - 1) <= 0.5 * h * h + 1e-4);
    coarse = fine;
  }
}
