/// Error of the moving-average kernel against its cost.
///
/// Targets: the exponential that has fallen to e⁻ᶜ at the last of n × m lags, that is c decay lengths.
/// `error` is the largest over all lags of the plane, `mirrored` that over the quadrant (p,-q), both against
/// the true exponential; `ratio_to_transforms` is the time of the solve over that of the transforms that its
/// residuals, products and preconditionings stand for, measured in the same run.
///
///     kernel_error_time [LARGEST_N]
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "acf/kernel.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

// One transform of the formulation's torus.
double transform_seconds(Shape lags, Formulation formulation) {
  if (formulation == Formulation::symmetric) {
    auto side = [](Index n) { return n == 1 ? Index{2} : fast_length(3 * n - 2, 4); };
    const EvenTransform2D transform({side(lags.nx), side(lags.ny)});
    AlignedVector<double> quarter(static_cast<std::size_t>(transform.quarter().cells()));
    return seconds_of([&] { transform.apply(quarter.data()); });
  }
  const RealTransform2D transform({fast_length(2 * lags.nx, 2), fast_length(2 * lags.ny, 2)});
  AlignedVector<double> field(static_cast<std::size_t>(transform.shape().cells()));
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  return seconds_of([&] {
           transform.forward(field.data(), spectrum.data());
           transform.inverse(spectrum.data(), field.data());
         }) /
         2;
}

// Two transforms a residual (one a step) and a product, one a linearisation; two or four a preconditioning.
double transforms(const KernelReport& r, Formulation formulation) {
  const double preconditioning = formulation == Formulation::symmetric ? 2 : 4;
  return 3 * static_cast<double>(r.newton_steps) + 2 * static_cast<double>(r.jacobian_products) +
         preconditioning * static_cast<double>(r.preconditionings);
}

void row(Shape lags, double c, double tolerance, Formulation formulation) {
  KernelRequest request;
  request.target =
      ExponentialTarget{static_cast<double>(lags.nx), static_cast<double>(lags.ny), std::exp(-c)};
  request.lags = lags;
  request.formulation = formulation;
  request.tolerance = tolerance;
  const KernelReport r = solve_kernel(request).report;
  const double seconds = seconds_of([&] { solve_kernel(request); });
  const double floor = transforms(r, formulation) * transform_seconds(lags, formulation);
  fmt::print("{}\t{}x{}\t{}\t{:.0e}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2e}\t{}\t{}\t{:.2f}\t{}\n",
             name_of(formulation), lags.nx, lags.ny, c, tolerance, r.error, r.mirrored_error, seconds,
             r.residual, r.newton_steps, r.jacobian_products, seconds / floor, r.converged ? "yes" : "no");
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 63;
  fmt::print(
      "# "
      "case\tn\tc\ttol\terror\tmirrored\tseconds\tresidual\tsteps\tproducts\tratio_to_"
      "transforms\tconverged\n");
  for (Index n = 7; n <= largest; n = 2 * n + 1)
    for (double c : {4.6, 6.0, 7.0, 9.0, 11.5, 14.0}) row({n, n}, c, 1e-10, Formulation::symmetric);
  for (Shape lags : {Shape{7, 4}, Shape{3, 3}, Shape{17, 4}, Shape{17, 14}, Shape{13, 13}})
    for (Formulation f : {Formulation::symmetric, Formulation::patir}) row(lags, 4.6, 1e-10, f);
  for (Index n = 7; n <= largest; n = 2 * n + 1) row({n, n}, 4.6, 1e-10, Formulation::patir);
  for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    row({31, 31}, 6, tolerance, Formulation::symmetric);
  return 0;
}
