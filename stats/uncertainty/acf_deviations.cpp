#include "stats/uncertainty/acf_deviations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/parallel.hpp"
#include "math/linear_algebra.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

constexpr double furthest = 2.5;  // u

}  // namespace

AcfDeviations::AcfDeviations(std::vector<LagField> modes, double degrees)
    : modes_(std::move(modes)), degrees_(degrees) {}

AcfDeviations AcfDeviations::scaled(const std::function<double(Index, Index)>& factor) const {
  AcfDeviations out = *this;
  for (LagField& mode : out.modes_)
    mode = LagField::of(max_lag(), [&](Index p, Index q) { return factor(p, q) * mode(p, q); });
  return out;
}

double AcfDeviations::quantile(double tail) const { return student_quantile(tail, degrees_); }

LagField AcfDeviations::errors() const {
  Field variance = Field::Zero(modes_.front().half_plane().rows(), modes_.front().half_plane().cols());
  for (const LagField& mode : modes_) variance += mode.half_plane().square();
  return LagField(variance.sqrt());
}

// Orthogonal over the lags: eigenvectors of their products, but for those of round-off.
std::vector<Field> AcfDeviations::principal_modes() const {
  constexpr double round_off = 1e-14;
  const auto count = std::ssize(modes_);
  Eigen::MatrixXd products(count, count);
  for (Index k = 0; k < count; ++k)
    for (Index l = 0; l <= k; ++l) {
      const Field product = modes_[size(k)].half_plane() * modes_[size(l)].half_plane();
      products(k, l) = products(l, k) = product.isNaN().select(0, product).sum();
    }
  const Eigen::MatrixXd root = covariance_root(products);
  std::vector<Field> out;
  for (Index j = 0; j < count; ++j) {
    if (!(root.col(j).squaredNorm() > round_off * products.trace())) continue;
    const Eigen::VectorXd turn = root.col(j).normalized();
    Field sum = turn(0) * modes_[0].half_plane();
    for (Index k = 1; k < count; ++k) sum += turn(k) * modes_[size(k)].half_plane();
    out.push_back(std::move(sum));
  }
  if (out.empty()) out.push_back(modes_[0].half_plane());  // zero, or unknown
  return out;
}

AcfDeviations::Sides AcfDeviations::displaced(const LagField& rho, const std::vector<Field>& modes,
                                              double step, const Figures& figures, int threads) {
  std::vector<std::array<Eigen::ArrayXd, 2>> of(modes.size());
  parallel_ranges(std::ssize(modes), threads, [&](Index begin, Index end, int) {
    for (Index k = begin; k < end; ++k) {
      const Field by = step * modes[size(k)];
      of[size(k)] = {figures(LagField(rho.half_plane() + by)), figures(LagField(rho.half_plane() - by))};
    }
  });
  Sides out{Eigen::ArrayXXd(std::ssize(of), of[0][0].size()),
            Eigen::ArrayXXd(std::ssize(of), of[0][0].size())};
  for (std::size_t k = 0; k < of.size(); ++k) {
    out.above.row(static_cast<Index>(k)) = of[k][0].transpose();
    out.below.row(static_cast<Index>(k)) = of[k][1].transpose();
  }
  return out;
}

FigureDeviations AcfDeviations::of(const LagField& rho, const Figures& figures, int threads) const {
  const LagField here = rho.within(max_lag());
  const std::vector<Field> modes = principal_modes();
  const double end = quantile(0.025);
  FigureDeviations out;
  out.degrees_ = degrees_, out.step_ = std::min(end, furthest), out.here_ = figures(here);
  out.near_ = displaced(here, modes, out.step_, figures, threads);
  out.end_ = out.step_ < end ? displaced(here, modes, end, figures, threads) : out.near_;
  return out;
}

Eigen::ArrayXd AcfDeviations::relative_errors(const LagField& rho, const Figures& figures,
                                              int threads) const {
  const auto [above, below] = displaced(rho.within(max_lag()), principal_modes(), 1, figures, threads);
  return (0.5 * (above / below).log()).square().colwise().sum().sqrt().transpose();
}

// ---- figures ----

double FigureDeviations::quantile(double tail) const { return student_quantile(tail, degrees_); }

template <class Difference>
Eigen::ArrayXd FigureDeviations::differences(Index i, const Difference& apart) const {
  return Eigen::ArrayXd::NullaryExpr(near_.above.rows(), [&](Index k) {
    const double up = apart(near_.above(k, i), here_(i)), down = apart(here_(i), near_.below(k, i));
    const bool rises = std::isfinite(up), falls = std::isfinite(down);
    if (!rises && !falls) return static_cast<double>(NAN);
    return (rises && falls ? (up + down) / 2 : rises ? up : down) / step_;
  });
}

FigureDeviations::Law FigureDeviations::relative(Index i) const {
  const double here = here_(i);
  if (!(here > 0 && std::isfinite(here))) return {};
  Law out{.error = differences(i, [](double a, double b) { return std::log(a / b); }).matrix().norm()};
  for (const Eigen::ArrayXXd* side : {&end_.above, &end_.below}) {
    out.falls |= !(side->col(i) > 0).all();
    out.rises |= !(side->col(i) < INFINITY).all();
  }
  const Eigen::ArrayXd bends = (near_.above.col(i) * near_.below.col(i) / (here * here)).log();
  out.bias = bends.isFinite().select(bends, 0).sum() / (2 * step_ * step_);
  return out;
}

double FigureDeviations::of_axis(Index i) const {
  auto apart = [](double a, double b) { return std::remainder(a - b, std::numbers::pi); };
  const double error = differences(i, apart).matrix().norm();
  return quantile(0.025) * error < std::numbers::pi / 2 ? error : NAN;
}

double FigureDeviations::chance_of_pair(Index i, double beside) const {
  auto apart = [](double a, double b) { return a - b; };
  Eigen::MatrixX2d deviations(near_.above.rows(), 2);
  deviations << differences(i, apart), differences(i + 1, apart);
  const Eigen::Matrix2d covariance =
      deviations.transpose() * deviations + beside * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d x = here_.segment(i, 2);
  if (!x.allFinite() || !covariance.allFinite()) return 1;
  constexpr double no_pivot = 1e-9;
  const auto scaled = solve_positive(covariance, x, no_pivot);
  return scaled ? std::pow(1 + x.dot(*scaled) / degrees_, -degrees_ / 2) : 1;
}

}  // namespace asperity
