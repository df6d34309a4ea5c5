#include "stats/spectrum/holes.hpp"

#include <algorithm>
#include <limits>

#include "stats/filter/missing.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

// (1): a F⁻¹[C] is real and even, and so is C.
Field times_pairs(Field lags, const RealTransform2D& transform, const Field& there) {
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  AlignedVector<double> values(there.data(), there.data() + there.size());
  transform.forward(values.data(), spectrum.data());
  for (Complex& c : spectrum) c = std::norm(c);
  transform.inverse(spectrum.data(), values.data());
  const double all = values[0];
  for (Index k = 0; k < lags.size(); ++k) lags.data()[k] *= values[static_cast<std::size_t>(k)] / all;
  return lags;
}

}  // namespace

LagField spread_by_holes(const LagField& psd, const Field& d) {
  const Index nx = d.rows(), ny = d.cols();
  const RealTransform2D transform({nx, ny});
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < transform.spectrum_columns(); ++j)
      spectrum[static_cast<std::size_t>(i * transform.spectrum_columns() + j)] =
          i <= psd.max_p() ? psd(i, j) : psd(nx - i, -j);
  AlignedVector<double> lags(static_cast<std::size_t>(d.size()));
  transform.inverse(spectrum.data(), lags.data());
  const Field product = times_pairs(Eigen::Map<const Field>(lags.data(), nx, ny), transform, validity(d));
  std::ranges::copy(product.reshaped<Eigen::RowMajor>(), lags.begin());
  transform.forward(lags.data(), spectrum.data());
  return LagField::of(psd.max_lag(), [&](Index p, Index q) {
    const Index row = q >= 0 ? p : (nx - p) % nx;
    return spectrum[static_cast<std::size_t>(row * transform.spectrum_columns() + std::abs(q))].real() /
           static_cast<double>(d.size());
  });
}

void judge_holes(std::vector<SpectrumPoint>& points, const std::vector<SpectrumPoint>& once_more,
                 PointKind kind) {
  auto densities = [](const std::vector<SpectrumPoint>& of) {
    std::vector<double> out;
    for (const SpectrumPoint& p : of) out.push_back(p.density);
    return out;
  };
  const std::vector<double> bias = pooled_bias(densities(once_more), densities(points), kind);
  for (std::size_t i = 0; i < points.size(); ++i) {
    SpectrumPoint& point = points[i];
    point.bias += bias[i];
    if (point.no_error == NoError::none && hidden_by(bias[i], point)) point.no_error = NoError::holes;
    if (point.no_error != NoError::none)
      point.standard_error = point.degrees = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace asperity
