// Errors and p-values from surfaces that are drawn as prescribed.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"
#include "marginal/prescribed.hpp"
#include "stats/hypothesis/simulated_law.hpp"
#include "stats/hypothesis/specification.hpp"

namespace asperity {
namespace {

using Eigen::ArrayXd, Eigen::ArrayXXd;

constexpr Index simulated_a_surface = 4, fewest = 100, enough = 200;
constexpr double enough_points = 5e7;          // beyond `fewest` surfaces
constexpr double most_error_of_share = 0.5;    // of summits; a few tell nothing
constexpr double most_error_of_square = 0.01;  // of Sdq² that is drawn; beyond it short waves are added
constexpr double most_missing = 0.01;          // beyond it whole surfaces are drawn, with the same points

RandomFields fields_of(const Specification& asked, const Grid& grid) {
  FieldModel model{.grid = grid, .correlation = asked.correlation};
  if (asked.ssk != 0 || asked.sku != 3)
    model.translation = PrescribedHeights{asked.ssk, asked.sku, InfeasiblePolicy::nearest}.translation();
  return {model, asked.seed};
}

TestResult row(const std::string& name, double prescribed, const Compared& of) {
  TestResult out{.quantity = name, .prescribed = prescribed};
  out.mean = prescribed + of.observed.mean() - of.expected();
  out.standard_error = of.standard_error();
  out.z = (out.mean - prescribed) / out.standard_error;
  return out;
}

// Of a positive square, which is tested; its root is reported. `expected` is that of a surface of Sq 1.
TestResult row_of_square(const std::string& name, double prescribed, double expected, const Compared& of) {
  TestResult out = row(name, 1, of.mapped([=](double square) { return square / expected; }));
  out.p = p_of_skewed_mean(of);
  out.mean = prescribed * std::sqrt(of.observed.mean() / of.expected());
  out.prescribed = prescribed;
  out.standard_error *= prescribed / 2;
  return out;
}

// Without skewness, in any translation that was tried.
Compared ssk_over_root_of_sku(const Compared& ssk, const Compared& sku) {
  return {ssk.simulated / sku.simulated.sqrt(), ssk.observed / sku.observed.sqrt(), ssk.worth,
          ssk.limit / std::sqrt(sku.limit)};
}

// Of those that all surfaces have.
TestResult largest(const std::vector<TestResult>& each, const auto& compared) {
  std::vector<Compared> known;
  std::vector<TestResult> rows;
  for (Index i = 0; const TestResult& of : each)
    if (const Compared one = compared(i++); one.known()) known.push_back(one), rows.push_back(of);
  TestResult out = each.front();
  out.mean = out.prescribed, out.p = 1;
  if (known.empty()) return out;
  const SimulatedTogether together(known);
  std::size_t most = 0;
  together.deviations().abs().maxCoeff(&most);
  out = row(rows[most].quantity, rows[most].prescribed, known[most]);
  out.lag_x = rows[most].lag_x, out.lag_y = rows[most].lag_y;
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

bool SpecificationTest::draws_whole() const {
  return part_.shape == grid_.shape || std::ranges::any_of(missing_, [](const Missing& of) {
           return static_cast<double>(std::ranges::count(of.points, true)) >
                  most_missing * static_cast<double>(of.points.size());
         });
}

const SpecificationTest::Simulation& SpecificationTest::simulated() const {
  Simulation& s = *simulation_;
  if (s.missing == missing_) return s;
  const bool whole = draws_whole();
  const Grid& grid = whole ? grid_ : part_;
  const RandomFields fields = fields_of(asked_, grid);
  const auto least = static_cast<Index>(
      std::clamp(enough_points / static_cast<double>(grid.shape.cells()), double(fewest), double(enough)));
  const Index each = std::max(simulated_a_surface, (least + surfaces() - 1) / surfaces()),
              all = each * surfaces();
  s.values.resize(all, observed_.front().size());
  s.limits = limits(fields);
  s.worth = whole ? ArrayXd(ArrayXd::Ones(s.limits.size())) : worth();
  Index done = 0;
  for (const Missing& of : whole ? missing_ : std::vector<Missing>{{{}, surfaces()}}) {
    const Field missing = of.field(grid.shape);
    const Pairs pairs = Pairs::of(missing, grid, asked_.threads);
    const std::vector<LagField> stretches = stretch_->weights(pairs);
    for (const Index end = done + each * of.surfaces; done < end;) {
      const Index count = std::min<Index>(std::max(1, asked_.threads), end - done);
      parallel_ranges(count, asked_.threads, [&](Index from, Index to, int) {
        for (Index k = done + from; k < done + to; ++k) {
          const Field z = fields.heights(k) + missing;
          s.values.row(k) = measured(z, pairs, stretches, 1).transpose();
        }
      });
      done += count;
      if (asked_.simulated) asked_.simulated(done, all);
    }
  }
  s.missing = missing_;
  return s;
}

Compared SpecificationTest::compared(Index quantity) const {
  const Simulation& s = simulated();
  const auto surface = [&](Index m) { return observed_[static_cast<std::size_t>(m)](quantity); };
  return {s.values.col(quantity), ArrayXd::NullaryExpr(surfaces(), surface), s.worth(quantity),
          s.limits(quantity)};
}

Compared SpecificationTest::compared_square(Index quantity) const {
  Compared out = compared(quantity);
  out.observed /= asked_.sq * asked_.sq;
  return out;
}

std::vector<TestResult> SpecificationTest::slopes() const {
  std::vector<TestResult> out;
  if (std::abs(simulated().limits(at_sdq) / square_ - 1) > most_error_of_square) return out;
  if (const Compared square = compared_square(at_sdq); std::isfinite(asked_.sq) && square.known())
    out.push_back(row_of_square("Sdq", asked_.sq * std::sqrt(square_), square_, square));
  if (const Compared share = compared(at_summits); summits_ && share.known()) {
    const double half = 0.375 / static_cast<double>(grid_.shape.cells()),
                 area = grid_.cell_area();  // Anscombe's
    const TestResult summits = row("summit_density", share.expected() / area,
                                   share.mapped([=](double counted) { return counted / area; }));
    if (summits.standard_error < most_error_of_share * summits.prescribed) {
      out.push_back(summits);
      out.back().p = p_of_skewed_mean(share.mapped([=](double counted) { return counted + half; }));
    }
  }
  return out;
}

std::vector<TestResult> SpecificationTest::results() const {
  if (observed_.empty()) throw DataError("heights", "the ensemble has no surface");
  const Compared ssk = compared(at_ssk), sku = compared(at_sku);
  std::vector<TestResult> out;
  if (std::isfinite(asked_.sq))
    out.push_back(row_of_square("Sq", asked_.sq, 1, compared_square(at_variance)));
  out.push_back(row("Ssk", asked_.ssk, ssk));
  out.back().p = p_of_mean(ssk_over_root_of_sku(ssk, sku));
  out.push_back(row("Sku", asked_.sku, sku));
  out.back().p = p_of_skewed_mean(sku);
  for (const TestResult& of_slopes : slopes()) out.push_back(of_slopes);
  const auto from = [this](Index first) { return [=, this](Index i) { return compared(first + i); }; };
  if (!lags_.empty()) out.push_back(largest(lags_, from(at_shapes)));
  if (!lengths_.empty()) out.push_back(largest(lengths_, from(at_shapes + lags())));
  return out;
}

}  // namespace asperity
