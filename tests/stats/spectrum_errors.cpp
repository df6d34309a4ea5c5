// What wave numbers share, and the errors of means over them.
#include <iterator>
#include <tuple>

#include "fields.hpp"
#include "stats/spectrum/spectrum.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr DataWindows plain{DataWindow::none, DataWindow::none}, hann{DataWindow::hann, DataWindow::hann};

Grid metres(Index nx, Index ny) { return {{nx, ny}, 2e-6, 3e-6, false}; }

}  // namespace

// Σ (1 - cos)² exp(...) by hand: 3/2, -1, 1/4.
TEST_CASE("Hann's window lets neighbouring wave numbers share 4/9 and 1/36, none nothing",
          "[spectrum][exact]") {
  for (const Shape shape : {Shape{16, 9}, Shape{11, 12}}) {
    const Field d = random_field(shape, 98);
    const SharedPower none = shared_power(d, plain), both = shared_power(d, hann);
    const double along[] = {1, 4.0 / 9, 1.0 / 36, 0};
    for (Index p = 0; p <= 3; ++p)
      for (Index q = -3; q <= 3; ++q) {
        CHECK(std::abs(none(p, q) - (p == 0 && q == 0)) <= 100 * epsilon);
        CHECK(std::abs(both(p, q) - along[p] * along[std::abs(q)]) <= 100 * epsilon);
        CHECK(std::abs(both(p - shape.nx, q + shape.ny) - along[p] * along[std::abs(q)]) <= 100 * epsilon);
      }
  }
}

// E[C²] is 2 E[C]² of a wave number and 3 E[C]² of one that is its own mirror image, as (3) has it.
TEST_CASE("a single wave number has two degrees of freedom, its own mirror image one", "[spectrum][exact]") {
  const Shape shape{8, 6};
  const Grid g = metres(shape.nx, shape.ny);
  const Field z = random_field(shape, 101);
  const LagField psd = power_spectrum(z, g, hann);
  for (const auto& [p, q, own] : {std::tuple{0, 0, true}, {4, 3, true}, {4, 0, true}, {2, 1, false}}) {
    const auto only = [p = p, q = q](Index k, Index l) {
      return k == p && std::abs(l) == q && (q != 1 || l == q) ? 0 : -1;
    };
    const MeanPower mean = shared_power(z, hann).means(psd, 1, only).front();
    CAPTURE(p, q);
    CHECK(mean.count == (own ? 1 : 2));
    CHECK(relative_error(mean.variance, psd(p, q) * psd(p, q) * (own ? 2.0 / 3 : 0.5)) <= 100 * epsilon);
    CHECK(relative_error(mean.degrees, own ? 1 : 2) <= 100 * epsilon);
  }
}

// White noise, where the variance is exact. Of 1500 fields, a mean of χ² with ν ≥ 3 degrees has a standard
// deviation known to √((2 + 12/ν)/1500)/2 = 3.2 % at most, and the stated variance, of a relative spread of 1
// or so, to 2 %: four of both. Covered: ring by ring 5 % known to 0.6 %, and as much again for an estimated ν.
TEST_CASE("errors of profiles and rings of the PSD are their spread, at mirror images and edges too",
          "[spectrum][statistics]") {
  for (const Shape shape : {Shape{16, 12}, Shape{13, 16}, Shape{24, 9}})
    for (const DataWindows windows : {plain, hann}) {
      const Grid g = metres(shape.nx, shape.ny);
      std::vector<Spread> value, square_error;
      std::vector<double> covered;
      for (unsigned seed = 0; seed < 1500; ++seed) {
        const Field z = white_noise(shape, 3000 + seed);
        auto all = profile_spectrum(z, g, Axis1D::x, windows.x);
        std::ranges::copy(radial_spectrum(power_spectrum(z, g, windows), g, shared_power(z, windows)),
                          std::back_inserter(all));
        value.resize(all.size()), square_error.resize(all.size()), covered.resize(all.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
          const double truth = k <= static_cast<std::size_t>(shape.nx / 2) ? g.dx : g.cell_area();
          const Interval ends = all[k].interval();
          value[k].add(all[k].density), square_error[k].add(std::pow(all[k].standard_error, 2));
          covered[k] += ends.low <= truth && truth <= ends.high ? 1.0 / 1500 : 0;
        }
      }
      for (std::size_t k = 0; k < value.size(); ++k) {
        CAPTURE(shape.nx, shape.ny, k, covered[k]);
        CHECK(std::sqrt(square_error[k].mean()) / value[k].deviation() == Approx(1).margin(0.16));
        CHECK(std::abs(covered[k] - 0.95) <= 0.04);
      }
    }
}

// p² + 4q² against the odd squares (2r ± 1)² for a field twice as long as it is wide, by whole numbers: waves
// along x at odd p lie midway.
TEST_CASE("a wave number midway between two rings counts in the outer one, however the spacing is rounded",
          "[spectrum][exact]") {
  for (const Index ny : {12, 13})
    for (const double spacing : {1e-6, 0.1, 1.0 / 3, 0.7e-3})
      for (const double rounded : {1 - epsilon, 1.0, 1 + epsilon}) {
        const Grid g{{2 * ny, ny}, spacing * rounded, spacing, false};
        std::vector<double> count(static_cast<std::size_t>(ny / 2));
        for (Index p = 1 - ny; p <= ny; ++p)
          for (Index q = -((ny - 1) / 2); q <= ny / 2; ++q)
            for (Index r = 1; r <= ny / 2; ++r) {
              const Index twice = p * p + 4 * q * q;
              count[static_cast<std::size_t>(r - 1)] +=
                  (2 * r - 1) * (2 * r - 1) <= twice && twice < (2 * r + 1) * (2 * r + 1);
            }
        const Field z = random_field(g.shape, 99);
        const auto rings = radial_spectrum(power_spectrum(z, g, hann), g, shared_power(z, hann));
        REQUIRE(rings.size() == count.size());
        for (std::size_t r = 0; r < count.size(); ++r) {
          CAPTURE(ny, spacing, rounded, r);
          CHECK(rings[r].count == count[r]);
        }
      }
}
