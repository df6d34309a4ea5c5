#include "contact/relaxation.hpp"

#include <algorithm>
#include <vector>

#include "contact/blocks.hpp"
#include "contact/calibration.hpp"

namespace asperity {
namespace {
constexpr Index block = Relaxation::block;

Index strips_along(Index cells) { return (cells + block - 1) / block; }

// Every eighth cell of a row is of a class. In rows of p and g the classes follow each other; in those of d
// each has a 0 at both ends.
struct Classes {
  explicit Classes(Index row) : cells(row) {}

  Index count(Index c) const { return strips_along(cells - c); }
  Index begin(Index c) const { return c * (cells / block) + std::min(c, cells % block); }
  Index stride() const { return strips_along(cells) + 2; }
  /// Of the cells c + 8k in a row of d, -8 ≤ c < 16.
  Index padded(Index c) const {
    const Index turns = c < 0 ? -1 : c / block;
    return (c - turns * block) * stride() + 1 + turns;
  }

  Index cells;
};

// Rows from cells to classes, or back.
void reorder(Field& f, bool back, int threads) {
  const Classes classes(f.cols());
  parallel_ranges(f.rows(), threads, [&](Index first, Index last, int) {
    Eigen::ArrayXd row(f.cols());
    for (Index i = first; i < last; ++i) {
      row = f.row(i).transpose();
      for (Index c = 0; c < block; ++c) {
        double* of_class = &f(i, 0) + (back ? c : classes.begin(c));
        const double* from = row.data() + (back ? classes.begin(c) : c);
        for (Index k = 0; k < classes.count(c); ++k)
          of_class[back ? block * k : k] = from[back ? k : block * k];
      }
    }
  });
}

}  // namespace

Relaxation::Relaxation(ElasticOperator& body, int threads)
    : body_(body), slabs_(body.slabs()), threads_(useful_threads(body.shape().cells(), threads)) {
  static_assert(strip == Slabs::run);
  const Field k = body.near_influence(reach + 1);
  const double edge = std::max(k(reach + 1, 0), k(0, reach + 1));
  for (Index i = 0; i <= reach; ++i)
    for (Index j = 0; j <= reach; ++j) near_[size(i)][size(j)] = std::max(0.0, k(i, j) - edge);
  held_ = contact::held_load * edge;
}

// Of rows forth and back.
struct Relaxation::Sweeps {
  const Relaxation& model;
  Field& p;
  Rows& d;  // with rows and cells of 0 about it, in order of classes
  Field& loads;
  const Field& g;
  double approach, cap;
  Classes classes{p.cols()};
  Eigen::ArrayXd beside{d.cols()}, next{d.cols()};  // d summed over the two rows beside one, and the next two

  void forth(Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      sum_rows(i);
      for (Index c = 0; c < block; ++c) relax(i, c);
    }
  }

  void back(Index first, Index last) {
    for (Index i = last - 1; i >= first; --i) {
      sum_rows(i);
      for (Index c = block - 1; c >= 0; --c) relax(i, c);
    }
  }

  void sum_rows(Index i) {
    beside = (d.row(i + reach - 1) + d.row(i + reach + 1)).transpose();
    next = (d.row(i + reach - 2) + d.row(i + reach + 2)).transpose();
  }

  // (3) for the cells of a class.
  void relax(Index i, Index c) {
    double *pressure = &p(i, classes.begin(c)), *load = &loads(i / block, 0), *row = &d(i + reach, 0);
    const double *gap = &g(i, classes.begin(c)), *row1 = beside.data(), *row2 = next.data();
    const auto& [near0, near1, near2] = model.near_;
    const double k00 = near0[0], k01 = near0[1], k02 = near0[2], k10 = near1[0], k11 = near1[1],
                 k12 = near1[2], k20 = near2[0], k21 = near2[1], k22 = near2[2];
    const double held = model.held_, inverse = 1 / (k00 + held), level = approach, limit = cap;
    const Index count = classes.count(c), at = classes.padded(c), l1 = classes.padded(c - 1),
                l2 = classes.padded(c - 2), r1 = classes.padded(c + 1), r2 = classes.padded(c + 2);
#pragma omp simd
    for (Index k = 0; k < count; ++k) {
      const double force = gap[k] - level + held * load[k] + k00 * row[at + k] +
                           k01 * (row[l1 + k] + row[r1 + k]) + k02 * (row[l2 + k] + row[r2 + k]) +
                           k10 * row1[at + k] + k11 * (row1[l1 + k] + row1[r1 + k]) +
                           k12 * (row1[l2 + k] + row1[r2 + k]) + k20 * row2[at + k] +
                           k21 * (row2[l1 + k] + row2[r1 + k]) + k22 * (row2[l2 + k] + row2[r2 + k]);
      const double was = pressure[k], relaxed = std::min(limit, std::max(0.0, was - inverse * force));
      pressure[k] = relaxed;
      row[at + k] += relaxed - was;
      load[k] += relaxed - was;
    }
  }
};

// Of d, what other ranks have made of it.
void Relaxation::fetch_rows_beside(Rows& d) const {
  if (!slabs_.shared()) return;
  const Extent own = slabs_.own();
  std::vector<Index> wanted;
  for (Index k = 1; k <= reach; ++k)
    for (const Index i : {own.first - k, own.end() - 1 + k})
      if (i >= 0 && i < slabs_.rows()) wanted.push_back(i);
  const Field found = rows_of(d.middleRows(reach, own.count), slabs_, wanted);
  for (Index k = 0; k < found.rows(); ++k) d.row(wanted[size(k)] - own.first + reach) = found.row(k);
}

void Relaxation::relax(Field& p, Field& g, double approach, double cap, int sweeps) {
  const Index rows = p.rows(), strips = (rows + strip - 1) / strip, before = slabs_.own().first / strip;
  const Index length = block * Classes(p.cols()).stride();
  Rows d(body_.room(size((rows + 2 * reach) * length)).data(), rows + 2 * reach, length);
  d.setZero();
  loads_ = Field::Zero(strips_along(rows), strips_along(p.cols()));
  for (Field* field : {&p, &g}) reorder(*field, false, threads_);
  for (Index kind = 0; kind < sweeps; ++kind) {  // even strips, odd strips of all ranks
    const Index odd = (kind + before) % 2;
    fetch_rows_beside(d);
    parallel_ranges((strips + 1 - odd) / 2, threads_, [&](Index begin, Index end, int) {
      Sweeps both{*this, p, d, loads_, g, approach, cap};
      for (Index k = begin; k < end; ++k) {
        const Index first = (2 * k + odd) * strip, last = std::min(first + strip, rows);
        both.forth(first, last);
        both.back(first, last);
      }
    });
  }
  reorder(p, true, threads_);
}

}  // namespace asperity
