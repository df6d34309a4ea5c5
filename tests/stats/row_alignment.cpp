// Scan lines put level with each other, and what that takes of the surface itself.
#include "stats/filter/row_alignment.hpp"

#include "acf/band_limited.hpp"
#include "core/error.hpp"
#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/uncertainty/aligned_share.hpp"
#include "surface/synthesis.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Method = RowAlignment::Method;

const RowAlignment every_method[] = {
    {Method::median}, {Method::polynomial, 0}, {Method::polynomial, 3}, {Method::median_difference}};

// o(j), the same along each line along x.
Field with_offsets(const Field& z, const Eigen::ArrayXd& offsets) {
  return z.rowwise() + offsets.transpose().matrix().array();
}

Eigen::ArrayXd random_numbers(Index n, double size, unsigned seed) {
  return size * white_noise({n, 1}, seed).col(0);
}

Field without(Field z, Index i, Index j, Index lines_to) {
  z(i, j) = NAN;
  z.col(3).setConstant(NAN);
  z.col(lines_to).head(z.rows() / 2).setConstant(NAN);
  return z;
}

// From the middle of the field, where missing points are zero.
double furthest_apart(const Field& a, const Field& b) {
  CHECK((a.isNaN() == b.isNaN()).all());
  return (a - b).isNaN().select(0, a - b).abs().maxCoeff();
}

bool same_points(const Field& a, const Field& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a == b || (a.isNaN() && b.isNaN())).all();
}

Field centred(const Field& z) { return remove_form(z); }

}  // namespace

// Offsets of 100 and sums of 30 of them: ε times 3000, and more operations with it than 64 in none.
TEST_CASE("what lines are aligned to does not depend on their offsets, along x and along y, with holes",
          "[filter][law]") {
  const Field z = moving_average({40, 30}, {5, 4}, 1);
  for (const RowAlignment& how : every_method)
    for (const Field& field : {z, without(z, 7, 8, 20)}) {
      CAPTURE(static_cast<int>(how.method), how.degree);
      const Field aligned = aligned_rows(field, grid(40, 30), how).heights,
                  moved = aligned_rows(with_offsets(field, random_numbers(30, 100, 2)), grid(40, 30), how)
                              .heights;
      CHECK(furthest_apart(centred(aligned), centred(moved)) <= 64 * epsilon * 3000);
      RowAlignment along_y = how;
      along_y.along = Axis1D::y;
      const Field turned = aligned_rows(field.transpose(), grid(30, 40), along_y).heights.transpose();
      CHECK(furthest_apart(turned, aligned) == 0);
      CHECK(furthest_apart(aligned_rows(aligned, grid(40, 30), how).heights, aligned) <= 64 * epsilon * 10);
    }
}

TEST_CASE("aligned lines have the median 0, the mean 0, no polynomial, and differences of the median 0",
          "[filter][exact]") {
  const Grid on = grid(3, 3);
  const Field z{{1, 10, 0}, {2, 40, 5}, {9, 20, 1}};  // lines along x are columns
  CHECK(same_points(aligned_rows(z, on, {Method::median}).heights,
                    Field{{-1, -10, -1}, {0, 20, 4}, {7, 0, 0}}));
  const Field means{{-3, -40.0 / 3, -2}, {-2, 50.0 / 3, 3}, {5, -10.0 / 3, -1}};
  CHECK((aligned_rows(z, on, {Method::polynomial}).heights - means).abs().maxCoeff() <= 8 * epsilon * 40);
  // Differences 9, 38, 11 and -10, -35, -19: 11 and -19.
  CHECK(same_points(aligned_rows(z, on, {Method::median_difference}).heights,
                    Field{{1, -1, 8}, {2, 29, 13}, {9, 9, 9}}));
  const Field curved = Field::NullaryExpr(12, 5, [](Index i, Index j) {
    const double x = static_cast<double>(i) / 12;
    return static_cast<double>(j * j) + static_cast<double>(j - 2) * x + static_cast<double>(3 - j) * x * x;
  });
  CHECK(aligned_rows(curved, grid(12, 5), {Method::polynomial, 2}).heights.abs().maxCoeff() <=
        64 * epsilon * 16);
}

