#include "contact/window.hpp"

#include <algorithm>

namespace asperity {
namespace {

Extent united(Extent a, Extent b) {
  const Index first = std::min(a.first, b.first);
  return {first, std::max(a.end(), b.end()) - first};
}

Extent widened(Extent a, Index cells, Index domain) {
  const Index first = std::max<Index>(a.first - cells, 0);
  return {first, std::min(a.end() + cells, domain) - first};
}

Extent enlarged(Extent a, Index count, Index domain) {
  return {std::clamp<Index>(a.first - (count - a.count) / 2, 0, domain - count), count};
}

}  // namespace

ContactWindow united(const ContactWindow& a, const ContactWindow& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  return {united(a.x, b.x), united(a.y, b.y)};
}

ContactWindow widened(const ContactWindow& w, Index cells, Shape domain) {
  return {widened(w.x, cells, domain.nx), widened(w.y, cells, domain.ny)};
}

ContactWindow enlarged(const ContactWindow& w, Shape shape, Shape domain) {
  return {enlarged(w.x, shape.nx, domain.nx), enlarged(w.y, shape.ny, domain.ny)};
}

ContactWindow contact_window(const Field& p) {
  const auto [x, y] = extents(p, [](double value) { return value > 0; });
  return {x, y};
}

ContactWindow overlap_window(const Field& g, double approach) {
  const auto [x, y] = extents(g, [approach](double value) { return value < approach; });
  return {x, y};
}

}  // namespace asperity
