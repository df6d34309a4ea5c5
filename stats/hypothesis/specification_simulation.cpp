// Errors and p-values from surfaces that are drawn as prescribed.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"
#include "stats/hypothesis/simulated_law.hpp"
#include "stats/hypothesis/specification.hpp"

namespace asperity {
namespace {

using Eigen::ArrayXd, Eigen::ArrayXXd;

constexpr Index simulated_a_surface = 4, fewest = 100, enough = 200;
constexpr double enough_points = 5e7;          // beyond `fewest` surfaces
constexpr double most_error_of_share = 0.5;  // of summits; a few tell nothing

ArrayXXd rows_of(const std::vector<ArrayXd>& surfaces) {
  ArrayXXd out(surfaces.size(), surfaces.front().size());
  for (Index m = 0; const ArrayXd& surface : surfaces) out.row(m++) = surface.transpose();
  return out;
}

// Of a mean over `observed`, against one over `simulated`.
double standard_error(const ArrayXd& simulated, const ArrayXd& observed) {
  return sample_deviation(simulated) *
         std::sqrt(1 / static_cast<double>(observed.size()) + 1 / static_cast<double>(simulated.size()));
}

TestResult row(const std::string& name, double prescribed, const ArrayXd& simulated,
               const ArrayXd& observed) {
  TestResult out{.quantity = name, .prescribed = prescribed};
  out.mean = prescribed + observed.mean() - simulated.mean();
  out.standard_error = standard_error(simulated, observed);
  out.z = (out.mean - prescribed) / out.standard_error;
  return out;
}

// Of a positive square, which is tested; its root is reported. `expected` is that of a surface of Sq 1.
TestResult row_of_square(const std::string& name, double prescribed, double expected,
                         const ArrayXd& simulated, const ArrayXd& observed) {
  TestResult out = row(name, 1, simulated / expected, observed / expected);
  out.p = p_of_skewed_mean(simulated, observed);
  out.mean = prescribed * std::sqrt(observed.mean() / simulated.mean());
  out.prescribed = prescribed;
  out.standard_error *= prescribed / 2;
  return out;
}

// Without skewness, in any translation that was tried.
ArrayXd ssk_over_root_of_sku(const ArrayXXd& values) { return values.col(1) / values.col(2).sqrt(); }

// Of those that all surfaces have.
TestResult largest(const std::vector<TestResult>& each, const ArrayXXd& simulated, const ArrayXXd& observed) {
  std::vector<Index> had;
  for (Index i = 0; i < simulated.cols(); ++i)
    if (simulated.col(i).isFinite().all() && observed.col(i).isFinite().all() &&
        sample_deviation(simulated.col(i)) > 0)
      had.push_back(i);
  TestResult out = each.front();
  out.mean = out.prescribed, out.p = 1;
  if (had.empty()) return out;
  const SimulatedTogether together(simulated(Eigen::all, had), observed(Eigen::all, had));
  Index most = 0;
  together.deviations().abs().maxCoeff(&most);
  const Index i = had[static_cast<std::size_t>(most)];
  const TestResult& of = each[static_cast<std::size_t>(i)];
  out = row(of.quantity, of.prescribed, simulated.col(i), observed.col(i));
  out.lag_x = of.lag_x, out.lag_y = of.lag_y;
  out.p = together.p();
  return out;
}

}  // namespace

Field SpecificationTest::Missing::field(Shape shape) const {
  Field out = Field::Zero(shape.nx, shape.ny);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k]) out.data()[k] = NAN;
  return out;
}

void SpecificationTest::count_missing(const Field& z) {
  Missing of{};
  if (z.isNaN().any()) {
    of.points.resize(static_cast<std::size_t>(z.size()));
    for (std::size_t k = 0; k < of.points.size(); ++k) of.points[k] = std::isnan(z.data()[k]);
  }
  const auto same = std::ranges::find(missing_, of.points, &Missing::points);
  if (same == missing_.end())
    missing_.push_back(std::move(of));
  else
    ++same->surfaces;
}

