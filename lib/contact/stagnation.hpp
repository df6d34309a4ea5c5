/// Rounds in which a number has not fallen.
#pragma once

#include <limits>

namespace asperity {

/// Counts the rounds since a number last fell below a share of its mark, which is then set to it.
class Stagnation {
 public:
  explicit Stagnation(double share) : share_(share) {}

  /// Of one more round.
  int add(double value) {
    if (!(value < share_ * mark_)) return ++rounds_;
    restart(value);
    return 0;
  }
  void restart(double mark) {
    mark_ = mark;
    rounds_ = 0;
  }
  double mark() const { return mark_; }

 private:
  double share_, mark_ = std::numeric_limits<double>::infinity();
  int rounds_ = 0;
};

}  // namespace asperity
