#include "transform/convolution.hpp"

#include <algorithm>

#include "grid/parallel.hpp"

namespace asperity {
namespace {

constexpr Index width = PrunedTransform::width;

// Below this many cells a thread costs more than it saves.
constexpr Index cells_worth_a_thread = 128 * 128;

int useful_threads(Shape field, int threads) { return field.cells() < cells_worth_a_thread ? 1 : threads; }

}  // namespace

Shape padded_torus(Shape field) {
  return {fast_length(2 * field.nx - 1, 2), fast_length(2 * field.ny - 1, 2)};
}

Field even_symbol(Shape torus, const std::function<double(Index, Index)>& kernel) {
  const EvenTransform2D transform(torus);
  const Shape quarter = transform.quarter();
  Field symbol(quarter.nx, quarter.ny);
  for (Index i = 0; i < quarter.nx; ++i)
    for (Index j = 0; j < quarter.ny; ++j) symbol(i, j) = kernel(i, j);
  AlignedVector<double> data(symbol.data(), symbol.data() + symbol.size());
  transform.apply(data.data());
  std::copy(data.begin(), data.end(), symbol.data());
  return symbol;
}

EvenConvolution::EvenConvolution(Shape field, Shape torus, const Field& symbol, int threads,
                                 std::shared_ptr<HalfSpectrum> work)
    : transform_(field, torus),
      half_(work ? std::move(work) : std::make_shared<HalfSpectrum>()),
      threads_(useful_threads(field, threads)) {
  const auto room = static_cast<std::size_t>(transform_.blocks() * field.nx * width);
  if (half_->size() < room) *half_ = HalfSpectrum(room);
  const Index rows = torus.nx / 2 + 1;
  symbol_.resize(static_cast<std::size_t>(transform_.blocks() * rows * width));
  const double scale = 1.0 / static_cast<double>(torus.cells());
  for (Index k = 0; k < transform_.columns(); ++k)
    for (Index i = 0; i < rows; ++i) symbol_[static_cast<std::size_t>(k * rows + i)] = scale * symbol(i, k);
}

void EvenConvolution::multiply(Index b, Complex* block) const {
  const Index nx = transform_.torus().nx, rows = nx / 2 + 1;
  for (Index q = 0; q < width; ++q) {
    const double* s = symbol_.data() + (b * width + q) * rows;
    Complex* x = block + q * transform_.stride();
    for (Index i = 0; i < rows; ++i) x[i] *= s[i];
    for (Index i = rows; i < nx; ++i) x[i] *= s[nx - i];
  }
}

void EvenConvolution::apply(const Field& in, Field& out) {
  transform_.forward_rows(in, *half_, threads_);
  parallel_ranges(transform_.blocks(), threads_, [&](Index begin, Index end, int) {
    AlignedVector<Complex> block(static_cast<std::size_t>(transform_.block_size())), work(block.size());
    for (Index b = begin; b < end; ++b) {
      transform_.forward_block(*half_, b, block.data(), work.data());
      multiply(b, block.data());
      transform_.inverse_block(block.data(), b, *half_, work.data());
    }
  });
  out.resize(shape().nx, shape().ny);
  transform_.inverse_rows(*half_, out, threads_);
}

}  // namespace asperity
