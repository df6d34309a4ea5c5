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

Index square_blocks(Index cells) { return (cells + b - 1) / b; }

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
      shape_{body.slabs().own().count, body.shape().ny},
      threads_(useful_threads(shape_.cells(), threads)),
      end_(end) {}

Field TwoLevel::to_coarse(Field here) const {
  const Slabs slabs = body_.slabs();
  return slabs.shared() ? rows_of(here, slabs.coarsened(b), coarse_->slabs().own()) : here;
}

Field TwoLevel::from_coarse(const Field& coarse) const {
  const Slabs slabs = body_.slabs();
  if (!slabs.shared()) return coarse;
  const Extent here = slabs.coarsened(b).own();
  const Slabs of_coarse = coarse_->slabs();
  return of_coarse.shared() ? rows_of(coarse, of_coarse, here)
                            : Field(coarse.middleRows(here.first, here.count));
}

// visit(I, first, last) of every row of blocks and its rows of cells.
template <class Visit>
void TwoLevel::each_block_row(Visit visit) const {
  parallel_ranges(square_blocks(shape_.nx), threads_, [&](Index begin, Index end, int) {
    for (Index I = begin; I < end; ++I) visit(I, b * I, std::min(b * (I + 1), shape_.nx));
  });
}

void TwoLevel::set(const std::vector<std::int8_t>& mask) {
  mask_ = mask.data();
  applications_ = 0;
  Field here(square_blocks(shape_.nx), square_blocks(shape_.ny));
  each_block_row([&](Index I, Index first, Index last) {
    Row counts = Row::Zero(b * here.cols());
    for (Index i = first; i < last; ++i)
      for (Index j = 0; j < shape_.ny; ++j) counts[j] += mask_[i * shape_.ny + j];
    here.row(I) = sums_of_eight(counts).transpose();
  });
  constexpr double side_cells = b, block = b * b;
  auto inverses = [](const Field& counts) -> Field { return (counts > 0).cast<double>() / counts.max(1.0); };
  inverse_here_ = inverses(here);
  const Field n = to_coarse(std::move(here)), met = (n > 0).cast<double>();
  const double disc = 8 * std::sqrt(sum(met) / std::numbers::pi);
  raggedness_ = disc > 0 ? sum((n > 0 && n < block).cast<double>()) / disc : 0;
  inverse_ = inverses(n);
  const double k = coarse_->self_influence();
  stiffer_ =
      met * (block * body_.self_influence() * (inverse_ + (1 - inverse_) / (side_cells + 1) - 1 / side_cells))
                .max(0.0);
  scale_ = met * (k / (k + stiffer_)).sqrt();
  rest_ = stiffer_ / (k + stiffer_).square();
}

double TwoLevel::coarse_applications() const {
  return applications_ * static_cast<double>(coarse_->shape().cells()) /
         static_cast<double>(body_.shape().cells());
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
  Field here(inverse_here_.rows(), inverse_here_.cols());
  each_block_row([&](Index I, Index first, Index last) {
    Row sums = Row::Zero(b * here.cols());
    for (Index i = first; i < last; ++i) sums.head(r.cols()) += r.row(i).transpose();
    here.row(I) = inverse_here_.row(I) * sums_of_eight(sums).transpose();
    const Row means = eightfold(here.row(I).transpose());
    for (Index i = first; i < last; ++i) {
      const std::int8_t* in_set = mask_ + i * r.cols();
      const double *from = &r(i, 0), *mean = means.data();
      double* to = &z(i, 0);
#pragma omp simd
      for (Index j = 0; j < r.cols(); ++j) to[j] = from[j] - in_set[j] * mean[j];
    }
  });
  y_ = to_coarse(std::move(here));
}

// z = Π z + b² Z N⁻¹ x: x is a pressure of blocks.
void TwoLevel::add_blocks(Field& z) const {
  each_block_row([&](Index I, Index first, Index last) {
    Row sums = Row::Zero(b * x_here_.cols());
    for (Index i = first; i < last; ++i) {
      const std::int8_t* in_set = mask_ + i * z.cols();
      const double* from = &z(i, 0);
      double* sum = sums.data();
#pragma omp simd
      for (Index j = 0; j < z.cols(); ++j) sum[j] += in_set[j] * from[j];
    }
    const Row blocks = static_cast<double>(b * b) * x_here_.row(I).transpose() - sums_of_eight(sums);
    const Row lifts = eightfold(blocks * inverse_here_.row(I).transpose());
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
  const double goal = end_.tolerance * end_.tolerance * sum(y_.square());
  double zr_old = 1;
  for (int i = 0; i < end_.steps && sum(r.square()) > goal; ++i) {
    const Field z = precondition(r);
    const double zr = sum(z * r);
    d = z + (i > 0 ? zr / zr_old : 0) * d;
    zr_old = zr;
    coarse_->apply(d, q);
    q = met * (q + stiffer_ * d);
    ++applications_;
    const double a = zr / sum(d * q);
    if (!(a > 0)) break;
    x_ += a * d;
    r -= a * q;
  }
  x_here_ = from_coarse(x_);
}

}  // namespace asperity
