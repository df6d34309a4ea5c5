#include "contact/subspace_cg.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Cells at 0, free ones and cells at c = 1; gaps of ±1 about δ = 0.5, those at a bound times `drive`.
struct Cells {
  std::unique_ptr<ElasticOperator> body = make_influence({{30, 40}, 1e-6, 1e-6}, modulus);
  ContactProblem problem;
  Field p, g;

  explicit Cells(double drive)
      : p((1.5 * random_field({30, 40}, 1)).max(0.0).min(1.0)), g(random_field({30, 40}, 2)) {
    problem.influence = body.get();
    problem.h = Field::Zero(30, 40);
    problem.cap = 1;
    g = 0.5 + (p > 0 && p < 1).select(g, drive * g);
  }
  FreeSet all() const { return {problem, p, g, 0.5}; }
  FreeSet proportioned() const {
    FreeSet out = all();
    out.proportion(problem, p, g, 0.5);
    return out;
  }
  bool is_free(Index i) const { return problem.is_free(p.data()[i]); }
  double residual(Index i) const { return std::abs(g.data()[i] - 0.5); }
};

}  // namespace

TEST_CASE("proportion keeps the free cells, and of the others those driven by 0.3 of the largest residual",
          "[contact][exact]") {
  const Cells cells(0.8);
  const FreeSet all = cells.all(), some = cells.proportioned();
  double largest = 0, count = 0, sum = 0;
  for (Index i = 0; i < cells.p.size(); ++i)
    if (cells.is_free(i)) largest = std::max(largest, cells.residual(i));
  for (Index i = 0; i < cells.p.size(); ++i) {
    const bool kept = all.mask[size(i)] != 0 && (cells.is_free(i) || cells.residual(i) > 0.3 * largest);
    CHECK((some.mask[size(i)] != 0) == kept);
    count += kept;
    sum += kept ? cells.g.data()[i] : 0;
  }
  CHECK(some.cells == count);
  CHECK(some.cells < all.cells);
  CHECK(some.gap_sum == Approx(sum).epsilon(1e-13));
}

TEST_CASE("proportion keeps the free cells alone while the others are hardly driven", "[contact][exact]") {
  const Cells cells(0.005);
  const FreeSet some = cells.proportioned();
  for (Index i = 0; i < cells.p.size(); ++i) CHECK((some.mask[size(i)] != 0) == cells.is_free(i));
}
