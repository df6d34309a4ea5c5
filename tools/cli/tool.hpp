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
/// A tool is its options, its messages, the settings of its run and its datasets; what needs only one of
/// them takes this one. Exit codes, error messages, common options, the environment and history are the same
/// for all tools.
#pragma once

#include <functional>
#include <string>

#include "core/stopwatch.hpp"
#include "tools/cli/datasets.hpp"
#include "tools/cli/messages.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/run_settings.hpp"

namespace asperity::cli {

/// Exit codes.
enum Exit : int { done = 0, runtime_error = 1, usage_error = 2, not_converged = 3, bad_data = 4 };

class Tool : public Options, public Messages, public RunSettings, public Datasets {
 public:
  /// One of the toolbox (cli/toolbox.hpp).
  Tool(const std::string& name, const std::string& description);

  /// Parses and runs `body`, which returns an exit code; an exception becomes one line on stderr and a code.
  int run(int argc, char** argv, const std::function<int()>& body);

 private:
  void declare_common();
  int guarded(int argc, char** argv, const std::function<int()>& body);
  int answer(int argc, char** argv, const std::function<int()>& body);
  int fail(Exit code, const std::string& message);

  Stopwatch clock_;
  std::string last_words_;  ///< of what ends the run
  bool time_ = false;
};

}  // namespace asperity::cli
