#include "contact/subspace_cg.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

// A surface that shows new asperities on every finer grid takes hardly more convolutions on it. Counts are those
// of ε = 1e-8, measured 18.6 and 19.8 at 256², 17.2 and 16.8 at 512²; bare conjugate gradients on each set,
// clipped, take 21.1 and 25.3, 34.0 and 49.7.
TEST_CASE("spheres of exponential roughness take no more than 21 convolutions at 256², and as many at 512²",
          "[contact][law]") {
  for (Index n : {256, 512})
    for (double cap : {infinity, limit}) {
      const Grid grid = square(n);
      const Field rough = 0.4e-6 * exponential_heights(grid.shape, static_cast<double>(n) / 20, 3);
      const Contact contact = press(grid, undeformed_gap(grid, spheres) - rough, {.limit_pressure = cap});
      CAPTURE(n, cap, contact.convolutions, contact.preconditionings);
      CHECK(contact.residual <= 1e-8);
      CHECK(contact.convolutions <= 21);
      CHECK(contact.preconditionings < contact.convolutions);
    }
}

// 2^18 cells are the fewest that threads share.
TEST_CASE("a ragged contact does not depend on the number of threads", "[contact][law][slow]") {
  const Grid grid = periodic({{576, 512}, 1e-6, 1e-6});
  const Field gap = -1e-6 * exponential_heights(grid.shape, 30, 4);
  const double q = 2e8 * grid.size_x() * grid.size_y();
  const Contact one = press(grid, gap, {.load = q, .threads = 1}),
                three = press(grid, gap, {.load = q, .threads = 3});
  CHECK((one.pressure == three.pressure).all());
  CHECK(one.convolutions == three.convolutions);
}

TEST_CASE("a ragged contact sunk by the approach of its load has that load", "[contact][law][slow]") {
  const Grid grid = square(256);
  const Field gap = undeformed_gap(grid, spheres) - 0.4e-6 * exponential_heights(grid.shape, 13, 5);
  for (double cap : {infinity, limit}) {
    const Contact loaded = press(grid, gap, {.limit_pressure = cap});
    const Contact sunk = solve_contact(
        grid, gap, modulus, {.approach = loaded.approach, .limit_pressure = cap, .tolerance = 1e-8});
    CHECK(sunk.converged);
    CHECK(relative_error(sunk.load, loaded.load) <= 1e-6);
    CHECK((sunk.pressure - loaded.pressure).abs().maxCoeff() <= 1e-5 * loaded.max_pressure);
  }
}

namespace {

// A half-space whose apply_single errs at will: by so much of the largest displacement, up or down from cell
// to cell; 0: K itself.
class Careless final : public ElasticOperator {
 public:
  Careless(std::unique_ptr<ElasticOperator> body, double error) : body_(std::move(body)), error_(error) {}

  Shape shape() const override { return body_->shape(); }
  void apply(const Field& p, Field& u) override { body_->apply(p, u); }
  void apply_single(const Field& p, Field& u) override {
    body_->apply(p, u);
    if (error_ > 0) u += error_ * u.abs().maxCoeff() * random_field(shape(), ++calls_);
  }
  void precondition(const Field& r, Field& z) override { body_->precondition(r, z); }
  double self_influence() const override { return body_->self_influence(); }
  std::unique_ptr<ElasticOperator> coarsened(Index factor) const override { return body_->coarsened(factor); }

 private:
  std::unique_ptr<ElasticOperator> body_;
  double error_;
  unsigned calls_ = 0;
};

Contact pressed(const Grid& grid, const Field& gap, double tolerance, double error) {
  Careless body(make_influence(grid, modulus), error);
  return solve_contact(grid, gap, body, {.load = load, .tolerance = tolerance});
}

struct Scene {
  Grid grid;
  Field gap;
};

Scene rough(Index n) {
  const Grid grid = square(n);
  return {grid, undeformed_gap(grid, spheres) - 0.4e-6 * exponential_heights(grid.shape, 6, 1)};
}

double difference(const Contact& a, const Contact& b) {
  return (a.pressure - b.pressure).abs().maxCoeff() / b.max_pressure;
}

}  // namespace

// ε bounds |p - p*| by some tens of ε p_max on these grids.
TEST_CASE("a contact whose steps err is the contact without errors, or says that it is not converged",
          "[contact][law]") {
  const Scene scene = rough(96);
  const Contact exact = pressed(scene.grid, scene.gap, 1e-11, 0);
  REQUIRE(exact.converged);
  for (double error : {1e-7, 1e-5, 1e-3}) {
    const Contact contact = pressed(scene.grid, scene.gap, 1e-8, error);
    CAPTURE(error, contact.convolutions, contact.residual, contact.reason);
    CHECK(contact.converged == (contact.residual <= 1e-8));
    if (contact.converged) CHECK(difference(contact, exact) <= 1e-6);
    if (error <= 1e-5) CHECK(contact.converged);
  }
}

TEST_CASE("single precision takes no more steps to a residual of 1e-8", "[contact][law]") {
  const Scene scene = rough(384);
  const Contact twice = pressed(scene.grid, scene.gap, 1e-8, 0);
  const Contact single = solve_contact(scene.grid, scene.gap, modulus, {.load = load, .tolerance = 1e-8});
  CAPTURE(single.convolutions, twice.convolutions);
  CHECK(single.converged);
  CHECK(single.convolutions <= 1.1 * twice.convolutions);
  CHECK(difference(single, twice) <= 1e-6);
}

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
