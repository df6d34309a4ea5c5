#include "plastic/layered_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

using stress::Component;

constexpr Index five = deviator::components;

std::vector<double> thicknesses(const std::vector<double>& edges) {
  std::vector<double> out;
  for (std::size_t k = 1; k < edges.size(); ++k) out.push_back(edges[k] - edges[k - 1]);
  return out;
}

// On which the cells do not act around, but along its periodic axes.
Shape torus_of(const Grid& cells) {
  const Shape padded = padded_torus(cells.shape);
  return {cells.periodic.x ? cells.shape.nx : padded.nx, cells.periodic.y ? cells.shape.ny : padded.ny};
}

double wave_number(Index k, Index n, double spacing) {
  return 2 * std::numbers::pi * static_cast<double>(k) / (static_cast<double>(n) * spacing);
}

}  // namespace

// Of a thread: eight rows of blocks, zero where nothing is put, and a group of values.
struct LayeredBody::Rows {
  explicit Rows(const LayeredBody& body)
      : blocks(size(body.rows_.blocks() * stride)),
        values(size(group * body.grid_.shape.ny)),
        work(body.rows_.work()) {}
  static constexpr Index group = RowTransform::rows, stride = group * block_columns;

  AlignedVector<Complex> blocks;
  AlignedVector<double> values;
  RowTransform::Work work;
};

// Of a thread, for one block of columns.
struct LayeredBody::Buffers {
  Buffers(const LayeredBody& body, Index fields)
      : columns(size(fields * body.transform_.block_size())),
        scratch(size(body.transform_.block_size())),
        pressure(size(body.transform_.block_size())),
        work(body.layers()) {}

  AlignedVector<Complex> columns, scratch, pressure;
  LayerWaves::Work work;
};

LayeredBody::LayeredBody(const Grid& cells, std::vector<double> edges, double shear_modulus, double poisson,
                         int threads)
    : grid_(cells),
      edges_(std::move(edges)),
      two_mu_(2 * shear_modulus),
      poisson_(poisson),
      threads_(threads),
      transform_(cells.shape, torus_of(cells)),
      rows_(transform_.torus().ny),
      columns_(transform_.torus().nx, block_columns),
      waves_(thicknesses(edges_), poisson),
      kernel_rows_(transform_.torus().nx / 2 + 1) {
  make_chunks();
}

void LayeredBody::make_chunks() {
  constexpr Index lanes = LayerWaves::lanes;
  const Index px = transform_.torus().nx;
  std::vector<std::pair<Index, double>> waves;  // place and sign
  if (px % 2 == 0) waves = {{px / 2, 1}, {px / 2, -1}};
  for (Index k = 0; k < px; ++k)
    if (2 * k != px) waves.emplace_back(k, 2 * k < px ? 1 : -1);
  for (std::size_t first = 0; first < waves.size(); first += size(lanes)) {
    Chunk& chunk = chunks_.emplace_back();
    chunk.nyquist = first == 0 && px % 2 == 0;
    chunk.places.count = std::min(lanes, static_cast<Index>(waves.size() - first));
    for (Index l = 0; l < lanes; ++l) {
      const auto [k, sign] = waves[first + size(std::min(l, chunk.places.count - 1))];
      const Index positive = std::min(k, px - k);
      chunk.places.at[size(l)] = k;
      chunk.at[size(l)] = positive;
      chunk.sign[l] = sign;
      chunk.qx[l] = sign * wave_number(positive, px, grid_.dx);
    }
  }
}

// When it is first needed.
void LayeredBody::make_pressed() {
  if (!pressed_.empty()) return;
  pressed_.assign(size(transform_.columns() * layers() * five * kernel_rows_), 0);
  const Resolution resolution({grid_, Field::Zero(grid_.shape.nx, grid_.shape.ny), poisson_}, 1, threads_);
  const auto influence =
      make_layer_influence(resolution, poisson_, stress::Tractions().set(stress::normal), threads_);
  const double gauss = 0.5 / std::sqrt(3.0);
  for (Index k = 0; k < layers(); ++k)
    for (const double at : {0.5 - gauss, 0.5 + gauss}) {
      influence->set_depth(edges_[size(k)] + at * thickness(k), stress::all);
      add_kernel(*influence, k);
    }
}

