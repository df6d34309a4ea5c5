#include "stats/uncertainty/lag_spectrum.hpp"

namespace asperity {

Field unfolded(const LagField& f, Shape torus) {
  const auto [nx, ny] = torus;
  Field plane = Field::Zero(nx, ny);
  for (Index p = -f.max_p(); p <= f.max_p(); ++p)
    for (Index q = -f.max_q(); q <= f.max_q(); ++q) plane(wrapped(p, nx), wrapped(q, ny)) = f(p, q);
  return plane;
}

Eigen::ArrayXd LagSpectrum::of(const LagField& f) const {
  const Field plane = unfolded(f, torus());
  AlignedVector<Complex> values(static_cast<std::size_t>(transform_.spectrum_size()));
  transform_.forward(plane.data(), values.data());
  return Eigen::Map<const Eigen::ArrayXcd>(values.data(), transform_.spectrum_size()).real();
}

Field LagSpectrum::function(const Eigen::ArrayXd& spectrum) const {
  AlignedVector<Complex> values(spectrum.begin(), spectrum.end());
  Field out(torus().nx, torus().ny);
  transform_.inverse(values.data(), out.data());
  return out / static_cast<double>(torus().cells());
}

double LagSpectrum::mean(const Eigen::ArrayXd& values) const {
  double sum = 0;
  for (Index place = 0; place < values.size(); ++place) {
    const Index l = place % transform_.spectrum_columns();
    sum += (l == 0 || 2 * l == torus().ny ? 1 : 2) * values(place);
  }
  return sum / static_cast<double>(torus().cells());
}

}  // namespace asperity
