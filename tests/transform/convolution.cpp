#include "transform/convolution.hpp"

#include <limits>

#include "reference/ranks.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double kernel(Index i, Index j) {
  return 1.0 / (1.0 + static_cast<double>(i) + 2.0 * static_cast<double>(j * j));
}

Field direct(const Field& in) {
  Field out = Field::Zero(in.rows(), in.cols());
  for (Index i = 0; i < in.rows(); ++i)
    for (Index j = 0; j < in.cols(); ++j)
      for (Index k = 0; k < in.rows(); ++k)
        for (Index l = 0; l < in.cols(); ++l)
          out(i, j) += kernel(std::abs(i - k), std::abs(j - l)) * in(k, l);
  return out;
}

EvenConvolution convolution(Shape field, Shape torus, int threads = 1) {
  return EvenConvolution(field, torus, even_transfer_function(torus, kernel), threads);
}

}  // namespace

// Each output is a sum of n·m products below max|K| max|in| = 1; the transforms add ε log2(P) of Σ|in|.
TEST_CASE("a padded convolution equals the direct sum for every shape", "[convolution][exact]") {
  for (Shape shape :
       {Shape{1, 1}, Shape{1, 7}, Shape{8, 1}, Shape{5, 3}, Shape{16, 16}, Shape{13, 21}, Shape{3, 40}}) {
    const Field in = random_field(shape, 1);
    Field out;
    convolution(shape, padded_torus(shape)).apply(in, out);
    CAPTURE(shape.nx, shape.ny);
    const double bound = epsilon * 8 * (1 + in.abs().sum());
    CHECK((out - direct(in)).abs().maxCoeff() <= bound);
  }
}

// As above with the ε of single precision, which the symbol, the field and each transform are rounded to; in
// units of the largest values, so that none leaves its range of 1e-38 to 1e38.
TEST_CASE("single precision errs by its own round-off at any scale", "[convolution][exact]") {
  constexpr double single = std::numeric_limits<float>::epsilon();
  for (Shape shape : {Shape{1, 7}, Shape{13, 21}, Shape{40, 64}})
    for (double heights : {1e-250, 1.0, 1e150})
      for (double coefficients : {1e-60, 1.0, 1e100}) {
        const Field in = random_field(shape, 1);
        const Shape torus = padded_torus(shape);
        const Field symbol = coefficients * even_transfer_function(torus, kernel);
        const Field wanted = direct(in);
        Field made, converted;
        BasicEvenConvolution<float>(shape, torus, symbol).apply(heights * in, made);
        BasicEvenConvolution<float>(EvenConvolution(shape, torus, symbol)).apply(heights * in, converted);
        CAPTURE(shape.nx, shape.ny, heights, coefficients);
        const double bound = single * 8 * (1 + in.abs().sum());
        CHECK((made / (heights * coefficients) - wanted).abs().maxCoeff() <= bound);
        CHECK((converted / (heights * coefficients) - wanted).abs().maxCoeff() <= bound);
      }
}

TEST_CASE("a field of zeros convolves to zeros in single precision", "[convolution][exact]") {
  const Shape shape{9, 12}, torus = padded_torus(shape);
  Field out = Field::Zero(shape.nx, shape.ny);
  BasicEvenConvolution<float>(shape, torus, even_transfer_function(torus, kernel)).apply(out, out);
  CHECK((out == 0).all());
}

TEST_CASE("a circular convolution commutes with a shift", "[convolution][law]") {
  const Shape shape{12, 20};
  auto circular = convolution(shape, shape);
  auto shift = [&](const Field& f) {
    return Field(Field::NullaryExpr(shape.nx, shape.ny,
                                    [&](Index i, Index j) { return f((i + 5) % 12, (j + 3) % 20); }));
  };
  const Field in = random_field(shape, 2);
  Field out, shifted;
  circular.apply(in, out);
  circular.apply(shift(in), shifted);
  CHECK((shift(out) - shifted).abs().maxCoeff() <= epsilon * 8 * in.abs().sum());
}

TEST_CASE("a convolution does not depend on the number of threads, to the last bit", "[convolution][law]") {
  const Shape shape{150, 130};
  const Field in = random_field(shape, 3);
  Field one, three;
  convolution(shape, padded_torus(shape), 1).apply(in, one);
  convolution(shape, padded_torus(shape), 3).apply(in, three);
  CHECK((one == three).all());
}

TEST_CASE("a fast length has few factors five and none between is skipped", "[transform][exact]") {
  CHECK(fast_length(1) == 1);
  CHECK(fast_length(7) == 8);
  CHECK(fast_length(31) == 32);
  CHECK(fast_length(91) == 100);
  CHECK(fast_length(241) == 256);
  CHECK(fast_length(381, 2) == 400);
  CHECK(fast_length(1281, 2) == 1536);
  CHECK(fast_length(255, 4) == 256);
}

TEST_CASE("several ranks convolve as one does, to the last bit", "[convolution][ranks][law]") {
  for (const Shape shape : {Shape{130, 70}, Shape{256, 34}, Shape{64, 64}})
    for (const bool circular : {false, true})
      for (const int count : {2, 3, 4}) {
        const Shape torus = circular ? shape : padded_torus(shape);
        const Field in = random_field(shape, 4);
        Field wanted, single;
        convolution(shape, torus).apply(in, wanted);
        BasicEvenConvolution<float>(convolution(shape, torus)).apply(in, single);
        CAPTURE(shape.nx, circular, count);
        ThreadRanks(count).run([&](const Ranks& ranks) {
          const Slabs slabs(shape.nx, ranks);
          const Field own = in.middleRows(slabs.own().first, slabs.own().count);
          EvenConvolution whole(shape, torus, even_transfer_function(torus, kernel, 1, ranks), 1, {}, ranks);
          BasicEvenConvolution<float> half(whole);
          Field out, rounded;
          whole.apply(own, out);
          half.apply(own, rounded);
          out = rows_of(out, slabs, Extent{0, shape.nx});
          rounded = rows_of(rounded, slabs, Extent{0, shape.nx});
          if (ranks.rank() > 0) return;
          CHECK((out == wanted).all());
          CHECK((rounded == single).all());
        });
      }
}
