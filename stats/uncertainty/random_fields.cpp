#include "stats/uncertainty/random_fields.hpp"

#include <algorithm>
#include <cmath>

#include "marginal/correlation_map.hpp"
#include "math/noise.hpp"
#include "stats/uncertainty/translation_error.hpp"

namespace asperity {
namespace {

// Along one axis: the field, and the lags beyond which ρ is negligible.
Index torus_length(Index n, bool periodic, Index reach) {
  return periodic ? n : fast_length(std::min(2 * n, n + reach));
}
Shape torus_of(const FieldModel& model) {
  const LagField& rho = model.correlation;
  Shape reach{0, 0};
  for (Index p = 0; p <= rho.max_p(); ++p)
    for (Index q = -rho.max_q(); q <= rho.max_q(); ++q)
      if (std::abs(rho(p, q)) > model.negligible)
        reach = {std::max(reach.nx, p), std::max(reach.ny, std::abs(q))};
  const auto& [shape, dx, dy, periodic] = model.grid;
  return {torus_length(shape.nx, periodic.x, reach.nx + 1), torus_length(shape.ny, periodic.y, reach.ny + 1)};
}

AlignedVector<double> root_of_power(const RealTransform2D& transform, Shape torus, const LagField& rho) {
  AlignedVector<double> lags(static_cast<std::size_t>(torus.cells()));
  auto lag = [](Index i, Index n) { return 2 * i <= n ? i : i - n; };
  for (Index i = 0; i < torus.nx; ++i)
    for (Index j = 0; j < torus.ny; ++j)
      lags[static_cast<std::size_t>(i * torus.ny + j)] = rho(lag(i, torus.nx), lag(j, torus.ny));
  AlignedVector<Complex> power(static_cast<std::size_t>(transform.spectrum_size()));
  transform.forward(lags.data(), power.data());
  AlignedVector<double> out(power.size());
  const Index columns = transform.spectrum_columns();
  double sum = 0;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Index column = static_cast<Index>(k) % columns;
    const bool own = column == 0 || 2 * column == torus.ny;  // its mirror image is in the same column
    const double p = std::max(power[k].real(), 0.0);
    sum += own ? p : 2 * p;
    // Of the real and imaginary part; of a column that is its own mirror image the transform keeps one.
    out[k] = std::sqrt(own ? p : p / 2);
  }
  for (double& value : out) value /= std::sqrt(sum);
  return out;
}

}  // namespace

RandomFields::RandomFields(const FieldModel& model, std::uint64_t seed)
    : shape_(model.grid.shape),
      translation_(model.translation),
      seed_(seed),
      torus_(torus_of(model)),
      transform_(torus_) {
  root_ =
      root_of_power(transform_, torus_,
                    translation_ ? underlying_correlation(model.correlation, CorrelationMap(*translation_))
                                 : model.correlation);
}

Field RandomFields::heights(Index k) const {
  WhiteNoise noise(seed_, static_cast<std::uint64_t>(k));
  const Index columns = transform_.spectrum_columns();
  AlignedVector<Complex> spectrum(root_.size());
  for (Index i = 0; i < torus_.nx; ++i) {
    Complex* row = spectrum.data() + i * columns;
    noise.row(i, {reinterpret_cast<double*>(row), static_cast<std::size_t>(2 * columns)});
    for (Index j = 0; j < columns; ++j) row[j] *= root_[static_cast<std::size_t>(i * columns + j)];
  }
  AlignedVector<double> whole(static_cast<std::size_t>(torus_.cells()));
  transform_.inverse(spectrum.data(), whole.data());
  if (translation_) translation_->apply(whole);
  return Eigen::Map<const Field>(whole.data(), torus_.nx, torus_.ny).topLeftCorner(shape_.nx, shape_.ny);
}

}  // namespace asperity
