#include "stats/uncertainty/acf_deviations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/parallel.hpp"
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

Eigen::MatrixXd AcfDeviations::correlation(const std::vector<Shape>& lags) const {
  Eigen::MatrixXd m(static_cast<Index>(lags.size()), static_cast<Index>(modes_.size()));
  for (Index h = 0; h < m.rows(); ++h)
    for (Index k = 0; k < m.cols(); ++k) {
      const auto [p, q] = lags[static_cast<std::size_t>(h)];
      m(h, k) = modes_[static_cast<std::size_t>(k)](p, q);
    }
  m.rowwise().normalize();
  return m * m.transpose();
}

std::vector<AcfDeviations::Pair> AcfDeviations::displaced(const LagField& rho, const Figure& figure,
                                                          double step, int threads) const {
  const LagField here = rho.within(max_lag());
  std::vector<Pair> out(modes_.size());
  parallel_ranges(static_cast<Index>(modes_.size()), threads, [&](Index begin, Index end, int) {
    for (Index k = begin; k < end; ++k) {
      const Field by = step * modes_[static_cast<std::size_t>(k)].half_plane();
      out[static_cast<std::size_t>(k)] = {figure(LagField(here.half_plane() + by)),
                                          figure(LagField(here.half_plane() - by))};
    }
  });
  return out;
}

// (2), of differences by `apart`; of one side where the figure is missing on the other side.
double AcfDeviations::error_of(const std::vector<Pair>& pairs, double here, const Difference& apart) {
  double variance = 0;
  for (const auto& [above, below] : pairs) {
    if (!above && !below) return NAN;
    double sum = 0;
    if (above) sum += apart(*above, here);
    if (below) sum += apart(here, *below);
    variance += std::pow(above && below ? sum / 2 : sum, 2);
  }
  return std::sqrt(variance);
}

AcfDeviations::Law AcfDeviations::relative(const LagField& rho, const Figure& figure, int threads) const {
  const auto here = figure(rho);
  if (!here || !(*here > 0 && std::isfinite(*here))) return {};
  const double end = quantile(0.025), step = std::min(end, furthest);
  std::vector<Pair> pairs = displaced(rho, figure, step, threads);
  Law out;
  for (const auto& [above, below] : step < end ? displaced(rho, figure, end, threads) : pairs)
    for (const auto& side : {above, below}) {
      out.falls = out.falls || side.value_or(0) == 0;
      out.rises = out.rises || std::isinf(side.value_or(INFINITY));
    }
  double curvature = 0;
  for (auto& [above, below] : pairs) {
    for (std::optional<double>* side : {&above, &below})
      if (side->value_or(0) == 0 || std::isinf(**side)) side->reset();
    if (above && below) curvature += std::log(*above / *here) + std::log(*below / *here);
  }
  auto apart = [](double a, double b) { return std::log(a / b); };
  out.error = error_of(pairs, *here, apart) / step;
  out.bias = curvature / (2 * step * step);
  return out;
}

Eigen::ArrayXd AcfDeviations::relative_errors(const LagField& rho, const Figures& figures,
                                              int threads) const {
  const LagField here = rho.within(max_lag());
  std::vector<Eigen::ArrayXd> squares(modes_.size());
  parallel_ranges(static_cast<Index>(modes_.size()), threads, [&](Index begin, Index end, int) {
    for (Index k = begin; k < end; ++k) {
      const Field& by = modes_[static_cast<std::size_t>(k)].half_plane();
      const Eigen::ArrayXd above = figures(LagField(here.half_plane() + by)),
                           below = figures(LagField(here.half_plane() - by));
      squares[static_cast<std::size_t>(k)] = (0.5 * (above / below).log()).square();
    }
  });
  Eigen::ArrayXd variance = squares.front();
  for (std::size_t k = 1; k < squares.size(); ++k) variance += squares[k];
  return variance.sqrt();
}

double AcfDeviations::of_axis(const LagField& rho, const Figure& figure, int threads) const {
  const auto here = figure(rho);
  if (!here) return NAN;
  const double error = error_of(displaced(rho, figure, 1, threads), *here,
                                [](double a, double b) { return std::remainder(a - b, std::numbers::pi); });
  return quantile(0.025) * error < std::numbers::pi / 2 ? error : NAN;
}

}  // namespace asperity
