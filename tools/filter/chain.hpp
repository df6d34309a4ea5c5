/// The steps of a command line, read before any map and run on each.
#pragma once

#include <string>
#include <vector>

#include "tools/filter/step.hpp"

namespace asperity::cli {

class Chain {
 public:
  static void declare(Tool& tool);
  /// Throws UsageError for a wrong value, without any step, and where no wave passes two of them.
  explicit Chain(const Tool& tool);

  struct Ran {
    std::vector<std::string> lines;  ///< "1. crop 0:8,0:8: now 8x8 cells …"
    bool converged = true;
  };
  Ran operator()(const Tool& tool, Surface& surface) const;

  /// The first step that needs the whole map; "" if none does.
  std::string needs_whole_map() const;
  /// The lines, of steps on the parts of a map.
  std::vector<std::string> operator()(const Tool& tool, FieldParts& parts, const std::string& units) const;

 private:
  struct Link {
    std::string option, value;
    Act act;
    ActOnParts act_on_parts;  ///< empty: none

    std::string words() const { return option + " " + value; }
  };
  std::vector<Link> links_;
};

}  // namespace asperity::cli
