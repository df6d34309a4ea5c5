#include "stats/uncertainty/block_error.hpp"

#include <gsl/gsl_cdf.h>

#include "fields.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The heights above a level, by their excess: a part of a correlated field, whose shares are known.
Field excess_of(const Field& z, double level) { return (z > level).select(z - level, NAN); }

}  // namespace

// Of n independent cells a share f has the error √(f (1 - f)/n). From 64 blocks it is known to 9 %, from 16 to
// 18 %, and the larger of the two is high by √((9² + 18²)/2π) = 8 %, with a spread of 12 %; the square root
// lowers the one of 16 blocks by 1/(4 · 15) = 2 %. The mean of 40 fields: 1.07 ± 3 · 0.02.
TEST_CASE("shares of independent cells have the binomial error", "[block-error][statistics]") {
  const std::vector<double> edges{0.2, 0.5, 1, 1.5};
  std::vector<Spread> ratio(edges.size());
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Field z = excess_of(white_noise({160, 120}, seed), 0.3);
    const ShareErrors errors = share_errors(z, edges);
    const double n = static_cast<double>((!z.isNaN()).count());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const double f = static_cast<double>((z < edges[k]).count()) / n;
      ratio[k].add(errors.below[k] / std::sqrt(f * (1 - f) / n));
    }
    CHECK(errors.within.size() == 5);
    CHECK(errors.within.front() == errors.below.front());
  }
  for (const Spread& r : ratio) CHECK(std::abs(r.mean() - 1.07) <= 0.06);
}

// Of 300 fields the covering share is known to √(0.05 · 0.95/300) = 1.3 %. Blocks of 16 make 95 % of a Gaussian
// 93 % of Student's; correlations of an eighth of the side, two fifths of a block, take another 4 %.
TEST_CASE("95 % intervals of shares of a correlated part of a field cover the true share",
          "[block-error][statistics][slow]") {
  const double level = 0.5, edge = 0.7;
  const double above = gsl_cdf_ugaussian_Q(level), truth = 1 - gsl_cdf_ugaussian_Q(level + edge) / above;
  for (const auto& [window, least] : {std::pair<Index, double>{2, 0.92}, {5, 0.91}, {10, 0.86}}) {
    int covered = 0;
    const int fields = 300;
    for (unsigned seed = 0; seed < fields; ++seed) {
      const Field z = excess_of(moving_average({96, 80}, {window, window}, seed), level);
      const double share =
          static_cast<double>((z < edge).count()) / static_cast<double>((!z.isNaN()).count());
      covered += std::abs(share - truth) <= 1.96 * share_errors(z, {edge}).below[0];
    }
    CAPTURE(window);
    CHECK(covered >= least * fields);
    CHECK(covered <= 0.99 * fields);
  }
}

TEST_CASE("shares of cells in fewer than ten blocks have no error", "[block-error][contract]") {
  Field z = Field::Constant(64, 48, NAN);
  CHECK(std::isnan(share_errors(z, {0.5}).below[0]));
  z.block(10, 10, 3, 3) = 1;
  CHECK(std::isnan(share_errors(z, {0.5}).below[0]));
  z.block(10, 10, 12, 12) = 1;
  CHECK(share_errors(z, {0.5}).below[0] == 0);
  CHECK(std::isnan(share_errors(Field::Ones(1, 64), {0.5}).below[0]));
  CHECK(share_errors(z, {}).within.size() == 1);
}
