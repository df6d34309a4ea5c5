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

constexpr Index least_simulated = 200, simulated_a_surface = 4;

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

Eigen::ArrayXd SpecificationTest::shaped(Eigen::ArrayXd measured) const {
  measured.tail(measured.size() - at_shapes) /= measured(at_variance);
  return measured;
}

const Eigen::ArrayXXd& SpecificationTest::simulated() const {
  Simulation& s = *simulation_;
  if (s.missing == missing_) return s.values;
  const Index each = std::max(simulated_a_surface, (least_simulated + surfaces_ - 1) / surfaces_),
              all = each * surfaces_;
  s.values.resize(all, observed_.front().size());
  Index done = 0;
  for (const Missing& of : missing_) {
    const Field missing = of.field(grid_.shape);
    const Pairs pairs = Pairs::of(missing, grid_, asked_.threads);
    const Theory theory = pairs.complete() ? complete_ : theory_of(pairs);
    for (const Index end = done + each * of.surfaces; done < end;) {
      const Index count = std::min<Index>(std::max(1, asked_.threads), end - done);
      parallel_ranges(count, asked_.threads, [&](Index from, Index to, int) {
        for (Index k = done + from; k < done + to; ++k) {
          const Field z = s.fields.heights(k) + missing;
          s.values.row(k) = shaped(measured(z, pairs, theory, slopes_of(z, 1), 1)).transpose();
        }
      });
      done += count;
      if (asked_.simulated) asked_.simulated(done, all);
    }
  }
  s.missing = missing_;
  return s.values;
}

std::vector<TestResult> SpecificationTest::slopes_by_simulation(const ArrayXXd& drawn,
                                                                const ArrayXXd& observed) const {
  auto known = [&](Index column) {
    return drawn.col(column).isFinite().all() && observed.col(column).isFinite().all() &&
           sample_deviation(drawn.col(column)) > 0;
  };
  std::vector<TestResult> out;
  if (std::isfinite(asked_.sq) && known(at_sdq))
    out.push_back(row_of_square("Sdq", asked_.sq * std::sqrt(slopes_.square), slopes_.square,
                                drawn.col(at_sdq), observed.col(at_sdq) / (asked_.sq * asked_.sq)));
  if (known(at_summits)) {
    const double area = grid_.cell_area();
    out.push_back(row("summit_density", slopes_.summits.value / area, drawn.col(at_summits) / area,
                      observed.col(at_summits) / area));
    out.back().p = p_of_mean(drawn.col(at_summits), observed.col(at_summits));
  }
  return out;
}

std::vector<TestResult> SpecificationTest::by_simulation() const {
  const ArrayXXd &drawn = simulated(), observed = rows_of(observed_);
  std::vector<TestResult> out;
  if (std::isfinite(asked_.sq))
    out.push_back(row_of_square("Sq", asked_.sq, 1, drawn.col(at_variance),
                                observed.col(at_variance) / (asked_.sq * asked_.sq)));
  out.push_back(row("Ssk", asked_.ssk, drawn.col(at_ssk), observed.col(at_ssk)));
  out.back().p = p_of_mean(ssk_over_root_of_sku(drawn), ssk_over_root_of_sku(observed));
  out.push_back(row("Sku", asked_.sku, drawn.col(at_sku), observed.col(at_sku)));
  out.back().p = p_of_skewed_mean(drawn.col(at_sku), observed.col(at_sku));
  for (const TestResult& of_slopes : slopes_by_simulation(drawn, observed)) out.push_back(of_slopes);
  const Index stretches = drawn.cols() - at_shapes - lags();
  if (!lags_.empty())
    out.push_back(
        largest(acf_.each, drawn.middleCols(at_shapes, lags()), observed.middleCols(at_shapes, lags())));
  if (stretches > 0)
    out.push_back(largest(lengths_.each, drawn.rightCols(stretches), observed.rightCols(stretches)));
  return out;
}

}  // namespace asperity
