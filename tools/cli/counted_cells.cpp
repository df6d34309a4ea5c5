#include "tools/cli/counted_cells.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"

namespace asperity::cli {
namespace {

// More than 0 where a cell is in contact; nothing where the dataset does not tell.
std::optional<Field> contact_of(const Dataset& data) {
  for (const char* name : {"contact", "pressure"})
    if (data.has(name)) return field_of(data, name, Missing::not_a_number);
  return std::nullopt;
}

const char* verb(double count) { return count == 1 ? "is" : "are"; }

}  // namespace

std::string CountedCells::told() const {
  return fmt::format("{} of the {} that {} {}; the other {:.3g} % of {:.0f} cells are {}, and not counted",
                     variable, asperity::counted(static_cast<std::int64_t>(counted), "cell"), verb(counted),
                     which, 100 * (1 - counted / cells), cells, without);
}

std::string CountedCells::told_of_all() const {
  return fmt::format("{} of all {:.0f} cells, of which {:.0f} {} {}: asperity-pdf counts these alone",
                     variable, cells, counted, verb(counted), which);
}

std::optional<CountedCells> counted_cells(const Dataset& data, const std::string& variable) {
  if (!data.has(variable) || (variable != "pressure" && variable != "gap")) return std::nullopt;
  const bool pressure = variable == "pressure";
  const std::optional<Field> contact = contact_of(data);
  if (!contact) return std::nullopt;
  CountedCells out{.variable = variable,
                   .units = si_unit_of(data.at(variable)),
                   .grid = grid_of(data),
                   .values = field_of(data, variable, Missing::not_a_number),
                   .which = pressure ? "in contact" : "open",
                   .without = pressure ? "open, without pressure" : "in contact, without a gap"};
  out.cells = static_cast<double>((!out.values.isNaN()).count());
  const Field& in_contact = pressure ? out.values : *contact;
  const Eigen::ArrayXX<bool> counts = pressure ? (in_contact > 0).eval() : (in_contact == 0).eval();
  out.values = counts.select(out.values, NAN).eval();
  out.counted = static_cast<double>((!out.values.isNaN()).count());
  if (out.counted == 0)
    throw DataError(variable, "no cell is " + std::string(pressure ? "in contact" : "open"));
  return out;
}

}  // namespace asperity::cli