void LayeredBody::add_kernel(LayerInfluence& influence, Index k) {
  for (Component c : stress::components) {
    influence.set_component(c);
    const auto weights = deviator::of(c);
    const double half = c == stress::xy ? -0.5 : 0.5;  // where the waves are real
    parallel_ranges(transform_.blocks(), threads_, [&](Index begin, Index end, int worker) {
      for (Index b = begin; b < end; ++b) {
        const auto kernel = influence.transfer_function(stress::normal, b, worker);
        const auto* numbers = reinterpret_cast<const double*>(kernel.pairs.data());
        for (Index ky = b * block_columns; ky < end_of(b); ++ky)
          for (Index d = 0; d < five; ++d) {
            if (weights[size(d)] == 0) continue;
            const Index column = ky % block_columns;
            const double* of = numbers + column / 2 * kernel.stride * 2 + column % 2;
            float* to = pressed(ky, k, d);
            for (Index kx = 0; kx < kernel_rows_; ++kx)
              to[kx] += static_cast<float>(half * weights[size(d)] * of[2 * kx]);
          }
      }
    });
  }
}

void LayeredBody::set_strain(const LayeredField& strain) {
  strain_ = &strain;
  loaded_.count = 0;
}

std::vector<Extent> LayeredBody::groups(Index components) const {
  const auto block_bytes =
      static_cast<double>(layers() * components * grid_.shape.nx * block_columns) * sizeof(Complex);
  const Index blocks = transform_.blocks(),
              count = std::clamp<Index>(
                  static_cast<Index>(std::ceil(block_bytes * static_cast<double>(blocks) / most_spectra)), 1,
                  blocks);
  std::vector<Extent> out;
  for (Index g = 0; g < count; ++g)
    out.push_back({g * blocks / count, (g + 1) * blocks / count - g * blocks / count});
  return out;
}

// visit(layer and component n, first row, how many, buffers) on all threads.
template <class Visit>
void LayeredBody::each_group(Index fields, Visit visit) {
  parallel_ranges(fields, threads_, [&](Index begin, Index end, int) {
    Rows rows(*this);
    for (Index n = begin; n < end; ++n)
      for (Index i = 0; i < grid_.shape.nx; i += Rows::group)
        visit(n, i, std::min(Rows::group, grid_.shape.nx - i), rows);
  });
}

// The strain's rows, transformed in y, for these blocks.
void LayeredBody::load(Extent blocks, Index components) {
  if (loaded_ == blocks && components == components_) return;
  loaded_ = blocks;
  components_ = components;
  const auto [nx, ny] = grid_.shape;
  if (const std::size_t points = size(layers() * components_ * spectrum_size()); points > spectra_.size()) {
    spectra_ = AlignedVector<Complex>();  // not kept beside the larger ones
    spectra_.resize(points);
  }
  each_group(layers() * five, [&, nx = nx, ny = ny](Index n, Index i, Index count, Rows& rows) {
    const Index k = n / five, c = n % five;
    rows_.forward((*strain_)(k, c).data() + i * ny, ny, ny, count, rows.blocks.data(), rows.stride,
                  rows.work);
    for (Index b = 0; b < blocks.count; ++b)
      std::copy_n(rows.blocks.data() + (blocks.first + b) * rows.stride, count * block_columns,
                  spectrum(k, c) + (b * nx + i) * block_columns);
  });
}

