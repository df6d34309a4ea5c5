#include "stats/measure/surface.hpp"

#include <cmath>
#include <cstdlib>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/spatial/acf.hpp"

namespace asperity {
namespace {

std::string form_of(int degree) {
  return degree == 0 ? "mean" : degree == 1 ? "plane" : "degree " + std::to_string(degree);
}

double largest_of(const Field& z) { return z.abs().maxCoeff<Eigen::PropagateNumbers>(); }

Field mean_surface(const Surface& surface, const char* name, double cutoff, int threads) try {
  return gaussian_mean_surface(surface.heights, surface.grid, cutoff, threads);
} catch (const ParameterError& error) {
  throw ParameterError(name, error.what());
}

}  // namespace

Surface prepared(Surface surface, const Preparation& preparation, int threads) {
  surface.level = mean(surface.heights);
  const double size = surface.largest = largest_of(surface.heights);
  const auto [degree, shorter, longer] = preparation;
  surface.heights = remove_form(surface.heights, degree);
  surface.degree = degree;
  if (!std::isnan(shorter)) surface.heights = mean_surface(surface, "lambda-s", shorter, threads);
  if (!std::isnan(longer)) surface.heights -= mean_surface(surface, "lambda-c", longer, threads);
  if (preparation.filters()) surface.correlation.reset(), surface.distribution.reset();
  refuse_round_off(largest_of(surface.heights), size, degree, surface.variable);
  return surface;
}

void refuse_round_off(double largest, double size, int degree, const std::string& variable) {
  if (!(largest > 0)) throw DataError(variable, "every value is the same");
  if (largest <= round_off_of(size))
    throw DataError(variable, "zero to round-off above its form (" + form_of(degree) + "): only " +
                                  shortest(largest) + " remains of values up to " + shortest(size));
}

ErrorBasis error_basis(const Surface& surface, int threads) {
  const Pairs pairs = Pairs::of(surface.heights, surface.grid, threads);
  const FormModes form(surface.heights, pairs, surface.degree, threads);
  if (surface.correlation) return {*surface.correlation, false, pairs, form};
  const AcfParameters half{.max_lag = default_max_lag(surface.grid), .threads = threads};
  return {estimate_autocorrelation(surface.heights, pairs, half), true, pairs, form};
}

FieldExtent ErrorBasis::extent() const {
  double all = 0, along_x = 0, along_y = 0, negative = 0;
  const LagField rho = known_lags().normalised();
  for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
    const double square = weight * rho(p, q) * rho(p, q);
    all += square;
    along_x += square * static_cast<double>(std::abs(p));
    along_y += square * static_cast<double>(std::abs(q));
    if (rho(p, q) < 0) negative += square;
  });
  const auto [nx, ny] = pairs.sides();
  auto lengths = [all](double side, double along) { return side / (0.5 + along / all); };
  return {size().patches(), lengths(nx, along_x) / lengths(ny, along_y), negative / all};
}

std::string rounded(double independent) { return shortest(std::round(10 * independent) / 10); }

std::string too_few(const EffectiveSampleSize& size) {
  if (size.gives_errors()) return "";
  return "N_eff = " + rounded(size.effective(2)) + " is below " + shortest(size.least_effective());
}

}  // namespace asperity
