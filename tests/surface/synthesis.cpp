#include "surface/synthesis.hpp"

#include "core/error.hpp"
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

// Draws with less and less memory until that is refused; returns the lowest band met.
Index lowest_band(const Field& kernel, Shape shape, Synthesis::Options options,
                  const std::function<void(const Synthesis&)>& draw) {
  Index lowest = shape.nx;
  options.memory = Synthesis(kernel, shape, options).working_set();
  try {
    for (;; options.memory = options.memory * 3 / 4) {
      const Synthesis synthesis(kernel, shape, options);
      CHECK(synthesis.working_set() <= options.memory);
      lowest = std::min(lowest, synthesis.band_rows());
      draw(synthesis);
    }
  } catch (const ParameterError& e) {
    CHECK(e.name == "memory");
  }
  return lowest;
}

struct Case {
  Shape kernel, surface;
};
// Tall ones have several strips of 8K rows; in some the kernel is larger than the surface.
const std::vector<Case> cases{{{1, 1}, {6, 5}},  {{3, 5}, {100, 17}}, {{4, 2}, {33, 64}}, {{9, 7}, {5, 3}},
                              {{1, 6}, {40, 1}}, {{5, 1}, {1, 40}},   {{2, 3}, {97, 8}}};

Field noise_below(const Synthesis& synthesis, const WhiteNoise& noise) {
  Field out(synthesis.shape().nx, synthesis.shape().ny);
  synthesis.noise_below(
      noise, [&](Index first, const Eigen::Ref<Field>& rows) { out.middleRows(first, rows.rows()) = rows; });
  return out;
}

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

// E η = 0 apart, the noise below the middle of a delta kernel is the surface itself; of an even number of
// coefficients the middle is the former of two.
TEST_CASE("the noise below a surface is what the middle of its kernel multiplies", "[synthesis][exact]") {
  for (bool periodic : {false, true})
    for (const Shape shape : {Shape{7, 5}, Shape{6, 4}}) {
      Field delta = Field::Zero(shape.nx, shape.ny);
      delta((shape.nx - 1) / 2, (shape.ny - 1) / 2) = 1;
      const Synthesis synthesis(delta, {30, 4}, {periodic, Summation::direct});
      CHECK((synthesis.surface(WhiteNoise(9)) == noise_below(synthesis, WhiteNoise(9))).all());
    }
}

TEST_CASE("a small kernel is summed directly and a large one transformed", "[synthesis][contract]") {
  CHECK(Synthesis(Field::Ones(3, 3), {128, 128}, {}).summation() == Summation::direct);
  CHECK(Synthesis(Field::Ones(61, 61), {128, 128}, {}).summation() == Summation::transform);
}

// Kernels of 5 rows have tiles of at most 508 rows: 3000 are several, and as many bands as the memory leaves.
TEST_CASE("a surface depends neither on the memory nor on the threads that draw it, to the last bit",
          "[synthesis][law]") {
  const Field kernel = random_field({5, 9}, 2);
  const Shape shape{3000, 60};
  for (bool periodic : {false, true})
    for (Summation summation : {Summation::direct, Summation::transform}) {
      const Synthesis whole(kernel, shape, {periodic, summation, 1});
      const Field exact = whole.surface(WhiteNoise(5)), below = noise_below(whole, WhiteNoise(5));
      CHECK(whole.band_rows() >= shape.nx);
      const Index least = lowest_band(kernel, shape, {periodic, summation, 3}, [&](const Synthesis& bounded) {
        CHECK((bounded.surface(WhiteNoise(5)) == exact).all());
        CHECK((noise_below(bounded, WhiteNoise(5)) == below).all());
      });
      CHECK(least <= 508);
    }
}

TEST_CASE("a sink gets every row once and in order", "[synthesis][contract]") {
  const Field kernel = random_field({7, 3}, 8);
  const Shape shape{2500, 40};
  lowest_band(kernel, shape, {}, [&](const Synthesis& synthesis) {
    Index next = 0;
    Field rows(shape.nx, shape.ny);
    synthesis.surface(WhiteNoise(3), [&](Index first, Eigen::Ref<Field> band) {
      REQUIRE(first == next);
      REQUIRE(band.rows() <= synthesis.band_rows());
      rows.middleRows(first, band.rows()) = band;
      band.setZero();  // is the sink's to alter
      next += band.rows();
    });
    CHECK(next == shape.nx);
    CHECK((rows == synthesis.surface(WhiteNoise(3))).all());
  });
}

TEST_CASE("a sink that fails ends the drawing with its own exception", "[synthesis][contract]") {
  const Synthesis synthesis(Field::Ones(3, 3), {4000, 100}, {false, Summation::direct, 2, 1 << 20});
  REQUIRE(synthesis.band_rows() < 4000);
  int calls = 0;
  auto full_disk = [&](Index, Eigen::Ref<Field>) {
    throw std::runtime_error("full" + std::to_string(++calls));
  };
  CHECK_THROWS_WITH(synthesis.surface(WhiteNoise(1), full_disk), "full1");
}

// A torus has 512² points at the most, so that a band of 4096 columns is one tile high: 512 · 4156 doubles of
// noise and 452 · 4096 heights; the symbol and what two threads need are five such tori. Together 42.4 MB.
TEST_CASE("the working set stays below 43 MB for a surface of any length", "[synthesis][contract]") {
  for (Summation summation : {Summation::direct, Summation::transform})
    for (int power : {12, 16, 20}) {
      const Synthesis synthesis(Field::Ones(61, 61), {1 << power, 4096}, {false, summation, 2});
      CHECK(synthesis.working_set() <= 43'000'000);
    }
}

TEST_CASE("less memory than one strip takes is refused, and the least is named", "[synthesis][contract]") {
  const Field kernel = Field::Ones(61, 61);
  CHECK_THROWS_MATCHES(Synthesis(kernel, {4096, 4096}, {false, Summation::transform, 2, 1'500'000}),
                       ParameterError, Message("1500kB does not hold one strip of this surface: 22MB do"));
  CHECK_NOTHROW(Synthesis(kernel, {4096, 4096}, {false, Summation::transform, 2, 22'000'000}));
}

TEST_CASE("a kernel without coefficients is refused", "[synthesis][contract]") {
  CHECK_THROWS_MATCHES(Synthesis(Field(), {8, 8}, {}), ParameterError, Message("it has no coefficients"));
}
