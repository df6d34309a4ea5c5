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
  spectra_ = WaveSpectra(directions.numbers);
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

namespace {

constexpr double enough = 10;  // points

// 1/n' and the degrees of freedom.
struct Certainty {
  double inverse = 0, degrees = 1;
};

double variance_of(const Frequency& f, double most) { return f.value * (1 - f.value / most); }

// Rows within a quarter of the standard deviation of the distribution.
Index rows_around(const std::vector<Frequency>& frequencies) {
  double sum = 0, first = 0, second = 0;
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    const double f = frequencies[k].value, place = static_cast<double>(k);
    sum += f, first += f * place, second += f * place * place;
  }
  const double mean = first / sum;
  return sum > 0 ? static_cast<Index>(std::sqrt(std::max(second / sum - mean * mean, 0.0)) / 4) : 0;
}

// The mean of the rows around that have points enough, nearer ones counting more.
Certainty around(const std::vector<Frequency>& frequencies, Index row, Index rows, double most) {
  Certainty out{0, 0};
  double weights = 0;
  const Index last = std::ssize(frequencies) - 1;
  for (Index k = std::max<Index>(row - rows, 0); k <= std::min(row + rows, last); ++k) {
    const Frequency& f = frequencies[static_cast<std::size_t>(k)];
    const double variance = variance_of(f, most);
    if (k != row && !(f.points >= enough && variance > 0)) continue;
    const double weight = static_cast<double>(rows + 1 - std::abs(k - row));
    weights += weight;
    out.inverse += variance > 0 ? weight * f.error * f.error / variance : 0;
    out.degrees += weight * f.degrees;
  }
  return {out.inverse / weights, out.degrees / weights};
}

}  // namespace

void set_intervals(std::vector<Frequency>& frequencies, double most) {
  constexpr double least_independent = 2;
  const std::vector<Frequency> own = frequencies;
  const Index top = std::ranges::max_element(own, {}, &Frequency::points) - own.begin(),
              rows = rows_around(own);
  auto set = [&](Index begin, Index end, Index step) {
    Certainty of;
    for (Index k = begin; k != end; k += step) {
      Frequency& f = frequencies[static_cast<std::size_t>(k)];
      if (f.points >= enough || k == begin) of = around(own, k, rows, most);
      f.error = std::sqrt(variance_of(f, most) * of.inverse);
      const double t = of.inverse > 0 ? student_quantile(0.025, of.degrees) : 0;
      const Interval score = score_interval(f.value, 1 / of.inverse, most, t);
      f.interval = Interval::of(f.value, std::max(0.0, f.value - std::hypot(f.value - score.low, f.fall)),
                                std::min(most, f.value + std::hypot(score.high - f.value, f.rise)));
      if (!(f.value >= least_independent * of.inverse)) f.error = NAN;
    }
  };
  set(top, std::ssize(own), 1);
  set(top, -1, -1);
}

}  // namespace asperity