// Of an even number the middle two count, and lines that are missing are stepped over.
TEST_CASE(
    "a line of an even number of points has the mean of its middle two as median, and holes do not count",
    "[filter][exact]") {
  const double none = NAN;
  const Field z{{1, none, 7}, {2, none, 9}, {4, none, none}, {8, none, 8}};
  const Field expected{{-2, none, -1}, {-1, none, 1}, {1, none, none}, {5, none, 0}};
  CHECK(same_points(aligned_rows(z, grid(4, 3), {Method::median}).heights, expected));
  // 6, 7, 0 at the common places.
  const Field stepped{{1, none, 1}, {2, none, 3}, {4, none, none}, {8, none, 2}};
  CHECK(same_points(aligned_rows(z, grid(4, 3), {Method::median_difference}).heights, stepped));
}

// The surface's own difference at a jump is at most 5 s; s is not above the deviation of all differences by
// more than 5 standard errors, 5·1.17/√255 of it. Lines that do not jump keep their heights relative to each other.
TEST_CASE(
    "jumps alone are taken, with drift and surface left, and where none is nothing changes to the last bit",
    "[filter][law]") {
  const Index n = 256;
  const Grid on = grid(n, n);
  const Field z = moving_average({n, n}, {12, 12}, 3);
  const Eigen::ArrayXd drift = Eigen::ArrayXd::LinSpaced(n, 0, 2000);
  for (const Field& surface : {z, with_offsets(z, drift), with_offsets(z, random_numbers(n, 3, 4))}) {
    const AlignedRows same_lines = aligned_rows(surface, on, {Method::jumps});
    CHECK(same_lines.jumps == 0);
    CHECK(same_points(same_lines.heights, surface));
    CHECK(taken_by_alignment(same_lines, on, {Method::jumps}).share == 0);
  }
  Eigen::ArrayXd offsets = Eigen::ArrayXd::Zero(n);
  for (const auto& [line, height] : {std::pair{40, 8.0}, {100, -12.0}, {200, 9.0}})
    offsets.tail(n - line) += height;
  offsets(150) += 20;  // a line alone: there and back
  const AlignedRows found = aligned_rows(with_offsets(z, offsets), on, {Method::jumps});
  CHECK(found.jumps == 5);
  CHECK(std::abs(found.largest - 20) <= 1);
  const Field left = found.heights - z;
  const double rms = std::sqrt(centred(left).square().mean());
  // Five numbers of standard deviation `taken` over a factor: their mean square within 1 ± 3 √(2/5) of it.
  CHECK(rms <= found.taken * std::sqrt(1 + 3 * std::sqrt(0.4)));
  CHECK(std::abs(left(5, 60) - left(99, 80)) <= 64 * epsilon * 20);
  CHECK(taken_by_alignment(found, on, {Method::jumps}).rms == found.taken);
}

// Lines up and down by 1: c = 0, s = 1.4826. Of 65 lines 32 lie behind the first jump, 15 behind the second.
TEST_CASE("what jumps take is the deviation of the steps, by the share of the lines behind each",
          "[filter][exact]") {
  const Field z = Field::NullaryExpr(4, 65, [](Index, Index j) {
    return static_cast<double>(j % 2 + (j >= 33 ? 100 : 0) - (j >= 50 ? 100 : 0));
  });
  const AlignedRows found = aligned_rows(z, grid(4, 65), {Method::jumps});
  const double first = 32.0 / 65, second = 15.0 / 65;
  CHECK(found.jumps == 2);
  CHECK(found.largest == 101);
  CHECK(std::abs(found.taken - 1.4826 * std::sqrt(first * (1 - first) + second * (1 - second))) <=
        4 * epsilon);
}

