#include "stats/filter/preparation.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/robust_gaussian.hpp"
#include "stats/filter/spline_filter.hpp"

namespace asperity {
namespace {

// Σ passed(1/λ) over the waves that a form takes.
template <class Passed>
double waves_taken(const Grid& grid, int degree, Passed passed) {
  const auto [nx, ny] = grid.shape;
  double sum = 0;
  for (int a = 0; a <= (nx > 1 ? degree : 0); ++a)
    for (int b = 0; b <= (ny > 1 ? degree - a : 0); ++b)
      if (a + b > 0) sum += passed(std::hypot(a / (2 * grid.size_x()), b / (2 * grid.size_y())));
  return sum;
}

int nearest_degree(const Grid& grid, double waves) {
  const auto of = [&](int degree) { return waves_taken(grid, degree, [](double) { return 1; }); };
  int degree = 0;
  while (waves > (of(degree) + of(degree + 1)) / 2) ++degree;
  return degree;
}

}  // namespace

std::string Form::words() const {
  if (kind != Kind::polynomial) return kind == Kind::sphere ? "sphere" : "cylinder";
  return degree == 0 ? "mean" : degree == 1 ? "plane" : "degree " + std::to_string(degree);
}

WithoutForm without_form(Field z, const Grid& grid, const Form& form, int threads) {
  if (form.kind == Form::Kind::polynomial) return {remove_form(std::move(z), form.degree)};
  const CurvedShape shape = form.kind == Form::Kind::sphere ? CurvedShape::sphere : CurvedShape::cylinder;
  const CurvedForm found = fit_curved_form(z, grid, shape, threads);
  return {above_form(z, grid, found), found.radius,
          std::remainder(std::atan2(found.axis[1], found.axis[0]), std::numbers::pi)};
}

MeanSurface mean_surface(const Field& z, const Grid& grid, const Cutoff& cutoff, int threads) {
  const double at = cutoff.wavelength;
  if (cutoff.filter == Cutoff::Filter::gaussian) return {gaussian_mean_surface(z, grid, at, threads)};
  if (cutoff.filter == Cutoff::Filter::spline) return {spline_mean_surface(z, grid, at, threads)};
  RobustMeanSurface found = robust_gaussian_mean_surface(z, grid, at, threads);
  std::string doubt;
  if (!found.converged)
    doubt = "the robust filter has not converged: its last step, of " + std::to_string(found.steps) +
            ", moved the surface by an rms of " + in_digits(found.change / found.width, 3) +
            " of the width of its weights; a longer cut-off converges";
  return {std::move(found.surface), std::move(doubt)};
}

int degree_on_part(int degree, const Grid& grid, double share) {
  return nearest_degree(grid, share * waves_taken(grid, degree, [](double) { return 1; }));
}

int degree_behind(int degree, const Grid& grid, const Cutoff& longer) {
  const auto passed = [&](double waves) {
    return std::pow(1 - std::exp2(-std::pow(longer.wavelength * waves, 2)), 2);
  };
  return nearest_degree(grid, waves_taken(grid, degree, passed));
}

}  // namespace asperity
