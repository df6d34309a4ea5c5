// What a form has taken of a part of a field, or of what an L-filter left; holes that are filled.
#include "stats/filter/preparation.hpp"

#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/fill.hpp"

using namespace asperity;
using namespace asperity::test;

// A form of degree d has taken d(d+3)/2 waves: 27, 14, 9, 5, 2 for 6, 4, 3, 2, 1; of a row d.
TEST_CASE("a part of a field has lost its share of the waves of a form", "[form][exact]") {
  const Grid grid{{64, 64}, 1e-6, 1e-6}, row{{64, 1}, 1e-6, 1e-6};
  for (const int degree : {0, 1, 2, 6, 20}) {
    CHECK(degree_on_part(degree, grid, 1) == degree);
    CHECK(degree_on_part(degree, row, 1) == degree);
  }
  CHECK(degree_on_part(6, grid, 0.25) == 2);  // 6.75 waves, below 7
  CHECK(degree_on_part(6, grid, 0.5) == 4);   // 13.5
  CHECK(degree_on_part(2, grid, 0.25) == 1);  // 1.25, above 1
  CHECK(degree_on_part(1, grid, 0.25) == 0);  // 0.5
  CHECK(degree_on_part(6, row, 0.5) == 3);
}

// A cut-off of a tenth of the side passes a share below (1 - 2^-0.16)² = 0.011 of each of the 14 waves of degree
// 4; one of ten sides, above (1 - 2^-25)² of all.
TEST_CASE("an L-filter takes the waves of a form below its cut-off itself", "[form][exact]") {
  const Grid grid{{64, 64}, 1e-6, 1e-6};
  for (const int degree : {0, 1, 4}) {
    CHECK(degree_behind(degree, grid, {6.4e-6}) == 0);
    CHECK(degree_behind(degree, grid, {640e-6}) == degree);
  }
  for (int degree = 1; degree < 20; ++degree)
    CHECK(degree_behind(degree, grid, {40e-6}) <= degree_behind(degree + 1, grid, {40e-6}));
}

// It was spanned over a hole at the edge as if the other side were not there.
TEST_CASE("a membrane spans a seam as any other place", "[fill][law]") {
  const Grid grid{{18, 12}, 1e-6, 2e-6, {true, true}};
  Field z = random_field(grid.shape, 3);
  z.block(7, 4, 5, 3).setConstant(none);
  const Field inside = filled(z, grid, Filling::laplace);
  const auto turned = [](const Field& f, Index a, Index b) {
    return Field::NullaryExpr(
               f.rows(), f.cols(),
               [&f, a, b](Index i, Index j) { return f((i + a) % f.rows(), (j + b) % f.cols()); })
        .eval();
  };
  const Field across = filled(turned(z, 9, 5), grid, Filling::laplace);
  CHECK((across - turned(inside, 9, 5)).abs().maxCoeff() <= 1e3 * epsilon);
  // Along a free axis there is no height beyond the edge.
  const Grid free{grid.shape, grid.dx, grid.dy};
  CHECK((filled(turned(z, 9, 5), free, Filling::laplace) - across).abs().maxCoeff() > 0.1);
}
