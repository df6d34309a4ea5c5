#include "stats/uncertainty/acf_deviations.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/parallel.hpp"
#include "math/noise.hpp"
#include "stats/sample/axes.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

constexpr Index draws = 100;

std::vector<double> found(const std::vector<std::optional<double>>& values) {
  std::vector<double> out;
  for (const auto& value : values)
    if (value) out.push_back(*value);
  return out;
}

bool too_few(const std::vector<double>& values) {
  return static_cast<double>(values.size()) < 0.8 * static_cast<double>(draws);
}

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

std::vector<std::optional<double>> AcfDeviations::drawn(const LagField& rho, const Figure& figure,
                                                        int threads) const {
  const LagField here = rho.within(max_lag());
  Eigen::ArrayXXd xi(static_cast<Index>(modes_.size()), draws / 2);
  WhiteNoise(1).row(0, {xi.data(), static_cast<std::size_t>(xi.size())});
  std::vector<std::optional<double>> out(draws);
  parallel_ranges(draws / 2, threads, [&](Index begin, Index end, int) {
    for (Index n = begin; n < end; ++n) {
      Field deviation = xi(0, n) * modes_[0].half_plane();
      for (std::size_t k = 1; k < modes_.size(); ++k)
        deviation += xi(static_cast<Index>(k), n) * modes_[k].half_plane();
      out[static_cast<std::size_t>(2 * n)] = figure(LagField(here.half_plane() + deviation));
      out[static_cast<std::size_t>(2 * n + 1)] = figure(LagField(here.half_plane() - deviation));
    }
  });
  return out;
}

AcfDeviations::Law AcfDeviations::relative(const LagField& rho, const Figure& figure, int threads) const {
  std::vector<double> values = found(drawn(rho, figure, threads));
  const auto here = figure(rho);
  if (!here || too_few(values)) return {NAN, NAN};
  const double n = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (double& value : values) mean += (value = std::log(value / *here)) / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {std::sqrt(squares / (n - 1)), mean};
}

double AcfDeviations::of_axis(const LagField& rho, const Figure& figure, int threads) const {
  const std::vector<double> angles = found(drawn(rho, figure, threads));
  if (too_few(angles)) return NAN;
  const double spread = axial_spread(angles);
  return quantile(0.025) * spread < std::numbers::pi / 2 ? spread : NAN;
}

}  // namespace asperity
