#include "transform/convolution.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "core/parallel.hpp"
#include "transform/mirrored.hpp"

namespace asperity {
namespace {

constexpr Index block_width = PrunedTransform::width;

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

std::byte* room_in(const WorkSpace& work, std::size_t bytes) {
  if (work->size() < bytes) {
    WorkSpace::element_type().swap(*work);  // never both at once
    work->resize(bytes);
  }
  return work->data();
}

Extent symbol_columns(Shape torus, const Ranks& ranks, int rank) {
  const Extent blocks = PrunedTransform::blocks_of(torus, ranks, rank);
  const Index first = blocks.first * block_width;
  return {first, std::min(blocks.end() * block_width, torus.ny / 2 + 1) - first};
}

namespace {

// All rows of this rank's columns, for all columns of its rows.
Field own_columns(Field own_rows, Shape torus, const Slabs& rows) {
  const Ranks& ranks = rows.ranks();
  if (!rows.shared()) return own_rows;
  const Extent own = symbol_columns(torus, ranks);
  std::vector<std::vector<double>> parts;
  for (int r = 0; r < ranks.count(); ++r) {
    const Extent theirs = symbol_columns(torus, ranks, r);
    const Field part = own_rows.middleCols(theirs.first, theirs.count);
    parts.emplace_back(part.data(), part.data() + part.size());
  }
  const auto found = exchanged(ranks, parts, [&](int r) { return rows.of(r).count * own.count; });
  Field out(rows.rows(), own.count);
  for (int r = 0; r < ranks.count(); ++r)
    std::ranges::copy(found[static_cast<std::size_t>(r)], out.data() + rows.of(r).first * own.count);
  return out;
}

}  // namespace

Field even_transfer_function(Shape torus, const std::function<double(Index, Index)>& kernel, int threads,
                             const Ranks& ranks) {
  const Slabs rows(torus.nx / 2 + 1, ranks);
  const Extent own = rows.own();
  Field symbol(own.count, torus.ny / 2 + 1);
  transform_even(
      torus.ny, own.count, threads, [&](Index i, Index j) { return kernel(own.first + i, j); },
      [&](Index i, Index k, double value) { symbol(i, k) = value; });
  symbol = own_columns(std::move(symbol), torus, rows);
  transform_even(
      torus.nx, symbol.cols(), threads, [&](Index j, Index i) { return symbol(i, j); },
      [&](Index j, Index k, double value) { symbol(k, j) = value; });
  return symbol;
}

namespace {

// Single precision has a short range: its numbers count in the largest of all ranks. Doubles stay as they
// are.
template <class Real, class Number>
double unit_of(const Number* numbers, Index count, int threads, const Ranks& ranks) {
  if constexpr (std::is_same_v<Real, double>) return 1;
  std::vector<double> parts(size(std::max(threads, 1)));
  parallel_ranges(count, threads, [&](Index begin, Index end, int thread) {
    if (begin == end) return;
    const Eigen::Map<const Eigen::ArrayX<Number>> run(numbers + begin, end - begin);
    parts[size(thread)] = static_cast<double>(run.abs().maxCoeff());
  });
  const double most = largest(ranks, *std::ranges::max_element(parts));
  return std::isnormal(most) ? most : 1;
}

}  // namespace

template <class Real>
BasicEvenConvolution<Real>::BasicEvenConvolution(Shape field, Shape torus, const Field& symbol, int threads,
                                                 WorkSpace work, const Ranks& ranks)
    : transform_(field, torus, Ways::both, ranks),
      unit_(unit_of<Real>(symbol.data(), symbol.size(), threads, ranks)),
      work_(work ? std::move(work) : std::make_shared<WorkSpace::element_type>()),
      threads_(useful_threads(field, threads)) {
  const Index rows = torus.nx / 2 + 1;
  symbol_.resize(size(transform_.own_blocks().count * rows * block_width));
  const double scale = 1.0 / (unit_ * static_cast<double>(torus.cells()));
  for (Index k = 0; k < symbol.cols(); ++k)
    for (Index i = 0; i < rows; ++i) symbol_[size(k * rows + i)] = static_cast<Real>(scale * symbol(i, k));
  half_spectrum();
}

template <class Real>
template <class Other>
BasicEvenConvolution<Real>::BasicEvenConvolution(const BasicEvenConvolution<Other>& other)
    : transform_(other.transform_.field(), other.transform_.torus(), Ways::both,
                 other.transform_.slabs().ranks()),
      unit_(other.unit_),
      work_(other.work_),
      threads_(other.threads_) {
  const double unit =
      unit_of<Real>(other.symbol_.data(), std::ssize(other.symbol_), threads_, transform_.slabs().ranks());
  unit_ *= unit;
  symbol_.reserve(other.symbol_.size());
  for (const Other s : other.symbol_) symbol_.push_back(static_cast<Real>(s / unit));
}

template <class Real>
auto BasicEvenConvolution<Real>::half_spectrum() const -> std::span<Number> {
  const std::size_t points = size(transform_.half_size());
  return {reinterpret_cast<Number*>(room_in(work_, points * sizeof(Number))), points};
}

template <class Real>
void BasicEvenConvolution<Real>::multiply(Index b, Number* block) const {
  const Index nx = transform_.torus().nx, rows = nx / 2 + 1, first = transform_.own_blocks().first;
  for (Index q = 0; q < block_width; ++q) {
    const Real* s = symbol_.data() + ((b - first) * block_width + q) * rows;
    Number* x = block + q * transform_.stride();
    for (Index i = 0; i < rows; ++i) x[i] *= s[i];
    for (Index i = rows; i < nx; ++i) x[i] *= s[nx - i];
  }
}

template <class Real>
void BasicEvenConvolution<Real>::apply(const Field& in, Field& out) {
  const double unit = unit_of<Real>(in.data(), in.size(), threads_, transform_.slabs().ranks());
  const std::span<Number> half = half_spectrum();
  transform_.forward_rows(in, half, threads_, 1 / unit);
  transform_.filter(half, threads_, [this](Index b, Number* block) { multiply(b, block); });
  out.resize(transform_.slabs().own().count, shape().ny);
  transform_.inverse_rows(half, out, threads_, unit * unit_);
}

template class BasicEvenConvolution<double>;
template class BasicEvenConvolution<float>;
template BasicEvenConvolution<float>::BasicEvenConvolution(const BasicEvenConvolution<double>&);

}  // namespace asperity
