#include "stats/uncertainty/lag_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/parallel.hpp"
#include "stats/uncertainty/pair_blocks.hpp"

namespace asperity {
namespace {

// Of a wave over the pairs at a lag. At lags of half a complete field it is 0.19.
constexpr double least_variance = 0.05;

// Blocks of n points that the mirror image shares: an odd number of an odd number.
Index mirrored_blocks(Index half_waves, Index n) {
  const Index blocks = std::max(2 * half_waves, Index{1});
  return std::min(n, blocks + (n % 2 == 1 && blocks % 2 == 0));
}

// The mean over a lag and its opposite.
Field folded(const Field& plane) {
  const Index rows = plane.rows() / 2 + 1;
  return 0.5 * (plane.bottomRows(rows) + plane.topRows(rows).reverse());
}

}  // namespace

LagWaves::LagWaves(const Field& d, const Grid& grid, Shape max_lag, const FieldExtent& extent, int threads,
                   Number number)
    : long_waves_(grid, extent,
                  number == Number::few ? LongWaves::Range{5, 5} : LongWaves::Range{.least = 5}),
      patches_(extent.patches) {
  Index most_x = 0, most_y = 0;
  for (const auto& [x, y] : long_waves_.all()) {
    most_x = std::max(most_x, half_waves(x, grid.periodic.x));
    most_y = std::max(most_y, half_waves(y, grid.periodic.y));
  }
  const auto [nx, ny] = grid.shape;
  const Index along_x = mirrored_blocks(most_x, nx), along_y = mirrored_blocks(most_y, ny);
  PairBlocks blocks(d, grid, max_lag, along_x, along_y);
  const Eigen::MatrixXd waves = directions(blocks, {{along_x, along_y}, 1, 1, grid.periodic});
  const Field none = Field::Zero(max_lag.nx + 1, 2 * max_lag.ny + 1);
  waves_.assign(static_cast<std::size_t>(waves.rows()) + 1, {none, none, none, none});
  for (Index first = 0; first < blocks.count(); first += threads) {
    const Index count = std::min<Index>(threads, blocks.count() - first);
    const std::vector<PairSums> sums = blocks.sums({first, count}, threads);
    parallel_ranges(static_cast<Index>(waves_.size()), threads, [&](Index begin, Index end, int) {
      for (Index k = begin; k < end; ++k) {
        Wave& wave = waves_[static_cast<std::size_t>(k)];
        for (Index b = 0; b < count; ++b) {
          const auto& [products, squares, pairs] = sums[static_cast<std::size_t>(b)];
          const Shape lags = shape_of(pairs);
          const Field u =
              k == 0 ? Field(Field::Ones(lags.nx, lags.ny))
                     : blocks.waves(first + b, long_waves_.all()).combined(waves.row(k - 1).transpose());
          wave.add(u, products, squares, pairs);
        }
      }
    });
  }
  variance_ = waves_[0].squares(0, max_lag.ny) / waves_[0].pairs(0, max_lag.ny);
}

void LagWaves::Wave::add(const Field& u, const Field& of_products, const Field& of_squares,
                         const Field& of_pairs) {
  const Field weighted = u * of_pairs;
  products += folded(u * of_products);
  squares += folded(u * of_squares);
  pairs += folded(weighted);
  weights += folded(u * weighted);
}

Eigen::MatrixXd LagWaves::directions(const PairBlocks& blocks, const Grid& of_blocks) const {
  const auto count = std::ssize(long_waves_.all());
  if (blocks.complete()) return Eigen::MatrixXd::Identity(count, count);
  const AxisWaves along(of_blocks);
  AxisWaves::Squares squares = AxisWaves::none();
  for (Index i = 0; i < of_blocks.shape.nx; ++i) along.add_row(squares, i, blocks.points(i));
  return long_waves_.directions(squares);
}

std::vector<Field> LagWaves::modes(const Field& per_product, const Field& per_square, double loss) const {
  auto sum = [&](const Wave& wave) -> Field {
    return per_product * wave.products + per_square * wave.squares;
  };
  const Field& pairs = waves_[0].pairs;
  const Field mean = sum(waves_[0]) / pairs;
  const double scale = 1 / (std::sqrt(static_cast<double>(waves_.size() - 1)) * (1 - std::min(0.4, loss)));
  std::vector<Field> out;
  for (std::size_t k = 1; k < waves_.size(); ++k) {
    const Wave& wave = waves_[k];
    const Field variance = wave.weights / pairs - (wave.pairs / pairs).square();
    out.push_back(scale * (sum(wave) / pairs - mean * wave.pairs / pairs) /
                  variance.max(least_variance).sqrt());
  }
  return out;
}

AcfDeviations LagWaves::of_ratio(const LagField& rho) const {
  const Wave& all = waves_[0];
  const LagField lags = rho.within({all.pairs.rows() - 1, all.pairs.cols() / 2});
  const Field& ratio = lags.half_plane();
  std::vector<LagField> out;
  for (Field& mode :
       modes(Field::Constant(ratio.rows(), ratio.cols(), 1 / variance_), -ratio / variance_, loss()))
    out.emplace_back(std::move(mode));
  out.emplace_back(ratio * (all.squares / all.pairs / variance_ - 1));
  return {std::move(out), degrees()};
}

LagField LagWaves::errors(double per_product, double per_square, double loss) const {
  const Field one = Field::Ones(waves_[0].pairs.rows(), waves_[0].pairs.cols());
  Field variance = Field::Constant(one.rows(), one.cols(), degrees() > 0 ? 0 : NAN);
  for (const Field& mode : modes(per_product * one, per_square * one, loss)) variance += mode.square();
  return LagField(variance.sqrt());
}

LagField LagWaves::of_covariance() const { return errors(1, 0, loss()); }
LagField LagWaves::of_structure() const { return errors(-2, 2, 1 / std::sqrt(patches_)); }

}  // namespace asperity
