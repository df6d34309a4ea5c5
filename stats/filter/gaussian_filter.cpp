#include "stats/filter/gaussian_filter.hpp"

#include <cmath>
#include <tuple>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_sums.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {

void check_cutoff(const Grid& grid, double cutoff) {
  if (!(cutoff > 0 && std::isfinite(cutoff)))
    throw ParameterError("cut-off", "'" + in_digits(cutoff, 12) + " m' is not a positive length");
  for (const auto& [axis, n, spacing] :
       {std::tuple{"x", grid.shape.nx, grid.dx}, std::tuple{"y", grid.shape.ny, grid.dy}})
    if (n > 1 && cutoff < 2 * spacing)
      throw ParameterError("cut-off", "'" + in_digits(cutoff, 12) + " m' is below two samples along " + axis +
                                          ", " + in_digits(2 * spacing, 12) + " m");
}

Field gaussian_mean_surface(const Field& z, const Grid& grid, double cutoff, int threads) {
  GaussianSums sums(grid, cutoff, threads);
  const double level = mean(z);
  if (!has_missing(z)) {
    Field out = sums.mean(z - level);
    out += level;
    return out;
  }
  const Field valid = validity(z);
  return (valid > 0).select(sums.of(zero_filled(z - level)) / sums.of(valid), NAN) + level;
}

}  // namespace asperity
