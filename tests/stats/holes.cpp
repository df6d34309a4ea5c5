// What missing points do to the densities of a spectrum.
#include "stats/spectrum/holes.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "fields.hpp"
#include "holes.hpp"
#include "stats/measure/spectra.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double at(const LagField& psd, Shape shape, Index p, Index q) {
  p = (p % shape.nx + shape.nx) % shape.nx, q = (q % shape.ny + shape.ny) % shape.ny;
  if (p > shape.nx / 2) p = shape.nx - p, q = (shape.ny - q) % shape.ny;
  return psd(p, q <= shape.ny / 2 ? q : q - shape.ny);
}

}  // namespace

// C'(k) = Σ_j C(j) |M(k-j)|² / (n Σ M): sums of n² positive terms, round-off below n ε of the largest density.
TEST_CASE("a spectrum is spread once more by the transform of the points that are there", "[holes][exact]") {
  for (const Shape shape : {Shape{6, 5}, Shape{7, 8}, Shape{1, 9}}) {
    const Grid grid{shape, 1, 1, false};
    const Field z = with_holes(white_noise(shape, 3), 0.4, 77);
    const LagField psd = power_spectrum(z, grid, {DataWindow::none, DataWindow::none}),
                   spread = spread_by_holes(psd, z);
    Field power(shape.nx, shape.ny);
    double there = 0;
    for (Index p = 0; p < shape.nx; ++p)
      for (Index q = 0; q < shape.ny; ++q) {
        std::complex<double> sum = 0;
        for (Index i = 0; i < shape.nx; ++i)
          for (Index j = 0; j < shape.ny; ++j)
            if (!std::isnan(z(i, j)))
              sum += std::polar(1.0, -2 * std::numbers::pi *
                                         (static_cast<double>(p * i) / static_cast<double>(shape.nx) +
                                          static_cast<double>(q * j) / static_cast<double>(shape.ny)));
        power(p, q) = std::norm(sum);
        there += std::isnan(z(p, q)) ? 0 : 1;
      }
    const double n = static_cast<double>(z.size()), largest = psd.half_plane().maxCoeff();
    for (Index p = 0; p <= shape.nx / 2; ++p)
      for (Index q = -(shape.ny / 2); q <= shape.ny / 2; ++q) {
        double expected = 0;
        for (Index i = 0; i < shape.nx; ++i)
          for (Index j = 0; j < shape.ny; ++j)
            expected += at(psd, shape, p - i, q - j) * power(i, j) / (n * there);
        CAPTURE(shape.nx, shape.ny, p, q);
        CHECK(std::abs(spread(p, q) - expected) <= 20 * n * epsilon * largest);
      }
  }
}

// The spectrum of an average over squares falls below what a disc or holes spread; that of white noise is as
// flat as what they spread of it.
TEST_CASE("points that holes hide have no error, and others keep theirs", "[holes][law]") {
  const Grid g = grid(96, 96);
  const Field smooth = moving_average(g.shape, {9, 9}, 5);
  Field disc = smooth;
  for (Index i = 0; i < 96; ++i)
    for (Index j = 0; j < 96; ++j)
      if (std::hypot(static_cast<double>(i) - 47.5, static_cast<double>(j) - 47.5) > 46) disc(i, j) = none;
  auto hidden = [&](const Field& z, std::size_t from) {
    const auto rings =
        radial_spectrum(Sample(prepared({.grid = g, .heights = 1e-6 * z}, {})), default_windows(g));
    Index out = 0;
    for (std::size_t k = from; k < rings.size(); ++k)
      out += rings[k].no_error != NoError::none && std::isnan(rings[k].standard_error);
    return static_cast<double>(out) / static_cast<double>(rings.size() - from);
  };
  CHECK(hidden(with_holes(smooth, 0.2, 77), 24) >= 0.9);
  CHECK(hidden(disc, 40) >= 0.9);
  CHECK(hidden(with_holes(white_noise(g.shape, 9), 0.01, 77), 4) <= 0.1);
}
