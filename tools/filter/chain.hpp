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

 private:
  struct Link {
    std::string option, value;
    Act act;

    std::string words() const { return option + " " + value; }
  };
  std::vector<Link> links_;
};

}  // namespace asperity::cli
