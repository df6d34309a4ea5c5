/// Columns of numbers as layers of a panel, in the order in which they are added.
///
/// Columns are in SI and divided by the units of the axes. A number that is not finite breaks lines and
/// bands, and leaves out dots and bars.
#pragma once

#include <string>

#include "tools/plot/figure.hpp"

namespace asperity::plot {

class Series {
 public:
  using Column = Eigen::ArrayXd;
  Series(Panel& panel, double x_unit, double y_unit) : layers_(panel.layers), x_(x_unit), y_(y_unit) {}

  void line(const Column& x, const Column& y, const std::string& colour, double width = 1.4,
            const std::string& dashes = "");
  /// Between two curves, and nowhere else.
  void band(const Column& x, const Column& low, const Column& high, const std::string& colour,
            double opacity = 0.2);
  void dots(const Column& x, const Column& y, const std::string& colour, double size = 0.3);
  void circles(const Column& x, const Column& y, const std::string& colour);
  /// Upright, or where `across` along x.
  void bars(const Column& x, const Column& y, const Column& half, const std::string& colour,
            bool across = false);
  /// Columns x and y in any other style of gnuplot.
  void add(const Column& x, const Column& y, const std::string& style);

 private:
  Field pairs(const Column& x, const Column& y) const;

  std::vector<Layer>& layers_;
  double x_, y_;
};

/// A column of what a function gives for each element of a container.
template <class Container, class Function>
Series::Column column_of(const Container& all, Function value) {
  Series::Column out(std::ssize(all));
  for (Index k = 0; const auto& element : all) out(k++) = value(element);
  return out;
}
/// The values where a condition holds, and NaN elsewhere.
inline Series::Column where(const Eigen::Array<bool, Eigen::Dynamic, 1>& holds,
                            const Series::Column& values) {
  return holds.select(values, NAN);
}

}  // namespace asperity::plot
