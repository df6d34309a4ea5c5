#include "acf_yardsticks.hpp"

#include <Eigen/QR>

#include "acf/equations.hpp"
#include "core/stopwatch.hpp"

namespace asperity {
namespace {

constexpr Index depth = 5;  // earlier iterates that are combined
constexpr long most_steps = 200;
constexpr double most_growth = 1e6;  // of the residual over its least: beyond it the iteration diverges

std::span<double> span(Eigen::VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

// The last differences of a sequence, the oldest overwritten.
struct Differences {
  Eigen::MatrixXd columns;
  Eigen::VectorXd former;

  void add(const Eigen::VectorXd& next, Index k) {
    if (k > 0) columns.col((k - 1) % columns.cols()) = next - former;
    former = next;
  }
};

// From `best`, the start, to the iterate of the least max |F|.
void iterate(Equations& equations, Eigen::VectorXd& best, double tolerance, KernelReport& report) {
  Eigen::VectorXd u = best, f(u.size());
  Differences images{Eigen::MatrixXd(u.size(), std::min(depth, u.size())), u}, steps = images;
  double least = std::numeric_limits<double>::infinity();
  while (true) {
    equations.residual(span(u), span(f));
    ++report.residuals;
    const double largest = largest_absolute(span(f));
    if (largest < least) {
      least = largest;
      best = u;
    }
    if (largest <= tolerance || !(largest <= most_growth * least && std::isfinite(largest)) ||
        report.steps == most_steps)
      return;
    equations.linearize(span(u));
    equations.precondition(span(f));
    const Index k = report.steps++, earlier = std::min(k, images.columns.cols());
    u -= f;
    images.add(u, k);
    steps.add(-f, k);
    if (earlier > 0)
      u -= images.columns.leftCols(earlier) * steps.columns.leftCols(earlier).householderQr().solve(-f);
  }
}

void measure(const KernelRequest& request, const Field& kernel, KernelReport& report) {
  const auto [n, m] = request.lags;
  const Index middle = 2 * m - 1;  // the column of q = 0
  const Field target = Field::NullaryExpr(2 * n, 4 * m - 1, [&](Index p, Index column) {
    return request.target(static_cast<double>(p), static_cast<double>(column - middle));
  });
  const Field error = (autocorrelation(kernel, target.rows(), target.cols()) - target).abs();
  report.error = error.maxCoeff();
  report.mirrored_error = error.block(1, middle - m + 1, n - 1, m - 1).maxCoeff();
  report.residual = error.block(0, middle, n, m).maxCoeff();
  if (request.formulation != Formulation::patir)
    report.residual = std::max(report.residual, report.mirrored_error);
}

}  // namespace

KernelReport anderson_fixed_point(const KernelRequest& request) {
  const Stopwatch watch;
  KernelReport report;
  std::unique_ptr<Equations> equations;
  if (request.formulation == Formulation::patir)
    equations = std::make_unique<PatirEquations>(request.target, request.lags);
  else
    equations = std::make_unique<ZeroPhaseEquations>(request.target, request.lags,
                                                     request.formulation == Formulation::oriented);
  const std::vector<double> start = equations->start();
  Eigen::VectorXd u = Eigen::Map<const Eigen::VectorXd>(start.data(), equations->count());
  iterate(*equations, u, request.tolerance / 2, report);
  Field kernel = equations->kernel(span(u));
  measure(request, kernel, report);
  if (!(report.residual <= request.tolerance))
    measure(request, kernel /= std::sqrt(kernel.square().sum()), report);
  report.answer = report.residual <= request.tolerance ? Answer::exact : Answer::best;
  report.seconds = watch.seconds();
  return report;
}

}  // namespace asperity
