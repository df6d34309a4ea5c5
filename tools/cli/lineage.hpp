/// A result that is replaced takes with it all that was computed from it (dataset/catalogue.hpp).
///
/// Contact, acf and psd may have been computed from another field than the heights: their attribute contact_variable,
/// acf_variable or psd_variable says which, and they rest on that one. A tool that replaces a result leaves nothing
/// stale and says what is gone:
///
///     const Inventory before(data);
///     drop_results(data, "contact", "heights_residual");     // which is pressed, and stays
///     ...                                                     // the new pressure
///     before.tell(tool, data, "pressure");
///
/// What the catalogue does not name is a user's own and stays, unless the surface or the grid that it stands on is another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// Removes a result that is about to be replaced, and all that rests on it, on that again, and so on. `input`, the
/// variable that the new result is computed from, stays, and with it what rests on it.
void drop_results(Dataset& data, std::string_view result, std::string_view input = {});
/// The same where the heights are to be those of another surface: whatever lies on (x, y) belongs to the former one.
void drop_surface(Dataset& data, std::string_view result = "heights");

/// The names in a dataset, coordinates apart, so that a tool can tell in the end which of them are gone.
class Inventory {
 public:
  Inventory() = default;
  explicit Inventory(const Dataset& data);

  std::vector<std::string> missing_in(const Dataset& now) const;
  /// One line, a note, of what is missing in `now`; `coming` lists, between blanks, those that will be written
  /// behind it. `replaced`
  /// says what is new: "pressure".
  void tell(const Tool& tool, const Dataset& now, const std::string& replaced,
            std::string_view coming = {}) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace asperity::cli
