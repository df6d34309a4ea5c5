#include "surface/synthesis.hpp"

#include "grid/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// (1) as it is written, from noise that wraps around when the surface is periodic.
Field by_definition(const Field& kernel, Shape shape, bool periodic) {
  const Shape drawn = periodic ? shape : Shape{shape.nx + kernel.rows() - 1, shape.ny + kernel.cols() - 1};
  Field eta(drawn.nx, drawn.ny);
  WhiteNoise noise(5);
  for (Index i = 0; i < drawn.nx; ++i) noise.row(i, {&eta(i, 0), static_cast<std::size_t>(drawn.ny)});
  Field z = Field::Zero(shape.nx, shape.ny);
  for (Index i = 0; i < shape.nx; ++i)
    for (Index j = 0; j < shape.ny; ++j)
      for (Index k = 0; k < kernel.rows(); ++k)
        for (Index l = 0; l < kernel.cols(); ++l)
          z(i, j) += kernel(k, l) * eta((i + k) % drawn.nx, (j + l) % drawn.ny);
  return z;
}

Field drawn(const Field& kernel, Shape shape, Synthesis::Options options, std::uint64_t seed = 5) {
  return Synthesis(kernel, shape, options).surface(WhiteNoise(seed));
}

// Σ|kernel| max|η| with |η| < 6 bounds each height; the transforms add ε log2 of their length.
double round_off(const Field& kernel) { return 16 * epsilon * 6 * kernel.abs().sum(); }

struct Case {
  Shape kernel, surface;
};
// Tall ones have several strips of 8K rows; in some the kernel is larger than the surface.
const std::vector<Case> cases{{{1, 1}, {6, 5}},  {{3, 5}, {100, 17}}, {{4, 2}, {33, 64}}, {{9, 7}, {5, 3}},
                              {{1, 6}, {40, 1}}, {{5, 1}, {1, 40}},   {{2, 3}, {97, 8}}};

}  // namespace

TEST_CASE("both summations equal the definition for every shape, periodic or not", "[synthesis][exact]") {
  for (const Case& c : cases)
    for (bool periodic : {false, true})
      for (Summation summation : {Summation::direct, Summation::transform}) {
        const Field kernel = random_field(c.kernel, 1);
        const Field exact = by_definition(kernel, c.surface, periodic);
        CAPTURE(c.kernel.nx, c.kernel.ny, c.surface.nx, c.surface.ny, periodic,
                summation == Summation::direct);
        CHECK((drawn(kernel, c.surface, {periodic, summation}) - exact).abs().maxCoeff() <=
              round_off(kernel));
      }
}

TEST_CASE("a surface does not depend on the number of threads, to the last bit", "[synthesis][law]") {
  const Field kernel = random_field({5, 9}, 2);
  for (bool periodic : {false, true})
    for (Summation summation : {Summation::direct, Summation::transform}) {
      const Field one = drawn(kernel, {250, 60}, {periodic, summation, 1});
      CHECK((one == drawn(kernel, {250, 60}, {periodic, summation, 2})).all());
      CHECK((one == drawn(kernel, {250, 60}, {periodic, summation, 7})).all());
    }
}

TEST_CASE("the same seed draws the same surface and another seed another", "[synthesis][contract]") {
  const Field kernel = random_field({5, 9}, 2);
  const Synthesis synthesis(kernel, {50, 60}, {});
  CHECK((synthesis.surface(WhiteNoise(1)) == synthesis.surface(WhiteNoise(1))).all());
  CHECK((synthesis.surface(WhiteNoise(1)) != synthesis.surface(WhiteNoise(2))).all());
  CHECK((synthesis.surface(WhiteNoise(1)) != synthesis.surface(WhiteNoise(1, 1))).all());
}

// Other strips, the same noise: equal to round-off, not to the bit.
TEST_CASE("a smaller surface is the corner of a larger one", "[synthesis][law]") {
  const Field kernel = random_field({6, 5}, 3);
  for (Summation summation : {Summation::direct, Summation::transform}) {
    const Field large = drawn(kernel, {170, 90}, {false, summation}),
                small = drawn(kernel, {33, 21}, {false, summation});
    CHECK((large.topLeftCorner(33, 21) - small).abs().maxCoeff() <= 2 * round_off(kernel));
  }
}

TEST_CASE("a kernel shifted inside zeros shifts the surface", "[synthesis][law]") {
  const Field kernel = random_field({4, 3}, 4);
  Field shifted = Field::Zero(9, 8);
  shifted.block(2, 4, 4, 3) = kernel;
  const Field z = drawn(kernel, {40, 40}, {}), moved = drawn(shifted, {40, 40}, {});
  CHECK((moved.topLeftCorner(38, 36) - z.bottomRightCorner(38, 36)).abs().maxCoeff() <=
        2 * round_off(kernel));
}

// E η = 0 apart, the noise below the middle of a delta kernel is the surface itself.
TEST_CASE("the noise below a surface is what the middle of its kernel multiplies", "[synthesis][exact]") {
  for (bool periodic : {false, true}) {
    Field delta = Field::Zero(7, 5);
    delta(3, 2) = 1;
    const Synthesis synthesis(delta, {30, 4}, {periodic, Summation::direct});
    CHECK((synthesis.surface(WhiteNoise(9)) == synthesis.noise_below(WhiteNoise(9))).all());
  }
}

TEST_CASE("a small kernel is summed directly and a large one transformed", "[synthesis][contract]") {
  CHECK(Synthesis(Field::Ones(3, 3), {128, 128}, {}).summation() == Summation::direct);
  CHECK(Synthesis(Field::Ones(61, 61), {128, 128}, {}).summation() == Summation::transform);
}

TEST_CASE("centring and scaling leave no mean and the rms height asked for", "[synthesis][exact]") {
  Field z = random_field({31, 17}, 6) + 3;
  centre_and_scale(z, 4e-7);
  CHECK(std::abs(z.mean()) <= 4e-7 * 16 * epsilon * 31);
  CHECK(relative_error(std::sqrt(z.square().mean()), 4e-7) <= 16 * epsilon);
  Field flat = Field::Zero(4, 4);
  CHECK_THROWS_AS(centre_and_scale(flat, 1), ParameterError);
}
