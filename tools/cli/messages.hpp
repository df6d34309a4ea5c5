/// Messages to the user: one line each on standard error, in place of a line of progress. Warnings are also
/// kept, for the result that they are about.
#pragma once

#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace asperity::cli {

class Options;

class Messages {
 public:
  Messages(std::string tool, const Options& options) : tool_(std::move(tool)), options_(options) {}

  void declare(Options& options);  ///< --quiet, --verbose

  bool quiet() const { return quiet_; }
  bool verbose() const { return verbose_; }
  /// "TOOL: text"; a warning is printed even with --quiet, a note only without it. Those of several datasets
  /// come in the order of these, and so does about().
  /// `kept`: for take_warnings(), too.
  void warn(const std::string& text, bool kept = true) const;
  void note(const std::string& text) const;
  void detail(const std::string& text) const;  ///< with --verbose only
  /// From here on, warnings and notes are about one of several surfaces: of those that differ in numbers
  /// alone the first is printed, the others are counted. After "", which prints the counts, they are about
  /// the run, and so are those printed before: its result is one of all surfaces.
  void about(const std::string& surface) const;
  /// The warnings printed so far.
  const std::vector<std::string>& warnings() const { return printed_; }
  /// Those about the dataset that this thread works on, and those of the run before it, each once. None of
  /// them is about another dataset afterwards, but those of the run.
  std::vector<std::string> take_warnings() const;
  /// Those taken on the thread that worked on this dataset before.
  void go_on_with(std::vector<std::string>&& taken) const;
  /// A line as it is, but for what could control a terminal.
  static void say(const std::string& line);

 private:
  void keep(const std::string& warning) const;

  std::string tool_;
  const Options& options_;
  bool quiet_ = false, verbose_ = false;
  // Warnings or notes of several surfaces.
  class Repeated {
   public:
    /// The line to print now, "s_1.nc: text"; none if one of other numbers has been printed, or this for the
    /// same surface.
    std::optional<std::string> first(const std::string& surface, const std::string& text);
    /// A line for each kind that came again, "3 more surfaces, up to s_9.nc: text"; begins anew.
    std::vector<std::string> rest();

   private:
    struct Kind {
      std::string words;  ///< without numbers
      int more = 0;
      std::string surface = {}, text = {};  ///< of the last
    };
    std::vector<Kind> kinds_;
    std::set<std::string> seen_ = {};
  };
  mutable std::string subject_;  ///< of warnings: one of several surfaces
  mutable Repeated warnings_, notes_;
  mutable std::vector<std::string> printed_;
  mutable std::mutex mutex_;
  mutable std::vector<std::string> of_run_;  ///< outside pieces of work (cli/ordered_work.hpp)
};

/// "--load is required", but "--load: '5' has no unit".
std::string sentence(const std::string& subject, const std::string& text);
/// The library names parameters between ` and `; here they are options, perhaps of another tool.
std::string with_options(std::string text, const Options& options);

}  // namespace asperity::cli