// d is 0 or a step of the heights, and more than half are 0: s was 0, and every step a jump.
TEST_CASE("heights in steps do not jump by single steps", "[filter][exact]") {
  Field z = moving_average({64, 64}, {20, 20}, 5);
  const double step = 0.5;
  z = (z / step).round() * step;
  const AlignedRows aligned = aligned_rows(z, grid(64, 64), {.method = Method::jumps, .step = step});
  CHECK(aligned.jumps == 0);
}

// ---- what is taken ----

namespace {

// Without what all lines have in common, the tilt and bow that a polynomial of each takes too.
Field lines_alone(Field taken) {
  const Eigen::ArrayXd common = taken.rowwise().mean();
  return taken.colwise() - common;
}

struct Taking {
  Spread real = {}, estimated = {}, share = {};

  // Of a surface with tilt and bow along x: what goes where there are no offsets, and what is estimated where
  // there are. The median of a tilted line is that of the few points around its middle, and takes more.
  void add(const Field& surface, const RowAlignment& how, unsigned seed) {
    const Grid on = grid(surface.rows(), surface.cols());
    const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(surface.rows(), -1, 1);
    Field z = surface;
    z.colwise() += 20 * x + 10 * x.square();
    real.add(std::sqrt(centred(lines_alone(z - aligned_rows(z, on, how).heights)).square().mean()));
    const Field scanned = with_offsets(z, random_numbers(z.cols(), 2, 1000 + seed));
    const TakenByAlignment taken = taken_by_alignment(aligned_rows(scanned, on, how), on, how);
    estimated.add(taken.rms), share.add(taken.share);
  }
};

Field part_of(const Field& z, Index n) { return z.topLeftCorner(n, n); }

Field affine_part(Index n, unsigned seed) {
  EllipticTarget target;
  target.model = Model::self_affine, target.hurst = 0.8, target.length_x = target.length_y = 10;
  const Shape shape{2 * n, 2 * n};
  const Synthesis synthesis(BandLimited(target, {.cutoff = 4}, shape).kernel(), shape, {.periodic = true});
  return part_of(synthesis.surface(WhiteNoise(seed)), n);
}

}  // namespace

// The table of the method: with ρ̄ = √π ℓ/L of exp(-r²/ℓ²), and 1/L of white noise. The rms of 256 line means of
// lines ℓ√(π/2) apart has a relative standard error of √(ℓ √(π/2)/(2·256)), and the mean of 6 fields √6 less;
// (1) is larger than the sum by the triangle, ℓ/(√π L) of it at most, and by ρ̄ of the mean over the map.
TEST_CASE("the mean of lines takes √ρ̄ of Sq, and the aligned map tells how much", "[filter][statistics]") {
  const Index n = 256;
  const double L = 256, fields = 6;
  for (const double length : {0.0, 5.0, 20.0}) {
    Taking taking;
    for (unsigned seed = 1; seed <= fields; ++seed)
      taking.add(length > 0 ? part_of(gaussian_acf_field({2 * n, 2 * n}, length, seed), n)
                            : white_noise({n, n}, seed),
                 {Method::polynomial}, seed);
    const double rho = length > 0 ? std::sqrt(std::numbers::pi) * length / L : 1 / L,
                 predicted = std::sqrt(rho),
                 error = std::sqrt(std::max(1.0, 1.25 * length) / (2 * L * fields));
    CAPTURE(length, predicted, taking.real.mean(), taking.estimated.mean(), taking.share.mean());
    CHECK(std::abs(taking.real.mean() / predicted - 1) <= 3 * error + rho);
    CHECK(std::abs(taking.estimated.mean() / taking.real.mean() - 1) <= 3 * error + rho);
    CHECK(std::abs(taking.share.mean() / taking.estimated.mean() - 1) <= 3 * error + rho);
  }
}

TEST_CASE("what each method takes of a Gaussian and of a self-affine surface is estimated to a fifth of it",
          "[filter][statistics]") {
  const Index n = 192;
  for (const RowAlignment& how : every_method)
    for (const bool affine : {false, true}) {
      Taking taking;
      for (unsigned seed = 1; seed <= 4; ++seed)
        taking.add(affine ? affine_part(n, seed) : part_of(gaussian_acf_field({2 * n, 2 * n}, 6, seed), n),
                   how, seed);
      CAPTURE(static_cast<int>(how.method), how.degree, affine, taking.real.mean(), taking.estimated.mean());
      CHECK(std::abs(taking.estimated.mean() / taking.real.mean() - 1) <= 0.2);
    }
}

