#include "surface/running_moments.hpp"

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The rows of a strip stand where they do not stand in the whole: an exact rms in little memory differed in
// the last bit once.
RunningMoments moments_of(const Field& heights, Index rows_at_a_time) {
  RunningMoments out;
  for (Index i = 0; i < heights.rows(); i += rows_at_a_time)
    out.add(Field(heights.middleRows(i, std::min(rows_at_a_time, heights.rows() - i))));
  return out;
}

}  // namespace

TEST_CASE("running moments are the same to the last bit however many rows come at a time", "[moments][law]") {
  for (Index columns : {23, 126, 129}) {
    const Field z = random_field({37, columns}, 1);
    const RunningMoments whole = moments_of(z, 37);
    for (Index rows : {1, 5, 36}) {
      CHECK(moments_of(z, rows).mean() == whole.mean());
      CHECK(moments_of(z, rows).rms() == whole.rms());
    }
    CHECK(whole.low() == z.minCoeff());
    CHECK(whole.high() == z.maxCoeff());
  }
}

// Heights c ± 1 in equal number have the mean c and the rms 1. Each of n = 1000 is rounded to ε c / 2, which
// moves the rms by as much; a mean of squares less the square of the mean would err by ε c² = 2e-4.
TEST_CASE("the rms of running moments does not suffer from a large mean", "[moments][exact]") {
  const double c = 1e6;
  const Field z = Field::NullaryExpr(20, 50, [&](Index i, Index j) { return c + ((i + j) % 2 ? 1 : -1); });
  CHECK(relative_error(moments_of(z, 3).mean(), c) <= 4 * epsilon);
  CHECK(relative_error(moments_of(z, 3).rms(), 1) <= 4 * epsilon * c);
}

// Means of n numbers err by some ε √n of their size at the most.
TEST_CASE("rescaling to an exact rms leaves no mean and the rms height asked for", "[moments][exact]") {
  Field z = random_field({31, 17}, 6) + 3;
  RunningMoments moments = moments_of(z, 31);
  const Rescaling map = exact_rms(moments, 4e-7);
  map.apply(z);
  moments.rescale(map);
  const RunningMoments after = moments_of(z, 31);
  CHECK(std::abs(after.mean()) <= 4e-7 * 16 * epsilon * 31);
  CHECK(relative_error(after.rms(), 4e-7) <= 64 * epsilon);
  CHECK(relative_error(moments.rms(), 4e-7) <= 4 * epsilon);
  CHECK(moments.low() == after.low());
  CHECK(moments.high() == after.high());
}

TEST_CASE("heights that are all equal cannot be given an rms", "[moments][contract]") {
  CHECK_THROWS_AS(exact_rms(moments_of(Field::Constant(4, 4, 0.1), 2), 1), ParameterError);
  // Their squares vanish; the factor was infinite, the heights NaN.
  Field small = Field::Zero(4, 4);
  small(1, 1) = 1e-300;
  CHECK_THROWS_AS(exact_rms(moments_of(small, 2), 1), ParameterError);
}
