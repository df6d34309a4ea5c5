/// The steps of asperity-filter: read from the command line before any map, then run on each.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stats/measure/surface.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct StepReport {
  std::string words;       ///< what it did, for the history: "removed 3.2um rms"
  bool notable = false;    ///< a note to the user, even without --verbose
  std::string doubt = {};  ///< a solver has not converged; "": none
};

using Act = std::function<StepReport(const Tool&, Surface&)>;

struct StepKind {
  const char *option, *kind;  ///< "crop", "A:B,C:D"
  std::string text;
  const char* group;
  /// Reads the value before the map is there; throws ParameterError(option, …).
  Act (*act)(const std::string& value);
};

std::vector<StepKind> value_steps();  ///< forms, waves, closing, opening, median, outliers, fill, scale
std::vector<StepKind> grid_steps();   ///< crop, decimate, refine, spacing, rotate, mirror, make-periodic

// ---- figures of a report ----

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

// ---- the chain ----

class Chain {
 public:
  static void declare(Tool& tool);
  /// Throws UsageError for a wrong value, without any step, and where no wave passes two of them.
  explicit Chain(const Tool& tool);

  struct Result {
    std::vector<std::string> lines;  ///< "1. crop 0:8,0:8: now 8x8 cells …"
    bool converged = true;
  };
  Result operator()(const Tool& tool, Surface& surface) const;

 private:
  struct Link {
    std::string option, value;
    Act act;

    std::string words() const { return option + " " + value; }
  };
  std::vector<Link> links_;
};

}  // namespace asperity::cli
