/// A map of one quantity over a rectangle, from a file of another program.
///
/// It is the step between file formats (formats/format.hpp) and Asperity's dataset (dataset/layout.hpp).
/// Values are (x, y), with x the first index. Lengths, heights too, become metres; any other quantity keeps
/// its unit.
///
/// In formats that name their axes (GSF, SDF, X3P, NRRD, ESRI, Gwyddion text) x runs along a line, and the
/// first line has the smallest y; in ESRI grids the first line is the north, the largest y. A bare matrix
/// (text, npy) does not give the order: Reading does.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity {

/// The indices of a bare matrix, the slower one first: `xy` has a line for each x, `yx` a line for each y.
enum class Order { xy, yx };

/// Separator of the numbers and decimal mark of a text; `any`: found from the text.
enum class Separator { any, blank, tab, comma, semicolon };
enum class DecimalMark { any, point, comma };

/// What the user says of a file. Each format uses what its files do not say.
struct Reading {
  Reading(Order order_of_matrix = Order::xy) : order(order_of_matrix) {}

  Order order;
  Separator separator = Separator::any;
  DecimalMark decimal = DecimalMark::any;
  std::vector<std::string> missing = {};  ///< further words and numbers of missing points in a text
  std::string columns = {};  ///< of a text: of z, x z or x y z by number or name, perhaps with units:
                             ///< "1/um,2/um,4/nm"; "none": all are heights; "": as its header says
  bool unit_told = false;    ///< the caller knows the unit of the values if the file gives none
  bool size_told = false;    ///< the caller knows the size of the map
  std::string channel =
      {};  ///< of a file of several maps: its name or number (chosen_channel in formats/format.hpp)
  MemoryBound memory = {};  ///< without the file's bytes, if the caller counts them as taken
};

struct Map {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Field values;                                     ///< (x, y) in SI if they are lengths; NaN: missing
  std::array<double, 2> spacing{unknown, unknown};  ///< Δx, Δy [m]; NaN: not in the file
  std::string units = {};       ///< "m", or a unit that is not a length; "": not in the file
  std::string file_units = {};  ///< as the file spells them, or ""
  std::string title = {};       ///< the channel's name, or ""
  decltype(Grid::periodic) periodic = {};
  std::string history = {};     ///< "time: command" of another program that read the file, or ""
  std::string understood = {};  ///< how a file was read, for a person: one line, or ""
};

/// Metres per unit of length as instruments spell it ("µm", "um"). Throws DataError("map", …) for others.
double metres_per(std::string_view unit);
bool is_length(std::string_view unit);
/// Whether two units are the same length.
bool same_length(const std::string& a, const std::string& b);
/// Whether UDUNITS knows a unit, of any quantity; not so of numbers.
bool is_unit(std::string_view unit);
/// Converts lengths to metres; other values stay. Throws DataError("map", …) when a value becomes infinite.
void set_units(Map& map, std::string_view unit);

/// In binary files an infinity is no height either: it becomes missing, and `understood` says so.
void leave_out_infinite(Map& map);
/// Throws DataError("map", …) when a value is infinite in metres.
void require_finite(const Map& map);

/// [m]; a mark of missing points may be so large, in any unit of length, but no height is.
inline constexpr double no_height = 1e20;
/// Throws DataError("map", …) with a height that is none.
void require_heights(const Map& map);
/// Throws DataError("map", …) for a map of unknown size, which `format` needs.
void check_size(const Map& map, const std::string& format);
/// Also for a quantity that is not a length, which `format` cannot hold.
void check_heights(const Map& map, const std::string& format);

/// For a person: that another program read the file, and how it was read.
std::vector<std::string> notes_of(const Map& map);
/// As a dataset with x, y and `heights`, or `values` if the quantity is not a length; missing points become
/// `mask` and _FillValue. Without a unit, metres are assumed. Throws DataError("x", …) when the map has no
/// size, DataError("map", …) when a height is none, DataError(name, …) when a point is infinite or all are
/// missing.
Dataset dataset_of(const Map& map);
/// The map of a variable on (x, y).
Map map_of(const Dataset& dataset, std::string_view variable);

}  // namespace asperity
