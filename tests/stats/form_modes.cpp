// What a removed form takes, and estimates of it.
#include "stats/uncertainty/form_modes.hpp"

#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/height/height_error.hpp"
#include "stats/measure.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/effective_size.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The projection onto the form, a column a point: what it takes of a field that is 1 there and 0 elsewhere;
// 0 where points are missing.
Eigen::MatrixXd projection(const Field& points, int degree) {
  const Index n = points.size(), ny = points.cols();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (Index k = 0; k < n; ++k) {
    Field z = 0 * points;
    if (std::isnan(z(k / ny, k % ny))) continue;
    z(k / ny, k % ny) = 1;
    out.col(k) = zero_filled(z - remove_form(z, degree)).reshaped<Eigen::RowMajor>().matrix();
  }
  return out;
}

// tr(P ρ).
double trace_of(const Eigen::MatrixXd& projection, const LagField& rho, Index ny) {
  double trace = 0;
  for (Index k = 0; k < projection.rows(); ++k)
    for (Index l = 0; l < projection.cols(); ++l)
      trace += projection(k, l) * rho(k / ny - l / ny, k % ny - l % ny);
  return trace;
}

// 1 on a disc less a corner, NaN elsewhere.
Field disc(Index n) {
  return Field::NullaryExpr(n, n, [=](Index i, Index j) {
    const double middle = 0.5 * static_cast<double>(n - 1), x = static_cast<double>(i) - middle,
                 y = static_cast<double>(j) - middle;
    return std::hypot(x, y) < 0.5 * static_cast<double>(n) && (x < 0 || y < 0.2 * middle) ? 1 : NAN;
  });
}

// The correlation of two points that are p, q apart, the shorter way round.
double folded_correlation(const LagField& rho, const Grid& g, Index p, Index q) {
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
        const Eigen::MatrixXd taken = projection(Field::Ones(shape.nx, shape.ny), degree);
        double trace = 0;
        for (Index k = 0; k < taken.rows(); ++k)
          for (Index l = 0; l < taken.cols(); ++l)
            trace += taken(k, l) *
                     folded_correlation(rho, g, k / shape.ny - l / shape.ny, k % shape.ny - l % shape.ny);
        CAPTURE(periodic, shape.nx, degree);
        const double n = static_cast<double>(shape.cells());
        const double expected = std::min(trace / n, 0.5);
        CHECK(relative_error(EffectiveSampleSize(rho, g, {g, degree}).taken_by_form(), expected) <=
              63 * 63 * epsilon);
      }
}

// tr(P ρ)/N again, over the points that are there. Modes of the square are off by 3 and 7 %.
TEST_CASE("a form over an outline takes the trace of its projection, and B is that of its modes",
          "[form-modes][exact]") {
  constexpr Index n = 15;
  const Field points = disc(n);
  const Grid g = grid(n, n);
  const Pairs pairs = Pairs::of(points, g);
  const LagField rho = triangular_correlation({4, 3});
  for (const int degree : {1, 2, 4}) {
    const FormModes form(points, pairs, degree);
    const Eigen::MatrixXd P = projection(points, degree);
    CAPTURE(degree);
    CHECK(relative_error(P.trace(), form.count()) <= 1e-10);
    const double expected = std::min(trace_of(P, rho, n) / pairs.points(), 0.5);
    CHECK(relative_error(EffectiveSampleSize(rho, pairs, form).taken_by_form(), expected) <= 1e-10);
    // Σ of P(k, l) over the pairs k, l at a lag, over their number and M/N.
    const LagField B = form.correlation({5, 5});
    for (const auto [p, q] : {Shape{0, 0}, {3, -2}, {0, 5}, {5, 5}}) {
      double sum = 0, count = 0;
      for (Index k = 0; k < P.rows(); ++k) {
        const Index i = k / n + p, j = k % n + q;
        if (i < 0 || i >= n || j < 0 || j >= n || std::isnan(points(k / n, k % n) * points(i, j))) continue;
        sum += P(k, i * n + j), ++count;
      }
      CHECK(std::abs(B(p, q) - sum / count * pairs.points() / form.count()) <= 1e-10);
    }
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
