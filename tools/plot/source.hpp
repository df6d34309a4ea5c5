/// What a figure reads from a dataset: rectangles of values with their positions and meaning.
///
/// Missing points are NaN here; maps show them hatched, lines are broken by them.
#pragma once

#include <string>
#include <vector>

#include "tools/plot/figure.hpp"

namespace asperity::plot {

/// Values at cell centres; `x` and `y` are the outer edges of the cells [m].
struct Patch {
  Field values;
  Range x, y;

  double dx() const { return x.width() / static_cast<double>(values.rows()); }
  double dy() const { return y.width() / static_cast<double>(values.cols()); }
  double x_at(Index i) const { return x.low + (static_cast<double>(i) + 0.5) * dx(); }
  double y_at(Index j) const { return y.low + (static_cast<double>(j) + 0.5) * dy(); }
};

/// What the zero of a quantity is: a choice, as of heights, the least value, or between pushing and pulling.
enum class Zero { chosen, least, between };

/// Name and colours of a quantity.
struct Quantity {
  std::string name;  ///< "pressure"
  std::string unit;  ///< SI
  Zero zero;
};
Quantity quantity_of(const Variable& variable);
/// What the variable is in all cases, by its own name where theirs differ; throws DataError where units do.
Quantity quantity_of(const Cases& cases, const std::string& variable);
/// One of like variables, for one axis; the same.
Quantity shared(const std::vector<Quantity>& all, const Cases& cases, const std::string& variable);

/// variable(x, y) within the request's x and y ranges; missing points are NaN.
Patch patch_of(const Dataset& data, const std::string& variable, const Request& request);
std::vector<Patch> patches_of(const Cases& cases, const std::string& variable, const Request& request);
Range range_of(const std::vector<Patch>& patches);

/// What is shown of a block of points: of those that are there, or the point in the middle.
enum class Block { mean, largest, middle };
/// So many blocks, whose sides differ by a point where they must; NaN of those without a point.
Field in_blocks(const Field& points, Shape number, Block shown);
/// The number of blocks of this size.
Shape blocks_in(const Field& points, Shape size);
/// The largest magnitude of the coordinates shown [m].
double reach(const Patch& patch);
/// The positions of its cells in these units.
Lattice lattice_of(const Patch& patch, const Unit& x, const Unit& y, bool in_space = false);

/// What values that differ by less than 1e-3 of their size are measured from, lest they need many digits:
/// their mean, rounded to a tenth of their range; 0 for others.
struct Level {
  double value = 0;
  std::string number = {};  ///< "2.3456 mm", its size

  std::string words() const;       ///< " above 2.3456 mm", or nothing
  std::string difference() const;  ///< " − 2.3456 mm", or nothing
};
Level level_of(const std::vector<Patch>& patches, Range asked, const Quantity& quantity);

/// Where a straight section runs: along x at y = place, or along y at x = place.
struct Section {
  bool along_x = true;
  double place = 0;  ///< [m]
  Index index = 0;   ///< of the nearest row of cells

  const char* along() const { return along_x ? "x" : "y"; }
  std::string label() const;  ///< "y = 11.7 µm"
};
/// The section that "y=0", "x=0.2mm" or "y=max" (through the largest von Mises stress) names, moved to the
/// nearest row of cells (of two as near, the second); throws ParameterError("section", …).
Section section_of(const Dataset& data, const std::string& text);

/// contact_hertz_pressure; throws DataError where the dataset has none.
double hertz_pressure(const Dataset& data);

/// The value range requested, in SI, or `otherwise`; throws ParameterError("range", …) where it contains none
/// of the values from `present.low` to `present.high`.
Range value_range(const Request& request, const std::string& unit, Range present, Range otherwise);

/// The axis of this range of values.
Axis value_axis(const Request& request, Range present, Range otherwise, const Quantity& quantity,
                std::string_view name);

/// Limits colours to the range requested: of values, or from "1%:99%" of those shares of them. Without a
/// request they are limited to the shares from 0.5 to 99.5 % where these take less than an eighth of the
/// range of heights: outliers would leave a few colours to all others.
void limit(Colours& colours, const std::vector<Patch>& patches, const Quantity& quantity,
           const Request& request);

/// The request's section in all cases alike: "y=max-of-all" becomes the place of the largest von Mises stress
/// of all, others stay. Throws DataError where a case does not give its largest stress.
std::string section_of_all(const Cases& cases, const std::string& section);

/// The part of `present` that is asked for, of depths and positions; throws ParameterError(option, …) where
/// there is none.
Range part_of(Range present, Range asked, const char* option);

/// Heights over their range, values of either sign about zero, others from zero up.
Colours colours_of(Range values, const Quantity& quantity);
/// The same for fields side by side, over the range requested.
Colours field_colours(const std::vector<Patch>& patches, const Quantity& quantity, const Request& request);

}  // namespace asperity::plot
