/// Options of a program: declared with a text and a place for the value, then read.
///
///     Options options("asperity-flatten", "Subtracts the mean plane");
///     double offset = 0;
///     options.quantity("--offset", offset, "m", "Height of the plane left behind", "Plane");
///     options.parse(argc, argv);
///
/// A value comes from the command line, else the environment variable ASPERITY_<TOOL>_<OPTION> (upper case,
/// hyphens as underscores), else the --config file (cli/documents.hpp), else its default. An error names
/// where a wrong value came from. Options that are steps keep their order, and one may come again.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "tools/cli/quantity.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace asperity::cli {

struct ExitStatus {
  int code;
  std::string meaning;
};

/// What help and the manual page say besides the options.
struct Documents {
  std::string example;
  std::vector<std::string> essential;  ///< options of the short help, in its order
  std::vector<ExitStatus> statuses;
  std::map<std::string, std::string> units =
      {};  ///< the SI unit in which a program gives a number, by option
};

/// "ASPERITY_STATS_LAMBDA_C" of asperity-stats and lambda-c.
std::string environment_name(const std::string& tool, const std::string& option);

/// An option, to which its declaration may add; each function returns the option itself.
struct Option {
  CLI::Option* of;

  Option required() const;
  Option needs(Option other) const;
  Option excludes(Option other) const;
  Option without_default() const;  ///< its text states the default
};

/// Options that contradict each other: "TOOL: --OPTION: message", exit 2.
using UsageError = ParameterError;
/// A command line or a file of options that cannot be read; the message is complete.
struct CommandLineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Thrown by an option that asks for a text in place of a run, such as --help.
struct Printout {
  std::string text;
};

/// For Options::parsed: what is given becomes the value; `parse` may want more than the option and its text.
template <class T, class Parse, class... More>
auto into(T& value, Parse parse, More... more) {
  return [&value, parse, more...](const std::string& key, const std::string& given) {
    value = static_cast<T>(parse(key, given, more...));
  };
}

class Options {
 public:
  /// Of one of the toolbox (cli/toolbox.hpp).
  Options(std::string name, std::string description);
  ~Options();

  const std::string& name() const { return name_; }

  // What help says besides the options.
  /// A command line that works as it stands.
  void example(std::string command) { documents_.example = std::move(command); }
  /// The options of the short help, -h, in its order.
  void essential(std::vector<std::string> options) { documents_.essential = std::move(options); }
  /// Besides those that all tools have.
  void exit_status(int code, std::string meaning) {
    documents_.statuses.push_back({code, std::move(meaning)});
  }

  // `group` is the heading in --help; the variable's present value is the default shown there.
  Option flag(const std::string& name, bool& value, const std::string& text, const std::string& group);
  Option integer(const std::string& name, int& value, const Bounds& bounds, const std::string& text,
                 const std::string& group);
  Option number(const std::string& name, double& value, const std::string& text, const std::string& group);
  Option text(const std::string& name, std::string& value, const std::string& what, const std::string& text,
              const std::string& group);
  /// The same, of an option that may be repeated.
  Option texts(const std::string& name, std::vector<std::string>& values, const std::string& what,
               const std::string& text, const std::string& group);
  Option choice(const std::string& name, std::string& value, const std::vector<std::string>& among,
                const std::string& text, const std::string& group);
  /// "A,B", some of the words, each once.
  Option words(const std::string& name, std::vector<std::string>& value,
               const std::vector<std::string>& among, const std::string& text, const std::string& group);
  /// One quantity with a unit, in SI: "5000N". `unit` is the SI unit that gives its dimension.
  Option quantity(const std::string& name, double& value, const std::string& unit, const std::string& text,
                  const std::string& group);
  /// "A,B", or one value for both; pure numbers of unit "1".
  Option quantities(const std::string& name, std::array<double, 2>& values, const std::string& unit,
                    const std::string& text, const std::string& group);
  /// "17px,4px", "0.4mm", or one value for both: lengths that may count samples.
  Option lengths(const std::string& name, std::array<SampledLength, 2>& values, const std::string& text,
                 const std::string& group);
  /// "AxB", each within the bounds.
  Option counts(const std::string& name, Shape& value, const Bounds& bounds, const std::string& text,
                const std::string& group);
  /// What `read` makes of a text; it throws ParameterError(key, …). `shown` is the default.
  using Read = std::function<void(const std::string& key, const std::string& given)>;
  Option parsed(const std::string& name, const std::string& kind, const std::string& text,
                const std::string& group, const std::string& shown, const Read& read);
  /// A word, or several of them, known by its place: INPUT.
  Option argument(const std::string& name, std::string& value, const std::string& kind,
                  const std::string& text);
  Option arguments(const std::string& name, std::vector<std::string>& values, const std::string& kind,
                   const std::string& text);
  /// The one option that may have an empty value.
  void may_be_empty(Option option) { may_be_empty_ = option.of; }

  /// An option whose order among others counts, and that may come again; steps() has its values.
  Option step(const std::string& name, const std::string& kind, const std::string& text,
              const std::string& group);
  /// --steps, the same as one text, for what has no order: --config and the environment.
  void steps_in_a_text(const std::string& group);

  // Options of all programs, under the heading Common.
  void config();       ///< --config FILE
  void dump_config();  ///< --dump-config
  void documents();    ///< --man, --completion, --describe, --version, -h, --help
  /// No options but these documents(), and no variables: a program that computes nothing.
  void documents_only() { computes_ = false; }
  bool computes() const { return computes_; }

  /// Throws ParameterError for a wrong value, CommandLineError, or Printout.
  void parse(int argc, char** argv);

  // Afterwards.
  bool has(const std::string& option) const;
  bool given(const std::string& option) const;  ///< false of one that the tool does not have
  std::vector<std::string> given_under(const std::vector<std::string>& headings) const;  ///< their names
  struct Step {
    std::string option, value;  ///< its name without hyphens
  };
  /// In the order of the command line; without any there, those of --steps.
  std::vector<Step> steps() const;
  const std::string& command_line() const { return command_line_; }
  std::string config_file() const;      ///< of --config; "" without
  std::string config_to_print() const;  ///< what --dump-config asks for; "" without
  /// Where the value of an option came from, and the value as it was typed, where `message` begins with what
  /// the library makes of it: "--load 5N".
  std::string typed(const std::string& option, const std::string& message) const;

 private:
  Option in_units(const std::string& unit, Option option);
  std::vector<Step> steps_of_command_line() const;
  std::vector<Step> steps_of_text() const;
  void settle_steps();
  std::vector<std::string> environment() const;
  void check_environment() const;
  std::string origin(const std::string& option) const;
  std::string unexpected() const;
  std::vector<std::string> with_empty_values(const std::vector<std::string>& arguments) const;
  void read_values();

  std::unique_ptr<CLI::App> app_;
  std::string name_, command_line_;
  Documents documents_;
  std::vector<std::string> arguments_, environment_;  ///< of the command line; those that variables stand for
  const CLI::Option* may_be_empty_ = nullptr;
  std::vector<const CLI::Option*> step_options_;
  std::string steps_text_;
  bool computes_ = true, dump_config_ = false;
};

}  // namespace asperity::cli
