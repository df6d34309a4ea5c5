/// Runs command lines of the real tools, as a user types them.
#pragma once

#include <string>

namespace asperity::test {

struct Outcome {
  int exit;                ///< of the last command of the pipe that failed, 128 + n when signal n ended it
  std::string out, error;  ///< standard output and standard error
};

/// Runs a line of bash with pipefail, the tools on PATH, nothing on standard input, in a folder of this
/// process that is empty when the process begins and gone when it has ended.
Outcome shell(const std::string& line);

/// The path of a file in that folder.
std::string scratch(const std::string& name);

/// Waits until the clock shows another second than now.
void await_next_second();

}  // namespace asperity::test
