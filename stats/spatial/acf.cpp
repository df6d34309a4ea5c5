#include "stats/spatial/acf.hpp"

#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/lag_sums.hpp"

namespace asperity {
namespace {

constexpr double no_pair = std::numeric_limits<double>::quiet_NaN();

void divide_by_pairs(Field& sums, const Pairs& pairs, Shape max_lag, int threads) {
  parallel_ranges(sums.rows(), threads, [&](Index begin, Index end, int) {
    for (Index p = begin; p < end; ++p)
      for (Index q = -max_lag.ny; q <= max_lag.ny; ++q) {
        const double share = pairs.share(p, q);
        sums(p, max_lag.ny + q) = share > 0 ? sums(p, max_lag.ny + q) / share : no_pair;
      }
  });
}

}  // namespace

void AcfParameters::check(const Grid& grid) const {
  const Shape most = grid.periodic ? default_max_lag(grid) : Shape{grid.shape.nx - 1, grid.shape.ny - 1};
  auto within = [](Index lag, Index bound) { return lag >= 0 && lag <= bound; };
  if (within(max_lag.nx, most.nx) && within(max_lag.ny, most.ny)) return;
  auto text = [](Shape s) { return std::to_string(s.nx) + "x" + std::to_string(s.ny); };
  throw ParameterError("max-lag",
                       "value " + text(max_lag) + " is outside 0x0 to " + text(most) +
                           (grid.periodic ? ", half the period" : ", the longest lags of the field"));
}

Shape default_max_lag(const Grid& grid) { return {grid.shape.nx / 2, grid.shape.ny / 2}; }

LagField estimate_autocorrelation(const Field& z, const Pairs& pairs, const AcfParameters& parameters) {
  const Grid& grid = pairs.grid();
  parameters.check(grid);
  Field d = parameters.level ? Field(z - *parameters.level) : remove_form(z);
  if (!pairs.complete()) d = zero_filled(d);
  Field sums = lag_sums(d, grid, parameters.max_lag, parameters.threads);
  sums /= pairs.points();
  const bool divided = grid.periodic && pairs.complete();
  if (!divided && !parameters.biased) divide_by_pairs(sums, pairs, parameters.max_lag, parameters.threads);
  return LagField(std::move(sums));
}

LagField estimate_autocorrelation(const Field& z, const Grid& grid, const AcfParameters& parameters) {
  parameters.check(grid);
  return estimate_autocorrelation(z, Pairs::of(z, grid, parameters.threads), parameters);
}

}  // namespace asperity
