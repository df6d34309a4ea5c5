// Single precision where it is enough: between confirmations of the gap.
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

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
