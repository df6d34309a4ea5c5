/// The steps of asperity-filter: what each does to a map, and how it tells of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stats/measure/surface.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// What a step did, "removed 3.2um rms", for the history.
struct Account {
  std::string words;
  bool told = false;       ///< to the user too, even without --verbose
  std::string doubt = {};  ///< a solver has not converged; "": none
};

using Act = std::function<Account(const Tool&, Surface&)>;

struct StepKind {
  const char *option, *kind;  ///< "crop", "A:B,C:D"
  std::string text;
  const char* group;
  /// Reads the value before the map is there; throws ParameterError(option, …).
  Act (*act)(const std::string& value);
};

std::vector<StepKind> form_steps();   ///< form and waves
std::vector<StepKind> point_steps();  ///< closing, opening, median, outliers, fill, scale
std::vector<StepKind> grid_steps();   ///< crop, decimate, refine, spacing, rotate, mirror, make-periodic

// ---- figures of an account ----

/// "3.2um" to four digits; of a field in other units "3.2 V".
std::string figure(double value, const std::string& units);
struct Spread {
  double mean = 0, rms = 0;  ///< rms about the mean; both zero where all is missing
  explicit Spread(const Field& z);
};
/// What left a map, and what is left of it.
struct Removal {
  Spread gone, left;

  Removal(const Field& before, const Field& after) : gone(before - after), left(after) {}
  /// "removed 3.2um rms about a mean of 12um; 0.4um rms is left".
  std::string words(const std::string& units) const;
  /// Whether more went than is left, by their rms.
  bool most() const { return gone.rms > left.rms; }
};
std::string removed(const Field& before, const Field& after, const std::string& units);
/// "31 of 1024 points (3 %)".
std::string share_of(Index points, Index all);
/// Points that are missing.
Index missing_in(const Field& z);

}  // namespace asperity::cli