// What load() and respond() have made of these blocks, back in the rows, which are added to the stress.
void LayeredBody::add_rows(Extent blocks, LayeredField& out) {
  const auto [nx, ny] = grid_.shape;
  each_group(layers() * components_, [&, nx = nx, ny = ny](Index n, Index i, Index count, Rows& rows) {
    const Index k = n / components_, c = n % components_;
    for (Index b = 0; b < blocks.count; ++b)
      std::copy_n(spectrum(k, c) + (b * nx + i) * block_columns, count * block_columns,
                  rows.blocks.data() + (blocks.first + b) * rows.stride);
    rows_.inverse(rows.blocks.data(), rows.stride, count, ny, rows.values.data(), ny, rows.work);
    out(k, c).middleRows(i, count) += Eigen::Map<Field>(rows.values.data(), count, ny);
  });
}

Field LayeredBody::displacement() {
  make_pressed();
  auto half = transform_.half_spectrum();
  for (const Extent blocks : groups(five)) {
    load(blocks, five);
    parallel_ranges(blocks.count, threads_, [&](Index begin, Index end, int) {
      Buffers buffers(*this, 1);
      for (Index b = begin; b < end; ++b) {
        sum_displacement(b, blocks.first + b, buffers);
        transform_.inverse_block(buffers.pressure.data(), blocks.first + b, half, buffers.scratch.data());
      }
    });
  }
  Field out(grid_.shape.nx, grid_.shape.ny);
  transform_.inverse_rows(half, out, threads_);
  return out;
}

// The spectrum of the displacement in a block, the b-th loaded one.
void LayeredBody::sum_displacement(Index b, Index block, Buffers& buffers) {
  const Shape torus = transform_.torus();
  std::ranges::fill(buffers.pressure, Complex{});
  for (Index k = 0; k < layers(); ++k)
    for (Index c = 0; c < five; ++c) {
      forward_columns(spectrum(k, c) + b * grid_.shape.nx * block_columns, buffers.columns.data(),
                      buffers.scratch.data());
      const double scale = thickness(k) / static_cast<double>(torus.cells()),
                   odd = deviator::odd_in_x(c) ? -1 : 1;
      const Complex turn = c == 3 || c == 4 ? Complex(0, scale) : scale;
      for (Index ky = block * block_columns; ky < end_of(block); ++ky) {
        const Index column = ky % block_columns * transform_.stride();
        const float* kernel = pressed(ky, k, c);
        for (Index kx = 0; kx < torus.nx; ++kx) {
          const double weight = 2 * kx > torus.nx ? odd * kernel[torus.nx - kx] : kernel[kx];
          buffers.pressure[size(column + kx)] += weight * turn * buffers.columns[size(column + kx)];
        }
      }
    }
}

void LayeredBody::stress(const Field* pressure, LayeredField& out) {
  if (pressure != nullptr) make_pressed();
  auto half = transform_.half_spectrum();
  if (pressure != nullptr) transform_.forward_rows(*pressure, half, threads_);
  out.values.setZero();
  for (const Extent blocks : groups(out.components())) {
    load(blocks, out.components());
    parallel_ranges(blocks.count, threads_, [&](Index begin, Index end, int) {
      Buffers buffers(*this, layers() * components_);
      for (Index b = begin; b < end; ++b) {
        if (pressure != nullptr)
          transform_.forward_block(half, blocks.first + b, buffers.pressure.data(), buffers.scratch.data());
        respond_block(b, blocks.first + b, pressure != nullptr, buffers);
      }
    });
    add_rows(blocks, out);
    loaded_.count = 0;
  }
  take_off_images(grid_, transform_.torus(), waves_, two_mu_, *strain_, out, threads_);
}

