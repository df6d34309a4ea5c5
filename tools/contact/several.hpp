/// Contacts of several surfaces: a row for each with the mean over them, or the mean of their sweeps.
#pragma once

#include <functional>

#include "tools/cli/table.hpp"
#include "tools/contact/press.hpp"

namespace asperity::cli {

/// The table of the loads of a scene, whose unconverged rows are told by `of`; raises `code` to the worst.
using Sweep = std::function<Table(const ContactScene& scene, ElasticOperator& influence,
                                  const std::string& of, int& code)>;

/// Prints the table; surfaces that fail are rows without a result, and not in the mean. Returns the worst of
/// the exit codes.
int press_several(Tool& tool, ContactOptions& options);
/// The same of sweeps: a row for each load, with the mean over the surfaces that converged under it.
int sweep_several(Tool& tool, ContactOptions& options, const Sweep& sweep);

}  // namespace asperity::cli
