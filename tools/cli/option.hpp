/// An option of a tool: what its declaration may add, and what the documents tell of it, which are --help, the manual page,
/// the completions and the file that --dump-config prints.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace asperity::cli {

/// A handle: its copies stand for the same option.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  // Restrictions; each returns the option itself.
  Option required() const;
  Option needs(Option other) const;
  Option excludes(Option other) const;
  Option without_default() const;  ///< its text tells the default
  Option only_on_demand() const;   ///< stands in no file of options, and in no environment
  Option refusing_empty() const;   ///< an empty value is a ParameterError

  std::vector<std::string> names() const;  ///< "-o", "--output"; none where its place tells what it is
  std::string key() const;                 ///< "output", or "INPUT" of a place
  std::string group() const;               ///< heading in --help
  std::string kind() const;                ///< of its value: "FILE", "A,B", "png|svg"
  std::string text() const;
  std::string shown_default() const;  ///< "": none is shown
  bool is_flag() const;               ///< it stands alone, without a value
  bool is_positional() const;
  bool is_required() const;
  bool is_list() const;  ///< of several values
  bool in_config() const;

  bool given() const;
  std::vector<std::string> values() const;  ///< as they were given
  bool flag_value() const;                  ///< of a flag that is given

  bool operator==(const Option&) const = default;

 private:
  CLI::Option* option_;
};

/// Options under one heading of --help.
struct OptionGroup {
  std::string heading;
  std::vector<Option> options;
};
std::vector<OptionGroup> by_group(const std::vector<Option>& options);

[[noreturn]] void refuse_empty(const std::string& key);

}  // namespace asperity::cli