// The stress in a block, the b-th loaded one, in place of the strain.
void LayeredBody::respond_block(Index b, Index block, bool pressed, Buffers& buffers) {
  auto columns = [&](Index n) { return buffers.columns.data() + n * transform_.block_size(); };
  auto rows = [&](Index n) {
    return spectrum(n / components_, n % components_) + b * grid_.shape.nx * block_columns;
  };
  for (Index n = 0; n < layers() * components_; ++n)
    if (n % components_ < five) forward_columns(rows(n), columns(n), buffers.scratch.data());
  for (Index ky = block * block_columns; ky < end_of(block); ++ky) {
    const Index column = ky % block_columns * transform_.stride();
    respond(ky, column, pressed ? buffers.pressure.data() + column : nullptr, buffers);
  }
  for (Index n = 0; n < layers() * components_; ++n) {
    columns_.inverse(columns(n), buffers.scratch.data());
    rows_from_columns<block_columns>(buffers.scratch.data(), columns_.stride(), grid_.shape.nx, rows(n));
  }
}

void LayeredBody::forward_columns(const Complex* rows, Complex* columns, Complex* scratch) const {
  const Index nx = grid_.shape.nx;
  columns_from_rows<block_columns>(rows, nx, scratch, columns_.stride());
  for (Index c = 0; c < block_columns; ++c)
    std::fill(scratch + c * columns_.stride() + nx, scratch + c * columns_.stride() + columns_.points(),
              Complex{});
  columns_.forward(scratch, columns);
}

// The stress of a column of waves, in place of the strain.
void LayeredBody::respond(Index ky, Index column, const Complex* pressure, Buffers& buffers) {
  LayerWaves::Work& work = buffers.work;
  const Lanes qy = Lanes::Constant(wave_number(ky, transform_.torus().ny, grid_.dy)),
              factor = Lanes::Constant(two_mu_ / static_cast<double>(transform_.torus().cells()));
  auto spectrum_of = [&](Index k, Index c) {
    return buffers.columns.data() + (k * components_ + c) * transform_.block_size() + column;
  };
  for (const Chunk& chunk : chunks_) {
    waves_.prepare(chunk.qx, qy, work);
    waves_.respond(work, chunk.places, factor, components_ > five, spectrum_of, [&](int part) {
      if (pressure != nullptr) add_pressed(chunk, ky, part, pressure, work);
      if (!chunk.nyquist) return;
      for (Lanes& x : work.x) x[0] = x[1] = 0.5 * (x[0] + x[1]);
      for (Lanes& x : work.mean) x[0] = x[1] = 0.5 * (x[0] + x[1]);
    });
  }
}

void LayeredBody::add_pressed(const Chunk& chunk, Index ky, int part, const Complex* pressure,
                              LayerWaves::Work& work) {
  Lanes p;
  LayerWaves::load(part, 0, chunk.places, pressure, p);
  p /= static_cast<double>(transform_.torus().cells());
  const Lanes odd = chunk.sign * p;
  for (Index k = 0; k < layers(); ++k)
    for (Index c = 0; c < five; ++c) {
      const float* kernel = pressed(ky, k, c);
      const Lanes& load = deviator::odd_in_x(c) ? odd : p;
      Lanes& x = work.of(k, c);
      for (Index l = 0; l < LayerWaves::lanes; ++l) x[l] += double{kernel[chunk.at[size(l)]]} * load[l];
    }
}

Field surface_displacement(const Grid& grid, Index i, Index j, const std::vector<double>& edges,
                           double poisson, const LayeredField& strain, int threads) {
  const auto [nx, ny] = strain.shape();
  Field out = Field::Zero(grid.shape.nx, grid.shape.ny);
  LayeredField layer(1, five, grid.shape);
  for (Index k = 0; k < strain.layers(); ++k) {
    for (Index c = 0; c < five; ++c) layer(0, c).block(i, j, nx, ny) = strain(k, c);
    if ((layer.values == 0).all()) continue;
    LayeredBody body(grid, {edges[size(k)], edges[size(k + 1)]}, 1, poisson, threads);
    body.set_strain(layer);
    out += body.displacement();
  }
  return out;
}

}  // namespace asperity
