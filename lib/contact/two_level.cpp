#include "contact/two_level.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/blocks.hpp"
#include "core/parallel.hpp"

namespace asperity {
namespace {

constexpr Index b = TwoLevel::side;
using Row = Eigen::ArrayXd;

Index blocks_along(Index cells) { return (cells + b - 1) / b; }

// Of each eight values the sum, and eight times each value.
Row sums_of_eight(const Row& cells) {
  return cells.reshaped(b, cells.size() / b).colwise().sum().transpose();
}
Row eightfold(const Row& values) {
  Row cells(b * values.size());
  cells.reshaped(b, values.size()).rowwise() = values.transpose();
  return cells;
}

}  // namespace

TwoLevel::TwoLevel(ElasticOperator& body, int threads, BlockEnd end)
    : body_(body),
      coarse_(body.coarsened(b)),
      shape_(body.shape()),
      threads_(useful_threads(shape_.cells(), threads)),
      end_(end) {
  const Shape blocks = coarse_->shape();
  for (Field* field : {&inverse_, &y_}) field->resize(blocks.nx, blocks.ny);
}

// visit(I, first, last) of every row of blocks and its rows of cells.
template <class Visit>
void TwoLevel::each_block_row(Visit visit) const {
  parallel_ranges(blocks_along(shape_.nx), threads_, [&](Index begin, Index end, int) {
    for (Index I = begin; I < end; ++I) visit(I, b * I, std::min(b * (I + 1), shape_.nx));
  });
}

void TwoLevel::set(const std::vector<std::int8_t>& mask) {
  mask_ = mask.data();
  applications_ = 0;
  Field& n = inverse_;
  each_block_row([&](Index I, Index first, Index last) {
    Row counts = Row::Zero(b * n.cols());
    for (Index i = first; i < last; ++i)
      for (Index j = 0; j < shape_.ny; ++j) counts[j] += mask_[i * shape_.ny + j];
    n.row(I) = sums_of_eight(counts).transpose();
  });
  constexpr double side_cells = b, block = b * b;
  const Field met = (n > 0).cast<double>();
  const double disc = 8 * std::sqrt(met.sum() / std::numbers::pi);
  raggedness_ = disc > 0 ? static_cast<double>((n > 0 && n < block).count()) / disc : 0;
  inverse_ = met / n.max(1.0);
  const double k = coarse_->self_influence();
  stiffer_ =
      met * (block * body_.self_influence() * (inverse_ + (1 - inverse_) / (side_cells + 1) - 1 / side_cells))
                .max(0.0);
  scale_ = met * (k / (k + stiffer_)).sqrt();
  rest_ = stiffer_ / (k + stiffer_).square();
}

double TwoLevel::coarse_applications() const {
  return applications_ * static_cast<double>(inverse_.size()) / static_cast<double>(shape_.cells());
}

void TwoLevel::apply(const Field& r, Field& z) {
  remove_means(r, z);
  solve();
  body_.precondition(z, z);
  add_blocks(z);
}

// y = N⁻¹ Zᵀ r and z = r - Z y.
void TwoLevel::remove_means(const Field& r, Field& z) {
  z.resize(r.rows(), r.cols());
  each_block_row([&](Index I, Index first, Index last) {
    Row sums = Row::Zero(b * y_.cols());
    for (Index i = first; i < last; ++i) sums.head(r.cols()) += r.row(i).transpose();
    y_.row(I) = inverse_.row(I) * sums_of_eight(sums).transpose();
    const Row means = eightfold(y_.row(I).transpose());
    for (Index i = first; i < last; ++i) {
      const std::int8_t* in_set = mask_ + i * r.cols();
      const double *from = &r(i, 0), *mean = means.data();
      double* to = &z(i, 0);
#pragma omp simd
      for (Index j = 0; j < r.cols(); ++j) to[j] = from[j] - in_set[j] * mean[j];
    }
  });
}

// z = Π z + b² Z N⁻¹ x: x is a pressure of blocks.
void TwoLevel::add_blocks(Field& z) const {
  each_block_row([&](Index I, Index first, Index last) {
    Row sums = Row::Zero(b * y_.cols());
    for (Index i = first; i < last; ++i) {
      const std::int8_t* in_set = mask_ + i * z.cols();
      const double* from = &z(i, 0);
      double* sum = sums.data();
#pragma omp simd
      for (Index j = 0; j < z.cols(); ++j) sum[j] += in_set[j] * from[j];
    }
    const Row blocks = static_cast<double>(b * b) * x_.row(I).transpose() - sums_of_eight(sums);
    const Row lifts = eightfold(blocks * inverse_.row(I).transpose());
    for (Index i = first; i < last; ++i) {
      const std::int8_t* in_set = mask_ + i * z.cols();
      const double* lift = lifts.data();
      double* to = &z(i, 0);
#pragma omp simd
      for (Index j = 0; j < z.cols(); ++j) to[j] = in_set[j] * (to[j] + lift[j]);
    }
  });
}

Field TwoLevel::precondition(const Field& r) {
  Field z = scale_ * r;
  coarse_->precondition(z, z);
  return scale_ * z + rest_ * r;
}

// x = (K_c + D)⁻¹ y on the blocks that F meets.
void TwoLevel::solve() {
  const Field met = (inverse_ > 0).cast<double>();
  x_ = Field::Zero(y_.rows(), y_.cols());
  Field r = y_, d = x_, q;
  const double goal = end_.tolerance * end_.tolerance * y_.square().sum();
  double zr_old = 1;
  for (int i = 0; i < end_.steps && r.square().sum() > goal; ++i) {
    const Field z = precondition(r);
    const double zr = (z * r).sum();
    d = z + (i > 0 ? zr / zr_old : 0) * d;
    zr_old = zr;
    coarse_->apply(d, q);
    q = met * (q + stiffer_ * d);
    ++applications_;
    const double a = zr / (d * q).sum();
    if (!(a > 0)) break;
    x_ += a * d;
    r -= a * q;
  }
}

}  // namespace asperity
