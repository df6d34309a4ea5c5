#include "transform/convolution.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

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

namespace {

// Single precision has a short range: its numbers count in the largest. Doubles stay as they are.
template <class Real, class Number>
double unit_of(const Number* numbers, Index count, int threads) {
  if constexpr (std::is_same_v<Real, double>) return 1;
  std::vector<double> parts(size(std::max(threads, 1)));
  parallel_ranges(count, threads, [&](Index begin, Index end, int thread) {
    if (begin == end) return;
    const Eigen::Map<const Eigen::ArrayX<Number>> run(numbers + begin, end - begin);
    parts[size(thread)] = static_cast<double>(run.abs().maxCoeff());
  });
  const double largest = *std::max_element(parts.begin(), parts.end());
  return std::isnormal(largest) ? largest : 1;
}

}  // namespace

template <class Real>
BasicEvenConvolution<Real>::BasicEvenConvolution(Shape field, Shape torus, const Field& symbol, int threads,
                                                 WorkSpace work)
    : transform_(field, torus),
      unit_(unit_of<Real>(symbol.data(), symbol.size(), threads)),
      work_(work ? std::move(work) : std::make_shared<WorkSpace::element_type>()),
      threads_(useful_threads(field, threads)) {
  const Index rows = torus.nx / 2 + 1;
  symbol_.resize(size(transform_.blocks() * rows * width));
  const double scale = 1.0 / (unit_ * static_cast<double>(torus.cells()));
  for (Index k = 0; k < transform_.columns(); ++k)
    for (Index i = 0; i < rows; ++i) symbol_[size(k * rows + i)] = static_cast<Real>(scale * symbol(i, k));
  half_spectrum();
}

template <class Real>
template <class Other>
BasicEvenConvolution<Real>::BasicEvenConvolution(const BasicEvenConvolution<Other>& other)
    : transform_(other.transform_.field(), other.transform_.torus()),
      unit_(other.unit_),
      work_(other.work_),
      threads_(other.threads_) {
  const double unit = unit_of<Real>(other.symbol_.data(), std::ssize(other.symbol_), threads_);
  unit_ *= unit;
  symbol_.reserve(other.symbol_.size());
  for (const Other s : other.symbol_) symbol_.push_back(static_cast<Real>(s / unit));
}

template <class Real>
auto BasicEvenConvolution<Real>::half_spectrum() const -> std::span<Number> {
  const std::size_t points = size(transform_.half_size()), room = points * sizeof(Number);
  if (work_->size() < room) *work_ = WorkSpace::element_type(room);
  return {reinterpret_cast<Number*>(work_->data()), points};
}

template <class Real>
void BasicEvenConvolution<Real>::multiply(Index b, Number* block) const {
  const Index nx = transform_.torus().nx, rows = nx / 2 + 1;
  for (Index q = 0; q < width; ++q) {
    const Real* s = symbol_.data() + (b * width + q) * rows;
    Number* x = block + q * transform_.stride();
    for (Index i = 0; i < rows; ++i) x[i] *= s[i];
    for (Index i = rows; i < nx; ++i) x[i] *= s[nx - i];
  }
}

template <class Real>
void BasicEvenConvolution<Real>::apply(const Field& in, Field& out) {
  const double unit = unit_of<Real>(in.data(), in.size(), threads_);
  const std::span<Number> half = half_spectrum();
  transform_.forward_rows(in, half, threads_, 1 / unit);
  transform_.filter(half, threads_, [this](Index b, Number* block) { multiply(b, block); });
  out.resize(shape().nx, shape().ny);
  transform_.inverse_rows(half, out, threads_, unit * unit_);
}

template class BasicEvenConvolution<double>;
template class BasicEvenConvolution<float>;
template BasicEvenConvolution<float>::BasicEvenConvolution(const BasicEvenConvolution<double>&);

}  // namespace asperity
