#include "plastic/image_strains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"

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

// An axis: its points, and the interpolation from them to the cells.
struct CoarseAxis {
  Eigen::MatrixXd to_cells;  // cells × points
  double spacing, share;     // of the points [m]; of it that a cell has
  Index points;              // in a period
  bool periodic;

  Index of_periods(Index times) const { return periodic ? points : times * points; }
};

CoarseAxis coarse_axis(Index cells, double spacing, Index period, bool periodic) {
  if (periodic) return {Eigen::MatrixXd::Identity(cells, cells), spacing, 1, cells, true};
  const Index points = std::min(coarse_period, period);
  const double wide = spacing * static_cast<double>(period) / static_cast<double>(points);
  const auto last = static_cast<Index>(static_cast<double>(cells - 1) * spacing / wide);
  CoarseAxis out{Eigen::MatrixXd::Zero(cells, last + 4), wide, spacing / wide, points, false};
  for (Index i = 0; i < cells; ++i) {
    const double x = static_cast<double>(i) * spacing / wide;
    const Index j = std::min(static_cast<Index>(x), last);
    for (Index n = 0; n < 4; ++n) {  // Lagrange's polynomials on j-1 … j+2
      double weight = 1;
      for (Index m = 0; m < 4; ++m)
        if (m != n) weight *= (x - static_cast<double>(j + m - 1)) / static_cast<double>(n - m);
      out.to_cells(i, j + n) = weight;
    }
  }
  return out;
}

// On coarse points; layers, or waves, are shared by threads.
struct CoarseBody {
  const LayerWaves& waves;
  CoarseAxis x, y;
  int threads;

  template <class Visit>
  void each_layer(Visit visit) const {
    parallel_ranges(waves.layers(), threads, [&](Index begin, Index end, int) {
      for (Index k = begin; k < end; ++k) visit(k);
    });
  }
  void add_response(const LayeredField& strain, Index times, double factor, LayeredField& out) const;
  template <class Spectrum>
  void respond(Shape torus, double factor, bool with_mean, Spectrum spectrum) const;
};

// Of the strain on `times` periods along the free axes.
void CoarseBody::add_response(const LayeredField& strain, Index times, double factor,
                              LayeredField& out) const {
  const RealTransform2D transform({x.of_periods(times), y.of_periods(times)});
  const Shape torus = transform.shape();
  const Index components = out.components(), modes = transform.spectrum_size();
  std::vector<AlignedVector<Complex>> spectra(size(strain.layers() * components));
  auto spectrum = [&](Index k, Index c) { return spectra[size(k * components + c)].data(); };
  const auto [nx, ny] = strain.shape();
  each_layer([&, nx = nx, ny = ny](Index k) {
    AlignedVector<double> points(size(torus.cells()));
    for (Index c = 0; c < components; ++c) {
      spectra[size(k * components + c)].resize(size(modes));
      if (c >= strain.components()) continue;
      Eigen::Map<Field>(points.data(), torus.nx, torus.ny).topLeftCorner(nx, ny) = strain(k, c);
      transform.forward(points.data(), spectrum(k, c));
    }
  });
  respond(torus, factor / static_cast<double>(torus.cells()), components > strain.components(), spectrum);
  each_layer([&, nx = nx, ny = ny](Index k) {
    AlignedVector<double> points(size(torus.cells()));
    for (Index c = 0; c < components; ++c) {
      transform.inverse(spectrum(k, c), points.data());
      out(k, c) += Eigen::Map<Field>(points.data(), torus.nx, torus.ny).topLeftCorner(nx, ny);
    }
  });
}

// On the half spectra of a torus of coarse points.
template <class Spectrum>
void CoarseBody::respond(Shape torus, double factor, bool with_mean, Spectrum spectrum) const {
  constexpr Index lanes = LayerWaves::lanes;
  const Index columns = torus.ny / 2 + 1, modes = torus.nx * columns;
  parallel_ranges((modes + lanes - 1) / lanes, threads, [&](Index begin, Index end, int) {
    LayerWaves::Work work(waves.layers());
    for (Index first = begin * lanes; first < std::min(end * lanes, modes); first += lanes) {
      LayerWaves::Lanes qx, qy, factors;
      LayerWaves::Places places{{}, std::min(lanes, modes - first)};
      for (Index l = 0; l < lanes; ++l) {
        const Index mode = first + std::min(l, places.count - 1);
        places.at[size(l)] = mode;
        qx[l] = image_wave(mode / columns, torus.nx, x.spacing);
        qy[l] = image_wave(mode % columns, torus.ny, y.spacing);
        const double nyquist = 1 / std::numbers::pi, part = std::pow(nyquist * qx[l] * x.spacing, 2) +
                                                            std::pow(nyquist * qy[l] * y.spacing, 2);
        factors[l] = factor * std::exp(-image_damping * part * part);
      }
      waves.prepare(qx, qy, work);
      waves.respond(work, places, factors, with_mean, spectrum, [](int) {});
    }
  });
}

}  // namespace

void take_off_images(const Grid& cells, Shape torus, const LayerWaves& waves, double two_mu,
                     const LayeredField& strain, LayeredField& stress, int threads) {
  if (cells.periodic.both()) return;
  const double order = cells.periodic.any() ? 2 : 3, kappa = 1 / (1 - std::exp2(-order));
  const CoarseBody body{waves, coarse_axis(cells.shape.nx, cells.dx, torus.nx, cells.periodic.x),
                        coarse_axis(cells.shape.ny, cells.dy, torus.ny, cells.periodic.y), threads};
  const Eigen::MatrixXd &to_x = body.x.to_cells, &to_y = body.y.to_cells,
                        from_x = body.x.share * to_x.transpose();
  const Shape coarse{to_x.cols(), to_y.cols()};
  LayeredField coarse_strain(strain.layers(), strain.components(), coarse),
      coarse_stress(strain.layers(), stress.components(), coarse);
  body.each_layer([&](Index k) {
    for (Index c = 0; c < strain.components(); ++c)
      coarse_strain(k, c) = (body.y.share * (from_x * strain(k, c).matrix()) * to_y).array();
  });
  body.add_response(coarse_strain, 2, kappa * two_mu, coarse_stress);
  body.add_response(coarse_strain, 1, -kappa * two_mu, coarse_stress);
  body.each_layer([&](Index k) {
    for (Index c = 0; c < stress.components(); ++c)
      stress(k, c) += ((to_x * coarse_stress(k, c).matrix()) * to_y.transpose()).array();
  });
}

}  // namespace asperity
