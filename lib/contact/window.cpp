#include "contact/window.hpp"

#include <algorithm>

namespace asperity {
namespace {

// The least window that holds the cells where `holds`.
template <class Holds>
Window bounding_window(const Field& f, Holds holds) {
  const Index none = f.cols();
  Index first_i = f.rows(), last_i = -1, first_j = none, last_j = -1;
  for (Index i = 0; i < f.rows(); ++i) {
    const double* row = f.data() + i * f.cols();
    Index j = 0, k = f.cols() - 1;
    while (j < none && !holds(row[j])) ++j;
    if (j == none) continue;
    while (k > last_j && !holds(row[k])) --k;
    first_i = std::min(first_i, i);
    last_i = i;
    first_j = std::min(first_j, j);
    last_j = std::max(last_j, k);
  }
  if (last_i < 0) return {};
  return {first_i, first_j, {last_i - first_i + 1, last_j - first_j + 1}};
}

// `count` cells about the middle of `held` from `first`, within 0 … n-1.
Index placed(Index first, Index held, Index count, Index n) {
  return std::clamp<Index>(first - (count - held) / 2, 0, n - count);
}

}  // namespace

Window united(const Window& a, const Window& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const Index i = std::min(a.i, b.i), j = std::min(a.j, b.j);
  return {
      i,
      j,
      {std::max(a.i + a.shape.nx, b.i + b.shape.nx) - i, std::max(a.j + a.shape.ny, b.j + b.shape.ny) - j}};
}

Window widened(const Window& w, Index cells, Shape domain) {
  const Index i = std::max<Index>(w.i - cells, 0), j = std::max<Index>(w.j - cells, 0);
  return {
      i,
      j,
      {std::min(w.i + w.shape.nx + cells, domain.nx) - i, std::min(w.j + w.shape.ny + cells, domain.ny) - j}};
}

Window enlarged(const Window& w, Shape shape, Shape domain) {
  return {placed(w.i, w.shape.nx, shape.nx, domain.nx), placed(w.j, w.shape.ny, shape.ny, domain.ny), shape};
}

Window contact_window(const Field& p) {
  return bounding_window(p, [](double x) { return x > 0; });
}

Window overlap_window(const Field& g, double approach) {
  return bounding_window(g, [approach](double x) { return x < approach; });
}

}  // namespace asperity
