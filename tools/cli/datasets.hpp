/// Datasets in and out of a tool: INPUT, --from, --output, --json, --report; the files that a run reads and
/// writes, so that no output replaces an input or another output; history and source of what is written.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "dataset/bytes.hpp"
#include "dataset/dataset.hpp"
#include "tools/cli/input_format.hpp"

namespace asperity::cli {

class Messages;
class Options;
class RunSettings;

class Datasets {
 public:
  Datasets(Options& options, const Messages& messages, RunSettings& settings)
      : options_(options), messages_(messages), settings_(settings) {}

  // What a tool has.
  void input();                              ///< positional INPUT, "-" unless given, and input_format()
  void input_format();                       ///< --from, --channel and --from-order, of what read() reads
  void output() { writes_dataset_ = true; }  ///< -o, --output of a dataset
  void output_of_any_format() { writes_dataset_ = writes_any_ = true; }  ///< the same, text perhaps
  void table() { writes_table_ = true; }                                 ///< -o, --output of a table, --json
  void report() { reports_ = true; }  ///< --report FILE.json: attributes with the tool's prefix

  // The options themselves, where the tool has them.
  void declare_memory();  ///< --memory of a tool that reads, unless it has it
  void declare_output();
  void declare_history();

  /// Before the work: throws ParameterError for names of outputs that cannot be.
  void check_outputs();
  /// Whether INPUT is a terminal: nobody pipes anything in.
  bool lacks_input() const;

  const std::string& input_name() const { return input_; }
  const std::string& output_name() const { return output_; }
  const InputFormat& format() const { return format_; }
  bool json() const { return json_; }
  bool table_is_text() const { return table_ == "text" || (table_ == "auto" && output_is_terminal()); }
  bool output_is_terminal() const;

  /// Of a tool that writes a dataset or a table: which of them goes to --output in this run.
  void writes_dataset(bool dataset) { result_is_dataset_ = dataset; }
  bool result_is_dataset() const { return result_is_dataset_; }
  /// A further output; throws UsageError(option, …) where it is another output's file.
  void writes(const std::string& option, const std::string& name);
  /// This file is read from here on: errors in data name it. Throws UsageError where an output would replace
  /// it. `passed_on`: --output may, because the whole content goes there.
  void reads(const std::string& name, bool passed_on = false) const;
  /// An error in the data of the file that was read last, as a line: "rough.nc: heights: …".
  std::string in_file(const DataError& error) const;

  // A large variable is read when it is needed (dataset/unread.hpp).
  Dataset read() const;  ///< the dataset named by INPUT
  /// "-" is stdin. `held` bytes are in use by other inputs.
  Dataset read(const std::string& name, std::size_t held = 0) const;
  /// The dataset in bytes that were read from `name`; bytes that are given away keep its unread values.
  Dataset read(const Bytes& bytes, const std::string& name, std::size_t held = 0) const;
  Dataset read(Bytes&& bytes, const std::string& name, std::size_t held = 0) const;
  /// Settles lengths (dataset/layout.hpp) and notes what was settled; `name` is that of one file among
  /// several.
  void settle(Dataset& dataset, const std::string& name = "-") const;

  void write(Dataset& dataset);  ///< to --output, after history, source and --report
  /// To another file, which gets its name in order (cli/ordered_work.hpp). `lines`: what the run did, as of
  /// sign().
  void write(Dataset& dataset, const std::string& name, const std::vector<std::string>& lines = {}) const;
  void write_text(const std::string& text) const;  ///< to --output, every byte checked
  // The parts of write(), for a tool that writes its dataset piece by piece.
  /// Conventions, source and history; `lines` are what the run did, after its command.
  void sign(Dataset& dataset, const std::vector<std::string>& lines = {}) const;
  /// Adds those of take_warnings(), or of `lines`, that the dataset has not to the attribute PREFIX_warnings.
  /// sign() does so for the tool's own result.
  void record_warnings(Attributes& attributes, std::string_view prefix) const;
  void record_warnings(Attributes& attributes, std::string_view prefix,
                       const std::vector<std::string>& lines) const;
  void write_report(const Dataset& dataset) const;  ///< to --report, if given

 private:
  Dataset read_by(const std::string& name, std::string_view first_bytes,
                  const std::function<Dataset()>& decoded) const;

  Options& options_;
  const Messages& messages_;
  RunSettings& settings_;
  std::string input_ = "-", output_ = "-", report_, table_ = "auto";
  struct Output {
    std::string option, name;
  };
  std::map<std::string, Output> outputs_;  ///< by what they are (cli/output_name.hpp)
  InputFormat format_;
  bool takes_input_ = false, reads_ = false, writes_dataset_ = false, writes_any_ = false,
       writes_table_ = false, reports_ = false, result_is_dataset_ = false, json_ = false,
       no_history_ = false;
};

}  // namespace asperity::cli
