// Autocorrelations and kernels of periodic surfaces, against sums as they are written.
#include "acf/periodic.hpp"

#include "acf/kernel.hpp"
#include "acf/target.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Index within(Index lag, Index period) { return ((lag % period) + period) % period; }

// Of an average by this kernel of noise that repeats itself, at lags of up to half a period.
Field circular(const Field& kernel, Shape period) {
  Field wrapped = Field::Zero(period.nx, period.ny);
  for (Index k = 0; k < kernel.rows(); ++k)
    for (Index l = 0; l < kernel.cols(); ++l) wrapped(k % period.nx, l % period.ny) += kernel(k, l);
  const Index middle = period.ny / 2;
  return Field::NullaryExpr(period.nx / 2 + 1, 2 * middle + 1, [&](Index p, Index column) {
    double sum = 0;
    for (Index i = 0; i < period.nx; ++i)
      for (Index j = 0; j < period.ny; ++j)
        sum += wrapped(i, j) * wrapped(within(i + p, period.nx), within(j + column - middle, period.ny));
    return sum;
  });
}

// A half plane with zeros around it.
Field with_zeros(const Field& half_plane, Shape period) {
  Field out = Field::Zero(period.nx / 2 + 1, period.ny / 2 * 2 + 1);
  out.block(0, (out.cols() - half_plane.cols()) / 2, half_plane.rows(), half_plane.cols()) = half_plane;
  return out;
}

Field whole_autocorrelation(const Field& kernel) {
  return autocorrelation(kernel, kernel.rows(), 2 * kernel.cols() - 1);
}

}  // namespace

// A kernel of 7 × 5 reaches to lags 6 and 4. Both sums have 35 products a lag at most, each rounded, below
// (Σ|kernel|)² in all. The variance of a profile 1 × 4096 of 20 samples was 17 times what was asked for, and
// drawn without a word.
TEST_CASE(
    "an average of noise that repeats itself has the autocorrelation of its kernel summed over the periods",
    "[periodic][exact]") {
  const Field kernel = random_field({7, 5}, 6);
  for (const Shape period : {Shape{1, 1}, Shape{1, 40}, Shape{3, 2}, Shape{6, 4}, Shape{7, 5}, Shape{9, 8},
                             Shape{12, 8}, Shape{40, 3}, Shape{13, 9}, Shape{40, 30}}) {
    CAPTURE(period.nx, period.ny);
    const Field sum = with_zeros(periodic_sum(whole_autocorrelation(kernel), period), period);
    CHECK((sum - circular(kernel, period)).abs().maxCoeff() <=
          70 * epsilon * std::pow(kernel.abs().sum(), 2));
  }
}

TEST_CASE("an autocorrelation that ends before half a period is its own sum over the periods",
          "[periodic][exact]") {
  const Field kernel = random_field({7, 5}, 6), alone = whole_autocorrelation(kernel);
  CHECK((periodic_sum(alone, {13, 9}) == alone).all());
  CHECK_FALSE(reaches_around(shape_of(kernel), {13, 9}));
  CHECK(reaches_around(shape_of(kernel), {12, 9}));
  CHECK(reaches_around(shape_of(kernel), {13, 8}));
}

// ε log2(N M) < 12 ε of transforms there and back, twice, of values that add up to less than N M.
TEST_CASE("the kernel of a period has the autocorrelation asked for, of any shape and orientation",
          "[periodic][exact]") {
  EllipticTarget model;
  model.length_x = 9, model.length_y = 4, model.angle = 0.5;
  const Target target = model.target();
  const Field plane = Field::NullaryExpr(90, 179, [&](Index p, Index column) {
    return target(static_cast<double>(p), static_cast<double>(column - 89));
  });
  for (const Shape period :
       {Shape{1, 1}, Shape{1, 32}, Shape{31, 1}, Shape{2, 2}, Shape{16, 12}, Shape{17, 13}, Shape{11, 30}}) {
    CAPTURE(period.nx, period.ny);
    Field asked = periodic_sum(plane, period);
    asked /= asked(0, asked.cols() / 2);
    const Field kernel = periodic_kernel(asked, period);
    CHECK(shape_of(kernel) == period);
    // Cut at lags 89, where 1e-10 are left of it, the target is one of a surface to as much.
    CHECK((circular(kernel, period) - asked).abs().maxCoeff() <= 1e-9);
    Field achieved(asked.rows(), asked.cols());
    correlation_of(spectral_root(asked, period), asked.rows(),
                   [&](Index first, const Eigen::Ref<const Field>& rows) {
                     achieved.middleRows(first, rows.rows()) = rows;
                   });
    CHECK((achieved - circular(kernel, period)).abs().maxCoeff() <= 100 * epsilon);
    CHECK((kernel_of(root_of_kernel(kernel)) - kernel).abs().maxCoeff() <= 100 * epsilon);
  }
}

// R = 1, 0.9 at lag one, 0 beyond has the spectrum 1 + 1.8 cos: it is negative at a third of the waves.
TEST_CASE("of what no surface has the kernel of a period takes what is positive of its spectrum",
          "[periodic][exact]") {
  const Index n = 12;
  Field asked = Field::Zero(2, 1);
  asked << 1, 0.9;
  Field expected(n / 2 + 1, 1);
  double variance = 0;
  for (Index p = 0; p <= n / 2; ++p) {
    double sum = 0;
    for (Index k = 0; k < n; ++k) {
      const double wave = 2 * M_PI * static_cast<double>(k) / n;
      sum += std::max(1 + 1.8 * std::cos(wave), 0.0) * std::cos(wave * static_cast<double>(p));
    }
    if (p == 0) variance = sum;
    expected(p, 0) = sum / variance;
  }
  CHECK((circular(periodic_kernel(asked, {n, 1}), {n, 1}) - expected).abs().maxCoeff() <= 100 * epsilon);
}
