/// A tool of the chain: a filter that reads a dataset, works, and writes a dataset or a table.
///
///     cli::Tool tool("asperity-flatten", "Subtracts the mean plane");
///     tool.input();
///     tool.output();
///     double offset = 0;
///     tool.quantity("--offset", offset, "m", "Height of the plane left behind", "Plane");
///     return tool.run(argc, argv, [&] {
///       Dataset data = tool.read();
///       ...
///       tool.write(data);
///       return cli::done;
///     });
///
/// Exit codes, error messages, common options, the environment and history are the same for all tools. A
/// value comes from the command line, else the environment variable ASPERITY_<TOOL>_<OPTION> (upper case,
/// hyphens as underscores), else the --config file (cli/config.hpp), else its default; an error names where a
/// wrong value came from.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/ranks.hpp"
#include "core/stopwatch.hpp"
#include "dataset/bytes.hpp"
#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"
#include "tools/cli/input_format.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/repeated.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace asperity::cli {

/// Exit codes.
enum Exit : int { done = 0, runtime_error = 1, usage_error = 2, not_converged = 3, bad_data = 4 };

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

/// A command line whose options contradict each other: "TOOL: --OPTION: message", exit 2.
using UsageError = ParameterError;

/// For Tool::parsed: what is given becomes the value; `parse` may want more than the option and its text.
template <class T, class Parse, class... More>
auto into(T& value, Parse parse, More... more) {
  return [&value, parse, more...](const std::string& key, const std::string& given) {
    value = static_cast<T>(parse(key, given, more...));
  };
}

class Tool {
 public:
  /// One of the toolbox (cli/toolbox.hpp).
  Tool(std::string name, std::string description);
  ~Tool();
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;

  /// A command line that works as it stands.
  void example(std::string command) { documents_.example = std::move(command); }
  /// The options of the short help, -h, in its order.
  void essential(std::vector<std::string> options) { documents_.essential = std::move(options); }
  /// Besides those that all tools have.
  void exit_status(int code, std::string meaning) {
    documents_.statuses.push_back({code, std::move(meaning)});
  }

  const std::string& name() const { return name_; }

  // Options. `group` is the heading in --help; the variable's present value is the default shown there.
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

  /// An option of which the order among others counts, and that may come again; steps() has its values.
  Option step(const std::string& name, const std::string& kind, const std::string& text,
              const std::string& group);
  /// --steps, the same as one text, for what has no order: --config and the environment.
  void steps_in_a_text(const std::string& group);
  struct Step {
    std::string option, value;  ///< its name without hyphens
  };
  /// In the order of the command line; without any there, those of --steps.
  std::vector<Step> steps() const;

  /// The one option that may have an empty value.
  void may_be_empty(Option option) { may_be_empty_ = option.of; }

  /// A size of memory: "512MB", "2GiB".
  Option bytes(const std::string& name, std::size_t& value, const std::string& text,
               const std::string& group);

  // Options that several tools share.
  void input();  ///< positional INPUT, "-" unless given, and input_format()
  /// --from and --from-order, of what read() reads.
  void input_format();
  void output() { writes_dataset_ = true; }                              ///< -o, --output of a dataset
  void output_of_any_format() { writes_dataset_ = writes_any_ = true; }  ///< the same, text perhaps
  void table() { writes_table_ = true; }                                 ///< -o, --output of a table, --json
  void report() { reports_ = true; }    ///< --report FILE.json: attributes with the tool's prefix
  void threads() { threaded_ = true; }  ///< --threads N
  /// --memory SIZE; `text` says what it bounds besides an input. A tool that reads has the option anyway.
  void memory(const std::string& text);
  void seed() { seeded_ = true; }  ///< --seed N and --stream K
  /// Of a tool that several ranks may run together (core/launch.hpp); no other starts under a launcher.
  void shares_ranks() { shares_ranks_ = true; }
  /// No other options than those that print a text, and no variables: a program that computes nothing.
  void documents_only() { computes_ = false; }

  bool given(const std::string& option) const;  ///< false of one that the tool does not have
  std::vector<std::string> given_under(const std::vector<std::string>& headings) const;  ///< their names
  const std::string& input_name() const { return input_; }
  const std::string& output_name() const { return output_; }
  int thread_count() const;                            ///< resolved: at least 1
  const Ranks& ranks() const { return *ranks_; }       ///< that run it, once its options are known
  bool speaks() const { return ranks().rank() == 0; }  ///< and writes, for all of them
  std::size_t memory() const { return memory_; }       ///< that the run may take [byte]
  /// The part of it for reading; `held` is in use.
  MemoryBound memory_bound(std::size_t held = 0) const;
  std::uint64_t seed_value();  ///< from --seed, else from entropy, the same at each call
  std::uint64_t stream_value() const { return static_cast<std::uint64_t>(stream_); }
  bool json() const { return json_; }
  bool verbose() const { return verbose_; }
  bool shows_progress() const;  ///< a line of progress on standard error is wanted

