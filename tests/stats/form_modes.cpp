// What a removed form takes, and estimates of it.
#include "stats/uncertainty/form_modes.hpp"

#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/height/height_error.hpp"
#include "stats/measure.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/effective_size.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The projection onto the form, a column a point: what it takes of a field that is 1 there and 0 elsewhere.
Eigen::MatrixXd projection(const Grid& g, int degree) {
  const Index n = g.shape.cells();
  Eigen::MatrixXd out(n, n);
  for (Index k = 0; k < n; ++k) {
    Field z = Field::Zero(g.shape.nx, g.shape.ny);
    z(k / g.shape.ny, k % g.shape.ny) = 1;
    out.col(k) = (z - remove_form(z, degree)).reshaped<Eigen::RowMajor>().matrix();
  }
  return out;
}

// The correlation of two points that are p, q apart, the shorter way round.
double between(const LagField& rho, const Grid& g, Index p, Index q) {
  auto way = [](Index lag, Index n, bool periodic) {
    return periodic && 2 * std::abs(lag) > n ? lag - (lag > 0 ? n : -n) : lag;
  };
  return rho(way(p, g.shape.nx, g.periodic.x), way(q, g.shape.ny, g.periodic.y));
}

}  // namespace

// tr(P ρ)/N over 63 × 63 pairs of points; an axis of 3 points has three polynomials.
TEST_CASE("a form takes the trace of its projection of the correlation", "[form-modes][exact]") {
  const LagField rho = triangular_correlation({4, 3});
  for (const bool periodic : {false, true})
    for (const Shape shape : {Shape{9, 7}, Shape{21, 3}})
      for (const int degree : {0, 1, 2, 4}) {
        const Grid g = grid(shape.nx, shape.ny, periodic);
        if (periodic && shape.ny < 6) continue;  // shorter than the correlation
        const Eigen::MatrixXd taken = projection(g, degree);
        double trace = 0;
        for (Index k = 0; k < taken.rows(); ++k)
          for (Index l = 0; l < taken.cols(); ++l)
            trace += taken(k, l) * between(rho, g, k / shape.ny - l / shape.ny, k % shape.ny - l % shape.ny);
        CAPTURE(periodic, shape.nx, degree);
        const double n = static_cast<double>(shape.cells());
        const double expected = std::min(trace / n, 0.5);
        CHECK(relative_error(EffectiveSampleSize(rho, g, {g, degree}).taken_by_form(), expected) <=
              63 * 63 * epsilon);
      }
}

// M of N degrees of freedom.
TEST_CASE("of white noise a form takes as many points as it has modes, and B is 1 at lag zero",
          "[form-modes][exact]") {
  const Grid g = grid(24, 17);
  for (const int degree : {0, 1, 3, 20}) {
    const FormModes form(g, degree);
    double modes = 0;
    for (Index a = 0; a <= degree; ++a)
      for (Index b = 0; a + b <= degree; ++b) modes += a < 24 && b < 17;
    CHECK(form.count() == modes);
    CHECK(relative_error(form.correlation({3, 3})(0, 0), 1) <= 1e-12);
    const EffectiveSampleSize size(triangular_correlation({1, 1}), g, form);
    CHECK(relative_error(size.taken_by_form(), std::min(0.5, modes / (24 * 17))) <= 1e-12);
  }
}

// Sq² of a field has the error √(2 S_2/N) = 4.8 %, with S_2 = 8.7 and N = 7680; its mean over 100 fields 0.5 %.
// The forms take 1.5 and 3.8 %.
TEST_CASE("with what the form took put back, Sq is that of the surface without it",
          "[form-modes][statistics]") {
  const Grid g = grid(96, 80);
  for (const int degree : {2, 4}) {
    Spread by_correlation, by_modes;
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Surface surface =
          prepared({.grid = g, .heights = moving_average(g.shape, {5, 4}, seed)}, {.degree = degree});
      const Sample sample(surface, false);
      const double square = std::pow(sample.moments().sq, 2);
      by_correlation.add(square / (1 - sample.size().taken_by_form()));
      by_modes.add(square / (1 - sample.height_errors()->taken()));
    }
    CAPTURE(degree);
    CHECK(std::abs(by_correlation.mean() - 1) <= 0.015);
    CHECK(std::abs(by_modes.mean() - 1) <= 0.015);
  }
}

// The mean of 5 × 4 neighbours has the variance 20/7680 less the edges; nine modes know it to 1/√18 a field.
TEST_CASE("above a form the error of the mean is that of the mean of the surface",
          "[form-modes][statistics]") {
  const Grid g = grid(96, 80);
  const double known = EffectiveSampleSize(triangular_correlation({5, 4}), g).mean_power(1);
  Spread stated;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Surface surface =
        prepared({.grid = g, .heights = moving_average(g.shape, {5, 4}, seed)}, {.degree = 2});
    stated.add(std::pow(Sample(surface, false).height_errors()->of_mean(), 2));
  }
  // Four errors of the mean over the fields, and 3 % that 1/(1 - L)² may be off at N_eff = 880.
  CHECK(relative_error(stated.mean(), known) <= 4 * std::sqrt(2.0 / 900) + 0.03);
}
