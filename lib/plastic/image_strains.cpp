#include "plastic/image_strains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

// Points, and the low-pass filter exp(-16 (q/q_Nyquist)⁴) that lets no wave ring: 24 points, or another
// power, leave the same errors to 3 % (tests/plastic/layered_body.cpp).
constexpr Index coarse_period = 16;
constexpr double image_damping = 16;

// Of n points of a spacing [rad/m].
double image_wave(Index k, Index n, double spacing) {
  return 2 * std::numbers::pi * static_cast<double>(2 * k <= n ? k : k - n) /
         (static_cast<double>(n) * spacing);
}

}  // namespace

ImageStrains::ImageStrains(const Grid& cells, Shape torus, const LayerWaves& waves)
    : waves_(waves),
      x_(axis(cells.shape.nx, cells.dx, torus.nx, cells.periodic.x)),
      y_(axis(cells.shape.ny, cells.dy, torus.ny, cells.periodic.y)) {}

ImageStrains::Axis ImageStrains::axis(Index cells, double spacing, Index period, bool periodic) {
  if (periodic) return {Eigen::MatrixXd::Identity(cells, cells), spacing, 1, cells, true};
  const Index points = std::min(coarse_period, period);
  const double wide = spacing * static_cast<double>(period) / static_cast<double>(points);
  const auto last = static_cast<Index>(static_cast<double>(cells - 1) * spacing / wide);
  Axis out{Eigen::MatrixXd::Zero(cells, last + 4), wide, spacing / wide, points, false};
  for (Index i = 0; i < cells; ++i) {
    const double x = static_cast<double>(i) * spacing / wide;
    const Index j = std::min(static_cast<Index>(x), last);
    for (Index n = 0; n < 4; ++n) {  // Lagrange's polynomials on j-1 … j+2
      double weight = 1;
      for (Index m = 0; m < 4; ++m)
        if (m != n) weight *= (x - static_cast<double>(j + m - 1)) / static_cast<double>(n - m);
      out.interpolation(i, j + n) = weight;
    }
  }
  return out;
}

// Of the coarse strain on `times` periods along the free axes.
void ImageStrains::add_response(const LayeredField& strain, Index times, double factor,
                                LayeredField& out) const {
  const Shape torus{x_.periodic ? x_.period : times * x_.period, y_.periodic ? y_.period : times * y_.period};
  const RealTransform2D transform(torus);
  const Index components = out.components();
  AlignedVector<double> points(size(torus.cells()));
  Eigen::Map<Field> on_torus(points.data(), torus.nx, torus.ny);
  std::vector<AlignedVector<Complex>> spectra(size(strain.layers() * components));
  auto spectrum = [&](Index k, Index c) { return spectra[size(k * components + c)].data(); };
  const auto [nx, ny] = strain.shape();
  for (Index k = 0; k < strain.layers(); ++k)
    for (Index c = 0; c < components; ++c) {
      spectra[size(k * components + c)].resize(size(transform.spectrum_size()));
      if (c >= strain.components()) continue;
      on_torus.setZero();
      on_torus.topLeftCorner(nx, ny) = strain(k, c);
      transform.forward(points.data(), spectrum(k, c));
    }
  respond(torus, factor / static_cast<double>(torus.cells()), components > strain.components(), spectrum);
  for (Index k = 0; k < strain.layers(); ++k)
    for (Index c = 0; c < components; ++c) {
      transform.inverse(spectrum(k, c), points.data());
      out(k, c) += on_torus.topLeftCorner(nx, ny);
    }
}

// On the half spectra of a torus of coarse points.
template <class Spectrum>
void ImageStrains::respond(Shape torus, double factor, bool with_mean, Spectrum spectrum) const {
  constexpr Index lanes = LayerWaves::lanes;
  const Index columns = torus.ny / 2 + 1, waves = torus.nx * columns;
  LayerWaves::Work work(waves_.layers());
  for (Index first = 0; first < waves; first += lanes) {
    LayerWaves::Lanes qx, qy, factors;
    LayerWaves::Places places{{}, std::min(lanes, waves - first)};
    for (Index l = 0; l < lanes; ++l) {
      const Index wave = first + std::min(l, places.count - 1), kx = wave / columns, ky = wave % columns;
      places.at[size(l)] = wave;
      qx[l] = image_wave(kx, torus.nx, x_.spacing);
      qy[l] = image_wave(ky, torus.ny, y_.spacing);
      const double nyquist = 1 / std::numbers::pi, part = std::pow(nyquist * qx[l] * x_.spacing, 2) +
                                                          std::pow(nyquist * qy[l] * y_.spacing, 2);
      factors[l] = factor * std::exp(-image_damping * part * part);
    }
    waves_.prepare(qx, qy, work);
    waves_.respond(work, places, factors, with_mean, spectrum, [](int) {});
  }
}

void ImageStrains::take_off(const LayeredField& strain, LayeredField& stress, double two_mu) const {
  if (x_.periodic && y_.periodic) return;
  const double order = x_.periodic || y_.periodic ? 2 : 3, kappa = 1 / (1 - std::exp2(-order));
  const Shape coarse{x_.interpolation.cols(), y_.interpolation.cols()};
  LayeredField coarse_strain(strain.layers(), strain.components(), coarse),
      coarse_stress(strain.layers(), stress.components(), coarse);
  const Eigen::MatrixXd &to_x = x_.interpolation, &to_y = y_.interpolation,
                        from_x = x_.share * to_x.transpose();
  for (Index k = 0; k < strain.layers(); ++k)
    for (Index c = 0; c < strain.components(); ++c)
      coarse_strain(k, c) = (y_.share * (from_x * strain(k, c).matrix()) * to_y).array();
  add_response(coarse_strain, 2, kappa * two_mu, coarse_stress);
  add_response(coarse_strain, 1, -kappa * two_mu, coarse_stress);
  for (Index k = 0; k < strain.layers(); ++k)
    for (Index c = 0; c < stress.components(); ++c)
      stress(k, c) += ((to_x * coarse_stress(k, c).matrix()) * to_y.transpose()).array();
}

}  // namespace asperity
