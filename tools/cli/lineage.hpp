/// A new result replaces the former one together with everything computed from it (dataset/catalogue.hpp):
/// from heights, or from the field that contact_variable, acf_variable or psd_variable names. A note lists
/// what was dropped:
///
///     const Inventory before(data);
///     drop_results(data, "contact", "heights_residual");     // which is pressed, and stays
///     ...                                                     // the new pressure
///     before.tell(tool, data, "pressure");
///
/// Variables that the catalogue does not name are the user's own. They stay, unless the surface or the grid
/// changes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/map.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// Removes a result and everything computed from it, directly or not. `input`, from which the new result is
/// computed, stays, and so does what was computed from it.
void drop_results(Dataset& data, std::string_view result, std::string_view input = {});
/// The same before a new surface: every variable on (x, y) belongs to the former one.
void drop_surface(Dataset& data, std::string_view result = "heights");
/// Removes one variable, with dimensions and coordinates that no other has.
void drop_variable(Dataset& data, std::string_view name);

/// Puts a new map in place of the surface: drops what belonged to the former one, and notes it. What was
/// removed from the surface was removed from the map too, unless it is that of another variable.
void replace_surface(const Tool& tool, Dataset& data, const Map& map, bool another = false);

/// The names in a dataset, without coordinates, so that a tool can list at the end which of them were
/// dropped.
class Inventory {
 public:
  Inventory() = default;
  explicit Inventory(const Dataset& data);

  std::vector<std::string> missing_in(const Dataset& now) const;
  /// Notes what is missing in `now`. `coming`, names between blanks, is still to be written; `replaced` names
  /// the new result: "pressure".
  void tell(const Tool& tool, const Dataset& now, const std::string& replaced,
            std::string_view coming = {}) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace asperity::cli
