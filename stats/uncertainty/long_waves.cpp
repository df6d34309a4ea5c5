#include "stats/uncertainty/long_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "math/linear_algebra.hpp"

namespace asperity {
namespace {

// In the order of AxisWaves::number.
std::vector<AxisProducts::Term> all_products() {
  std::vector<AxisProducts::Term> out;
  for (Index j = 0; j <= AxisWaves::most; ++j)
    for (Index k = 0; k <= AxisWaves::most; ++k) out.push_back({j, k});
  return out;
}

}  // namespace

Eigen::MatrixXd axis_waves(Index n, bool periodic, Index count) {
  const Eigen::ArrayXd phase = Eigen::ArrayXd::LinSpaced(n, 0.5, static_cast<double>(n) - 0.5) *
                               (std::numbers::pi / static_cast<double>(n));
  return axis_waves(phase, periodic, count);
}

Eigen::MatrixXd axis_waves(const Eigen::ArrayXd& phase, bool periodic, Index count) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Ones(phase.size(), count + 1);
  for (Index j = 1; j <= count; ++j) {
    const double quarter = periodic && j % 2 == 0 ? std::numbers::pi / 2 : 0;  // of a sine
    out.col(j) = std::numbers::sqrt2 * (static_cast<double>(half_waves(j, periodic)) * phase - quarter).cos();
  }
  return out;
}

AxisWaves::AxisWaves(const Grid& grid)
    : products_(axis_waves(grid.shape.nx, grid.periodic.x, most),
                axis_waves(grid.shape.ny, grid.periodic.y, most), all_products()) {}

LongWaves::LongWaves(const Grid& grid, const FieldExtent& extent, double most) {
  constexpr double round_off = 1e-9;
  std::vector<double> nu, half;
  const auto [nx, ny] = grid.shape;
  for (Index j = 0; j <= std::min(AxisWaves::most, nx - 1); ++j)  // of more waves a row has none
    for (Index k = 0; k <= std::min(AxisWaves::most, ny - 1); ++k) {
      const auto x = static_cast<double>(half_waves(j, grid.periodic.x)),
                 y = static_cast<double>(half_waves(k, grid.periodic.y)),
                 number = x * x / extent.elongation + y * y * extent.elongation;
      if (!(number > 0 && number <= most * (1 + round_off))) continue;
      all_.push_back({j, k}), nu.push_back(number), half.insert(half.end(), {x, y});
    }
  numbers_.nu = Eigen::Map<const Eigen::ArrayXd>(nu.data(), std::ssize(nu));
  numbers_.half_waves = Eigen::Map<const Eigen::Array<double, Eigen::Dynamic, 2, Eigen::RowMajor>>(
      half.data(), std::ssize(nu), 2);
}

// Below `round_off` all points lie at one place.
LongWaves::Directions LongWaves::directions(const AxisWaves::Squares& squares) const {
  constexpr double least_share = 0.2, round_off = 1e-12, complete = 1e-9;
  std::vector<Index> own;
  for (const Wave& wave : all_) own.push_back(AxisWaves::number(wave.a, wave.b));
  const double n = squares(0, 0);
  if (!(n > 0) || own.empty()) return {Eigen::MatrixXd(0, std::ssize(own))};
  const Eigen::VectorXd mean = squares(own, 0) / n;
  const Eigen::MatrixXd covariance = squares(own, own) / n - mean * mean.transpose();
  const auto one = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
  if ((covariance - one).cwiseAbs().maxCoeff() <= complete) return {one, numbers_};
  const Eigen::MatrixXd some = orthonormal(covariance, least_share, round_off);
  if (some.rows() == 0) return {some};
  const Eigen::MatrixXd e = some.rowwise().normalized();
  Eigen::MatrixXd turn = covariance_root(e * numbers_.nu.matrix().asDiagonal() * e.transpose());
  turn.colwise().normalize();
  const Eigen::MatrixXd share = (turn.transpose() * e).cwiseAbs2();
  LongWaveNumbers numbers{(share * numbers_.nu.matrix()).array(), Eigen::ArrayX2d(share.rows(), 2)};
  for (Index k = 0; k < share.rows(); ++k) {
    Index most = 0;
    share.row(k).maxCoeff(&most);
    numbers.half_waves.row(k) = numbers_.half_waves.row(most);
  }
  return {turn.transpose() * some, numbers};
}

