/// The manual page of a tool.
#pragma once

#include <string>

#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct ExitStatus {
  Exit code;
  const char* meaning;
};
inline constexpr ExitStatus exit_statuses[] = {{done, "done"},
                                               {runtime_error, "input or output failed"},
                                               {usage_error, "wrong usage"},
                                               {not_converged, "not converged"},
                                               {bad_data, "bad input data"}};

/// In the man macros of roff.
std::string man_page(const Tool& tool);
/// A text as roff prints it, with no character that it takes for its own: \ - ' ` ^ ~ and a period at the beginning of
/// a line; what is not ASCII by its code point.
std::string roff(const std::string& text);

}  // namespace asperity::cli
