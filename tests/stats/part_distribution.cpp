#include "stats/height/part_distribution.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/uncertainty/block_error.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Field part(unsigned seed) {
  const Field z = moving_average({96, 80}, {4, 4}, seed);
  return (z > 0.3).select(z - 0.3, NAN);
}

}  // namespace

TEST_CASE("the bins of a part reach from 0 to its largest value and count each cell once",
          "[part-distribution][exact]") {
  const Field z = part(1);
  for (const int asked : {0, 1, 7, 40}) {
    const std::vector<PartBin> bins = part_histogram(z, asked);
    double count = 0;
    for (const PartBin& b : bins) {
      const double end = &b == &bins.back() ? INFINITY : b.upper;
      CHECK(b.count == static_cast<double>((z >= b.lower && z < end).count()));
      CHECK(relative_error(b.width(), bins.front().width()) <= 1e-9);
      count += b.count;
    }
    if (asked > 0) CHECK(bins.size() == static_cast<std::size_t>(asked));
    CHECK(count == static_cast<double>((!z.isNaN()).count()));
    CHECK(bins.front().lower == 0);
    CHECK(bins.back().upper == z.maxCoeff<Eigen::PropagateNumbers>());
  }
}

TEST_CASE("the errors of counts are those of their shares", "[part-distribution][law]") {
  const Field z = part(2);
  const std::vector<PartBin> bins = part_histogram(z, 3);
  const ShareErrors errors = share_errors(z, {bins[0].upper, bins[1].upper});
  const double n = static_cast<double>((!z.isNaN()).count());
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(relative_error(bins[k].count_error, n * errors.within[k]) <= 1e-12);
}

// Woodruff's error is e/density to first order in e; the density of the median's neighbourhood of 20 % differs
// by less than half.
TEST_CASE("quantiles of a part rise, and have the error of their share over the density",
          "[part-distribution][law]") {
  const Field z = part(3);
  const std::vector<PartQuantile> rows = part_quantiles(z, 9);
  REQUIRE(rows.size() == 9);
  for (std::size_t k = 1; k < rows.size(); ++k) CHECK(rows[k].value > rows[k - 1].value);
  CHECK(rows[4].share == 0.5);
  const double density = 0.2 / (rows[5].value - rows[3].value), e = share_errors(z, {rows[4].value}).below[0];
  CHECK(relative_error(rows[4].error, e / density) <= 0.5);
}

TEST_CASE("a part of one value is one bin, and one without a value above 0 is refused",
          "[part-distribution][contract]") {
  Field z = Field::Constant(20, 20, NAN);
  CHECK_THROWS_AS(part_histogram(z), DataError);
  z.block(0, 0, 10, 10) = 0;
  CHECK_THROWS_AS(part_histogram(z), DataError);
  z.block(0, 0, 10, 10) = 3;
  CHECK(part_histogram(z).size() == 1);
  CHECK(part_histogram(z)[0].count == 100);
  CHECK_THROWS_AS(part_histogram(z, 101), ParameterError);
}
