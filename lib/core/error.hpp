/// What can be wrong with a request, in the user's words: the name of it, so that a tool can say "load: ..."
/// in one line, and a text with the value and the bound that it breaks.
#pragma once

#include <stdexcept>
#include <string>

namespace asperity {

/// A parameter outside its bounds. `name` is spelled as on the command line: words joined by hyphens.
class ParameterError : public std::invalid_argument {
 public:
  ParameterError(std::string parameter, const std::string& message)
      : std::invalid_argument(message), name(std::move(parameter)) {}
  std::string name;
};

/// Throws ParameterError unless it holds.
inline void check_parameter(bool holds, const char* parameter, const std::string& message) {
  if (!holds) throw ParameterError(parameter, message);
}

/// Data that cannot be used: a dataset, a variable or a field of it. `name` is the variable's.
class DataError : public std::runtime_error {
 public:
  DataError(std::string variable, const std::string& message)
      : std::runtime_error(message), name(std::move(variable)) {}
  std::string name;
};

/// A dataset without a variable that is needed.
class MissingVariable : public DataError {
 public:
  using DataError::DataError;
};

}  // namespace asperity
