#include "stats/filter/preparation.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/words.hpp"
#include "stats/filter/curved_form.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/robust_gaussian.hpp"
#include "stats/filter/spline_filter.hpp"

namespace asperity {

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
            " of the width of its weights";
  return {std::move(found.surface), std::move(doubt)};
}

}  // namespace asperity
