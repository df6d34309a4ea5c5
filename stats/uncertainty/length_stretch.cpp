#include "stats/uncertainty/length_stretch.hpp"

#include <cmath>
#include <cstdlib>

#include "stats/uncertainty/lag_spectrum.hpp"

namespace asperity {
namespace {

constexpr double least_power = 0.03;   // of the largest: f
constexpr double least_density = 0.1;  // of pairs
constexpr double most_error = 1;       // of a stretch of one field

// Whether three values fall like an exponential or a Gaussian, whose steps in ln f grow threefold at most,
// and not towards a zero.
bool decays(double before, double at, double after) {
  return before > at && at > after && after > 0 && std::log(at / after) < 3.5 * std::log(before / at);
}

// f'(k), 0 < k ≤ last, of values f(0)…f(last), without crossing the cusp at 0. The difference of logarithms
// is exact for exponentials and Gaussians, however short.
double slope(const auto& f, Index k, Index last) {
  if (k == last) return f(k) - f(k - 1);
  if (decays(f(k - 1), f(k), f(k + 1))) return f(k) * std::log(f(k + 1) / f(k - 1)) / 2;
  if (k >= 2 && k + 2 <= last) return (f(k - 2) - 8 * f(k - 1) + 8 * f(k + 1) - f(k + 2)) / 12;
  return (f(k + 1) - f(k - 1)) / 2;
}

LagField change_along(int axis, const LagField& rho) {
  const Index last = axis == 0 ? rho.max_p() : rho.max_q();
  return LagField::of(rho.max_lag(), [&](Index p, Index q) {
    const Index k = axis == 0 ? p : std::abs(q), side = q < 0 ? -1 : 1;
    auto line = [&](Index m) { return axis == 0 ? rho(m, q) : rho(p, side * m); };
    return k == 0 ? 0.0 : -static_cast<double>(k) * slope(line, k, last);
  });
}

// Σ a(h) b(h) over the lags of a in the whole plane.
double plane_sum(const LagField& a, const LagField& b) {
  double sum = 0;
  for (Index p = 0; p <= a.max_p(); ++p)
    for (Index q = -a.max_q(); q <= a.max_q(); ++q)
      if (const double weight = a(p, q); weight != 0) sum += (p > 0 ? 2 : 1) * weight * b(p, q);
  return sum;
}

LagSpectrum spectra(const LagField& rho, Shape lags, const Grid& grid) {
  if (grid.periodic.both()) return LagSpectrum(grid.shape);
  const Shape reach = rho.reach();
  return LagSpectrum::holding({reach.nx + lags.nx, reach.ny + lags.ny});
}

LagField lags_of(const Field& plane, Shape max_lag) {
  return LagField::of(
      max_lag, [&](Index p, Index q) { return plane(wrapped(p, plane.rows()), wrapped(q, plane.cols())); });
}

LagField sum_of(const std::vector<LagField>& fields, const Eigen::VectorXd& factors) {
  Field sum = Field::Zero(fields[0].half_plane().rows(), fields[0].half_plane().cols());
  for (Index i = 0; i < factors.size(); ++i)
    sum += factors(i) * fields[static_cast<std::size_t>(i)].half_plane();
  return LagField(std::move(sum));
}

// Of a matrix of one or two rows.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& m) {
  if (m.rows() == 1) return m.cwiseInverse();
  Eigen::MatrixXd out(2, 2);
  out << m(1, 1), -m(0, 1), -m(1, 0), m(0, 0);
  return out / (m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0));
}

}  // namespace

LengthStretch::LengthStretch(const LagField& correlation, const Grid& grid, Shape max_lag)
    : rho_(correlation.normalised()) {
  const Pairs pairs(grid);
  const LagField rho = tapered(rho_, pairs);
  const LagSpectrum spectrum = spectra(rho, max_lag, grid);
  const Eigen::ArrayXd f = spectrum.of(rho), squared = (f.max(0) + least_power * f.maxCoeff()).square();
  std::vector<Axis> axes;
  for (const int axis : {0, 1}) {
    const LagField change = change_along(axis, rho_);
    const Eigen::ArrayXd g = spectrum.of(tapered(change, pairs));
    const double a = spectrum.mean(g * f / squared) / spectrum.mean(f * f / squared);
    const LagField weights = lags_of(spectrum.function((g - a * f) / squared), max_lag);
    if (plane_sum(weights, change) > 0)
      axes.push_back({weights, change, axis == 0 ? "length_x" : "length_y"});
  }
  take(axes, pairs);
}

// Both axes, or the one that is known better.
void LengthStretch::take(const std::vector<Axis>& axes, const Pairs& pairs) {
  const auto n = static_cast<Index>(axes.size());
  if (n == 0) return;
  auto at = [&](Index i) -> const Axis& { return axes[static_cast<std::size_t>(i)]; };
  const Eigen::MatrixXd turns = Eigen::MatrixXd::NullaryExpr(
      n, n, [&](Index i, Index j) { return plane_sum(at(i).weights, at(j).change); });
  std::vector<LagField> weights;
  for (const Axis& axis : axes) weights.push_back(axis.weights);
  const Eigen::MatrixXd parted = inverse(turns);
  weights_.clear(), names_.clear();
  for (Index i = 0; i < n; ++i) {
    weights_.push_back(sum_of(weights, parted.row(i)));
    names_.push_back(at(i).name);
  }
  Index worst = 0;
  if (variances(pairs).maxCoeff(&worst) <= most_error * most_error) {
    if (n == 1) return;
    for (const Eigen::Vector2d& factors : {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(1, -1)})
      weights_.push_back(sum_of({weights_[0], weights_[1]}, factors));
    names_.insert(names_.end(), {"length", "length_x/length_y"});
    return;
  }
  weights_.clear(), names_.clear();
  if (n == 2) take({at(1 - worst)}, pairs);
}

std::vector<LagField> LengthStretch::weights(const Pairs& pairs) const {
  std::vector<LagField> out;
  for (const LagField& all : weights_) {
    const Shape lags = all.max_lag();
    Field w = LagField::of(lags, [&](Index p, Index q) {
                const bool counts = (p != 0 || q != 0) && pairs.density(p, q) > least_density;
                return counts ? all(p, q) : 0;
              }).half_plane();
    w(0, lags.ny) = -plane_sum(LagField(w), rho_);
    out.emplace_back(w);
  }
  return out;
}

Eigen::ArrayXd LengthStretch::variances(const Pairs& pairs) const {
  const LagField rho = tapered(rho_, pairs);
  const std::vector<LagField> all = weights(pairs);
  const LagSpectrum spectrum = spectra(rho, all[0].max_lag(), pairs.grid());
  const Eigen::ArrayXd f = spectrum.of(rho);
  return Eigen::ArrayXd::NullaryExpr(static_cast<Index>(all.size()), [&](Index i) {
    const LagField& w = all[static_cast<std::size_t>(i)];
    const LagField per_pair = LagField::of(w.max_lag(), [&](Index p, Index q) {
      return w(p, q) == 0 ? 0 : w(p, q) / std::sqrt(pairs.pair_fraction(p, q));
    });
    return 2 / pairs.points() * spectrum.mean((f * spectrum.of(per_pair)).square());
  });
}

double LengthStretch::estimate(const LagField& weights, const LagField& estimate) {
  return plane_sum(weights, estimate);
}

}  // namespace asperity
