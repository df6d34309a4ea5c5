#include "contact/two_level.hpp"

#include <Eigen/Cholesky>

#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr BlockEnd exactly{1e-15, 200};
constexpr Index b = TwoLevel::side;

// Of a share of the cells, at random.
std::vector<std::int8_t> random_mask(Shape shape, double share, unsigned seed) {
  const Field draw = random_field(shape, seed);
  std::vector<std::int8_t> mask;
  for (double x : draw.reshaped<Eigen::RowMajor>()) mask.push_back((x + 1) / 2 < share);
  return mask;
}

Field masked(const Field& f, const std::vector<std::int8_t>& mask) {
  Field out = f;
  for (Index i = 0; i < f.size(); ++i) out.data()[i] *= mask[size(i)];
  return out;
}

// B, column by column, on the cells of F.
Eigen::MatrixXd matrix(TwoLevel& two_level, Shape shape, const std::vector<std::int8_t>& mask) {
  std::vector<Index> cells;
  for (Index i = 0; i < shape.cells(); ++i)
    if (mask[size(i)] != 0) cells.push_back(i);
  Eigen::MatrixXd B(std::ssize(cells), std::ssize(cells));
  for (Index k = 0; k < B.cols(); ++k) {
    Field r = Field::Zero(shape.nx, shape.ny), z;
    r.data()[cells[size(k)]] = 1;
    two_level.apply(r, z);
    for (Index i = 0; i < B.rows(); ++i) B(i, k) = z.data()[cells[size(i)]];
  }
  return B;
}

}  // namespace

// Conjugate gradients on 12 or 15 blocks leave 1e-15 and their condition: 1e-12 of the largest entry.
TEST_CASE("the two-level preconditioner is symmetric and positive definite on the free set",
          "[two-level][law]") {
  for (Periodic around : {Periodic(), Periodic(true, false), Periodic(true)})
    for (Shape shape : {Shape{24, 32}, Shape{21, 35}})  // whole blocks, and some that the grid cuts
      for (double share : {0.02, 0.3, 0.7}) {
        const auto body = make_influence({shape, 1e-5, 2e-5, around}, modulus);
        const auto mask = random_mask(shape, share, 3);
        TwoLevel two_level(*body, 1, exactly);
        two_level.set(mask);
        const Eigen::MatrixXd B = matrix(two_level, shape, mask);
        CAPTURE(shape.nx, share, around.x, around.y);
        CHECK((B - B.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * B.cwiseAbs().maxCoeff());
        CHECK(Eigen::LLT<Eigen::MatrixXd>((B + B.transpose()) / 2).info() == Eigen::Success);
      }
}

TEST_CASE("off the free set it gives nothing, whatever the body's preconditioner puts there",
          "[two-level][exact]") {
  const Shape shape{40, 43};
  const auto body = make_influence({shape, 1e-5, 1e-5}, modulus);
  const auto mask = random_mask(shape, 0.4, 5);
  TwoLevel two_level(*body);
  two_level.set(mask);
  Field z;
  two_level.apply(masked(random_field(shape, 6), mask), z);
  CHECK((masked(z, mask) == z).all());
}

// D = 0 on blocks that F fills, and Π r = 0.
TEST_CASE("on filled blocks it inverts the coarse body", "[two-level][exact]") {
  const Grid grid{{48, 64}, 1e-5, 1e-5};
  const auto body = make_influence(grid, modulus), coarse = body->coarsened(b);
  Field pressures = random_field({6, 8}, 8), displacements;
  std::vector<std::int8_t> mask(size(grid.shape.cells()));
  auto on_cells = [&](const Field& blocks) {
    return Field(Field::NullaryExpr(48, 64, [&](Index i, Index j) { return blocks(i / b, j / b); }));
  };
  const Field on = on_cells((random_field({6, 8}, 9) > -0.3).cast<double>());
  std::copy(on.data(), on.data() + on.size(), mask.begin());
  pressures *= (random_field({6, 8}, 9) > -0.3).cast<double>();
  coarse->apply(pressures, displacements);
  TwoLevel two_level(*body, 1, exactly);
  two_level.set(mask);
  Field z;
  two_level.apply(masked(on_cells(displacements), mask), z);
  CHECK((z - on_cells(pressures)).abs().maxCoeff() <= 1e-11);
}

// The eigenvalues of B K on F, of fields of no sum: a sparse set sees long waves by B as by K.
TEST_CASE("its condition on a sparse set hardly grows with the grid, that of the body's own does",
          "[two-level][law]") {
  auto condition = [](Index n, bool two_levels) {
    const Shape shape{n, n};
    const auto body =
        make_influence({shape, 1e-3 / static_cast<double>(n), 1e-3 / static_cast<double>(n)}, modulus);
    const auto mask = random_mask(shape, 0.25, 4);
    TwoLevel two_level(*body, 1, exactly);
    two_level.set(mask);
    Field v = masked(random_field(shape, 1), mask), z;
    // Power iterations for the largest eigenvalue of B K, then of its distance from it.
    auto apply = [&](const Field& p) {
      Field u;
      body->apply(p, u);
      u = masked(u, mask);
      two_levels ? two_level.apply(u, z) : body->precondition(u, z);
      return masked(z, mask);
    };
    auto power = [&](double shift) {
      Field x = v;
      double value = 0;
      for (int k = 0; k < 300; ++k) {
        const Field y = apply(x) - shift * x;
        value = (x * y).sum() / (x * x).sum();
        x = y / std::sqrt(y.square().sum());
      }
      return value;
    };
    const double largest = power(0);
    return largest / (largest + power(largest));
  };
  const double coarse = condition(32, true), fine = condition(128, true), coarse_M = condition(32, false),
               fine_M = condition(128, false);
  CAPTURE(coarse, fine, coarse_M, fine_M);
  CHECK(fine <= 1.5 * coarse);
  CHECK(fine_M >= 2 * coarse_M);
}

// A disc meets 4ρ blocks beside those of its area, ρ its radius in blocks, and barely touches some of the 8ρ
// that it cuts: together the number falls short by a sixth at ρ = 12, and by more for smaller discs.
TEST_CASE("a disc has a raggedness of one, N of them the root of N", "[two-level][law]") {
  auto raggedness = [](Index n, Index discs) {
    const double side = static_cast<double>(n) / static_cast<double>(discs);
    auto from_middle = [side](Index k) { return std::fmod(static_cast<double>(k) + 0.5, side) - side / 2; };
    std::vector<std::int8_t> mask;
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) mask.push_back(std::hypot(from_middle(i), from_middle(j)) < 0.4 * side);
    const auto body = make_influence(square(n), modulus);
    TwoLevel two_level(*body);
    two_level.set(mask);
    return two_level.raggedness();
  };
  for (Index n : {256, 512, 1024}) {
    const double one = raggedness(n, 1), four = raggedness(n, 2);
    CAPTURE(n, one, four);
    CHECK(one >= 0.8);
    CHECK(one <= 1);
    CHECK(four >= 1.5 * one);
    CHECK(four <= 2 * one);
  }
}
