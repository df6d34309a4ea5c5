#include "stats/uncertainty/long_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"

namespace asperity {
namespace {

constexpr Index most_waves = 4;

// (3), of ν independent values.
double loss(double largest, double independent) {
  return std::min(0.4, 0.75 * (0.3 / std::sqrt(independent) + (1.4 + 0.7 * largest) / independent));
}

}  // namespace

LongWaves::Axis::Axis(Index n, bool periodic) : waves(n, most_waves + 1) {
  const Eigen::ArrayXd phase = Eigen::ArrayXd::LinSpaced(n, 0.5, static_cast<double>(n) - 0.5) *
                               (std::numbers::pi / static_cast<double>(n));
  waves.col(0).setOnes();
  half_waves.push_back(0);
  for (Index j = 1; j <= most_waves; ++j) {
    const auto k = static_cast<double>(periodic ? j + j % 2 : j);
    const double quarter = periodic && j % 2 == 0 ? std::numbers::pi / 2 : 0;  // of a sine
    waves.col(j) = std::numbers::sqrt2 * (k * phase - quarter).cos();
    half_waves.push_back(k);
  }
}

LongWaves::LongWaves(const Grid& grid)
    : periodic_(grid.periodic.any()),
      x_(grid.shape.nx, grid.periodic.x),
      y_(grid.shape.ny, grid.periodic.y) {}

double LongWaves::largest(double n_eff) const {
  const double free = n_eff < 160 ? 2 : n_eff < 640 ? 5 : n_eff < 2560 ? 10 : 20;
  return periodic_ ? std::max(free, 4.0) : free;
}

std::vector<LongWaves::Numbers> LongWaves::longest(const FieldExtent& extent) const {
  std::vector<Numbers> out;
  const std::size_t points_x = size(x_.waves.rows()), points_y = size(y_.waves.rows());  // a row has no more
  for (std::size_t j = 0; j < x_.half_waves.size(); ++j)
    for (std::size_t k = 0; k < y_.half_waves.size(); ++k) {
      const double nu = std::pow(x_.half_waves[j], 2) / extent.elongation +
                        std::pow(y_.half_waves[k], 2) * extent.elongation;
      if (nu > 0 && nu <= 1.1 * largest(extent.n_eff) && j < points_x && k < points_y)
        out.push_back({static_cast<Index>(j), static_cast<Index>(k)});
    }
  return out;
}

double LongWaves::error(double variance, double at_point, double largest) {
  if (!(variance > 0)) return variance;
  return std::sqrt(variance) / (1 - loss(largest, std::max(at_point / variance, 1.0)));
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
  return LongWaves::error(variance, gradient.dot(covariance_ * gradient), largest_wave_);
}

LocalSums::LocalSums(const Grid& grid, Index functions)
    : shape_(grid.shape), functions_(functions), waves_(grid), sums_(none()) {}

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
  const Eigen::MatrixXd along_y = values.transpose() * waves_.y();
  for (std::size_t j = 0; j < sums.waves.size(); ++j)
    sums.waves[j] += waves_.x()(i, static_cast<Index>(j)) * along_y;
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
  const Eigen::VectorXd means = sums_.waves[0].col(0) / n;
  const auto longest = waves_.longest(extent);
  out.waves_.resize(functions_, static_cast<Index>(longest.size()));
  for (Index k = 0; k < out.waves_.cols(); ++k) {
    const auto [along_x, along_y] = longest[size(k)];
    const Eigen::VectorXd c = sums_.waves[size(along_x)].col(along_y) / n;
    out.waves_.col(k) = (c - means * c(0)).tail(functions_);
  }
  out.means_ = means.tail(functions_);
  const Eigen::MatrixXd second = sums_.products / n;
  const Eigen::VectorXd at = second.col(0);
  out.covariance_ = (second - at * at.transpose()).bottomRightCorner(functions_, functions_);
  out.largest_wave_ = waves_.largest(extent.n_eff);
  return out;
}

}  // namespace asperity
