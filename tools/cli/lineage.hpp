/// A result that is replaced takes with it all that was computed from it (dataset/catalogue.hpp), from
/// heights or the field that contact_variable, acf_variable or psd_variable names, and what is gone is told:
///
///     const Inventory before(data);
///     drop_results(data, "contact", "heights_residual");     // which is pressed, and stays
///     ...                                                     // the new pressure
///     before.tell(tool, data, "pressure");
///
/// What the catalogue does not name is a user's own and stays, unless its surface or its grid is another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// Removes a result that is to be replaced and all that rests on it, directly or not. `input`, which the new
/// one is computed from, stays with what rests on it.
void drop_results(Dataset& data, std::string_view result, std::string_view input = {});
/// The same where another surface is to come: whatever lies on (x, y) belongs to the former one.
void drop_surface(Dataset& data, std::string_view result = "heights");

/// The names in a dataset, coordinates apart, so that a tool can tell in the end which of them are gone.
class Inventory {
 public:
  Inventory() = default;
  explicit Inventory(const Dataset& data);

  std::vector<std::string> missing_in(const Dataset& now) const;
  /// Notes what is missing in `now` but for `coming`, a list between blanks, which is yet to be written.
  /// `replaced` says what is new: "pressure".
  void tell(const Tool& tool, const Dataset& now, const std::string& replaced,
            std::string_view coming = {}) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace asperity::cli
