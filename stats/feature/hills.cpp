#include "stats/feature/hills.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace asperity {
namespace {

using Place = std::int32_t;

std::size_t at(std::int32_t number) { return static_cast<std::size_t>(number); }

// The points that are there, the highest first.
std::vector<Place> by_height(const Field& z) {
  struct Point {
    double height;
    Place place;
  };
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(z.size()));
  for (Index k = 0; k < z.size(); ++k)
    if (!std::isnan(z.data()[k])) points.push_back({z.data()[k], static_cast<Place>(k)});
  std::ranges::sort(points, [](const Point& a, const Point& b) {
    return a.height > b.height || (a.height == b.height && a.place < b.place);
  });
  std::vector<Place> out(points.size());
  std::ranges::transform(points, out.begin(), &Point::place);
  return out;
}

// Takes the points one by one. Of connected hills the one with the highest peak, which has the least number,
// is the root.
class Flood {
 public:
  Flood(const Field& z, const Periodic& periodic)
      : z_(z.data()),
        nx_(static_cast<Place>(z.rows())),
        ny_(static_cast<Place>(z.cols())),
        periodic_(periodic) {
    hills_.of_point.setConstant(nx_, ny_, no_hill);
  }

  void take(Place k) {
    std::array<Place, 8> all{};
    const std::span<const Place> beside{all.data(), find_beside(k, all)};
    if (beside.empty()) {
      hill(k) = static_cast<HillNumber>(hills_.all.size());
      up_.push_back(hill(k));
      hills_.all.push_back({.peak = k, .height = z_[k]});
      return;
    }
    hill(k) = hill(*std::ranges::max_element(beside, {}, [this](Place p) { return z_[p]; }));
    for (const Place other : beside)
      if (hill(other) != hill(k))
        if (const HillNumber a = root(hill(other)), b = root(hill(k)); a != b)
          meet(z_[k], std::max(a, b), std::min(a, b), beside);
  }

  // After all points in this order.
  Hills ended(const std::vector<Place>& order) && {
    for (const Place k : order)  // the last of connected ones is the lowest
      hills_.all[at(root(hill(k)))].saddle = z_[k];
    return std::move(hills_);
  }

 private:
  HillNumber& hill(Place k) { return hills_.of_point.data()[k]; }
  bool taken(Place k) const { return hills_.of_point.data()[k] != no_hill; }

  HillNumber root(HillNumber a) {
    while (up_[at(a)] != a) a = up_[at(a)] = up_[at(up_[at(a)])];
    return a;
  }

  // Those of the eight neighbours that are taken.
  std::size_t find_beside(Place k, std::array<Place, 8>& out) const {
    const Place i = k / ny_, j = k % ny_;
    std::size_t n = 0;
    if (i > 0 && i + 1 < nx_ && j > 0 && j + 1 < ny_) {
      for (const Place step : {-ny_ - 1, -ny_, -ny_ + 1, -1, 1, ny_ - 1, ny_, ny_ + 1})
        if (taken(k + step)) out[n++] = k + step;
      return n;
    }
    for (Place a = i - 1; a <= i + 1; ++a)
      for (Place b = j - 1; b <= j + 1; ++b) {
        const bool outside = (!periodic_.x && (a < 0 || a >= nx_)) || (!periodic_.y && (b < 0 || b >= ny_));
        if (outside) continue;
        const Place beside = (a + nx_) % nx_ * ny_ + (b + ny_) % ny_;
        if (beside != k && taken(beside)) out[n++] = beside;
      }
    return n;
  }

  // A point of this height connects two roots.
  void meet(double height, HillNumber lower, HillNumber upper, std::span<const Place> beside) {
    Hill& ended = hills_.all[at(lower)];
    ended.saddle = height;
    for (double highest = -std::numeric_limits<double>::infinity(); const Place p : beside)
      if (z_[p] > highest && root(hill(p)) == upper) highest = z_[p], ended.across = hill(p);
    up_[at(lower)] = upper;
  }

  const double* z_;
  Place nx_, ny_;
  Periodic periodic_;
  std::vector<HillNumber> up_;  // towards the root
  Hills hills_ = {};
};

}  // namespace

Hills hills_of(const Field& z, const Periodic& periodic) {
  const std::vector<Place> order = by_height(z);
  Flood flood(z, periodic);
  for (const Place k : order) flood.take(k);
  return pruned(std::move(flood).ended(order), 0);
}

Hills pruned(Hills hills, double least) {
  // Where the points of each hill go: a hill across a saddle has a higher peak, so that chains end.
  std::vector<HillNumber> goes(hills.all.size()), number(hills.all.size(), no_hill);
  Hills out;
  for (std::size_t a = 0; a < goes.size(); ++a) {
    const Hill& h = hills.all[a];
    const bool stays = h.local_height() >= least && h.local_height() > 0;
    goes[a] = stays ? static_cast<HillNumber>(a) : h.across;
    if (!stays) continue;
    number[a] = static_cast<HillNumber>(out.all.size());
    out.all.push_back(h);
  }
  const auto left = [&](HillNumber a) {
    while (a != no_hill && goes[at(a)] != a) {
      const HillNumber next = goes[at(a)];
      if (next != no_hill) goes[at(a)] = goes[at(next)];
      a = next;
    }
    return a == no_hill ? no_hill : number[at(a)];
  };
  for (Hill& h : out.all) h.across = left(h.across);
  out.of_point = hills.of_point.unaryExpr(left);
  return out;
}

}  // namespace asperity
