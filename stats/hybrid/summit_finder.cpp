#include "stats/hybrid/summit_finder.hpp"

#include <numbers>
#include <utility>

namespace asperity {
namespace {

struct Neighbourhood {
  const Row &before, &here, &after;

  // No neighbour is higher or missing.
  bool highest(Index j) const {
    const double z = here(j);
    return z >= here(j - 1) && z >= here(j + 1) && z >= before(j) && z >= after(j) && z >= before(j - 1) &&
           z >= before(j + 1) && z >= after(j - 1) && z >= after(j + 1);
  }
  Index sides(Index j) const {
    const double z = here(j);
    return (z > here(j - 1)) + (z > here(j + 1)) + (z > before(j)) + (z > after(j));
  }
  Index equals(Index j) const {
    const double z = here(j);
    return 4 - sides(j) + (z == before(j - 1)) + (z == before(j + 1)) + (z == after(j - 1)) +
           (z == after(j + 1));
  }
  double curvature(Index j, const Grid& grid) const {
    const double twice = 2 * here(j);
    return 0.5 * ((twice - before(j) - after(j)) / (grid.dx * grid.dx) +
                  (twice - here(j - 1) - here(j + 1)) / (grid.dy * grid.dy));
  }
};

}  // namespace

SummitFinder::Place SummitFinder::find(Index node) const {
  Place out{node, 0, 0};
  for (; nodes_[size(out.root)].parent != out.root; out.root = nodes_[size(out.root)].parent)
    out.x += nodes_[size(out.root)].x, out.y += nodes_[size(out.root)].y;
  return out;
}

// Points of b, shifted by these periods, are neighbours of those of a. A plateau that meets itself shifted is
// a ridge.
void SummitFinder::unite(Index a, Index b, Index x, Index y) {
  Place to = find(a), from = find(b);
  nodes_[size(to.root)].equals -= 2;
  const Index dx = to.x - from.x - x, dy = to.y - from.y - y;
  if (to.root == from.root) {
    if (dx != 0 || dy != 0) nodes_[size(to.root)].ridge = true;
    return;
  }
  const bool smaller = nodes_[size(to.root)].points < nodes_[size(from.root)].points;
  if (smaller) std::swap(to, from);
  Node &whole = nodes_[size(to.root)], &part = nodes_[size(from.root)];
  part.parent = to.root, part.x = smaller ? -dx : dx, part.y = smaller ? -dy : dy;
  whole.points += part.points, whole.curvature += part.curvature;
  whole.sides += part.sides, whole.equals += part.equals;
  whole.waits |= part.waits, whole.ridge |= part.ridge;
  if (part.row > whole.row) whole.row = part.row, whole.column = part.column;
}

// The neighbours in the row above, which is x periods away, of a point of this row.
void SummitFinder::meet(Index node, const Labels& above, Index column, Index x) {
  for (Index k = column - 1; k <= column + 1; ++k) {
    const Index period = k < 0 ? -1 : k < columns_ ? 0 : 1;
    if (period != 0 && !around_) continue;
    if (const Index other = above[size(k - period * columns_)]; other != none) unite(node, other, x, period);
  }
}

// Points of a row without a higher neighbour, but with equal ones.
void SummitFinder::add_plateaus(const std::vector<Node>& points) {
  here_.assign(size(columns_), none);
  for (const Node& point : points) {
    const Index node = std::ssize(nodes_), j = point.column;
    nodes_.push_back(point);
    nodes_.back().parent = node;
    here_[size(j)] = node;
    if (j > 0 && here_[size(j - 1)] != none) unite(node, here_[size(j - 1)], 0, 0);
    if (!above_.empty()) meet(node, above_, j, 0);
  }
  if (around_ && here_.front() != none && here_.back() != none) unite(here_.back(), here_.front(), 0, 1);
}

// The plateaus that this row shows no more.
void SummitFinder::end_row(FoundSummits& out, bool last) {
  if (around_ && row_ == 0) first_ = here_;
  if (around_ && last)
    for (Index j = 0; j < columns_; ++j)
      if (first_[size(j)] != none) meet(first_[size(j)], here_, j, -1);
  close(above_, out, last);
  if (last) close(here_, out, last), close(first_, out, last);
  above_.swap(here_);
  forget_closed();
}

void SummitFinder::close(const Labels& labels, FoundSummits& out, bool last) {
  for (const Index label : labels) {
    if (label == none) continue;
    Node& plateau = nodes_[size(find(label).root)];
    if (plateau.done || (!last && (plateau.waits || plateau.row == row_))) continue;
    plateau.done = true;
    if (plateau.equals != 0 || plateau.ridge || plateau.sides == 0) continue;
    const double share = 1 + 2 * std::numbers::inv_pi * (plateau.points - 1);
    out.push_back({plateau.column, plateau.height,
                   4 * plateau.curvature / (static_cast<double>(plateau.sides) * share), plateau.points});
  }
}

// Keeps what the last row and the first still show.
void SummitFinder::forget_closed() {
  if (std::ssize(nodes_) <= 8 * columns_) return;
  std::vector<Node> kept;
  Labels places(nodes_.size(), none);
  auto keep = [&](Index node, Node as) {
    if (places[size(node)] != none) return;
    places[size(node)] = std::ssize(kept);
    as.parent = as.parent == node ? places[size(node)] : places[size(as.parent)];
    kept.push_back(as);
  };
  for (Labels* labels : {&above_, &first_})
    for (Index& label : *labels) {
      if (label == none) continue;
      const Place place = find(label);
      keep(place.root, nodes_[size(place.root)]);
      keep(label, Node{.parent = place.root, .x = place.x, .y = place.y});
      label = places[size(label)];
    }
  nodes_ = std::move(kept);
}

std::vector<FoundSummits> SummitFinder::add(const Strip& strip) {
  const NeighbourRows rows(strip, 2);
  std::vector<FoundSummits> out(size(rows.rows()));
  if (out.empty()) return out;
  around_ = strip.grid.periodic.both(), columns_ = rows.columns();
  const Index last = strip.grid.shape.nx - (around_ ? 1 : 3);
  auto level = [&](const Row& row) { return rounding_ > 0 ? Row((row / rounding_).round()) : row; };
  Row before = rows(0), here = rows(1);
  for (Index i = 0; i < rows.rows(); ++i, ++row_) {
    const Row after = rows(i + 2), levels[] = {level(before), level(here), level(after)};
    const Neighbourhood around{before, here, after}, by_level{levels[0], levels[1], levels[2]};
    FoundSummits& found = out[size(i)];
    std::vector<Node> points;
    for (Index j = 1; j <= columns_; ++j) {
      if (!by_level.highest(j)) continue;
      const double curvature = around.curvature(j, strip.grid);
      const Index equals = by_level.equals(j);
      if (equals == 0)
        found.push_back({j - 1, here(j), curvature});
      else
        points.push_back({.parent = none,
                          .row = row_,
                          .column = j - 1,
                          .height = here(j),
                          .points = 1,
                          .curvature = curvature,
                          .sides = by_level.sides(j),
                          .equals = equals,
                          .waits = around_ && row_ == 0});
    }
    add_plateaus(points);
    end_row(found, row_ == last);
    before = std::move(here), here = after;
  }
  return out;
}

}  // namespace asperity
