#include "stats/spectral_moments.hpp"

#include <cmath>

#include "grid/error.hpp"
#include "stats/form.hpp"
#include "stats/neighbours.hpp"

namespace asperity {
namespace {

enum Sum { s00, s20, s11, s02, s40, s31, s22, s13, s04, sums };
using Sums = RowSums<sums>;

// Point j of a stencil is column j + 1 of its rows, which all have the points to either side.
struct Stencil {
  const Row &before, &here, &after;

  Index points() const { return here.size() - 2; }
  auto middle(const Row& row) const { return row.segment(1, points()); }
  auto left(const Row& row) const { return row.head(points()); }
  auto right(const Row& row) const { return row.tail(points()); }
  Row zxx() const { return middle(before) - 2 * middle(here) + middle(after); }
  Row zyy() const { return left(here) - 2 * middle(here) + right(here); }
  Row zxy() const { return 0.25 * (right(after) - left(after) - right(before) + left(before)); }
};

// z(i+1) - z(i) of all points of a row that the field has.
void add_slopes_along_x(Sums& out, const Row& here, const Row& after, Index ny, Index sides) {
  const Row step = after - here;
  out[s20] = step.head(ny).square().sum();
  out[s11] =
      0.25 * ((step.head(sides) + step.segment(1, sides)) *
              (here.segment(1, sides) - here.head(sides) + after.segment(1, sides) - after.head(sides)))
                 .sum();
}

void add_mixed_derivatives(Sums& out, const Stencil& stencil) {
  const Row zxx = stencil.zxx(), zyy = stencil.zyy(), zxy = stencil.zxy();
  out[s31] = (zxx * zxy).sum();
  out[s22] = (zxx * zyy).sum();
  out[s13] = (zxy * zyy).sum();
}

}  // namespace

ProfileSpectralMoments SpectralMoments::along(double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  return {.m0 = m00,
          .m2 = c * c * m20 + 2 * c * s * m11 + s * s * m02,
          .m4 = c * c * c * c * m40 + 4 * c * c * c * s * m31 + 6 * c * c * s * s * m22 +
                4 * c * s * s * s * m13 + s * s * s * s * m04};
}

ProfileSpectralMoments SpectralMoments::isotropic() const {
  return {.m0 = m00, .m2 = std::sqrt(m20 * m02), .m4 = std::sqrt(m40 * m04)};
}

SpectralMoments spectral_moments(const Field& z, const Grid& grid, int threads) {
  const NeighbourRows sides(z, grid, 1), curves(z, grid, 2);
  const Index nx = z.rows(), ny = z.cols();
  if (curves.rows() < 1 || curves.columns() < 1)
    throw DataError("heights", "second derivatives need 3 x 3 points");
  const double level = mean(z);
  const Sums sum = sum_over_rows<sums>(nx, threads, [&](Index i) {
    const Row here = curves(i);
    Sums out{};
    out[s00] = (here.head(ny) - level).square().sum();
    out[s02] = (here.segment(1, sides.columns()) - here.head(sides.columns())).square().sum();
    out[s04] = Stencil{here, here, here}.zyy().square().sum();
    if (i >= sides.rows()) return out;
    const Row after = curves(i + 1);
    add_slopes_along_x(out, here, after, ny, sides.columns());
    if (i >= curves.rows()) return out;
    const Row second = curves(i + 2);
    out[s40] = (here - 2 * after + second).head(ny).square().sum();
    add_mixed_derivatives(out, {here, after, second});
    return out;
  });
  auto mean_of = [](double total, Index rows, Index columns) {
    return total / static_cast<double>(rows * columns);
  };
  const double x = 1 / grid.dx, y = 1 / grid.dy;
  const Index inner_x = curves.rows(), inner_y = curves.columns();
  return {.m00 = mean_of(sum[s00], nx, ny),
          .m20 = x * x * mean_of(sum[s20], sides.rows(), ny),
          .m11 = x * y * mean_of(sum[s11], sides.rows(), sides.columns()),
          .m02 = y * y * mean_of(sum[s02], nx, sides.columns()),
          .m40 = x * x * x * x * mean_of(sum[s40], inner_x, ny),
          .m31 = x * x * x * y * mean_of(sum[s31], inner_x, inner_y),
          .m22 = x * x * y * y * mean_of(sum[s22], inner_x, inner_y),
          .m13 = x * y * y * y * mean_of(sum[s13], inner_x, inner_y),
          .m04 = y * y * y * y * mean_of(sum[s04], nx, inner_y)};
}

}  // namespace asperity