WaveError LocalMeans::error(const Function& g) const {
  Eigen::VectorXd gradient(means_.size());
  for (Index a = 0; a < means_.size(); ++a) {
    Eigen::VectorXd beside = means_;
    const double step = 1e-4 * deviations_(a);
    auto at = [&](double shift) {
      beside(a) = means_(a) + shift;
      return g(beside);
    };
    gradient(a) = step > 0 ? (at(step) - at(-step)) / (2 * step) : 0;
  }
  return spectra_.error((waves_.transpose() * gradient).array().square());
}

LocalSums::LocalSums(const Grid& grid, Index functions)
    : grid_(grid), functions_(functions), along_(grid), sums_(none()) {}

LocalSums::Sums LocalSums::none() const {
  const Index m = functions_ + 1;
  return {std::vector<Eigen::MatrixXd>(AxisWaves::most + 1, Eigen::MatrixXd::Zero(m, AxisWaves::most + 1)),
          Eigen::VectorXd::Zero(m), AxisWaves::none()};
}

void LocalSums::add_row(Sums& sums, Index i, Values& values) const {
  values.col(0).setOnes();
  const Eigen::ArrayXd all = values.rowwise().sum();
  if (all.isNaN().any())
    for (Index j = 0; j < values.rows(); ++j)
      if (std::isnan(all(j))) values.row(j).setZero();
  const Eigen::MatrixXd along_y = values.transpose() * along_.y();
  for (std::size_t j = 0; j < sums.waves.size(); ++j)
    sums.waves[j] += along_.x()(i, static_cast<Index>(j)) * along_y;
  along_.add_row(sums.squares, i, values.col(0));
  sums.powers += values.colwise().squaredNorm().transpose();
}

void LocalSums::add_rows(Index rows, int threads, const std::function<void(Index i, Values& values)>& fill) {
  constexpr Index block = 32;
  const Index blocks = (rows + block - 1) / block;
  std::vector<Sums> of_blocks(static_cast<std::size_t>(blocks));
  parallel_ranges(blocks, threads, [&](Index begin, Index end, int) {
    Values values(grid_.shape.ny, functions_ + 1);
    for (Index b = begin; b < end; ++b) {
      Sums& sums = of_blocks[static_cast<std::size_t>(b)] = none();
      for (Index i = b * block; i < std::min(rows, (b + 1) * block); ++i) {
        values.setConstant(NAN);
        fill(i, values);
        add_row(sums, i, values);
      }
    }
  });
  for (const Sums& sums : of_blocks) sums_ += sums;
}

LocalMeans LocalSums::means(const FieldExtent& extent) const {
  LocalMeans out;
  const LongWaves long_waves(grid_, extent);
  const double n = count();
  const Eigen::VectorXd means = sums_.waves[0].col(0) / n;
  const auto& waves = long_waves.all();
  Eigen::MatrixXd of_waves(functions_, std::ssize(waves));
  for (std::size_t k = 0; k < waves.size(); ++k) {
    const Eigen::VectorXd c = sums_.waves[static_cast<std::size_t>(waves[k].a)].col(waves[k].b) / n;
    of_waves.col(static_cast<Index>(k)) = (c - means * c(0)).tail(functions_);
  }
  const LongWaves::Directions directions = long_waves.directions(sums_.squares);
  out.waves_ = of_waves * directions.factors.transpose();
  out.spectra_ = WaveSpectra(directions.numbers);
  out.means_ = means.tail(functions_);
  out.deviations_ = (sums_.powers / n - means.cwiseAbs2()).tail(functions_).cwiseMax(0).cwiseSqrt();
  return out;
}

}  // namespace asperity
