/// The largest stress of a sliding Hertz contact against Hamilton's closed form and published figures.
///
///     stress_edge [LARGEST_N]
///
/// Cells' means of the Hertz pressure on n × n cells of a square three contact radii wide, ν = 0.3, n = 64 …
/// LARGEST_N (512), a_over_h cells to the radius. First table: √J2/p0 of the closed form, below the surface for
/// μ = 0 and 0.25 and at the trailing edge for 0.4 and 0.5, beside Smith & Liu's; `found` is that of the
/// search on the largest grid. Second table: errors of the largest von Mises stress, as shares of it, `found` by the
/// search, `coarse` on cells twice as wide (means of four of the same pressure) and `extrapolated` from both at order
/// ½; `stated` is what the library says may be missing (stress/maximum_error.hpp). Third table: the largest tension (1-2ν)/3
/// + πμ(4+ν)/8, on the same grids.
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "reference/hertz_stress.hpp"
#include "stress/equivalent.hpp"
#include "stress/maximum_error.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double nu = 0.3;

Grid square(Index n) { return {{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)}; }

LoadedBody contact(Index n, double mu) { return {square(n), hertz_pressure(square(n)), nu, {mu, 0}}; }

// The same load on cells twice as long and wide.
LoadedBody coarsened(const LoadedBody& fine) {
  const Index n = fine.grid.shape.nx / 2;
  LoadedBody out{square(n), Field(n, n), fine.poisson, fine.friction};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) out.pressure(i, j) = fine.pressure.block(2 * i, 2 * j, 2, 2).mean();
  return out;
}

StressMaximum found(const LoadedBody& body, Criterion of) {
  return maximum_stress(StressSolver(body, 1, DepthResolution::adapted), {of, 0});
}

// Where the surface's pressure and traction end, and the largest of all below it.
struct Figure {
  double mu, x, z, published;  ///< place of the maximum of the closed form, √J2/p0
};
constexpr Figure figures[] = {
    {0, 0, 0.480864, 0.3580}, {0.25, 0.2703, 0.4440, 0.3739}, {0.4, -1, 0, 0.4646}, {0.5, -1, 0, 0.5523}};

double exact(const Figure& f) { return von_mises(hertz_stress(f.x, 0, f.z, nu, Friction{f.mu, 0})); }

double tension(double mu) { return (1 - 2 * nu) / 3 + std::numbers::pi * mu * (4 + nu) / 8; }

void published(Index n) {
  fmt::print("# mu\tpublished\tclosed_form\tfound\tfound_error\n");
  for (const Figure& f : figures) {
    const double here = found(contact(n, f.mu), Criterion::von_mises).value;
    fmt::print("{}\t{:.4f}\t{:.5f}\t{:.5f}\t{:.1e}\n", f.mu, f.published, exact(f) / std::numbers::sqrt3,
               here / std::numbers::sqrt3, here / exact(f) - 1);
  }
}

void edge(Index largest) {
  fmt::print("# mu\tn\ta_over_h\tfound\tcoarse\textrapolated\tstated\tseconds\tseconds_spread\n");
  for (double mu : {0.4, 0.5})
    for (Index n = 64; n <= largest; n *= 2) {
      const LoadedBody body = contact(n, mu);
      const StressMaximum top = found(body, Criterion::von_mises);
      const Seconds seconds = seconds_of([&] { found(body, Criterion::von_mises); });
      const double fine = top.value, coarse = found(coarsened(body), Criterion::von_mises).value,
                   root = fine + (fine - coarse) / (std::numbers::sqrt2 - 1),
                   value = exact(figures[mu == 0.4 ? 2 : 3]);
      fmt::print("{}\t{}\t{:.0f}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.2f}\n", mu, n,
                 static_cast<double>(n) / 3, fine / value - 1, coarse / value - 1, root / value - 1,
                 edge_error(top, Criterion::von_mises, body, false) / value, seconds);
    }
}

void tensions(Index largest) {
  fmt::print("# mu\tn\tfound\tstated\n");
  for (double mu : {0.0, 0.1, 0.3, 0.5})
    for (Index n = 64; n <= largest; n *= 2) {
      const LoadedBody body = contact(n, mu);
      const StressMaximum top = found(body, Criterion::principal);
      fmt::print("{}\t{}\t{:.1e}\t{:.1e}\n", mu, n, top.value / tension(mu) - 1,
                 edge_error(top, Criterion::principal, body, false) / tension(mu));
    }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 512;
  published(largest);
  edge(largest);
  tensions(largest);
}
