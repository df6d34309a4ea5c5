/// Errors in a request: the name of the parameter or variable, so that a tool can print "load: ..." in one
/// line, and a text with the value and the violated bound.
#pragma once

#include <stdexcept>
#include <string>

namespace asperity {

/// A parameter outside its bounds. `name` is spelled as on the command line, with hyphens. Messages
/// name other parameters between ` and `.
class ParameterError : public std::invalid_argument {
 public:
  ParameterError(std::string parameter, const std::string& message)
      : std::invalid_argument(message), name(std::move(parameter)) {}
  std::string name;
};

/// Throws ParameterError unless `holds`.
inline void check_parameter(bool holds, const char* parameter, const std::string& message) {
  if (!holds) throw ParameterError(parameter, message);
}

/// Unusable data: a dataset or one of its variables. `name` is that of the variable.
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
