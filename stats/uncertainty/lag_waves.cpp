#include "stats/uncertainty/lag_waves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/rectangle_sums.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

// Of a wave over the pairs at a lag. At lags of half a complete field it is 0.19.
constexpr double least_variance = 0.05;

// Sums over the pairs whose first point lies in a block, in the layout of LagField.
struct PairSums {
  Field products, squares, pairs;
};

// Points first ≤ i < last along an axis.
struct Range {
  Index first, last;

  Index length() const { return last - first; }
};

}  // namespace

class LagWaves::Blocks {
 public:
  Blocks(const Field& d, const Grid& grid, Shape max_lag, Index along_x, Index along_y)
      : grid_(grid),
        max_lag_(max_lag),
        along_x_(along_x),
        along_y_(along_y),
        complete_(!d.isNaN().any()),
        heights_(complete_ ? d : zero_filled(d)),
        valid_(complete_ ? Field() : validity(d)),
        torus_{fast_length((grid.shape.nx + along_x - 1) / along_x + max_lag.nx),
               fast_length((grid.shape.ny + along_y - 1) / along_y + 2 * max_lag.ny)},
        transform_(torus_) {}

  bool complete() const { return complete_; }
  Index count() const { return along_x_ * along_y_; }
  // Of the blocks of a row of them.
  Eigen::VectorXd points(Index row) const {
    const Range x = block(row, along_x_, grid_.shape.nx);
    Eigen::VectorXd out(along_y_);
    for (Index b = 0; b < along_y_; ++b) {
      const Range y = block(b, along_y_, grid_.shape.ny);
      out(b) = valid_.block(x.first, y.first, x.length(), y.length()).sum();
    }
    return out;
  }
  Index x_of(Index b) const { return b / along_y_; }
  Index y_of(Index b) const { return b % along_y_; }

  PairSums sums(Index b) const {
    const Range x = block(x_of(b), along_x_, grid_.shape.nx), y = block(y_of(b), along_y_, grid_.shape.ny);
    const Field far = surroundings(heights_, x, y);
    PairSums out;
    const Spectrum of_heights(*this, far, x, y);
    out.products = correlated(of_heights, of_heights);
    if (complete_) {
      squares_of_rectangles(far, x, y, out);
    } else {
      const Spectrum of_squares(*this, far.square(), x, y), of_valid(*this, surroundings(valid_, x, y), x, y);
      out.squares = 0.5 * (correlated(of_squares, of_valid) + correlated(of_valid, of_squares));
      out.pairs = correlated(of_valid, of_valid).round();
    }
    return out;
  }

 private:
  // Transforms of a block and of its surroundings.
  struct Spectrum {
    AlignedVector<Complex> near, far;

    Spectrum(const Blocks& blocks, const Field& surroundings, Range x, Range y)
        : near(blocks.transformed(surroundings.block(0, blocks.max_lag_.ny, x.length(), y.length()))),
          far(blocks.transformed(surroundings)) {}
  };

  static Range block(Index b, Index blocks, Index n) { return {b * n / blocks, (b + 1) * n / blocks}; }

