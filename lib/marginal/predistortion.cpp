#include "marginal/predistortion.hpp"

#include <algorithm>
#include <vector>

#include "acf/kernel_evaluation.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

// Lags that are looked at for the lowest value: a model that falls more slowly has it nearer than this.
constexpr Index farthest = 4096;

[[noreturn]] void refuse(const Target& target, const std::string& message) {
  if (target.known) throw DataError("acf", message);
  throw ParameterError("marginal", message);
}

}  // namespace

Target Predistortion::target(const Target& heights) const {
  Target out;
  out.row = [map = map_, row = heights.row](double p, double q, std::span<double> values) {
    row(p, q, values);
    for (double& r : values) r = map->inverse(r);
  };
  out.oriented = heights.oriented;
  out.known = heights.known;
  if (heights.reach)
    out.reach = [map = map_, reach = heights.reach](double t) {
      return reach(std::min((*map)(t), -(*map)(-t)));
    };
  return out;
}

double Predistortion::change(const Target& heights) const {
  const double lowest = map_->lowest();
  if (lowest <= -1 + 1e-12 || (!heights.known && !heights.reach)) return 0;
  Shape lags = heights.known ? *heights.known : heights.reach(-lowest);
  lags = {std::min(lags.nx, farthest), std::min(lags.ny, farthest)};
  std::vector<double> row(size(2 * lags.ny - 1));
  double least = lowest;
  for (Index p = 0; p < lags.nx; ++p) {
    heights.row(static_cast<double>(p), static_cast<double>(1 - lags.ny), row);
    least = std::min(least, *std::ranges::min_element(row));
  }
  return lowest - least;
}

// The tables and the errors of y into those of the heights.
void Predistortion::translate(Kernel& kernel, const Target& heights) const {
  kernel.acf_target = half_plane_of(heights, {kernel.acf_target.rows(), kernel.acf_target.cols() / 2 + 1});
  kernel.acf_achieved =
      kernel.acf_achieved.unaryExpr([&](double rho) { return (*map_)(std::clamp(rho, -1.0, 1.0)); }).eval();
  KernelReport& report = kernel.report;
  const double residual = report.residual;
  measure_errors(kernel);
  if (report.answer != Answer::exact) report.change = report.residual;
  report.residual = residual;
}

Kernel Predistortion::solve(const KernelRequest& heights) const {
  const double below = change(heights.target);
  const std::string bound = "heights of this distribution correlate no lower than " + number(map_->lowest());
  if (!allows(heights.infeasible, below))
    refuse(heights.target, "the autocorrelation falls to " + number(map_->lowest() - below) + ", but " +
                               bound + " (see `infeasible`)");
  KernelRequest gaussian = heights;
  gaussian.target = target(heights.target);
  gaussian.rms = 1;
  Kernel kernel = solve_kernel(gaussian);
  KernelReport& report = kernel.report;
  if (below > 0 && report.answer == Answer::exact) {
    report.answer = Answer::nearest;
    report.reason = bound;
  }
  translate(kernel, heights.target);
  if (report.answer == Answer::nearest && !(report.change <= heights.acf_tolerance) &&
      !allows(heights.infeasible, report.change))
    refuse(heights.target, report.reason + "; the closest one found changes it by " + number(report.change) +
                               " (see `infeasible`)");
  judge(report, heights);
  kernel.rms = heights.rms;
  kernel.acf_target *= heights.rms * heights.rms;
  kernel.acf_achieved *= heights.rms * heights.rms;
  return kernel;
}

}  // namespace asperity
