#include "stats/uncertainty/long_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"

namespace asperity {
namespace {

constexpr Index most_waves = 4;

// (2).
double largest_wave(double n_eff, Periodic periodic) {
  const double free = n_eff < 160 ? 2 : n_eff < 640 ? 5 : n_eff < 2560 ? 10 : 20;
  return periodic.any() ? std::max(free, 4.0) : free;
}

// (3), of ν independent values.
double loss(double largest, double independent) {
  return std::min(0.4, 0.75 * (0.3 / std::sqrt(independent) + (1.4 + 0.7 * largest) / independent));
}

// Of the j-th longest wave along an axis.
double half_waves_of(Index j, bool periodic) { return static_cast<double>(periodic ? j + j % 2 : j); }

}  // namespace

Eigen::MatrixXd longest_waves(Index n, bool periodic, Index count) {
  const Eigen::ArrayXd phase = Eigen::ArrayXd::LinSpaced(n, 0.5, static_cast<double>(n) - 0.5) *
                               (std::numbers::pi / static_cast<double>(n));
  Eigen::MatrixXd out(n, count);
  for (Index j = 1; j <= count; ++j) {
    const double quarter = periodic && j % 2 == 0 ? std::numbers::pi / 2 : 0;  // of a sine
    out.col(j - 1) = std::numbers::sqrt2 * (half_waves_of(j, periodic) * phase - quarter).cos();
  }
  return out;
}

double LocalMeans::error(const Function& g) const {
  Eigen::VectorXd gradient(means_.size());
  for (Index a = 0; a < means_.size(); ++a) {
    Eigen::VectorXd beside = means_;
    const double step = 1e-4 * std::sqrt(covariance_(a, a));
    auto at = [&](double shift) {
      beside(a) = means_(a) + shift;
      return g(beside);
    };
    gradient(a) = step > 0 ? (at(step) - at(-step)) / (2 * step) : 0;
  }
  const double variance = (waves_.transpose() * gradient).squaredNorm() / static_cast<double>(degrees());
  if (!(variance > 0)) return variance;
  const double independent = gradient.dot(covariance_ * gradient) / variance;
  return std::sqrt(variance) / (1 - loss(largest_wave_, std::max(independent, 1.0)));
}

LocalSums::Axis::Axis(Index n, bool periodic) : waves(n, most_waves + 1) {
  waves << Eigen::VectorXd::Ones(n), longest_waves(n, periodic, most_waves);
  half_waves.push_back(0);
  for (Index j = 1; j <= most_waves; ++j) half_waves.push_back(half_waves_of(j, periodic));
}

LocalSums::LocalSums(const Grid& grid, Index functions)
    : shape_(grid.shape),
      periodic_(grid.periodic),
      functions_(functions),
      x_(grid.shape.nx, grid.periodic.x),
      y_(grid.shape.ny, grid.periodic.y),
      sums_(none()) {}

void LocalSums::Sums::operator+=(const Sums& other) {
  for (std::size_t j = 0; j < waves.size(); ++j) waves[j] += other.waves[j];
  products += other.products;
}

LocalSums::Sums LocalSums::none() const {
  const Index m = functions_ + 1;
  return {std::vector<Eigen::MatrixXd>(most_waves + 1, Eigen::MatrixXd::Zero(m, most_waves + 1)),
          Eigen::MatrixXd::Zero(m, m)};
}

void LocalSums::add_row(Sums& sums, Index i, Values& values) const {
  values.col(0).setOnes();
  const Eigen::ArrayXd all = values.rowwise().sum();
  if (all.isNaN().any())
    for (Index j = 0; j < values.rows(); ++j)
      if (std::isnan(all(j))) values.row(j).setZero();
  const Eigen::MatrixXd along_y = values.transpose() * y_.waves;
  for (std::size_t j = 0; j < sums.waves.size(); ++j)
    sums.waves[j] += x_.waves(i, static_cast<Index>(j)) * along_y;
  sums.products += values.transpose() * values;
}

void LocalSums::add_rows(Index rows, int threads, const std::function<void(Index i, Values& values)>& fill) {
  constexpr Index block = 32;
  const Index blocks = (rows + block - 1) / block;
  std::vector<Sums> of_blocks(static_cast<std::size_t>(blocks));
  parallel_ranges(blocks, threads, [&](Index begin, Index end, int) {
    Values values(shape_.ny, functions_ + 1);
    for (Index b = begin; b < end; ++b) {
      Sums& sums = of_blocks[static_cast<std::size_t>(b)] = none();
      for (Index i = b * block; i < std::min(rows, (b + 1) * block); ++i) {
        values.setConstant(NAN);
        fill(i, values);
        add_row(sums, rows_ + i, values);
      }
    }
  });
  for (const Sums& sums : of_blocks) sums_ += sums;
  rows_ += rows;
}

LocalMeans LocalSums::means(const FieldExtent& extent) const {
  LocalMeans out;
  const double n = count();
  out.largest_wave_ = largest_wave(extent.n_eff, periodic_);
  const Eigen::VectorXd means = sums_.waves[0].col(0) / n;
  const std::size_t points_x = size(shape_.nx), points_y = size(shape_.ny);  // of more waves a row has none
  std::vector<Eigen::VectorXd> waves;
  for (std::size_t j = 0; j < x_.half_waves.size(); ++j)
    for (std::size_t k = 0; k < y_.half_waves.size(); ++k) {
      const double nu = std::pow(x_.half_waves[j], 2) / extent.elongation +
                        std::pow(y_.half_waves[k], 2) * extent.elongation;
      if (nu == 0 || nu > 1.1 * out.largest_wave_ || j >= points_x || k >= points_y) continue;
      const Eigen::VectorXd c = sums_.waves[j].col(static_cast<Index>(k)) / n;
      waves.emplace_back((c - means * c(0)).tail(functions_));
    }
  out.waves_.resize(functions_, static_cast<Index>(waves.size()));
  for (std::size_t k = 0; k < waves.size(); ++k) out.waves_.col(static_cast<Index>(k)) = waves[k];
  out.means_ = means.tail(functions_);
  const Eigen::MatrixXd second = sums_.products / n;
  const Eigen::VectorXd at = second.col(0);
  out.covariance_ = (second - at * at.transpose()).bottomRightCorner(functions_, functions_);
  return out;
}

}  // namespace asperity