  // Files that this run reads and writes, so that no output replaces an input or another output.
  /// Of a tool that writes a dataset or a table: which of them goes to --output in this run.
  void writes_dataset(bool dataset) { result_is_dataset_ = dataset; }
  bool result_is_dataset() const { return result_is_dataset_; }
  /// A further output; throws UsageError(option, …) where it is another output's file.
  void writes(const std::string& option, const std::string& name);
  /// This file is read from here on: errors in data name it. Throws UsageError where an output would replace
  /// it. `passed_on`: --output may, because the whole content goes there.
  void reads(const std::string& name, bool passed_on = false) const;

  /// Parses and runs `body`, which returns an exit code; an exception becomes one line on stderr and a code.
  int run(int argc, char** argv, const std::function<int()>& body);

  // Inside the body.
  // A large variable is read when it is needed (dataset/unread.hpp).
  Dataset read() const;  ///< the dataset named by INPUT
  /// "-" is stdin. `held` bytes are in use by other inputs.
  Dataset read(const std::string& name, std::size_t held = 0) const;
  /// The dataset in bytes that were read from `name`; bytes that are given away keep its unread values.
  Dataset read(const Bytes& bytes, const std::string& name, std::size_t held = 0) const;
  Dataset read(Bytes&& bytes, const std::string& name, std::size_t held = 0) const;
  const InputFormat& format() const { return format_; }
  /// Settles lengths (dataset/layout.hpp) and notes what was settled; `name` is that of one file among
  /// several.
  void settle(Dataset& dataset, const std::string& name = "-") const;
  void write(Dataset& dataset);  ///< to --output, after history, source and --report
  /// To another file, which gets its name in turn (cli/turns.hpp). `lines`: what the run did, as of sign().
  void write(Dataset& dataset, const std::string& name, const std::vector<std::string>& lines = {}) const;
  /// Throws UsageError(option, …) where `what`, "a contact of 64x64 cells", needs more than --memory allows.
  void require_memory(double bytes, const std::string& option, const std::string& what,
                      const std::string& instead = "") const;
  // The parts of write(), for a tool that writes its dataset piece by piece.
  /// Conventions, source and history; `lines` are what the run did, behind its command.
  void sign(Dataset& dataset, const std::vector<std::string>& lines = {}) const;
  void write_report(const Dataset& dataset) const;  ///< to --report, if given
  /// An error in the data of the file that was read last, as a line: "rough.nc: heights: …".
  std::string in_file(const DataError& error) const;
  bool output_is_terminal() const;
  void write_text(const std::string& text) const;  ///< to --output, every byte checked
  /// One line on stderr, "TOOL: text"; a warning is printed even with --quiet, a note only without it. Each
  /// is said in turn, and so is about().
  void warn(const std::string& text) const;
  void note(const std::string& text) const;
  void detail(const std::string& text) const;  ///< with --verbose only
  /// From here on, warnings and notes are about one of several surfaces, and like ones are told once; of "":
  /// those that came again are told, and the others are about the run.
  void about(const std::string& surface) const;

 private:
  Option in_units(const std::string& unit, Option option);
  std::vector<Step> steps_of_command_line() const;
  std::vector<Step> steps_of_text() const;
  void settle_steps();
  Dataset read_by(const std::string& name, std::string_view first_bytes,
                  const std::function<Dataset()>& decoded) const;
  void add_common();
  void add_seed();
  void add_running();
  void add_documents();
  void parse(int argc, char** argv);
  int guarded(int argc, char** argv, const std::function<int()>& body);
  int answer(int argc, char** argv, const std::function<int()>& body);
  std::vector<std::string> environment() const;
  std::string origin(const std::string& option) const;
  std::string typed(const std::string& option, const std::string& message) const;
  std::string config_file() const;
  std::string unexpected() const;
  void check_environment() const;
  std::vector<std::string> with_empty_values(const std::vector<std::string>& arguments) const;
  static void say(const std::string& line);
  int fail(Exit code, const std::string& message) const;

  std::unique_ptr<CLI::App> app_;
  std::string name_, command_line_;
  Documents documents_;
  std::vector<std::string> arguments_, environment_;  ///< of the command line; those that variables stand for
  std::string input_ = "-", output_ = "-", report_, progress_ = "auto";
  struct Output {
    std::string option, name;
  };
  std::map<std::string, Output> outputs_;  ///< by what they are (cli/place.hpp)
  const CLI::Option* may_be_empty_ = nullptr;
  std::vector<const CLI::Option*> step_options_;
  std::string steps_text_;
  InputFormat format_;
  std::size_t memory_;
  Stopwatch clock_;
  int threads_ = 0, stream_ = 0;
  std::optional<std::uint64_t> seed_;
  static thread_local std::string reading_;  ///< the last file that was, on this thread
  mutable std::string subject_;              ///< of warnings: one of several surfaces
  mutable Repeated warnings_, notes_;
  const Ranks* ranks_ = &alone();
  mutable std::string last_words_;  ///< of what ends the run
  bool result_is_dataset_ = false, shares_ranks_ = false;
  bool takes_input_ = false, reads_ = false, writes_dataset_ = false, writes_any_ = false,
       writes_table_ = false, reports_ = false, threaded_ = false, seeded_ = false;
  bool computes_ = true, quiet_ = false, verbose_ = false, json_ = false, no_history_ = false, time_ = false,
       dump_config_ = false;
};

}  // namespace asperity::cli
