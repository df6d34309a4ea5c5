#include "stats/measure/ensemble_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/bracketed_root.hpp"
#include "stats/measure/pooled_maps.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

// e and its degrees of freedom; NaN where there is none.
struct KnownTo {
  double error = unknown, degrees = unknown;
};

// Of which an interval of so many errors on either side is one of 95 %.
double degrees_of(double errors) {
  constexpr double fewest = 1, most = 1e4;
  auto beyond = [&](double log) { return student_quantile(0.025, std::exp(log)) - errors; };
  const CurvePoint few{std::log(fewest), beyond(std::log(fewest))},
      many{std::log(most), beyond(std::log(most))};
  return !(few.f > 0) ? fewest : !(many.f < 0) ? INFINITY : std::exp(bracketed_root(beyond, few, many, 1e-6));
}

// An interval is even in the value or in its logarithm: the one in which it is shorter.
KnownTo known_to(const Parameter& p) {
  const Interval ends = p.interval_95();
  if (!(p.standard_error > 0) || p.is_bound || !std::isfinite(ends.high - ends.low)) return {};
  double width = ends.high - ends.low;
  if (ends.low > 0) width = std::min(width, p.value * std::log(ends.high / ends.low));
  return {p.standard_error, degrees_of(width / 2 / p.standard_error)};
}

// Square error, value, 1/ν; a direction by the wave that has it, of two periods a turn.
Eigen::Array4d summed(const Parameter& parameter) {
  const double value = parameter.value, square_error = parameter.standard_error * parameter.standard_error,
               fewness = 1 / known_to(parameter).degrees;
  if (parameter.unit != "rad") return {square_error, value, 0, fewness};
  return {square_error, std::cos(2 * value), std::sin(2 * value), fewness};
}

// Of points; it has no error.
bool is_number(const std::string& name) { return name.starts_with("N"); }

}  // namespace

void EnsembleParameters::add(const Parameters& parameters, double weight) {
  ++surfaces_;
  for (const Parameter& parameter : parameters) {
    auto known = std::ranges::find(quantities_, parameter.name, &Quantity::name);
    if (known == quantities_.end()) known = quantities_.insert(known, {parameter.name, parameter.unit});
    known->values.add(summed(parameter), is_number(parameter.name) ? 1 : weight);
    known->is_bound |= parameter.is_bound;
  }
}

std::vector<EnsembleParameter> EnsembleParameters::all() const {
  std::vector<EnsembleParameter> out;
  for (const auto& [name, unit, values, is_bound] : quantities_) {
    const Eigen::Array4d m = values.mean();
    const double n = values.count()(1);
    EnsembleParameter of{name, unit, m(1), 0, values.spread()(1), std::sqrt(m(0)), n, n / m(3), is_bound};
    if (unit == "rad") {
      const double length = std::min(std::hypot(m(1), m(2)), 1.0);
      of.mean = std::atan2(m(2), m(1)) / 2;
      of.spread = n > 1 ? std::sqrt(-2 * std::log(length) * n / (n - 1)) / 2 : NAN;
    }
    of.standard_error = of.spread / std::sqrt(n);
    out.push_back(of);
  }
  return out;
}

namespace {

// Extremes over directions, and what they have.
bool keeps_bias(const std::string& name) {
  return name.starts_with("Sal") || name.starts_with("slowest_") || name == "Str";
}

}  // namespace

void take_pooled(std::vector<EnsembleParameter>& means, const Parameters& pooled, const PooledMaps& maps) {
  for (EnsembleParameter& mean : means) {
    const auto found = std::ranges::find(pooled, mean.name, &Parameter::name);
    if (keeps_bias(mean.name)) mean.standard_error = unknown;
    const bool any_spacing = mean.name == "mean" || mean.unit == "rad" || is_number(mean.name);
    if (found == pooled.end() || (!std::isfinite(found->value) && found->unit != "rad")) {
      if (!maps.one_spacing() && !any_spacing)
        mean = {mean.name, mean.unit, unknown, unknown, unknown, unknown, 0};
      continue;
    }
    mean.mean = found->value, mean.surfaces = maps.maps();
    if (!keeps_bias(mean.name)) mean.standard_error = found->standard_error;
  }
}

