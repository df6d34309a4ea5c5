/// Runs command lines of the real tools, as a user types them.
#pragma once

#include <map>
#include <string>
#include <vector>

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

/// A table as tools print it into a pipe: its columns by their names, its rows by the word in the first.
class Printed {
 public:
  explicit Printed(const std::string& text);
  bool has(const std::string& column) const { return columns_.contains(column); }
  const std::vector<double>& operator[](const std::string& column) const;  ///< NaN where a word stands
  double at(const std::string& row, const std::string& column = "value") const;
  std::vector<std::string> rows;

 private:
  std::map<std::string, std::vector<double>> columns_;
};

/// Waits until the clock shows another second than now.
void await_next_second();

}  // namespace asperity::test
