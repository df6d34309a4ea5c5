#include "stats/hypothesis/random_fields.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "marginal/correlation_map.hpp"
#include "math/noise.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {
namespace {

// Along one axis: the field, and the lags beyond which ρ is negligible.
// Of a correlation that has not ended at the last lag of the field, three times as far.
Index torus_length(Index n, bool periodic, Index reach) {
  return periodic ? n : fast_length(reach >= n ? 3 * n : n + reach);
}
Shape torus_of(const FieldModel& model) {
  const Shape reach = reach_of(model);
  const auto& [shape, dx, dy, periodic] = model.grid;
  return {torus_length(shape.nx, periodic.x, reach.nx + 1), torus_length(shape.ny, periodic.y, reach.ny + 1)};
}

// ρ up to half the torus. Lags that the field does not have are free: beyond a table they have its last
// values, as a step to zero would be noise of short waves.
LagField continued(const LagField& rho, Shape half, const Grid& grid) {
  auto known = [](Index lag, Index most, Index n, bool periodic) {
    return periodic || most < n - 1 ? lag : std::clamp(lag, -std::min(most, n), std::min(most, n));
  };
  return LagField::of(half, [&](Index p, Index q) {
    return rho(known(p, rho.max_p(), grid.shape.nx, grid.periodic.x),
               known(q, rho.max_q(), grid.shape.ny, grid.periodic.y));
  });
}

SpectralRoot root_on(Shape torus, const FieldModel& model) {
  const LagField rho = model.translation
                           ? underlying_correlation(model.correlation, CorrelationMap(*model.translation))
                           : model.correlation;
  return spectral_root(continued(rho, {torus.nx / 2, torus.ny / 2}, model.grid).half_plane(), torus);
}

}  // namespace

Shape reach_of(const FieldModel& model) {
  return model.correlation.mapped([&](double rho) { return std::abs(rho) > model.negligible ? rho : 0; })
      .reach();
}

RandomFields::RandomFields(const FieldModel& model, std::uint64_t seed)
    : shape_(model.grid.shape),
      translation_(model.translation),
      seed_(seed),
      transform_(torus_of(model)),
      root_(root_on(transform_.shape(), model)) {}

LagField RandomFields::correlation(Shape max_lag) const {
  LagField rho = LagField(correlation_of(root_)).within(max_lag);
  return translation_ ? rho.mapped(CorrelationMap(*translation_)) : rho;
}

Field RandomFields::heights(Index k) const {
  WhiteNoise noise(seed_, static_cast<std::uint64_t>(k));
  const Index columns = transform_.spectrum_columns();
  const Shape torus = transform_.shape();
  const double whole_share = 1 / std::sqrt(static_cast<double>(torus.cells()));
  AlignedVector<Complex> spectrum(root_.values.size());
  for (Index i = 0; i < torus.nx; ++i) {
    Complex* row = spectrum.data() + i * columns;
    noise.row(i, {reinterpret_cast<double*>(row), size(2 * columns)});
    for (Index j = 0; j < columns; ++j) {
      const bool own = j == 0 || 2 * j == torus.ny;  // its mirror image is in the same column
      // Of the real and imaginary part; of a column that is its own mirror image the transform keeps one.
      row[j] *= root_.column(j)[i] * (own ? whole_share : std::numbers::sqrt2 / 2 * whole_share);
    }
  }
  AlignedVector<double> whole(size(torus.cells()));
  transform_.inverse(spectrum.data(), whole.data());
  if (translation_) translation_->apply(whole);
  return Eigen::Map<const Field>(whole.data(), torus.nx, torus.ny).topLeftCorner(shape_.nx, shape_.ny);
}

}  // namespace asperity
