#include "acf/periodic.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"
#include "transform/pruned.hpp"

namespace asperity {
namespace {

Index within(Index lag, Index period) { return ((lag % period) + period) % period; }

// The least lag from -reach on that is this one but for whole periods.
Index first(Index lag, Index reach, Index period) { return lag - (lag + reach) / period * period; }

PowerSpectrum spectrum_of(const Field& plane) {
  const RealTransform2D transform(shape_of(plane));
  PowerSpectrum out(size(transform.spectrum_size()));
  transform.forward(plane.data(), out.data());
  return out;
}

Field inverse(PowerSpectrum spectrum, Shape torus) {
  Field out(torus.nx, torus.ny);
  RealTransform2D(torus).inverse(spectrum.data(), out.data());
  return out;
}

}  // namespace

Field periodic_sum(const Field& half_plane, Shape period) {
  const Index most_p = half_plane.rows() - 1, most_q = half_plane.cols() / 2;
  auto at = [&](Index p, Index q) { return p < 0 ? half_plane(-p, most_q - q) : half_plane(p, most_q + q); };
  const Index half_x = std::min(most_p, period.nx / 2), half_y = std::min(most_q, period.ny / 2);
  return Field::NullaryExpr(half_x + 1, 2 * half_y + 1, [&](Index row, Index column) {
    double sum = 0;
    for (Index p = first(row, most_p, period.nx); p <= most_p; p += period.nx)
      for (Index q = first(column - half_y, most_q, period.ny); q <= most_q; q += period.ny) sum += at(p, q);
    return sum;
  });
}

// ---- the root of a spectrum ----

namespace {

constexpr Index block_columns = PrunedTransform::width;

// visit(k, column) for the columns k ≤ M/2 in a block of a transform on the torus.
void each_column(const PrunedTransform& transform, Index b, Complex* block, auto visit) {
  for (Index c = 0; c < std::min(block_columns, transform.columns() - b * block_columns); ++c)
    visit(b * block_columns + c, block + c * transform.stride());
}

// Scaled to unit variance: the squares over the whole torus add up to its points.
SpectralRoot of_unit_variance(SpectralRoot root) {
  const auto [rows, columns] = root.torus;
  double sum = 0;
  for (Index k = 0; k < root.columns(); ++k) {
    const Eigen::Map<const Eigen::ArrayXd> column(root.column(k), rows);
    sum += column.square().sum() * (k > 0 && 2 * k < columns ? 2 : 1);
  }
  const double scale = std::sqrt(static_cast<double>(root.torus.cells()) / sum);
  for (double& value : root.values) value *= scale;
  return root;
}

SpectralRoot room_for_root(Shape torus) {
  return {torus, AlignedVector<double>(size(torus.nx * (torus.ny / 2 + 1)))};
}

// The half spectrum of so many rows of the inverse transform of root^power.
HalfSpectrum composed(const SpectralRoot& root, const PrunedTransform& transform, int power, int threads) {
  HalfSpectrum half = transform.half_spectrum();
  transform.compose(half, threads, [&](Index b, Complex* block, int) {
    std::fill_n(block, transform.block_size(), Complex{});
    each_column(transform, b, block, [&](Index k, Complex* column) {
      const double* value = root.column(k);
      for (Index i = 0; i < root.torus.nx; ++i) column[i] = power == 1 ? value[i] : value[i] * value[i];
    });
  });
  return half;
}

}  // namespace

// R is even under point reflection: its spectrum is twice the real part of that of the rows p ≥ 0, where
// those count half that are their own mirror images.
SpectralRoot spectral_root(const Field& half_plane, Shape torus, int threads) {
  const Index rows = half_plane.rows(), most_q = half_plane.cols() / 2;
  const PrunedTransform transform({rows, torus.ny}, torus, Ways::forward_only);
  HalfSpectrum half = transform.half_spectrum();
  transform.forward_each_row(
      [&](Index p, double* row) {
        const double weight = p == 0 || 2 * p == torus.nx ? 0.5 : 1;
        std::fill_n(row, torus.ny, 0.0);
        for (Index q = -most_q; q <= most_q; ++q)
          row[within(q, torus.ny)] = weight * half_plane(p, most_q + q);
      },
      half, threads);
  SpectralRoot out = room_for_root(torus);
  transform.each_block(half, threads, [&](Index b, Complex* block) {
    each_column(transform, b, block, [&](Index k, const Complex* column) {
      double* root = out.values.data() + k * torus.nx;
      for (Index i = 0; i < torus.nx; ++i) root[i] = std::sqrt(std::max(2 * column[i].real(), 0.0));
    });
  });
  return of_unit_variance(std::move(out));
}

Field kernel_of(const SpectralRoot& root, int threads) {
  const Shape torus = root.torus;
  const PrunedTransform transform(torus, torus);
  Field plane(torus.nx, torus.ny);
  transform.inverse_rows(composed(root, transform, 1, threads), plane, threads,
                         1 / static_cast<double>(torus.cells()));
  const Index middle_x = (torus.nx - 1) / 2, middle_y = (torus.ny - 1) / 2;
  return Field::NullaryExpr(torus.nx, torus.ny, [&](Index k, Index l) {
    return plane(within(k - middle_x, torus.nx), within(l - middle_y, torus.ny));
  });
}

void correlation_of(const SpectralRoot& root, Index rows, const LagRows& sink, int threads) {
  constexpr Index group = RowTransform::rows;
  const Index period = root.torus.ny, middle = period / 2;
  const PrunedTransform transform({rows, period}, root.torus);
  const HalfSpectrum half = composed(root, transform, 2, threads);
  const double scale = 1 / static_cast<double>(root.torus.cells());
  parallel_ranges((rows + group - 1) / group, threads, [&](Index begin, Index end, int) {
    Field circle(group, period), lags(group, 2 * middle + 1);
    RowTransform::Work work = transform.row_work();
    for (Index first = begin * group; first < std::min(end * group, rows); first += group) {
      const Index count = std::min(group, rows - first);
      transform.inverse_group(half, first, count, period, circle.data(), period, work);
      for (Index column = 0; column < lags.cols(); ++column)
        lags.col(column) = scale * circle.col(within(column - middle, period));
      sink(first, lags.topRows(count));
    }
  });
}

Field correlation_of(const SpectralRoot& root, int threads) {
  Field out(root.torus.nx / 2 + 1, root.torus.ny / 2 * 2 + 1);
  correlation_of(
      root, out.rows(),
      [&](Index begin, const Eigen::Ref<const Field>& rows) { out.middleRows(begin, rows.rows()) = rows; },
      threads);
  return out;
}

Field periodic_kernel(const Field& half_plane, Shape torus) {
  return kernel_of(spectral_root(half_plane, torus));
}

SpectralRoot root_of_power(const PowerSpectrum& power, Shape torus) {
  SpectralRoot out = room_for_root(torus);
  const Index columns = out.columns();
  for (Index i = 0; i < torus.nx; ++i)
    for (Index k = 0; k < columns; ++k)
      out.values[size(k * torus.nx + i)] = std::sqrt(std::max(power[size(i * columns + k)].real(), 0.0));
  return of_unit_variance(std::move(out));
}

SpectralRoot root_of_kernel(const Field& kernel) {
  PowerSpectrum power = spectrum_of(kernel);
  for (Complex& p : power) p = std::norm(p);
  return root_of_power(power, shape_of(kernel));
}

Field kernel_of_power(PowerSpectrum power, Shape torus) { return kernel_of(root_of_power(power, torus)); }

Field correlation_of_power(PowerSpectrum power, Shape torus) {
  const Field plane = inverse(std::move(power), torus);
  const Index middle = torus.ny / 2;
  return Field::NullaryExpr(torus.nx / 2 + 1, 2 * middle + 1, [&](Index p, Index column) {
    return plane(p, within(column - middle, torus.ny));
  });
}

Field periodic_autocorrelation(const Field& kernel) {
  PowerSpectrum power = spectrum_of(kernel);
  const double points = static_cast<double>(kernel.size());
  for (Complex& p : power) p = std::norm(p) / points;
  return correlation_of_power(std::move(power), shape_of(kernel));
}

}  // namespace asperity
