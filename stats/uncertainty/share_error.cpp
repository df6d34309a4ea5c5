#include "stats/uncertainty/share_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

// A row a wave, the first of them 1.
Eigen::MatrixXd chosen(const Eigen::MatrixXd& waves, const std::vector<LongWaves::Wave>& longest,
                       Index LongWaves::Wave::*along) {
  Eigen::MatrixXd out(static_cast<Index>(longest.size()) + 1, waves.rows());
  out.row(0).setOnes();
  for (std::size_t k = 0; k < longest.size(); ++k)
    out.row(static_cast<Index>(k) + 1) = waves.col(longest[k].*along).transpose();
  return out;
}

// The ends of (2): p² (1 + t²/(n' most)) - p (2 f + t²/n') + f² = 0.
Interval score_interval(double f, double independent, double most, double t) {
  const double q = t * t / independent, a = 1 + q / most, half = f + q / 2;
  const double root = std::sqrt(std::max(half * half - a * f * f, 0.0));
  const double high = std::min((half + root) / a, most);
  return Interval::of(f, f > 0 ? std::min(f * f / (half + root), f) : 0, std::max(high, f));
}

}  // namespace

ShareErrors::ShareErrors(const Grid& grid, const FieldExtent& extent, Index classes)
    : long_waves_(grid, extent), along_(grid) {
  x_ = chosen(along_.x(), long_waves_.all(), &LongWaves::Wave::a);
  y_ = chosen(along_.y(), long_waves_.all(), &LongWaves::Wave::b);
  waves_.setZero(x_.rows(), classes);
  at_all_.setZero(x_.rows());
  of_values_.setZero(x_.rows());
  values_.setZero(classes);
}

void ShareErrors::add(const Field& z, const std::function<Index(double)>& class_of) {
  Eigen::VectorXd wave(x_.rows());
  for (Index i = 0; i < z.rows(); ++i) {
    along_.add_row(of_points_, i, (!z.row(i).isNaN()).cast<double>().matrix().transpose());
    for (Index j = 0; j < z.cols(); ++j) {
      const double value = z(i, j);
      if (std::isnan(value)) continue;
      const Index b = class_of(value);
      wave = x_.col(i).cwiseProduct(y_.col(j));
      waves_.col(b) += wave;
      of_values_ += value * wave;
      values_(b) += value;
    }
  }
  at_all_ = waves_.rowwise().sum();
  const LongWaves::Directions directions = long_waves_.directions(of_points_);
  directions_ = directions.factors;
  spectra_ = WaveSpectra(directions.nu);
}

void ShareErrors::accumulate() {
  for (Index b = 1; b < waves_.cols(); ++b) {
    waves_.col(b) += waves_.col(b - 1);
    values_(b) += values_(b - 1);
  }
}

ShareErrors::Function::Function(const ShareErrors& of)
    : of_(of), sums_(Eigen::VectorXd::Zero(of.x_.rows())) {}

void ShareErrors::Function::add(Index b, double value) { sums_ += value * of_.waves_.col(b); }

WaveError ShareErrors::Function::error(double slope) const {
  const double n = of_.points();
  const Eigen::VectorXd sums = sums_ + slope * of_.of_values_;
  const Eigen::VectorXd waves =
      of_.directions_ * (sums - sums(0) / n * of_.at_all_).tail(of_.directions_.cols()) / n;
  return of_.spectra_.error(waves.array().square());
}

void set_intervals(std::vector<Frequency>& frequencies, double most) {
  constexpr double few = 10, least_independent = 2;
  const auto top = std::ranges::max_element(frequencies, {}, &Frequency::points);
  auto set = [&](auto begin, auto end) {
    double independent = std::numeric_limits<double>::infinity(), t = 0;
    for (auto it = begin; it != end; ++it) {
      const double variance = it->value * (1 - it->value / most);
      if (it->points >= few || it == begin)
        independent = it->error > 0 ? variance / (it->error * it->error) : independent,
        t = student_quantile(0.025, it->degrees);
      else
        it->error = std::sqrt(variance / independent);
      const Interval score = score_interval(it->value, independent, most, t);
      it->interval =
          Interval::of(it->value, std::max(0.0, it->value - std::hypot(it->value - score.low, it->fall)),
                       std::min(most, it->value + std::hypot(score.high - it->value, it->rise)));
      if (!(it->value * independent >= least_independent)) it->error = NAN;
    }
  };
  set(top, frequencies.end());
  set(std::make_reverse_iterator(top + 1), frequencies.rend());
}

}  // namespace asperity
