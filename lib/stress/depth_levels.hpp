/// What is made once for each resolution that layers are computed at (stress/resolution.hpp), when the first of them
/// needs it.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "core/field.hpp"
#include "stress/resolution.hpp"

namespace asperity {

enum class DepthResolution {
  full,     ///< every layer from its own cells
  adapted,  ///< deep layers from wider cells
};

template <class Made>
class DepthLevels {
 public:
  DepthLevels(const Grid& grid, DepthResolution resolution) : levels_(1) {
    if (resolution == DepthResolution::full) return;
    for (Index s = 2; Resolution::possible(grid, s); s *= 2) levels_.emplace_back().s = s;
    for (Level& level : levels_) level.least_depth = Resolution::least_depth(grid, level.s);
  }

  std::size_t count() const { return levels_.size(); }
  /// The coarsest that will do at depth z.
  std::size_t at(double z) const {
    std::size_t level = 0;
    while (level + 1 < count() && z >= levels_[level + 1].least_depth) ++level;
    return level;
  }
  /// make(s) returns what is made for cells s times as wide.
  template <class Make>
  const Made& get(std::size_t level, Make make) const {
    Level& l = levels_[level];
    std::call_once(l.asked, [&] { l.made = make(l.s); });
    return *l.made;
  }

 private:
  struct Level {
    Index s = 1;
    double least_depth = 0;
    std::once_flag asked;
    std::unique_ptr<const Made> made;
  };
  mutable std::deque<Level> levels_;
};

}  // namespace asperity