const Eigen::ArrayXXd& SpecificationTest::simulated() const {
  Simulation& s = *simulation_;
  if (s.missing == missing_) return s.values;
  const auto least = static_cast<Index>(
      std::clamp(enough_points / static_cast<double>(grid_.shape.cells()), double(fewest), double(enough)));
  const Index each = std::max(simulated_a_surface, (least + surfaces() - 1) / surfaces()),
              all = each * surfaces();
  s.values.resize(all, observed_.front().size());
  Index done = 0;
  for (const Missing& of : missing_) {
    const Field missing = of.field(grid_.shape);
    const Pairs pairs = Pairs::of(missing, grid_, asked_.threads);
    const std::vector<LagField> stretches = stretch_->weights(pairs);
    for (const Index end = done + each * of.surfaces; done < end;) {
      const Index count = std::min<Index>(std::max(1, asked_.threads), end - done);
      parallel_ranges(count, asked_.threads, [&](Index from, Index to, int) {
        for (Index k = done + from; k < done + to; ++k) {
          const Field z = s.fields.heights(k) + missing;
          s.values.row(k) = measured(z, pairs, stretches, 1).transpose();
        }
      });
      done += count;
      if (asked_.simulated) asked_.simulated(done, all);
    }
  }
  s.missing = missing_;
  return s.values;
}

std::vector<TestResult> SpecificationTest::slopes(const ArrayXXd& drawn, const ArrayXXd& observed) const {
  auto known = [&](Index column) {
    return drawn.col(column).isFinite().all() && observed.col(column).isFinite().all() &&
           sample_deviation(drawn.col(column)) > 0;
  };
  std::vector<TestResult> out;
  if (std::isfinite(asked_.sq) && known(at_sdq))
    out.push_back(row_of_square("Sdq", asked_.sq * std::sqrt(square_), square_, drawn.col(at_sdq),
                                observed.col(at_sdq) / (asked_.sq * asked_.sq)));
  if (summits_ && known(at_summits)) {
    const double half = 0.375 / static_cast<double>(grid_.shape.cells()),
                 area = grid_.cell_area();  // Anscombe's
    const ArrayXd expected = drawn.col(at_summits), shares = observed.col(at_summits);
    const TestResult summits = row("summit_density", expected.mean() / area, expected / area, shares / area);
    if (summits.standard_error < most_error_of_share * summits.prescribed) {
      out.push_back(summits);
      out.back().p = p_of_skewed_mean(expected + half, shares + half);
    }
  }
  return out;
}

std::vector<TestResult> SpecificationTest::results() const {
  if (observed_.empty()) throw DataError("heights", "the ensemble has no surface");
  const ArrayXXd &drawn = simulated(), observed = rows_of(observed_);
  std::vector<TestResult> out;
  if (std::isfinite(asked_.sq))
    out.push_back(row_of_square("Sq", asked_.sq, 1, drawn.col(at_variance),
                                observed.col(at_variance) / (asked_.sq * asked_.sq)));
  out.push_back(row("Ssk", asked_.ssk, drawn.col(at_ssk), observed.col(at_ssk)));
  out.back().p = p_of_mean(ssk_over_root_of_sku(drawn), ssk_over_root_of_sku(observed));
  out.push_back(row("Sku", asked_.sku, drawn.col(at_sku), observed.col(at_sku)));
  out.back().p = p_of_skewed_mean(drawn.col(at_sku), observed.col(at_sku));
  for (const TestResult& of_slopes : slopes(drawn, observed)) out.push_back(of_slopes);
  const Index stretches = drawn.cols() - at_shapes - lags();
  if (!lags_.empty())
    out.push_back(
        largest(lags_, drawn.middleCols(at_shapes, lags()), observed.middleCols(at_shapes, lags())));
  if (stretches > 0)
    out.push_back(largest(lengths_, drawn.rightCols(stretches), observed.rightCols(stretches)));
  return out;
}

}  // namespace asperity
