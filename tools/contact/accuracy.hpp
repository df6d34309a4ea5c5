/// --accuracy: the same surface on finer cells, until the errors that the grid leaves are small enough.
#pragma once

#include "tools/contact/press.hpp"

namespace asperity::cli {

struct Accurate {
  Pressed pressed;
  std::string unreached;  ///< why the accuracy is not reached; empty where it is
};

/// Presses the scene on its own cells, then on 2, 4, 8 and 16 times as many along each side, of the surface
/// refined by its own band limit, and leaves the last of these scenes with its result.
Accurate press_accurately(const Tool& tool, const ContactOptions& options, ContactScene& scene,
                          Influence& influence);

}  // namespace asperity::cli
