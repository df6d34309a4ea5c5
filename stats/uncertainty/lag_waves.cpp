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
Index mirrored_blocks(Index half_waves, Index n, bool periodic) {
  const Index blocks = std::max((periodic ? 4 : 2) * half_waves, Index{1});
  return std::min(n, blocks + (n % 2 == 1 && blocks % 2 == 0));
}

// The mean over a lag and its opposite.
Field folded(const Field& plane) {
  const Index rows = plane.rows() / 2 + 1;
  return 0.5 * (plane.bottomRows(rows) + plane.topRows(rows).reverse());
}

}  // namespace

LagWaves::LagWaves(const Field& d, const Grid& grid, Shape max_lag, const FieldExtent& extent, int threads,
                   double most)
    : threads_(threads) {
  const LongWaves long_waves(grid, extent, most);
  Index most_x = 0, most_y = 0;
  for (const auto& [x, y] : long_waves.all()) {
    most_x = std::max(most_x, half_waves(x, grid.periodic.x));
    most_y = std::max(most_y, half_waves(y, grid.periodic.y));
  }
  const auto [nx, ny] = grid.shape;
  const Index along_x = mirrored_blocks(most_x, nx, grid.periodic.x),
              along_y = mirrored_blocks(most_y, ny, grid.periodic.y);
  PairBlocks blocks(d, grid, max_lag, along_x, along_y);
  const auto found = directions(long_waves, blocks, {{along_x, along_y}, 1, 1, grid.periodic});
  const Eigen::MatrixXd& waves = found.factors;
  spectra_ = WaveSpectra(LongWaveNumbers{found.numbers.nu});  // without ridges
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
                     : blocks.waves(first + b, long_waves.all()).combined(waves.row(k - 1).transpose());
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

LongWaves::Directions LagWaves::directions(const LongWaves& all, const PairBlocks& blocks,
                                           const Grid& of_blocks) {
  const auto count = std::ssize(all.all());
  if (blocks.complete()) return {Eigen::MatrixXd::Identity(count, count), all.numbers()};
  const AxisWaves along(of_blocks);
  AxisWaves::Squares squares = AxisWaves::none();
  for (Index i = 0; i < of_blocks.shape.nx; ++i) along.add_row(squares, i, blocks.points(i));
  return all.directions(squares);
}

std::vector<Field> LagWaves::amplitudes(const Field& per_product, const Field& per_square) const {
  auto sum = [&](const Wave& wave) -> Field {
    return per_product * wave.products + per_square * wave.squares;
  };
  const Field& pairs = waves_[0].pairs;
  const Field mean = sum(waves_[0]) / pairs;
  std::vector<Field> out;
  for (std::size_t k = 1; k < waves_.size(); ++k) {
    const Wave& wave = waves_[k];
    const Field variance = wave.weights / pairs - (wave.pairs / pairs).square();
    out.push_back((sum(wave) / pairs - mean * wave.pairs / pairs) / variance.max(least_variance).sqrt());
  }
  return out;
}

AcfDeviations LagWaves::deviations(const Field& per_product, const Field& per_square) const {
  std::vector<Field> modes = amplitudes(per_product, per_square);
  if (modes.empty()) modes.push_back(Field::Constant(per_square.rows(), per_square.cols(), NAN));
  parallel_ranges(per_square.rows(), threads_, [&](Index begin, Index end, int) {
    Eigen::ArrayXd c(spectra_.waves());
    for (Index p = begin; p < end; ++p)
      for (Index q = 0; q < per_square.cols(); ++q) {
        for (Index k = 0; k < c.size(); ++k) c(k) = modes[size(k)](p, q);
        c *= spectra_.weights(c.square()).sqrt();
        for (Index k = 0; k < c.size(); ++k) modes[size(k)](p, q) = c(k);
      }
  });
  std::vector<LagField> out;
  for (Field& mode : modes) out.emplace_back(std::move(mode));
  return {std::move(out), degrees()};
}

// Of z².
double LagWaves::degrees() const {
  const Index zero = waves_[0].pairs.cols() / 2;
  const Field one = Field::Ones(waves_[0].pairs.rows(), waves_[0].pairs.cols());
  Eigen::ArrayXd squares(spectra_.waves());
  for (Index k = 0; const Field& c : amplitudes(one, 0 * one)) squares(k++) = c(0, zero) * c(0, zero);
  return spectra_.error(squares).degrees;
}

AcfDeviations LagWaves::of_ratio(const LagField& rho) const {
  const Wave& all = waves_[0];
  const LagField lags = rho.within({all.pairs.rows() - 1, all.pairs.cols() / 2});
  const Field& ratio = lags.half_plane();
  return deviations(Field::Constant(ratio.rows(), ratio.cols(), 1 / variance_), -ratio / variance_)
      .with(LagField(ratio * (all.squares / all.pairs / variance_ - 1)));
}

AcfDeviations LagWaves::of_covariance() const {
  const Field one = Field::Ones(waves_[0].pairs.rows(), waves_[0].pairs.cols());
  return deviations(one, 0 * one);
}

AcfDeviations LagWaves::of_structure() const {
  const Field two = Field::Constant(waves_[0].pairs.rows(), waves_[0].pairs.cols(), 2);
  return deviations(-two, two);
}

}  // namespace asperity