  // Of the block and all second points of its pairs; zero beyond the field.
  Field surroundings(const Field& f, Range x, Range y) const {
    const auto [nx, ny] = grid_.shape;
    auto inside = [](Index i, Index n, bool periodic) { return periodic ? ((i % n) + n) % n : i; };
    return Field::NullaryExpr(x.length() + max_lag_.nx, y.length() + 2 * max_lag_.ny, [&](Index i, Index j) {
      const Index row = inside(x.first + i, nx, grid_.periodic.x),
                  column = inside(y.first + j - max_lag_.ny, ny, grid_.periodic.y);
      return row < nx && column >= 0 && column < ny ? f(row, column) : 0.0;
    });
  }
  AlignedVector<Complex> transformed(const Field& f) const {
    AlignedVector<double> padded(static_cast<std::size_t>(torus_.cells()), 0.0);
    Eigen::Map<Field>(padded.data(), torus_.nx, torus_.ny).topLeftCorner(f.rows(), f.cols()) = f;
    AlignedVector<Complex> out(static_cast<std::size_t>(transform_.spectrum_size()));
    transform_.forward(padded.data(), out.data());
    return out;
  }
  // Σ f(i,j) g(i+p, j+q), f of the block.
  Field correlated(const Spectrum& f, const Spectrum& g) const {
    AlignedVector<Complex> product(f.near.size());
    for (std::size_t k = 0; k < product.size(); ++k) product[k] = std::conj(f.near[k]) * g.far[k];
    AlignedVector<double> out(static_cast<std::size_t>(torus_.cells()));
    transform_.inverse(product.data(), out.data());
    return Eigen::Map<const Field>(out.data(), torus_.nx, torus_.ny)
               .topLeftCorner(max_lag_.nx + 1, 2 * max_lag_.ny + 1) /
           static_cast<double>(torus_.cells());
  }
  // Pairs and squares of a complete field.
  void squares_of_rectangles(const Field& far, Range x, Range y, PairSums& out) const {
    const auto [nx, ny] = grid_.shape;
    const RectangleSums squares(far.square());
    out.pairs = out.squares = Field(max_lag_.nx + 1, 2 * max_lag_.ny + 1);
    for (Index p = 0; p <= max_lag_.nx; ++p)
      for (Index column = 0; column <= 2 * max_lag_.ny; ++column) {
        const Index q = column - max_lag_.ny;
        const Range i{0, grid_.periodic.x ? x.length() : std::clamp(nx - p - x.first, Index{0}, x.length())},
            j = grid_.periodic.y ? Range{0, y.length()}
                                 : Range{std::clamp(-q - y.first, Index{0}, y.length()),
                                         std::clamp(ny - q - y.first, Index{0}, y.length())};
        const Index rows = i.length(), columns = std::max(j.length(), Index{0});
        out.pairs(p, column) = static_cast<double>(rows * columns);
        out.squares(p, column) = 0.5 * (squares(0, max_lag_.ny + j.first, rows, columns) +
                                        squares(p, column + j.first, rows, columns));
      }
  }

  Grid grid_;
  Shape max_lag_;
  Index along_x_, along_y_;
  bool complete_;
  Field heights_, valid_;
  Shape torus_;
  RealTransform2D transform_;
};

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
  const Index along_x = std::clamp(3 * most_x, Index{1}, nx), along_y = std::clamp(3 * most_y, Index{1}, ny);
  const Blocks blocks(d, grid, max_lag, along_x, along_y);
  const Eigen::MatrixXd of_blocks = waves_of(blocks, {{along_x, along_y}, 1, 1, grid.periodic});
  const Field none = Field::Zero(max_lag.nx + 1, 2 * max_lag.ny + 1);
  waves_.assign(static_cast<std::size_t>(of_blocks.rows()), {none, none, none, none});
  for (Index first = 0; first < blocks.count(); first += threads) {
    const Index count = std::min<Index>(threads, blocks.count() - first);
    std::vector<PairSums> sums(static_cast<std::size_t>(count));
    parallel_ranges(count, threads, [&](Index begin, Index end, int) {
      for (Index b = begin; b < end; ++b) sums[static_cast<std::size_t>(b)] = blocks.sums(first + b);
    });
    parallel_ranges(static_cast<Index>(waves_.size()), threads, [&](Index begin, Index end, int) {
      for (Index k = begin; k < end; ++k) {
        Wave& wave = waves_[static_cast<std::size_t>(k)];
        for (Index b = 0; b < count; ++b) {
          const PairSums& s = sums[static_cast<std::size_t>(b)];
          const double u = of_blocks(k, first + b);
          wave.products += u * s.products;
          wave.squares += u * s.squares;
          wave.pairs += u * s.pairs;
          wave.weights += u * u * s.pairs;
        }
      }
    });
  }
  variance_ = waves_[0].squares(0, max_lag.ny) / waves_[0].pairs(0, max_lag.ny);
}

// (3) of long_waves.hpp over the points of the blocks; of a complete field C = 1.
Eigen::MatrixXd LagWaves::waves_of(const Blocks& blocks, const Grid& of_blocks) const {
  const AxisWaves along(of_blocks);
  const auto& all = long_waves_.all();
  Eigen::MatrixXd waves(static_cast<Index>(all.size()), blocks.count());
  for (std::size_t k = 0; k < all.size(); ++k)
    for (Index b = 0; b < blocks.count(); ++b)
      waves(static_cast<Index>(k), b) =
          along.x()(blocks.x_of(b), all[k].x) * along.y()(blocks.y_of(b), all[k].y);
  if (!blocks.complete()) {
    AxisWaves::Squares squares = AxisWaves::none();
    for (Index i = 0; i < of_blocks.shape.nx; ++i) along.add_row(squares, i, blocks.points(i));
    waves = long_waves_.directions(squares) * waves;
  }
  Eigen::MatrixXd out = Eigen::MatrixXd::Ones(waves.rows() + 1, waves.cols());
  out.bottomRows(waves.rows()) = waves;
  return out;
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
