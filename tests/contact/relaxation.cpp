#include "contact/relaxation.hpp"

#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr Index block = Relaxation::block, strip = Relaxation::strip;

// (1) and (2) of contact/relaxation.hpp as they are written, with h + K p - δ = g.
struct Model {
  Field near, g;
  double held;

  Model(ElasticOperator& body, Field gap) : near(body.near_influence(3)), g(std::move(gap)) {
    const double edge = std::max(near(3, 0), near(0, 3));
    near = (near - edge).max(0.0);
    held = 4 * edge;
  }

  double force(const Field& d, Index i, Index j) const {
    double sum = g(i, j);
    for (Index k = 0; k < d.rows(); ++k)
      for (Index l = 0; l < d.cols(); ++l) {
        if (std::abs(k - i) <= 3 && std::abs(l - j) <= 3)
          sum += near(std::abs(k - i), std::abs(l - j)) * d(k, l);
        if (k / block == i / block && l / block == j / block) sum += held * d(k, l);
      }
    return sum;
  }

  double energy(const Field& d) const {
    double sum = 0;
    for (Index i = 0; i < d.rows(); ++i)
      for (Index j = 0; j < d.cols(); ++j) sum += (g(i, j) + force(d, i, j)) / 2 * d(i, j);
    return sum;
  }

  // (3) of one cell.
  void relax(const Field& p, Field& d, double cap, Index i, Index j) const {
    const double all = p(i, j) + d(i, j);
    d(i, j) = std::clamp(all - force(d, i, j) / (near(0, 0) + held), 0.0, cap) - p(i, j);
  }
};

// In the documented order.
Field relaxed(const Model& model, const Field& p, double cap, int sweeps) {
  Field d = Field::Zero(p.rows(), p.cols());
  for (int kind = 0; kind < sweeps; ++kind)
    for (Index first = kind % 2 * strip; first < p.rows(); first += 2 * strip) {
      const Index last = std::min(first + strip, p.rows());
      for (Index i = first; i < last; ++i)
        for (Index c = 0; c < block; ++c)
          for (Index j = c; j < p.cols(); j += block) model.relax(p, d, cap, i, j);
      for (Index i = last - 1; i >= first; --i)
        for (Index c = block - 1; c >= 0; --c)
          for (Index j = c; j < p.cols(); j += block) model.relax(p, d, cap, i, j);
    }
  return p + d;
}

}  // namespace

// Rows and columns that no strip and no block divides; round-off of sums of 49 and 64 terms.
TEST_CASE("relaxation is a projected Gauss-Seidel iteration in its documented order", "[relaxation][exact]") {
  for (Shape shape : {Shape{70, 21}, Shape{17, 40}, Shape{9, 8}})
    for (double aspect : {1.0, 0.2}) {
      const auto body = make_influence({shape, 1e-5, aspect * 1e-5}, modulus);
      const Field p = 1e9 * (random_field(shape, 1) - 0.2), gap = 1e-7 * random_field(shape, 2);
      const Model model(*body, gap - 2e-8);
      for (int sweeps : {2, 4}) {
        Field q = p, g = gap;
        Relaxation(*body).relax(q, g, 2e-8, 0.5e9, sweeps);
        CAPTURE(shape.nx, aspect, sweeps);
        CHECK((q - relaxed(model, p, 0.5e9, sweeps)).abs().maxCoeff() <= 1e-12 * 1e9);
      }
    }
}

TEST_CASE("relaxation keeps the bounds, lowers the energy of its model, and more with more sweeps",
          "[relaxation][law]") {
  const Shape shape{72, 40};
  for (double cap : {0.6e9, infinity}) {
    const auto body = make_influence({shape, 1e-5, 1e-5}, modulus);
    const Field p = (1e9 * random_field(shape, 3)).max(0.0).min(cap), gap = 1e-7 * random_field(shape, 4);
    const Model model(*body, gap);
    double before = 0;
    for (int sweeps : {2, 4, 8}) {
      Field q = p, g = gap;
      Relaxation(*body).relax(q, g, 0, cap, sweeps);
      CHECK(q.minCoeff() >= 0);
      CHECK(q.maxCoeff() <= cap);
      const double energy = model.energy(q - p);
      CHECK(energy < before);
      before = energy;
    }
  }
}

TEST_CASE("relaxation does not depend on the number of threads", "[relaxation][law]") {
  const Shape shape{600, 520};
  const auto body = make_influence({shape, 1e-5, 1e-5}, modulus);
  const Field p = 1e9 * random_field(shape, 1), gap = 1e-7 * random_field(shape, 2);
  Field one = p, two = p, g1 = gap, g2 = gap;
  Relaxation(*body, 1).relax(one, g1, 0, infinity, 4);
  Relaxation(*body, 3).relax(two, g2, 0, infinity, 4);
  CHECK((one == two).all());
}

// A body that tells nothing of its neighbours is asked by a unit pressure.
TEST_CASE("the influence of near cells is that of a unit pressure", "[relaxation][exact]") {
  const auto body = make_influence({{32, 24}, 1e-5, 3e-5}, modulus);
  const Field told = body->near_influence(3), asked = body->ElasticOperator::near_influence(3);
  CHECK((told - asked).abs().maxCoeff() <= 1e-14 * told.maxCoeff());
}
