#include "stats/spectrum/power_excess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

// 1 or 0 over the square of the spacing.
struct Slopes {
  double x, y;
};

// Means of z² and of the squares of differences to the next point, and their long waves.
LocalMeans local_means(const Field& d, const Grid& grid, const Slopes& slopes, const FieldExtent& extent,
                       int threads) {
  const auto [nx, ny] = grid.shape;
  LocalSums sums(grid, 2);
  sums.add_rows(nx, threads, [&, nx = nx, ny = ny](Index i, LocalSums::Values& values) {
    const bool last = i + 1 == nx;
    if (last && slopes.x > 0 && !grid.periodic.x) return;  // all NaN
    const auto z = d.row(i).transpose();
    values.col(1) = z.square().matrix();
    values.col(2).setZero();
    if (slopes.x > 0)
      values.col(2) += slopes.x * (d.row(last ? 0 : i + 1) - d.row(i)).square().matrix().transpose();
    if (!(slopes.y > 0)) return;
    values.col(2).head(ny - 1) += slopes.y * (z.tail(ny - 1) - z.head(ny - 1)).square().matrix();
    values(ny - 1, 2) +=
        grid.periodic.y ? slopes.y * std::pow(z(0) - z(ny - 1), 2) : std::numeric_limits<double>::quiet_NaN();
  });
  return sums.means(extent);
}

// The power of differences to the next point.
LagField of_differences(const LagField& psd, const Grid& grid, const Slopes& slopes) {
  Field out = psd.half_plane();
  auto transfer = [](Index k, Index n) {
    return 4 * std::pow(std::sin(std::numbers::pi * static_cast<double>(k) / static_cast<double>(n)), 2);
  };
  for (Index p = 0; p < out.rows(); ++p)
    for (Index q = -psd.max_q(); q <= psd.max_q(); ++q)
      out(p, q + psd.max_q()) *=
          slopes.x * transfer(p, grid.shape.nx) + slopes.y * transfer(q, grid.shape.ny);
  return LagField(std::move(out));
}

PowerExcess excess(const Field& d, const Grid& grid, const LagField& psd, const SharedPower& shared,
                   const Slopes& slopes, const FieldExtent& extent, int threads) {
  const LocalMeans means = local_means(d, grid, slopes, extent, threads);
  double degrees = std::numeric_limits<double>::infinity();
  auto of = [&](Index a, const LagField& power) {
    auto mean = [a](const Eigen::VectorXd& m) { return m(a); };
    const MeanPower gaussian = shared.means(power, 1, [](Index, Index) { return 0; }).front();
    const WaveError error = means.error(mean);
    degrees = std::min(degrees, error.degrees);
    const double own = std::pow(error.error / means(mean), 2) * shared.overlap();
    return std::fmax(own - gaussian.variance / (gaussian.mean * gaussian.mean), 0);
  };
  const double heights = of(0, psd), differences = of(1, of_differences(psd, grid, slopes));
  return {heights, differences, std::sqrt(means([](const Eigen::VectorXd& m) { return m(1) / m(0); })),
          degrees};
}

double inverse_square(double spacing) { return 1 / (spacing * spacing); }

}  // namespace

PowerExcess profile_excess(const Field& d, const Grid& grid, Axis1D axis, const LagField& psd,
                           const SharedPower& shared, const FieldExtent& extent, int threads) {
  const Slopes slopes =
      axis == Axis1D::x ? Slopes{inverse_square(grid.dx), 0} : Slopes{0, inverse_square(grid.dy)};
  return excess(d, grid, psd, shared, slopes, extent, threads);
}

PowerExcess radial_excess(const Field& d, const Grid& grid, const LagField& psd, const SharedPower& shared,
                          const FieldExtent& extent, int threads) {
  return excess(d, grid, psd, shared, {inverse_square(grid.dx), inverse_square(grid.dy)}, extent, threads);
}

PowerExcess profile_excess(const Field& d, const Grid& grid, Axis1D axis, DataWindow window,
                           const FieldExtent& extent, int threads) {
  const DataWindows windows = windows_along(axis, window);
  return profile_excess(d, grid, axis, power_spectrum(d, grid, windows, threads), shared_power(d, windows),
                        extent, threads);
}

PowerExcess radial_excess(const Field& d, const Grid& grid, DataWindows windows, const FieldExtent& extent,
                          int threads) {
  return radial_excess(d, grid, power_spectrum(d, grid, windows, threads), shared_power(d, windows), extent,
                       threads);
}

void add_excess(std::vector<SpectrumPoint>& points, const PowerExcess& excess) {
  const double wider = student_quantile(0.025, excess.degrees) / student_quantile(0.025, 1e9);
  for (SpectrumPoint& point : points) {
    const double more = excess.at(point.wave_number);
    if (!(more > 0)) continue;
    point.standard_error = std::hypot(point.standard_error, point.density * std::sqrt(more));
    point.degrees = 1 / (1 / point.degrees + more / 2 * wider * wider);
  }
}

}  // namespace asperity