// The second alignment of a map told that it took 0.2 of Sq once more.
TEST_CASE("no more is said to be taken of the surface than went, and nothing of one that is aligned",
          "[filter][contract]") {
  const Field z = moving_average({128, 128}, {10, 10}, 7);
  const Grid on = grid(128, 128);
  for (const RowAlignment& how : every_method) {
    CAPTURE(static_cast<int>(how.method), how.degree);
    const AlignedRows once = aligned_rows(z, on, how), twice = aligned_rows(once.heights, on, how);
    CHECK(taken_by_alignment(once, on, how).rms <= once.removed);
    CHECK(taken_by_alignment(twice, on, how).share <= 64 * epsilon * 10);
    CHECK(taken_by_alignment(twice, on, how).all);
  }
  const auto taken = [](const Field& map) {
    const Grid of = grid(map.rows(), map.cols());
    return taken_by_alignment(aligned_rows(map, of, {}), of, {});
  };
  CHECK(taken(Field::Constant(8, 6, 3)).share == 0);
  // Short lines told nothing, and the map was not marked; lines of one height are of a grating, perhaps.
  const TakenByAlignment brief = taken(white_noise({2, 30}, 8)),
                         grating = taken(sine({30, 40}, 1, 4).transpose());
  CHECK((brief.all && brief.share > 0.5));
  CHECK((grating.all && grating.share == 1));
}

// √(k+1) of the mean's, where the correlation is short to the line's waves.
TEST_CASE("a polynomial of degree k takes √(k+1) times what the mean takes", "[filter][statistics]") {
  Taking mean, cubic;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Field z = moving_average({256, 256}, {5, 5}, seed);
    mean.add(z, {Method::polynomial}, seed);
    cubic.add(z, {Method::polynomial, 3}, seed);
  }
  // 1536 lines a fifth of which are independent, of the four modes each.
  const double error = 1 / std::sqrt(2 * 1536 / 5.0);
  CHECK(std::abs(cubic.real.mean() / mean.real.mean() / 2 - 1) <= 4 * error);
  CHECK(std::abs(cubic.estimated.mean() / mean.estimated.mean() / 2 - 1) <= 4 * error);
}

TEST_CASE("lines that cannot be aligned are refused with why", "[filter][contract]") {
  const auto refusal = [](const Field& z, const Grid& on, const RowAlignment& how) {
    try {
      aligned_rows(z, on, how);
    } catch (const ParameterError& error) {
      return error.name + ": " + error.what();
    }
    return std::string("taken");
  };
  const Field z = white_noise({6, 4}, 1);
  Grid periodic = grid(6, 4);
  periodic.periodic.y = true;
  CHECK_THAT(refusal(z, periodic, {}), ContainsSubstring("align-rows: the map is periodic along y"));
  CHECK_THAT(refusal(z.leftCols(1), grid(6, 1), {}), ContainsSubstring("there is one line along x"));
  CHECK_THAT(refusal(z, grid(6, 4), {Method::polynomial, 5}), ContainsSubstring("7 points are needed"));
  Field holes = z;
  holes.topRows(3).leftCols(2).setConstant(NAN), holes.bottomRows(3).rightCols(2).setConstant(NAN);
  CHECK_THAT(refusal(holes, grid(6, 4), {Method::jumps}),
             ContainsSubstring("line 2 along x has no place in common with line 1"));
  CHECK_THAT(refusal(holes, grid(6, 4), {Method::polynomial, 3}),
             ContainsSubstring("line 0 along x: '3' is too"));
  holes.rightCols(3).setConstant(NAN);
  CHECK_THAT(refusal(holes, grid(6, 4), {}), ContainsSubstring("1 of the lines has points: two are needed"));
}
