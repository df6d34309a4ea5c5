#include "stats/measure/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/height/distribution.hpp"
#include "stats/spatial/acf.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

void check_shape(const Surface& surface) {
  const Shape field = shape_of(surface.heights), own = surface.grid.shape;
  if (field != own)
    throw DataError(surface.variable, "the field has " + text(field) + " points, its grid " + text(own));
}

double largest_of(const Surface& surface) {
  return surface.heights.abs().maxCoeff<Eigen::PropagateNumbers>();
}

Field waves_beyond(Surface& surface, const char* name, const Cutoff& cutoff, int threads) try {
  MeanSurface waves = mean_surface(surface.heights, surface.grid, cutoff, threads);
  if (!waves.doubt.empty()) surface.doubts.push_back("`" + std::string(name) + "`: " + waves.doubt);
  return std::move(waves.surface);
} catch (const ParameterError& error) {
  throw ParameterError(name, error.what());
}

}  // namespace

FlatSurface::FlatSurface(const DataError& why, Surface of) : DataError(why) {
  of.heights = of.heights.isNaN().select(of.heights, 0).eval();
  of.flat = true;
  surface = std::make_shared<const Surface>(std::move(of));
}

Surface prepared(Surface surface, const Preparation& preparation, int threads) {
  check_shape(surface);
  surface.level = mean(surface.heights);
  const double size = surface.largest = largest_of(surface);
  const auto& [form, shorter, longer] = preparation;
  if (!shorter.given()) surface.step = neighbour_step(surface.heights);
  surface.heights = without_form(std::move(surface.heights), surface.grid, form, threads).heights;
  surface.degree = std::max(surface.degree, form.modes());
  if (shorter.given()) surface.heights = waves_beyond(surface, "lambda-s", shorter, threads);
  if (longer.given()) {
    surface.heights -= waves_beyond(surface, "lambda-c", longer, threads);
    surface.degree = degree_behind(surface.degree, surface.grid, longer);
  }
  if (preparation.filters()) {
    surface.heights -= mean(surface.heights);
    surface.correlation.reset(), surface.distribution.reset();
  }
  try {
    refuse_round_off(largest_of(surface), size, form, surface.variable);
  } catch (const DataError& flat) {
    throw FlatSurface(flat, std::move(surface));
  }
  return surface;
}

Shape lags_of_errors(const Grid& grid) {
  if (grid.periodic.both()) return longest_lags(grid);
  auto along = [](Index n) { return std::max(n + 1, fast_length(2 * n) / 2); };
  return {along(grid.shape.nx), along(grid.shape.ny)};
}

void refuse_round_off(double largest, double size, const Form& form, const std::string& variable) {
  if (!(largest > 0)) throw DataError(variable, "every value is the same");
  if (largest <= round_off_of(size))
    throw DataError(variable, "zero to round-off above its form (" + form.words() + "): only " +
                                  shortest(largest) + " remains of values up to " + shortest(size));
}

ErrorBasis error_basis(const Surface& surface, int threads) {
  check_shape(surface);
  const Pairs pairs = Pairs::of(surface.heights, surface.grid, threads);
  const FormModes form(surface.heights, pairs, surface.degree, threads);
  if (surface.correlation) return {*surface.correlation, false, pairs, form};
  const AcfParameters half{.max_lag = default_max_lag(surface.grid), .threads = threads};
  return {estimate_autocorrelation(surface.heights, pairs, half), true, pairs, form};
}

template <class Visit>
void ErrorBasis::for_each_known(Visit visit) const {
  const LagField rho = correlation.normalised();
  if (estimated)
    for (const WeightedLag& lag : significant(rho, pairs)) visit(lag);
  else
    for_each_lag(rho, pairs, [&](Index p, Index q, double weight) { visit({p, q, rho(p, q), weight}); });
}

FieldExtent ErrorBasis::extent() const {
  double all = 0, along_x = 0, along_y = 0, negative = 0;
  for_each_known([&](const WeightedLag& lag) {
    const double square = lag.weight * lag.rho * lag.rho;
    all += square;
    along_x += square * static_cast<double>(std::abs(lag.p));
    along_y += square * static_cast<double>(std::abs(lag.q));
    if (lag.rho < 0) negative += square;
  });
  const auto [nx, ny] = pairs.sides();
  auto lengths = [all](double side, double along) { return side / (0.5 + along / all); };
  return {size().patches(), lengths(nx, along_x) / lengths(ny, along_y), negative / all};
}

std::string rounded(double independent) { return shortest(std::round(10 * independent) / 10); }

std::string too_few(const EffectiveSampleSize& size) {
  if (size.gives_errors()) return "";
  if (size.effective(2) >= size.least_effective())
    return "the form of degree " + std::to_string(size.form().degree()) +
           " has taken too large a share of the heights to tell what it took: its " +
           shortest(size.form().count()) + " modes, with N_eff = " + rounded(size.effective(2));
  return "N_eff = " + rounded(size.effective(2)) + " is below " + shortest(size.least_effective());
}

}  // namespace asperity
