#include "stats/uncertainty/lag_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/parallel.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/rectangle_sums.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

// Of a wave over the pairs at a lag. At lags of half a complete field it is 0.19.
constexpr double least_variance = 0.05;

// Sums over the pairs whose first point lies in a block, at lags of the whole plane: row P + p, column Q + q.
struct PairSums {
  Field products, squares, pairs;

  void add(PairSums&& other) {
    if (products.size() == 0) return void(*this = std::move(other));
    products += other.products, squares += other.squares, pairs += other.pairs;
  }
};

// Points first ≤ i < last along an axis.
struct Range {
  Index first, last;

  Index length() const { return last - first; }
};

// First points x.first ≤ i < x.last whose partners a lag apart lie in the field; from x.first on.
Range partnered(Range x, Index lag, Index n, bool periodic) {
  if (periodic) return {0, x.length()};
  const Index first = std::clamp(-lag - x.first, Index{0}, x.length());
  return {first, std::max(first, std::clamp(n - lag - x.first, Index{0}, x.length()))};
}

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

class LagWaves::Blocks {
 public:
  Blocks(const Field& d, const Grid& grid, Shape max_lag, Index along_x, Index along_y)
      : grid_(grid),
        max_lag_(max_lag),
        along_x_(along_x),
        along_y_(along_y),
        complete_(!d.isNaN().any()),
        filled_(complete_ ? Field() : zero_filled(d)),
        valid_(complete_ ? Field() : validity(d)),
        heights_(complete_ ? d : filled_),
        piece_{piece(largest(along_x, grid.shape.nx), max_lag.nx),
               piece(largest(along_y, grid.shape.ny), max_lag.ny)},
        torus_{fast_length(piece_.nx + 2 * max_lag.nx), fast_length(piece_.ny + 2 * max_lag.ny)},
        transform_(torus_) {}

  bool complete() const { return complete_; }
  // The waves at the middles of a block's pairs, a row a lag.
  AxisProducts waves(Index b, const std::vector<LongWaves::Wave>& all) const {
    auto along = [](Range block, Index n, bool periodic, Index most) {
      const double middle = 0.5 * static_cast<double>(block.first + block.last),
                   half = 0.5 * static_cast<double>(most);
      const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(2 * most + 1, middle - half, middle + half);
      return axis_waves(std::numbers::pi / static_cast<double>(n) * at, periodic, AxisWaves::most);
    };
    const auto [nx, ny] = grid_.shape;
    return {along(block(x_of(b), along_x_, nx), nx, grid_.periodic.x, max_lag_.nx),
            along(block(y_of(b), along_y_, ny), ny, grid_.periodic.y, max_lag_.ny), all};
  }
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
    PairSums out;
    for (Index i = x.first; i < x.last; i += piece_.nx)
      for (Index j = y.first; j < y.last; j += piece_.ny)
        out.add(sums({i, std::min(i + piece_.nx, x.last)}, {j, std::min(j + piece_.ny, y.last)}));
    return out;
  }

 private:
  PairSums sums(Range x, Range y) const {
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

  // Transforms of a piece and of its surroundings.
  struct Spectrum {
    AlignedVector<Complex> near, far;

    Spectrum(const Blocks& blocks, const Field& surroundings, Range x, Range y)
        : near(blocks.transformed(
              surroundings.block(blocks.max_lag_.nx, blocks.max_lag_.ny, x.length(), y.length()))),
          far(blocks.transformed(surroundings)) {}
  };

  static Range block(Index b, Index blocks, Index n) {
    auto end = [&](Index k) { return 2 * k <= blocks ? k * n / blocks : n - (blocks - k) * n / blocks; };
    return {end(b), end(b + 1)};
  }
  // Points of the largest block: one in the middle takes what both halves round off.
  static Index largest(Index blocks, Index n) {
    Index out = 0;
    for (Index b = 0; b < blocks; ++b) out = std::max(out, block(b, blocks, n).length());
    return out;
  }

  // Much longer than the lags: less memory, where these are short.
  static Index piece(Index points, Index lag) { return std::min(points, std::max<Index>(64, 16 * lag)); }

  // Of a piece and all partners of its points; zero beyond the field.
  Field surroundings(const Field& f, Range x, Range y) const {
    const auto [nx, ny] = grid_.shape;
    auto inside = [](Index i, Index n, bool periodic) { return periodic ? ((i % n) + n) % n : i; };
    const auto [p, q] = max_lag_;
    return Field::NullaryExpr(x.length() + 2 * p, y.length() + 2 * q, [&, p = p, q = q](Index i, Index j) {
      const Index row = inside(x.first + i - p, nx, grid_.periodic.x),
                  column = inside(y.first + j - q, ny, grid_.periodic.y);
      return row >= 0 && row < nx && column >= 0 && column < ny ? f(row, column) : 0.0;
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
               .topLeftCorner(2 * max_lag_.nx + 1, 2 * max_lag_.ny + 1) /
           static_cast<double>(torus_.cells());
  }
  // Pairs and squares of a complete field.
  void squares_of_rectangles(const Field& far, Range x, Range y, PairSums& out) const {
    const auto [nx, ny] = grid_.shape;
    const auto [P, Q] = max_lag_;
    const RectangleSums squares(far.square());
    out.pairs = out.squares = Field::Zero(2 * P + 1, 2 * Q + 1);
    for (Index p = -P; p <= P; ++p)
      for (Index q = -Q; q <= Q; ++q) {
        const Range i = partnered(x, p, nx, grid_.periodic.x), j = partnered(y, q, ny, grid_.periodic.y);
        const Index rows = i.length(), columns = j.length(), row = P + i.first, column = Q + j.first;
        out.pairs(P + p, Q + q) = static_cast<double>(rows * columns);
        if (rows * columns == 0) continue;
        out.squares(P + p, Q + q) =
            0.5 * (squares(row, column, rows, columns) + squares(row + p, column + q, rows, columns));
      }
  }

  Grid grid_;
  Shape max_lag_;
  Index along_x_, along_y_;
  bool complete_;
  Field filled_, valid_;
  const Field& heights_;
  Shape piece_, torus_;
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
  const Index along_x = mirrored_blocks(most_x, nx), along_y = mirrored_blocks(most_y, ny);
  const Blocks blocks(d, grid, max_lag, along_x, along_y);
  const Eigen::MatrixXd waves = directions(blocks, {{along_x, along_y}, 1, 1, grid.periodic});
  const Field none = Field::Zero(max_lag.nx + 1, 2 * max_lag.ny + 1);
  waves_.assign(static_cast<std::size_t>(waves.rows()) + 1, {none, none, none, none});
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
          const auto& [products, squares, pairs] = sums[static_cast<std::size_t>(b)];
          const Shape lags = shape_of(pairs);
          const Field u = k == 0 ? Field(Field::Ones(lags.nx, lags.ny))
                                 : blocks.waves(first + b, long_waves_.all())
                                       .combined(waves.row(k - 1).transpose(), 0, 0, lags);
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

Eigen::MatrixXd LagWaves::directions(const Blocks& blocks, const Grid& of_blocks) const {
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
