/// Sums over rectangles of a field, each of four additions: a table of partial sums.
///
/// Accuracy  round-off ε Σ|f|.
#pragma once

#include "core/field.hpp"

namespace asperity {

class RectangleSums {
 public:
  explicit RectangleSums(const Field& f) : before_(Field::Zero(f.rows() + 1, f.cols() + 1)) {
    for (Index i = 0; i < f.rows(); ++i) {
      double row = 0;
      for (Index j = 0; j < f.cols(); ++j) before_(i + 1, j + 1) = before_(i, j + 1) + (row += f(i, j));
    }
  }
  /// Over `rows` × `columns` points from (i, j) on.
  double operator()(Index i, Index j, Index rows, Index columns) const {
    return before_(i + rows, j + columns) - before_(i, j + columns) - before_(i + rows, j) + before_(i, j);
  }

 private:
  Field before_;  // (i, j): over the points with smaller indices both
};

}  // namespace asperity
