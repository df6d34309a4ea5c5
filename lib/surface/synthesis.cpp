#include "surface/synthesis.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "transform/pruned.hpp"

namespace asperity {
namespace {

// Tiles in a band: enough that threads which share them unevenly lose little, and heights enough that
// starting the threads costs nothing against them.
constexpr Index tiles_a_thread = 4, heights_worth_a_band = 1 << 18;

// Rows of a torus that a sink gets at a time.
constexpr Index rows_at_a_time = 128;

Index ceiling(Index a, Index b) { return (a + b - 1) / b; }

void require_points(Shape surface) {
  if (surface.nx < 1 || surface.ny < 1) throw ParameterError("shape", "a surface needs at least 1x1 points");
}

// Megabytes, or kilobytes below ten of them, that suffice.
std::string shown(std::size_t bytes) {
  auto whole = [&](std::size_t unit) { return std::to_string((bytes + unit - 1) / unit); };
  return bytes < 10000000 ? whole(1000) + "kB" : whole(1000000) + "MB";
}

}  // namespace

Synthesis::Synthesis(Field kernel, Shape surface, Options options)
    : kernel_(std::move(kernel)), surface_(surface), options_(std::move(options)) {
  require_points(surface);
  if (kernel_.size() == 0) throw ParameterError("kernel", "it has no coefficients");
  if (options_.summation == Summation::cheapest) {
    const SynthesisCost cost = synthesis_cost(shape_of(kernel_), surface);
    options_.summation = cost.direct <= cost.transform ? Summation::direct : Summation::transform;
  }
  const bool direct = options_.summation == Summation::direct;
  filter_ = direct ? direct_filter(kernel_, surface) : transform_filter(kernel_, surface);
  choose_band();
}

std::size_t Synthesis::bytes(Index strips, int threads) const {
  const Index rows = strips * filter_.tile.nx;
  const Index values = (rows + kernel_.rows() - 1) * noise_columns() + rows * surface_.ny;
  return options_.memory_elsewhere + size(values) * sizeof(double) + filter_.shared_bytes +
         size(threads) * filter_.worker_bytes;
}

void Synthesis::choose_band() {
  const std::size_t least = bytes(1, 1);
  if (least > options_.memory)
    throw ParameterError("memory", shown(options_.memory) +
                                       " does not hold one strip of this surface: " + shown(least) + " do");
  while (bytes(1, options_.threads) > options_.memory) options_.threads -= 1;
  const Shape tile = filter_.tile;
  const Index busy = ceiling(tiles_a_thread * options_.threads, ceiling(surface_.ny, tile.ny)),
              worthwhile = ceiling(heights_worth_a_band, tile.nx * surface_.ny);
  strips_ = std::min(std::max(busy, worthwhile), ceiling(surface_.nx, tile.nx));
  while (strips_ > 1 && bytes(strips_, options_.threads) > options_.memory) strips_ -= 1;
}

// Rows first, first + 1, … of the noise, which repeats along both axes of a periodic surface.
void Synthesis::draw(const WhiteNoise& noise, Index first, Eigen::Ref<Field> rows) const {
  const Index drawn = options_.periodic ? std::min(surface_.ny, rows.cols()) : rows.cols();
  parallel_ranges(rows.rows(), options_.threads, [&](Index begin, Index end, int) {
    WhiteNoise source(noise);
    for (Index i = begin; i < end; ++i) {
      source.row(options_.periodic ? (first + i) % surface_.nx : first + i, {&rows(i, 0), size(drawn)});
      for (Index j = drawn; j < rows.cols(); ++j) rows(i, j) = rows(i, j - drawn);
    }
  });
}

// A band of noise into the heights above it, tile by tile.
void Synthesis::filter(const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out) const {
  const Shape tile = filter_.tile;
  const Index across = ceiling(out.cols(), tile.ny), tiles = across * ceiling(out.rows(), tile.nx);
  parallel_ranges(tiles, options_.threads, [&](Index begin, Index end, int) {
    const TileWorker worker = filter_.worker();
    for (Index t = begin; t < end; ++t) {
      const Index i = t / across * tile.nx, j = t % across * tile.ny;
      const Index rows = std::min(tile.nx, out.rows() - i), columns = std::min(tile.ny, out.cols() - j);
      Eigen::Ref<Field> heights = out.block(i, j, rows, columns);
      worker(noise.block(i, j, rows + kernel_.rows() - 1, columns + kernel_.cols() - 1), heights);
      if (options_.translation)
        for (Index row = 0; row < rows; ++row) options_.translation({&heights(row, 0), size(columns)});
    }
  });
}

// Into `room` for a band, or for the whole surface.
void Synthesis::bands(const WhiteNoise& noise, Eigen::Ref<Field> room, const RowSink& sink) const {
  const Index overlap = kernel_.rows() - 1, most = std::min(band_rows(), surface_.nx);
  Field rows(most + overlap, noise_columns());
  draw(noise, 0, rows.topRows(overlap));
  for (Index first = 0; first < surface_.nx; first += most) {
    const Index count = std::min(most, surface_.nx - first);
    draw(noise, first + overlap, rows.middleRows(overlap, count));
    Eigen::Ref<Field> heights = room.middleRows(first % room.rows(), count);
    filter(rows.topRows(count + overlap), heights);
    if (sink) sink(first, heights);
    for (Index i = 0; i < overlap; ++i) rows.row(i) = rows.row(i + count);
  }
}

void Synthesis::surface(const WhiteNoise& noise, const RowSink& sink) const {
  if (root_) {
    Field band(std::min(rows_at_a_time, surface_.nx), surface_.ny);
    return torus_rows(noise, band, sink);
  }
  Field band(std::min(band_rows(), surface_.nx), surface_.ny);
  bands(noise, band, sink);
}

Field Synthesis::surface(const WhiteNoise& noise) const {
  Field out(surface_.nx, surface_.ny);
  root_ ? torus_rows(noise, out, {}) : bands(noise, out, {});
  return out;
}

void Synthesis::noise_below(const WhiteNoise& noise, const RowSink& sink) const {
  if (root_) return noise_of_torus(noise, sink);
  const Index middle_x = (kernel_.rows() - 1) / 2, middle_y = (kernel_.cols() - 1) / 2;
  const Index most = std::min(band_rows(), surface_.nx);
  Field rows(most, noise_columns());
  for (Index first = 0; first < surface_.nx; first += most) {
    const Index count = std::min(most, surface_.nx - first);
    draw(noise, first + middle_x, rows.topRows(count));
    sink(first, rows.block(0, middle_y, count, surface_.ny));
  }
}

// ---- on a torus ----

namespace {

// The columns from `first` on, around the torus.
void corner_of(const Eigen::Ref<const Field>& circles, Index first, Eigen::Ref<Field> out) {
  const Index turned = std::min(out.cols(), circles.cols() - first);
  out.leftCols(turned) = circles.middleCols(first, turned);
  out.rightCols(out.cols() - turned) = circles.leftCols(out.cols() - turned);
}

}  // namespace

Synthesis::Synthesis(SpectralRoot root, double rms, Shape surface, Options options)
    : surface_(surface), options_(std::move(options)) {
  require_points(surface);
  if (surface.nx > root.torus.nx || surface.ny > root.torus.ny)
    throw ParameterError("shape",
                         text(surface) + ": larger than the torus of the kernel, " + text(root.torus));
  options_.summation = Summation::transform;
  const double scale = rms / static_cast<double>(root.torus.cells());
  for (double& value : root.values) value *= scale;
  root_ = std::make_shared<const SpectralRoot>(std::move(root));
  filter_.tile = {std::min(rows_at_a_time, surface.nx), surface.ny};
  if (torus_bytes() > options_.memory)
    throw ParameterError("memory", shown(options_.memory) + " does not hold the torus of this surface: " +
                                       shown(torus_bytes()) + " do");
}

Shape Synthesis::middle() const { return {(root_->torus.nx - 1) / 2, (root_->torus.ny - 1) / 2}; }

std::size_t Synthesis::torus_bytes() const {
  const auto [rows, columns] = root_->torus;
  return options_.memory_elsewhere + root_->values.size() * sizeof(double) +
         size(rows * (columns / 2 + PrunedTransform::width)) * sizeof(Complex) +
         size(filter_.tile.cells()) * sizeof(double);
}

void Synthesis::torus_rows(const WhiteNoise& noise, Field& room, const RowSink& sink) const {
  constexpr Index group = RowTransform::rows;
  const Shape torus = root_->torus, lag_zero = middle();
  const PrunedTransform transform(torus, torus);
  HalfSpectrum half = transform.half_spectrum();
  transform.forward_each_row(
      [&](Index i, double* row) {
        WhiteNoise(noise).row(i, {row, size(torus.ny)});
      },
      half, options_.threads);
  transform.filter(half, options_.threads, [&](Index b, Complex* block) {
    for (Index c = 0; c < std::min(transform.width, transform.columns() - b * transform.width); ++c) {
      const double* root = root_->column(b * transform.width + c);
      for (Index i = 0; i < torus.nx; ++i) block[c * transform.stride() + i] *= root[i];
    }
  });
  const Index most = room.rows();
  for (Index first = 0; first < surface_.nx; first += most) {
    const Index count = std::min(most, surface_.nx - first);
    parallel_ranges((count + group - 1) / group, options_.threads, [&](Index begin, Index end, int) {
      RowTransform::Work work = transform.row_work();
      Field circles(group, torus.ny);
      for (Index i = begin * group, n = 0; i < std::min(end * group, count); i += n) {
        const Index from = (first + i + lag_zero.nx) % torus.nx;
        n = std::min({group - i % group, count - i, torus.nx - from});
        transform.inverse_group(half, from, n, torus.ny, circles.data(), torus.ny, work);
        corner_of(circles.topRows(n), lag_zero.ny, room.middleRows(i, n));
      }
      if (!options_.translation) return;
      for (Index i = begin * group; i < std::min(end * group, count); ++i)
        options_.translation({&room(i, 0), size(surface_.ny)});
    });
    if (sink) sink(first, room.topRows(count));
  }
}

void Synthesis::noise_of_torus(const WhiteNoise& noise, const RowSink& sink) const {
  const Shape torus = root_->torus, lag_zero = middle();
  Field circle(1, torus.ny), row(1, surface_.ny);
  for (Index i = 0; i < surface_.nx; ++i) {
    WhiteNoise(noise).row((i + lag_zero.nx) % torus.nx, {circle.data(), size(torus.ny)});
    corner_of(circle, lag_zero.ny, row);
    sink(i, row);
  }
}

}  // namespace asperity
