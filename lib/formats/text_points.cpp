#include "formats/text_points.hpp"

#include <vector>

#include "formats/refuse.hpp"
#include "formats/text_grid.hpp"

namespace asperity {
namespace {

// The columns of a table, without lines that have no number in any of them.
std::vector<Column> taken(const Table& table, const std::vector<Index>& of) {
  const Eigen::Map<const Field> lines(table.values.data(), table.lines, table.columns);
  std::vector<Column> out(of.size(), Column(table.lines));
  Index count = 0;
  for (Index i = 0; i < table.lines; ++i) {
    bool some = false;
    for (std::size_t k = 0; k < of.size(); ++k) {
      out[k](count) = lines(i, of[k]);
      some |= !std::isnan(out[k](count));
    }
    count += some ? 1 : 0;
  }
  for (Column& column : out) column.conservativeResize(count);
  return out;
}

double metres_of(const Columns& columns, std::size_t axis) {
  const std::string& unit = columns.units[axis];
  if (unit.empty())
    refuse("the text gives no unit of {}: give it to asperity-convert, such as `xyz` {}",
           axis == 0 ? "x" : "y", example_of(columns));
  return metres_per(unit);
}

}  // namespace

Map map_of_points(const Table& table, const Columns& columns) {
  const bool profile = columns.of.size() == 2;
  const std::array metres{metres_of(columns, 0), profile ? 1 : metres_of(columns, 1)};
  std::vector<Column> given = taken(table, columns.of);
  const Column xs = std::move(given.front()), zs = std::move(given.back()),
               ys = profile ? Column::Zero(xs.size()) : Column(std::move(given[1]));
  if (xs.size() < 2) refuse("a map needs at least 2 points");
  const GridAxis x = require_axis(xs, 'x'), y = require_axis(ys, 'y');
  if (x.count > 2 * xs.size() / y.count)
    refuse("{} points fill less than half of a grid of {} x {}", xs.size(), x.count, y.count);
  Map map{.values = Field::Constant(x.count, y.count, Map::unknown)};
  std::vector<bool> known(static_cast<std::size_t>(map.values.size()));
  for (Index i = 0; i < xs.size(); ++i) {
    const Index at_x = x.place(xs(i)), at_y = y.place(ys(i));
    const auto at = static_cast<std::size_t>(at_x * y.count + at_y);
    if (known[at])
      refuse("point x = {}{} is given twice", shortest(xs(i)), profile ? "" : ", y = " + shortest(ys(i)));
    known[at] = true;
    map.values(at_x, at_y) = zs(i);
  }
  const double dx = metres[0] * x.step, dy = metres[1] * y.step;
  map.spacing = {x.count > 1 ? dx : dy, y.count > 1 ? dy : dx};
  return map;
}

}  // namespace asperity
