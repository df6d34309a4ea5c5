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

// Of a component of the stress in those of the deviator, where the waves are real.
constexpr std::array<double, 5> deviator_weights(Component c) {
  constexpr double half = 0.70710678118654752440, sixth = 0.40824829046386301637, two = 2 * half;
  switch (c) {
    case stress::xx:
      return {half, -sixth, 0, 0, 0};
    case stress::yy:
      return {-half, -sixth, 0, 0, 0};
    case stress::zz:
      return {0, 2 * sixth, 0, 0, 0};
    case stress::xy:
      return {0, 0, -two, 0, 0};
    case stress::xz:
      return {0, 0, 0, two, 0};
    default:
      return {0, 0, 0, 0, two};
  }
}

}  // namespace

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
      waves_(thicknesses(edges_), poisson),
      images_(cells, transform_.torus(), waves_),
      kernel_rows_(transform_.torus().nx / 2 + 1) {
  make_chunks();
  make_pressed();
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

void LayeredBody::make_pressed() {
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
    const auto weights = deviator_weights(c);
    parallel_ranges(transform_.blocks(), threads_, [&](Index begin, Index end, int worker) {
      for (Index b = begin; b < end; ++b) {
        const auto kernel = influence.transfer_function(stress::normal, b, worker);
        const auto* numbers = reinterpret_cast<const double*>(kernel.pairs.data());
        for (Index ky = b * block_columns; ky < std::min((b + 1) * block_columns, transform_.columns()); ++ky)
          for (Index d = 0; d < five; ++d) {
            if (weights[size(d)] == 0) continue;
            const Index column = ky % block_columns;
            const double* of = numbers + column / 2 * kernel.stride * 2 + column % 2;
            float* to = pressed(ky, k, d);
            for (Index kx = 0; kx < kernel_rows_; ++kx)
              to[kx] += static_cast<float>(0.5 * weights[size(d)] * of[2 * kx]);
          }
      }
    });
  }
}

void LayeredBody::set_strain(const LayeredField& strain) {
  strain_ = &strain;
  transform_rows(strain);
}

void LayeredBody::transform_rows(const LayeredField& strain) {
  const Index ny = grid_.shape.ny;
  spectra_.resize(size(layers() * components_ * transform_.half_size()));
  parallel_ranges(layers() * five, threads_, [&](Index begin, Index end, int) {
    for (Index n = begin; n < end; ++n) {
      const auto values = strain(n / five, n % five);
      transform_.forward_each_row([&](Index i, double* row) { std::copy_n(values.data() + i * ny, ny, row); },
                                  spectrum(n / five, n % five));
    }
  });
}

Field LayeredBody::displacement() {
  auto half = transform_.half_spectrum();
  const Shape torus = transform_.torus();
  const double scale = 1 / static_cast<double>(torus.cells());
  parallel_ranges(transform_.blocks(), threads_, [&](Index begin, Index end, int) {
    AlignedVector<Complex> block(size(transform_.block_size())), scratch(block.size()), sum(block.size());
    for (Index b = begin; b < end; ++b) {
      std::ranges::fill(sum, Complex{});
      for (Index k = 0; k < layers(); ++k)
        for (Index c = 0; c < five; ++c) {
          transform_.forward_block(spectrum(k, c), b, block.data(), scratch.data());
          for (Index ky = b * block_columns; ky < std::min((b + 1) * block_columns, transform_.columns());
               ++ky) {
            const Index column = ky % block_columns * transform_.stride();
            const float* kernel = pressed(ky, k, c);
            const Complex turn = c == 3 || c == 4 ? Complex(0, scale * thickness(k)) : scale * thickness(k);
            const double odd = deviator::odd_in_x(c) ? -1 : 1;
            for (Index kx = 0; kx < torus.nx; ++kx) {
              const double weight = 2 * kx > torus.nx ? odd * kernel[torus.nx - kx] : kernel[kx];
              sum[size(column + kx)] += weight * turn * block[size(column + kx)];
            }
          }
        }
      transform_.inverse_block(sum.data(), b, half, scratch.data());
    }
  });
  Field out(grid_.shape.nx, grid_.shape.ny);
  transform_.inverse_rows(half, out, threads_);
  return out;
}

void LayeredBody::stress(const Field* pressure, LayeredField& out) {
  const bool with_mean = out.components() > five;
  if (with_mean != (components_ > five)) {
    components_ = out.components();
    transform_rows(*strain_);
  }
  auto half = transform_.half_spectrum();
  if (pressure != nullptr) transform_.forward_rows(*pressure, half, threads_);
  parallel_ranges(transform_.blocks(), threads_, [&](Index begin, Index end, int) {
    Buffers buffers(*this, layers() * components_);
    auto block = [&](Index n) { return buffers.columns.data() + n * transform_.block_size(); };
    for (Index b = begin; b < end; ++b) {
      for (Index n = 0; n < layers() * components_; ++n)
        if (n % components_ < five)
          transform_.forward_block(spectrum(n / components_, n % components_), b, block(n),
                                   buffers.scratch.data());
      if (pressure != nullptr)
        transform_.forward_block(half, b, buffers.pressure.data(), buffers.scratch.data());
      for (Index ky = b * block_columns; ky < std::min((b + 1) * block_columns, transform_.columns()); ++ky) {
        const Index column = ky % block_columns * transform_.stride();
        respond(ky, column, pressure ? buffers.pressure.data() + column : nullptr, buffers);
      }
      for (Index n = 0; n < layers() * components_; ++n)
        transform_.inverse_block(block(n), b, spectrum(n / components_, n % components_),
                                 buffers.scratch.data());
    }
  });
  transform_back(out);
  images_.take_off(*strain_, out, two_mu_);
}

// The stress of a column of waves, in place of the strain.
void LayeredBody::respond(Index ky, Index column, const Complex* pressure, Buffers& buffers) const {
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
                              LayerWaves::Work& work) const {
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

void LayeredBody::transform_back(LayeredField& out) {
  constexpr Index group = RowTransform::rows;
  const auto [nx, ny] = grid_.shape;
  parallel_ranges(layers() * components_, threads_, [&, nx = nx, ny = ny](Index begin, Index end, int) {
    auto work = transform_.row_work();
    for (Index n = begin; n < end; ++n) {
      const auto half = spectrum(n / components_, n % components_);
      double* to = out(n / components_, n % components_).data();
      for (Index i = 0; i < nx; i += group)
        transform_.inverse_group(half, i, std::min(group, nx - i), ny, to + i * ny, ny, work);
    }
  });
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
