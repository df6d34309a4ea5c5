#include "transform/convolution.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "transform/mirrored.hpp"

namespace asperity {
namespace {

constexpr Index width = PrunedTransform::width;

// Below this many cells a thread costs more than it saves.
constexpr Index cells_worth_a_thread = 128 * 128;

int useful_threads(Shape field, int threads) { return field.cells() < cells_worth_a_thread ? 1 : threads; }

// Even sequences s = 0 … count-1 of this period, eight at a time: read(s, j) gives, write(s, k, value) takes.
template <class Read, class Write>
void transform_even(Index period, Index count, int threads, Read read, Write write) {
  const MirroredTransform transform(period);
  constexpr Index pairs = MirroredTransform::pairs, eight = MirroredTransform::width;
  parallel_ranges((count + eight - 1) / eight, threads, [&](Index begin, Index end, int) {
    AlignedVector<Complex> x(size(transform.size())), spectrum(x.size());
    auto at = [&](AlignedVector<Complex>& v, Index pair, Index j) -> Complex& {
      return v[size(pair * transform.stride() + j)];
    };
    for (Index first = begin * eight; first < std::min(end * eight, count); first += eight) {
      auto of_pair = [&](Index pair) { return std::min(first + 2 * pair, count - 1); };
      for (Index j = 0; j <= period / 2; ++j)
        for (Index c = 0; c < pairs; ++c)
          at(x, c, j) = {read(of_pair(c), j), read(std::min(of_pair(c) + 1, count - 1), j)};
      transform.apply(Parity::even, x.data(), period / 2 + 1, spectrum.data());
      for (Index k = 0; k <= period / 2; ++k)
        for (Index c = 0; c < pairs && first + 2 * c < count; ++c) {
          write(of_pair(c), k, at(spectrum, c, k).real());
          if (of_pair(c) + 1 < count) write(of_pair(c) + 1, k, at(spectrum, c, k).imag());
        }
    }
  });
}

}  // namespace

Shape padded_torus(Shape field) {
  return {fast_length(2 * field.nx - 1, 2), fast_length(2 * field.ny - 1, 2)};
}

Field even_transfer_function(Shape torus, const std::function<double(Index, Index)>& kernel, int threads) {
  Field symbol(torus.nx / 2 + 1, torus.ny / 2 + 1);
  transform_even(torus.ny, symbol.rows(), threads, kernel,
                 [&](Index i, Index k, double value) { symbol(i, k) = value; });
  transform_even(
      torus.nx, symbol.cols(), threads, [&](Index j, Index i) { return symbol(i, j); },
      [&](Index j, Index k, double value) { symbol(k, j) = value; });
  return symbol;
}

EvenConvolution::EvenConvolution(Shape field, Shape torus, const Field& symbol, int threads,
                                 std::shared_ptr<HalfSpectrum> work)
    : transform_(field, torus),
      half_(work ? std::move(work) : std::make_shared<HalfSpectrum>()),
      threads_(useful_threads(field, threads)) {
  const std::size_t room = size(transform_.blocks() * field.nx * width);
  if (half_->size() < room) *half_ = HalfSpectrum(room);
  const Index rows = torus.nx / 2 + 1;
  symbol_.resize(size(transform_.blocks() * rows * width));
  const double scale = 1.0 / static_cast<double>(torus.cells());
  for (Index k = 0; k < transform_.columns(); ++k)
    for (Index i = 0; i < rows; ++i) symbol_[size(k * rows + i)] = scale * symbol(i, k);
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
  transform_.filter(*half_, threads_, [this](Index b, Complex* block) { multiply(b, block); });
  out.resize(shape().nx, shape().ny);
  transform_.inverse_rows(*half_, out, threads_);
}

}  // namespace asperity
