/// The curves of a panel in SI, in the order in which they are drawn; the range of their numbers, from which
/// the axes follow, and the layers on these axes.
///
/// A number that is not finite breaks lines and bands, and leaves out dots and bars; but a line to
/// ±`unlimited` goes to the end of its axis, where bands end too.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/plot/figure.hpp"

namespace asperity::plot {

inline constexpr Range nothing{unlimited, -unlimited};  ///< of no numbers

class Curves {
 public:
  using Column = Eigen::ArrayXd;
  Range x = nothing, y = nothing;  ///< of the numbers of all curves

  void line(const Column& x, const Column& y, const std::string& colour, double width = 1.4,
            const std::string& dashes = "");
  /// Between two curves, and nowhere else. Without `counts` the range of y is that of the other curves.
  void band(const Column& x, const Column& low, const Column& high, const std::string& colour,
            double opacity = 0.2, bool counts = true);
  void dots(const Column& x, const Column& y, const std::string& colour, double size = 0.3);
  void circles(const Column& x, const Column& y, const std::string& colour);
  /// Upright, or where `across` along x.
  void bars(const Column& x, const Column& y, const Column& half, const std::string& colour,
            bool across = false);
  /// Columns in any other style of gnuplot, each of the axis that its letter names. Those of capital letters
  /// are lengths, or others that the ranges do not count.
  void add(const Field& columns, const std::string& axes, const std::string& style);

  std::vector<Layer> layers(const Axis& of_x, const Axis& of_y) const;

 private:
  enum class Shape { points, line, band };
  struct Curve {
    Field columns;
    std::string axes, style;
    Shape shape;
  };
  void put(Curve curve);

  std::vector<Curve> all_;
};

/// Gives the panel these axes, and the curves on them.
void place(Panel& panel, const Curves& curves, const Axis& x, const Axis& y);

/// The ranges of all curves, {0, 0} of no number.
Range range_of(const std::vector<Curves>& all, Range Curves::*axis);
/// With room below and above, in parts of its width.
inline Range with_room(Range r, double below, double above) {
  return {r.low - below * r.width(), r.high + above * r.width()};
}
/// Lines in the colours of the cases, where there are several.
void name_cases(Figure& figure, const Cases& cases);

/// The values of a member or a function for each element of a container.
template <class Container, class Value>
Curves::Column column_of(const Container& all, Value value) {
  Curves::Column out(std::ssize(all));
  for (Index k = 0; const auto& element : all) out(k++) = std::invoke(value, element);
  return out;
}
using Flags = Eigen::Array<bool, Eigen::Dynamic, 1>;
/// The values where a condition holds, and NaN elsewhere.
inline Curves::Column where(const Flags& holds, const Curves::Column& values) {
  return holds.select(values, NAN);
}

}  // namespace asperity::plot
