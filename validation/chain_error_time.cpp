/// Error of the whole chain against its cost: a surface drawn, pressed, and the largest stress below it
/// found.
///
///     chain_error_time [LARGEST_N]         512 unless given
///
/// Two steel spheres under 5000 N on 3 mm × 3 mm (contact_scenes.hpp), elastic, on N × N cells, N = 64 …
/// LARGEST_N, each to ε = 1e-3, 1e-5 and 1e-8, one thread. `hertz` are smooth, and the reference is the
/// closed form. `rough` have a roughness of 0.4 µm rms and Gaussian autocorrelation of the 10 % length 0.2
/// mm: drawn once, periodic, on 128 × 128 points, it is a trigonometric polynomial, and this one surface is
/// evaluated at the centres of the cells of every grid. Its reference is the grid of 4 LARGEST_N; the error
/// of the finest grid is thus understated by 1/16 of it.
///
/// p_max, area, von_mises  relative errors of the greatest pressure, the real area, the largest von Mises
/// stress
/// setup                   seconds of the kernel and of the contact's influence coefficients, made once
/// seconds                 of a surface of N × N drawn, the contact, and the search for the largest stress, of which
/// draw, contact, stress   are the parts
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "acf/kernel.hpp"
#include "contact/bodies.hpp"
#include "contact/influence.hpp"
#include "contact/solver.hpp"
#include "contact_scenes.hpp"
#include "stress/maximum.hpp"
#include "surface/synthesis.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

constexpr double side = 3e-3, rms = 0.4e-6, length = 0.2e-3;
constexpr Index drawn_points = 128;

Grid square(Index n) { return {{n, n}, side / static_cast<double>(n), side / static_cast<double>(n)}; }

// Of the roughness sampled n times a side.
Field kernel_values(Index n) {
  EllipticTarget target;
  target.model = Model::gaussian;
  target.length_x = target.length_y = length;
  target.spacing_x = target.spacing_y = square(n).dx;
  KernelRequest request;
  request.target = target.target();
  request.method = Method::spectral;
  request.rms = rms;
  request.acf_tolerance = 1e-6;
  return solve_kernel(request).values;
}

// The trigonometric polynomial through z, a periodic field, at the centres of n × n cells.
Field interpolated(const Field& z, Index n) {
  const Index m = z.rows(), common = std::min(m, n);
  const RealTransform2D from({m, m}), to({n, n});
  AlignedVector<Complex> wide(static_cast<std::size_t>(from.spectrum_size())),
      out(static_cast<std::size_t>(to.spectrum_size()));
  from.forward(z.data(), wide.data());
  // Centres lie half a cell from the domain's edge, whatever the cell.
  const double shift = std::numbers::pi * (1 / static_cast<double>(n) - 1 / static_cast<double>(m));
  for (Index p = 1 - common / 2; p < common / 2; ++p)
    for (Index q = 0; q < common / 2; ++q)
      out[static_cast<std::size_t>((p + n) % n * to.spectrum_columns() + q)] =
          std::polar(1 / static_cast<double>(m * m), shift * static_cast<double>(p + q)) *
          wide[static_cast<std::size_t>((p + m) % m * from.spectrum_columns() + q)];
  Field fine(n, n);
  to.inverse(out.data(), fine.data());
  return fine;
}

Field roughness(Index n) {
  static const Field drawn =
      Synthesis(kernel_values(drawn_points), {drawn_points, drawn_points}, {.periodic = true})
          .surface(WhiteNoise(5));
  return interpolated(drawn, n);
}

struct Outcome {
  double p_max = 0, area = 0, von_mises = 0;
};

// What is made once, and what is done for each surface.
class Chain {
 public:
  Chain(Index n, bool rough)
      : grid_(square(n)),
        influence_(make_influence(grid_, scene_bodies.composite_modulus())),
        surfaces_(rough ? std::make_unique<Synthesis>(kernel_values(n), grid_.shape, Synthesis::Options{})
                        : nullptr),
        gap_(undeformed_gap(grid_, scene_bodies)) {
    if (rough) gap_ -= roughness(n);
  }

  void draw() const {
    if (surfaces_) surfaces_->surface(WhiteNoise(1));
  }
  Contact press(double tolerance) const {
    return solve_contact(grid_, gap_, *influence_, {.load = scene_load, .tolerance = tolerance});
  }
  StressMaximum stress(const Field& pressure) const {
    return maximum_stress(
        StressSolver({grid_, pressure, scene_bodies.poisson[0]}, 1, DepthResolution::adapted));
  }

 private:
  Grid grid_;
  std::unique_ptr<ElasticOperator> influence_;
  std::unique_ptr<Synthesis> surfaces_;
  Field gap_;
};

Outcome outcome(const Chain& chain, double tolerance) {
  const Contact c = chain.press(tolerance);
  return {c.max_pressure, c.area, chain.stress(c.pressure).value};
}

Outcome hertz_outcome() {
  const Hertz exact = hertz(scene_bodies, scene_load);
  return {exact.pressure, std::numbers::pi * exact.radius * exact.radius, 0.620041004 * exact.pressure};
}

void print_rows(const char* name, bool rough, Index n, const Outcome& exact) {
  const Chain chain(n, rough);
  const Seconds setup = seconds_of([&] {
    make_influence(square(n), scene_bodies.composite_modulus());
    if (rough) kernel_values(n);
  });
  const Seconds draw = rough ? seconds_of([&] { chain.draw(); }) : Seconds{};
  for (double tolerance : {1e-3, 1e-5, 1e-8}) {
    const Outcome o = outcome(chain, tolerance);
    const Seconds press = seconds_of([&] { chain.press(tolerance); });
    const Field pressure = chain.press(tolerance).pressure;
    const Seconds stress = seconds_of([&] { chain.stress(pressure); });
    fmt::print("{}\t{}\t{:.0e}\t{:.1e}\t{:.1e}\t{:.1e}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2e}\n", name, n,
               tolerance, o.p_max / exact.p_max - 1, o.area / exact.area - 1,
               o.von_mises / exact.von_mises - 1, setup, draw + press + stress, draw, press, stress);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 512;
  fmt::print(
      "# case\tN\ttol\tp_max\tarea\tvon_mises\tsetup\tsetup_spread\tseconds\tseconds_spread\t"
      "draw\tdraw_spread\tcontact\tcontact_spread\tstress\tstress_spread\n");
  for (Index n = 64; n <= largest; n *= 2) print_rows("hertz", false, n, hertz_outcome());
  const Outcome fine = outcome(Chain(4 * largest, true), 1e-8);
  for (Index n = 64; n <= largest; n *= 2) print_rows("rough", true, n, fine);
  return 0;
}
