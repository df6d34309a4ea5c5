#include "transform/rows.hpp"

#include <numbers>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr Index width = RowTransform::width;

// Of row r, from blocks of `count` rows.
Complex mode(const AlignedVector<Complex>& blocks, Index count, Index r, Index k) {
  return blocks[static_cast<std::size_t>(((k / width) * count + r) * width + k % width)];
}

}  // namespace

// ε log2 n of Σ|x| of the larger of two rows, of at most n numbers below 4.
TEST_CASE("rows transformed in pairs have each its own spectrum, and the way back undoes it n times",
          "[transform][exact]") {
  for (Index n : {1, 2, 3, 8, 15, 16, 30, 34})
    for (Index count : {1, 2, 3, 7, 8})
      for (Index given : {Index{1}, (n + 1) / 2, n}) {
        const RowTransform transform(n);
        const Field x = random_field({count, given}, 6);
        RowTransform::Work work = transform.work();
        AlignedVector<Complex> blocks(static_cast<std::size_t>(transform.blocks() * count * width), 99.0);
        transform.forward(x.data(), given, given, count, blocks.data(), count * width, work);
        const double bound = 16 * epsilon * static_cast<double>(n);
        double error = 0, beyond = 0;
        for (Index r = 0; r < count; ++r) {
          for (Index k = 0; k <= n / 2; ++k) {
            Complex sum{};
            for (Index j = 0; j < given; ++j)
              sum += x(r, j) * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j * k % n) /
                                                   static_cast<double>(n));
            error = std::max(error, std::abs(mode(blocks, count, r, k) - sum));
          }
          for (Index k = n / 2 + 1; k < transform.blocks() * width; ++k)
            beyond = std::max(beyond, std::abs(mode(blocks, count, r, k)));
        }
        Field back = Field::Constant(count, n + 1, 99.0);
        transform.inverse(blocks.data(), count * width, count, n, back.data(), n + 1, work);
        const double scale = static_cast<double>(n);
        const double undone = (back.leftCols(given) / scale - x).abs().maxCoeff();
        CAPTURE(n, count, given);
        CHECK(error <= bound);
        CHECK(beyond == 0);
        CHECK(undone <= bound);
        CHECK((back.col(n) == 99.0).all());
        if (given < n) CHECK((back.middleCols(given, n - given) / scale).abs().maxCoeff() <= bound);
      }
}

TEST_CASE("the imaginary parts of the modes that are their own negatives are not read",
          "[transform][contract]") {
  const Index n = 8;
  const RowTransform transform(n);
  RowTransform::Work work = transform.work();
  AlignedVector<Complex> blocks(2 * width);
  const Field re = random_field({2, n / 2 + 1}, 7);
  for (Index r = 0; r < 2; ++r)
    for (Index k = 0; k <= n / 2; ++k) blocks[static_cast<std::size_t>(r * width + k)] = {re(r, k), 0};
  Field plain(2, n), other(2, n);
  transform.inverse(blocks.data(), 2 * width, 2, n, plain.data(), n, work);
  for (std::size_t k : {std::size_t{0}, std::size_t{4}, std::size_t{8}, std::size_t{12}})
    blocks[k] += Complex{0, 5};
  transform.inverse(blocks.data(), 2 * width, 2, n, other.data(), n, work);
  CHECK((plain == other).all());
}
