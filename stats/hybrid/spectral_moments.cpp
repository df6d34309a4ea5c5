#include "stats/hybrid/spectral_moments.hpp"

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/hybrid/neighbours.hpp"

namespace asperity {
namespace {

enum Product { p00, p20, p11, p02, p40, p31, p22, p13, p04 };
using ProductSums = RowSums<9>;

// Point j of a stencil is column j + 1 of its rows, which all have the points to either side.
struct Stencil {
  const Row &before, &here, &after;

  Index points() const { return std::max<Index>(0, here.size() - 2); }
  auto middle(const Row& row) const { return row.segment(1, points()); }
  auto left(const Row& row) const { return row.head(points()); }
  auto right(const Row& row) const { return row.tail(points()); }
  Row zxx() const { return middle(before) - 2 * middle(here) + middle(after); }
  Row zyy() const { return left(here) - 2 * middle(here) + right(here); }
  Row zxy() const { return 0.25 * (right(after) - left(after) - right(before) + left(before)); }
};

// z(i+1) - z(i) of all points of a row that the field has.
void add_slopes_along_x(ProductSums& out, const Row& here, const Row& after, Index ny, Index sides) {
  const Row step = after - here;
  out[p20] = sum_of_valid(step.head(ny).square());
  out[p11] =
      sum_of_valid((step.head(sides) + step.segment(1, sides)) *
                   (here.segment(1, sides) - here.head(sides) + after.segment(1, sides) - after.head(sides)));
  out[p11].sum *= 0.25;
}

void add_mixed_derivatives(ProductSums& out, const Stencil& stencil) {
  const Row zxx = stencil.zxx(), zyy = stencil.zyy(), zxy = stencil.zxy();
  out[p31] = sum_of_valid(zxx * zxy);
  out[p22] = sum_of_valid(zxx * zyy);
  out[p13] = sum_of_valid(zxy * zyy);
}

}  // namespace

ProfileSpectralMoments SpectralMoments::along(double angle) const {
  auto along_axis = [](double part) { return std::abs(part) < 1e-15 ? 0 : part; };  // cos of a rounded π/2
  const double c = along_axis(std::cos(angle)), s = along_axis(std::sin(angle));
  return {.m0 = m00,
          .m2 = c * c * m20 + 2 * c * s * m11 + s * s * m02,
          .m4 = c * c * c * c * m40 + 4 * c * c * c * s * m31 + 6 * c * c * s * s * m22 +
                4 * c * s * s * s * m13 + s * s * s * s * m04};
}

ProfileSpectralMoments SpectralMoments::isotropic() const {
  return {.m0 = m00, .m2 = std::sqrt(m20 * m02), .m4 = std::sqrt(m40 * m04)};
}

SpectralMoments SpectralMoments::without_round_off(const Grid& grid, double difference) const {
  SpectralMoments out = *this;
  auto remains = [difference](double moment, double spacing, int order) {
    const double at_point = order == 1 ? difference : 4 * difference;
    return !(std::sqrt(moment) * std::pow(spacing, order) <= at_point);
  };
  const bool zx = remains(m20, grid.dx, 1), zy = remains(m02, grid.dy, 1),
             zxx = zx && remains(m40, grid.dx, 2), zyy = zy && remains(m04, grid.dy, 2), zxy = zx && zy;
  if (!zx) out.m20 = 0;
  if (!zy) out.m02 = 0;
  if (!zxy) out.m11 = 0;
  if (!zxx) out.m40 = 0;
  if (!zyy) out.m04 = 0;
  if (!zxx || !zxy) out.m31 = 0;
  if (!zxx || !zyy) out.m22 = 0;
  if (!zyy || !zxy) out.m13 = 0;
  return out;
}

SpectralMoments spectral_moments(const Field& z, const Grid& grid, int threads) {
  const NeighbourRows sides(z, grid, 1), curves(z, grid, 2);
  const Index ny = z.cols();
  const double level = mean(z);
  const ProductSums sums = sum_rows<9>(z.rows(), threads, [&](Index i) {
    const Row here = curves(i);
    ProductSums out{};
    out[p00] = sum_of_valid((here.head(ny) - level).square());
    out[p02] = sum_of_valid((here.segment(1, sides.columns()) - here.head(sides.columns())).square());
    out[p04] = sum_of_valid(Stencil{here, here, here}.zyy().square());
    if (i >= sides.rows()) return out;
    const Row after = curves(i + 1);
    add_slopes_along_x(out, here, after, ny, sides.columns());
    if (i >= curves.rows()) return out;
    const Row second = curves(i + 2);
    out[p40] = sum_of_valid((here - 2 * after + second).head(ny).square());
    add_mixed_derivatives(out, {here, after, second});
    return out;
  });
  if (!(sums[p31].count > 0))
    throw DataError("heights", "second derivatives need 3 x 3 points, none of them missing");
  const double x = 1 / grid.dx, y = 1 / grid.dy;
  return {.m00 = mean_of(sums[p00]),
          .m20 = x * x * mean_of(sums[p20]),
          .m11 = x * y * mean_of(sums[p11]),
          .m02 = y * y * mean_of(sums[p02]),
          .m40 = x * x * x * x * mean_of(sums[p40]),
          .m31 = x * x * x * y * mean_of(sums[p31]),
          .m22 = x * x * y * y * mean_of(sums[p22]),
          .m13 = x * y * y * y * mean_of(sums[p13]),
          .m04 = y * y * y * y * mean_of(sums[p04])};
}

}  // namespace asperity
