#include "acf/kernel_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "transform/lag_sums.hpp"
#include "transform/zero_phase.hpp"

namespace asperity {
namespace {

// The lags 0 ≤ p < rows, |q| < columns of the tables: one beyond the end of every autocorrelation, and all of
// a target that is a table.
Shape extent(const Target& target, Shape lags, const Field& kernel) {
  const Shape known = target.known.value_or(Shape{1, 1});
  return {std::max({2 * lags.nx, kernel.rows() + 1, known.nx}),
          std::max({2 * lags.ny, kernel.cols() + 1, known.ny})};
}

// The autocorrelation of a zero-phase kernel, by its real spectrum.
Field zero_phase_autocorrelation(const Field& kernel, bool oriented, Index rows, Index columns) {
  const Shape reach = shape_of(kernel);  // of R: its lags are below
  const auto transform = zero_phase_transform(reach, {2 * reach.nx, 2 * reach.ny}, oriented);
  const Index middle_x = reach.nx / 2, middle_y = reach.ny / 2;
  std::vector<double> part = transform->part([&](Index k, Index l) {
    return k <= middle_x && std::abs(l) <= middle_y ? kernel(middle_x + k, middle_y + l) : 0.0;
  });
  transform->autocorrelate(part, part);
  Field out = Field::Zero(rows, columns);
  const Index middle = columns / 2;
  for (Index p = 0; p < std::min(rows, reach.nx); ++p)
    for (Index q = 0; q < std::min(middle + 1, reach.ny); ++q) {
      out(p, middle + q) = part[size(transform->place(p, q))];
      out(p, middle - q) = part[size(transform->place(p, -q))];
    }
  return out;
}

}  // namespace

Field autocorrelation(const Field& kernel, Index rows, Index columns) {
  const Shape shape = shape_of(kernel),
              last{std::min(rows, shape.nx) - 1, std::min(columns / 2, shape.ny - 1)};
  Field out = Field::Zero(rows, columns);
  out.block(0, columns / 2 - last.ny, last.nx + 1, 2 * last.ny + 1) =
      lag_sums(kernel, Grid{shape, 1, 1, false}, last);
  return out;
}

Field half_plane_of(const Target& target, Shape lags) {
  Field out(lags.nx, 2 * lags.ny - 1);
  const Index middle = lags.ny - 1, columns = out.cols();
  for (Index p = 0; p < lags.nx; ++p) {
    const Index first = target.oriented ? 0 : middle;
    const std::span row(out.data() + p * columns, size(columns));
    target.row(static_cast<double>(p), static_cast<double>(first - middle), row.subspan(size(first)));
    if (!target.oriented) std::reverse_copy(row.end() - middle, row.end(), row.begin());
  }
  if (target.known) {
    const Index rows = std::max<Index>(lags.nx - target.known->nx, 0),
                columns_beyond = std::max<Index>(lags.ny - target.known->ny, 0);
    for (auto unknown :
         {out.block(lags.nx - rows, 0, rows, columns), out.block(0, 0, lags.nx, columns_beyond),
          out.block(0, columns - columns_beyond, lags.nx, columns_beyond)})
      unknown.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

void measure_errors(Kernel& kernel) {
  KernelReport& report = kernel.report;
  const auto known = !kernel.acf_target.isNaN();
  const auto error =
      known.select((kernel.acf_achieved - kernel.acf_target).abs(), 0);  // evaluated where requested
  const auto beyond = known.select(error, kernel.acf_achieved.abs());
  const auto [n, m] = kernel.lags;
  const Index middle = -kernel.first_q();
  report.residual = error.block(0, middle, n, m).maxCoeff();
  report.mirrored_error = n > 1 && m > 1 ? error.block(1, middle - m + 1, n - 1, m - 1).maxCoeff() : 0.0;
  if (kernel.formulation != Formulation::patir)
    report.residual = std::max(report.residual, report.mirrored_error);
  report.error = error.maxCoeff();
  report.tail = beyond.rows() > n ? beyond.bottomRows(beyond.rows() - n).maxCoeff() : 0.0;
  if (middle >= m)
    report.tail = std::max({report.tail, beyond.leftCols(middle - m + 1).maxCoeff(),
                            beyond.rightCols(middle - m + 1).maxCoeff()});
}

void judge(KernelReport& report, const KernelRequest& request) {
  const bool open = request.lags == Shape{};
  report.converged = (open ? report.error : report.change) <= request.acf_tolerance;
}

std::optional<Kernel> evaluate_kernel(const Target& target, Shape lags, Formulation formulation,
                                      Field values) {
  const double sum = values.square().sum();
  if (!std::isfinite(sum) || !(sum > 0)) return std::nullopt;
  if (values.sum() < 0) values = -values;
  Kernel kernel;
  kernel.formulation = formulation;
  kernel.lags = lags;
  kernel.values = std::move(values);
  kernel.acf_target = half_plane_of(target, extent(target, lags, kernel.values));
  const Index rows = kernel.acf_target.rows(), columns = kernel.acf_target.cols();
  kernel.acf_achieved =
      formulation == Formulation::patir
          ? autocorrelation(kernel.values, rows, columns)
          : zero_phase_autocorrelation(kernel.values, formulation == Formulation::oriented, rows, columns);
  measure_errors(kernel);
  return kernel;
}

}  // namespace asperity