namespace {

constexpr double comparison_level = 0.01;  // shared among the parameters

KnownTo known_to(const EnsembleParameter& p) {
  if (p.is_bound || !(p.spread > 0)) return {};
  const double few = p.surfaces - 1, of_spread = 1 / std::sqrt(2 * few);  // its relative error
  const bool as_expected = std::abs(p.spread / p.expected_spread - 1) <= 2 * of_spread;
  return {std::fmax(p.spread, p.expected_spread) / std::sqrt(p.surfaces),
          as_expected ? std::fmax(few, p.expected_degrees) : few};
}

// Welch's, where the errors are known apart.
double common_degrees(const KnownTo& x, const KnownTo& y) {
  const double square_x = x.error * x.error, square_y = y.error * y.error, sum = square_x + square_y;
  return sum * sum / (square_x * square_x / x.degrees + square_y * square_y / y.degrees);
}

void judge(ComparedParameter& c, const KnownTo& x, const KnownTo& y, double degrees) {
  const double apart = c.others - c.first;
  c.z = (c.unit == "rad" ? std::remainder(apart, std::numbers::pi) : apart) / std::hypot(x.error, y.error);
  c.p = std::isfinite(c.z) ? 2 * student_tails(std::abs(c.z), degrees).above : unknown;
}

// It has no Student's t.
bool is_p_value(const Parameter& p) { return p.unit == "1" && p.name.ends_with("_p"); }

// Of one other, `y` is that. `one_size`: of surfaces as large as the first.
void judge(ComparedParameter& c, const Parameter& x, const Parameter* y, const EnsembleParameter& others,
           bool one_size) {
  const KnownTo of_x = known_to(x), of_y = y ? known_to(*y) : known_to(others);
  const bool alike = (one_size || std::isnan(of_x.error)) && !y && !x.is_bound && !is_p_value(x);
  const KnownTo taken = alike ? KnownTo{of_y.error * std::sqrt(others.surfaces), of_y.degrees} : of_x;
  c.first_error = taken.error, c.others_error = of_y.error;
  judge(c, taken, of_y, alike ? taken.degrees : common_degrees(of_x, of_y));
}

}  // namespace

std::vector<ComparedParameter> compared(const Parameters& first, const EnsembleParameters& others,
                                        const Parameters& other) {
  std::vector<ComparedParameter> out;
  const auto among = [](const auto& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, [](const auto& one) { return one.name; });
    return found == all.end() ? nullptr : &*found;
  };
  const std::vector<EnsembleParameter> means = others.all();
  const Parameter* points = among(first, "N");
  const EnsembleParameter* of_others = among(means, "N");
  const bool one_size = !points || !of_others || std::abs(points->value / of_others->mean - 1) < 0.1;
  for (const EnsembleParameter& y : means) {
    const Parameter *x = among(first, y.name),
                    *alone = others.surfaces() == 1 ? among(other, y.name) : nullptr;
    ComparedParameter c{.name = y.name,
                        .unit = y.unit,
                        .first = x ? x->value : unknown,
                        .others = y.mean,
                        .number = y.surfaces};
    if (x) judge(c, *x, alone, y, one_size);
    out.push_back(c);
  }
  for (const Parameter& x : first)
    if (!among(means, x.name)) out.push_back({.name = x.name, .unit = x.unit, .first = x.value});
  const auto judged = std::ranges::count_if(out, [](const auto& c) { return std::isfinite(c.p); });
  for (ComparedParameter& c : out) c.differs = c.p <= comparison_level / static_cast<double>(judged);
  return out;
}

}  // namespace asperity
