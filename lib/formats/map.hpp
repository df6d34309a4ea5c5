/// A map of one quantity over a rectangle, as the files of other programs hold it.
///
/// It stands between their formats (formats/format.hpp) and Asperity's dataset (dataset/layout.hpp). Values
/// are (x, y), x the first index. Lengths become metres, heights too; any other quantity keeps its unit.
///
/// Formats that name their axes (GSF, SDF, X3P, NRRD, ESRI, Gwyddion's text) have x run along a line, and
/// begin with the least y; ESRI's, a chart, begins with the north, the largest. A bare matrix (text, npy)
/// does not say: Reading tells.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "core/field.hpp"
#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity {

/// The indices of a bare matrix, the slower one first: `xy` has a line for each x, `yx` one for each y.
enum class Order { xy, yx };

/// What stands between the numbers of a text, and what marks their decimals; `any` where the text is to tell.
enum class Separator { any, blank, tab, comma, semicolon };
enum class DecimalMark { any, point, comma };

/// What a user knows of a file that it does not say itself. Each format heeds what it leaves open.
struct Reading {
  Reading(Order order_of_matrix = Order::xy) : order(order_of_matrix) {}

  Order order;
  Separator separator = Separator::any;
  DecimalMark decimal = DecimalMark::any;
  bool heights = false;  ///< a text's columns are heights, though the first of them look like coordinates
  double coordinate =
      0;  ///< a text's lines are points, x z or x y z, with x and y in this many metres; 0: heights
  MemoryBound memory = {};  ///< beside the file's bytes, where the caller counts them as taken
};

struct Map {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Field values;                                     ///< (x, y) in SI if they are lengths; NaN where missing
  std::array<double, 2> spacing{unknown, unknown};  ///< Δx, Δy [m]; NaN where the file does not say
  std::string units = {};  ///< "m", or what is not a length; "" where the file does not say
  std::string title = {};  ///< the channel's name, or ""
};

/// Metres in a unit of length as instruments spell it ("µm", "um"). Throws DataError("map", …) of others.
double metres_per(std::string_view unit);
/// In metres if the unit is a length, else as they are. Throws DataError("map", …) where one gets infinite.
void set_units(Map& map, std::string_view unit);

/// Throws DataError("map", …) for a map of unknown size, which `format` cannot do without.
void check_size(const Map& map, const std::string& format);
/// The same, and for a quantity that is not a length, where `format` holds no other.
void check_heights(const Map& map, const std::string& format);

/// As a dataset with x, y and `heights`, or `values` where the quantity is no length; missing points become
/// `mask` and _FillValue. A unit that the file does not state is the metre. Throws DataError("x", …) when the
/// map has no size, DataError(name, …) when a point is infinite or none is there.
Dataset dataset_of(const Map& map);
/// A variable on (x, y) of a dataset.
Map map_of(const Dataset& dataset, std::string_view variable);

}  // namespace asperity
