#include "stress/equivalent.hpp"

#include <algorithm>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>

#include "reference/hertz_stress.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;
using stress::Tensor;

namespace {

using Matrix = Eigen::Matrix<long double, 3, 3>;
using Vector = Eigen::Matrix<long double, 3, 1>;

Matrix matrix(const Tensor& s) {
  Matrix m;
  m << s[stress::xx], s[stress::xy], s[stress::xz], s[stress::xy], s[stress::yy], s[stress::yz],
      s[stress::xz], s[stress::yz], s[stress::zz];
  return m;
}

Vector vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

// Jacobi's rotations in long double: the eigenvalues, largest first.
std::array<long double, 3> eigenvalues(Matrix m) {
  for (int sweep = 0; sweep < 12; ++sweep)
    for (auto [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      const long double angle = 0.5L * std::atan2(2 * m(p, q), m(q, q) - m(p, p));
      Matrix turn = Matrix::Identity();
      turn(p, p) = turn(q, q) = std::cos(angle), turn(p, q) = std::sin(angle), turn(q, p) = -std::sin(angle);
      m = turn.transpose() * m * turn;
    }
  std::array<long double, 3> values{m(0, 0), m(1, 1), m(2, 2)};
  std::ranges::sort(values, std::greater());
  return values;
}

// The tensor with these principal stresses, its axes turned by Euler angles.
Tensor turned(double s1, double s2, double s3, double a, double b, double c) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(a, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(b, Eigen::Vector3d::UnitX()) *
       Eigen::AngleAxisd(c, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  const Eigen::Matrix3d m = turn * Eigen::Vector3d(s1, s2, s3).asDiagonal() * turn.transpose();
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

struct Errors {
  double value = 0, residual = 0, angle = 0;  ///< the first two over the largest component
};

Errors errors(const Tensor& s) {
  const PrincipalStress p = principal_stress(s);
  const auto exact = eigenvalues(matrix(s));
  const long double size = matrix(s).cwiseAbs().maxCoeff();
  long double value = 0, residual = 0, angle = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector v = vector(p.direction[k]);
    value = std::max(value, std::abs(p.value[k] - exact[k]) / size);
    residual = std::max(residual, (matrix(s) * v - p.value[k] * v).norm() / size);
    for (std::size_t l = 0; l < 3; ++l)
      angle = std::max(angle, std::abs(v.dot(vector(p.direction[l])) - (k == l ? 1 : 0)));
  }
  return {static_cast<double>(value), static_cast<double>(residual), static_cast<double>(angle)};
}

}  // namespace

// The splits of a pair, from none to wide, that a closed form for all three roots would answer to √ε = 1e-8
// only; above the pair and below it, alone and under a pressure a thousand times as large.
TEST_CASE("principal stresses are exact to 8 epsilon however close they lie, their residuals to 16",
          "[principal][exact]") {
  const Field angles = random_field({40, 3}, 51);
  Errors worst;
  for (Index i = 0; i < angles.rows(); ++i)
    for (double split : {0.0, 1e-16, 1e-13, 1e-10, 1e-8, 1e-6, 1e-3, 0.5, 1.0})
      for (double lone : {1.0, -1.0})
        for (double mean : {0.0, 1000.0}) {
          const Tensor s = turned(mean + lone, mean + split * lone, mean, 3 * angles(i, 0), 3 * angles(i, 1),
                                  3 * angles(i, 2));
          const Errors e = errors(s);
          worst = {std::max(worst.value, e.value), std::max(worst.residual, e.residual),
                   std::max(worst.angle, e.angle)};
        }
  CAPTURE(worst.value, worst.residual, worst.angle);
  CHECK(worst.value <= 8 * epsilon);
  CHECK(worst.residual <= 16 * epsilon);
  CHECK(worst.angle <= 8 * epsilon);
}

// A turn leaves round-off between the two that coincide; along the axes they coincide to the last bit.
TEST_CASE("two principal stresses that are equal to the last bit have unit directions too",
          "[principal][exact]") {
  for (double lone : {3.0, -3.0})
    for (std::size_t axis : {0, 1, 2}) {
      Tensor s{};
      s[axis] = lone;
      const Errors e = errors(s);
      CAPTURE(lone, axis);
      CHECK(e.value <= 8 * epsilon);
      CHECK(e.residual <= 16 * epsilon);
      CHECK(e.angle <= 8 * epsilon);
    }
}

TEST_CASE("principal stresses scale with the stress over its whole range", "[principal][law]") {
  const Tensor s = turned(3, -1, -2, 0.3, 1.1, -0.7);
  const PrincipalStress one = principal_stress(s);
  for (int exponent : {-120, -40, 30, 100}) {
    Tensor t = s;
    for (double& c : t) c = std::ldexp(c, exponent);
    const PrincipalStress scaled = principal_stress(t);
    for (std::size_t k = 0; k < 3; ++k) CHECK(scaled.value[k] == std::ldexp(one.value[k], exponent));
    CHECK(scaled.direction == one.direction);
  }
}

TEST_CASE("a hydrostatic stress has its pressure as principal stresses, along the axes",
          "[principal][contract]") {
  for (double p : {0.0, -2.5}) {
    const PrincipalStress h = principal_stress({p, p, p, 0, 0, 0});
    CHECK(h.value == std::array{p, p, p});
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(h.direction[k][i] - (i == k ? 1 : 0)) <= 2 * epsilon);
  }
}

TEST_CASE("principal directions point into the body, and along the axes where they lie in the surface",
          "[principal][contract]") {
  const Field angles = random_field({100, 3}, 52);
  for (Index i = 0; i < angles.rows(); ++i) {
    const PrincipalStress p =
        principal_stress(turned(2, 1, -1, 3 * angles(i, 0), 3 * angles(i, 1), 3 * angles(i, 2)));
    for (const auto& v : p.direction) CHECK(v[2] > 0);
  }
  for (double noise : {1e-17, -1e-17}) {
    const PrincipalStress p = principal_stress({1, 2, -3, noise, -noise, noise});
    CHECK(std::abs(p.direction[0][1] - 1) <= 2 * epsilon);
    CHECK(std::abs(p.direction[1][0] - 1) <= 2 * epsilon);
    CHECK(std::abs(p.direction[2][2] - 1) <= 2 * epsilon);
  }
}

// On the axis xx = yy: the largest shear is half of |xx - zz|, at 45°; its maximum 0.3100 p0 lies 0.4809 a
// deep.
TEST_CASE("below a Hertz contact the largest shear stress is 0.310 of its pressure", "[principal][exact]") {
  const Tensor s = hertz_stress(0, 0, 0.480864, 0.3);
  CHECK(max_shear_stress(s) == Approx(0.5 * 0.620041004).epsilon(1e-8));
  CHECK(max_shear_stress(s) == Approx(0.5 * std::abs(s[stress::xx] - s[stress::zz])).epsilon(8 * epsilon));
}

TEST_CASE("the octahedral shear stress is a third of the root of the squared differences",
          "[principal][exact]") {
  const Field angles = random_field({20, 3}, 53);
  for (Index i = 0; i < angles.rows(); ++i) {
    const Tensor s = turned(2, 0.7, -1.5, 3 * angles(i, 0), 3 * angles(i, 1), 3 * angles(i, 2));
    const double exact = std::sqrt(1.3 * 1.3 + 2.2 * 2.2 + 3.5 * 3.5) / 3;
    StressRow row;
    for (auto c : stress::components) row[c] = {&s[c], 1};
    double found;
    octahedral_shear(row, {&found, 1});
    CHECK(found == Approx(exact).epsilon(16 * epsilon));
  }
}

// σ_vM lies between √3 τ_max and 2 τ_max: equal principal stresses in the middle, or at an end.
TEST_CASE("von Mises stress is between root 3 and twice the largest shear stress", "[principal][law]") {
  const Field components = random_field({200, 6}, 54);
  for (Index i = 0; i < components.rows(); ++i) {
    Tensor s;
    for (auto c : stress::components) s[c] = components(i, static_cast<Index>(c));
    const double ratio = von_mises(s) / max_shear_stress(s);
    CHECK(ratio >= std::numbers::sqrt3 * (1 - 16 * epsilon));
    CHECK(ratio <= 2 * (1 + 16 * epsilon));
  }
}
