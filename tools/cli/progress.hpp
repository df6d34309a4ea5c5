/// Progress of a long computation: a line on standard error, redrawn a few times a second and wiped before
/// any message, or with --verbose a table of its steps.
///
/// Of several tools in a pipe one at a time draws: the one that holds a lock on the terminal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/stopwatch.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// State of an iteration whose residual falls to its tolerance; the bar shows the share of the decades.
struct IterationStatus {
  std::vector<std::string> stage;  ///< such as the grid; the time left is estimated anew when it changes
  double residual = 1, tolerance = 0;
  double spent = 0;  ///< share of the steps allowed, where that is more
  double steps = 0;
  std::string name = {};  ///< of the steps: "products"
  double portion = 1;     ///< of what is left of the bar, for this stage
  bool last = true;       ///< no other stage is known to follow: the time left is shown
};

/// Time left of work whose share grows, smoothed: it counts down, and rises only if it was clearly too short.
class TimeLeft {
 public:
  void start(double seconds, double share);
  /// Nothing during the first second, and until `least` of the work is done.
  std::optional<double> at(double seconds, double share, double least);

 private:
  double begin_ = 0, share_ = 0;
  double end_ = 0, left_ = 0, seconds_ = 0;  ///< end expected, time left shown last, when
  bool known_ = false;
};

class Progress {
 public:
  /// `portion` is its part of what is left of the bar: less than 1 where the run goes on with another one.
  explicit Progress(const Tool& tool, double portion = 1)
      : name_(tool.name()), shown_(tool.shows_progress()), portion_(portion) {}
  ~Progress() {
    if (shown_) wipe();
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Of steady work: "7 s left, 17 of 40 surfaces, 3.1/s".
  void count(double done, double of, const std::string& units);
  /// "7 s left, 64x64, residual 1.3e-04, 85 products/s": if each decade takes as long.
  void iterate(const IterationStatus& now);
  /// Wipes the line of whichever progress drew it, and lets another tool draw.
  static void wipe();
  /// Prints a message on a line of its own, in place of any tool's progress.
  static void say(const std::string& message);
  /// Before a table on the same terminal.
  static void clear();

 private:
  struct Stage {
    std::vector<std::string> words;
    double seconds, steps, share, portion;  ///< when it began, with what; its part of all stages
  };
  bool reach(const std::vector<std::string>& words, double share, double portion, double steps);
  std::optional<double> time_left(double least);
  std::string rate(double steps, const std::string& name) const;
  void draw(const std::vector<std::string>& words);
  static bool take_line();

  static inline bool drawn_ = false;
  static inline double bar_ = 0;  ///< share of the bar that is full: of all progress in a run, never less
  static inline int line_ = -1;   ///< the descriptor that holds the lock
  std::string name_;
  bool shown_;
  Stopwatch clock_;
  double next_ = 0;                          ///< when the line may be redrawn [s]
  double portion_, begin_ = -1, share_ = 0;  ///< of the bar; where it began there, the largest share so far
  TimeLeft left_;
  std::optional<Stage> stage_;
};

/// How far a residual has come from 1 down to its tolerance, on a logarithmic scale: 0 … 1.
double decades_done(double residual, double tolerance);

/// The steps of an iteration under a line of headings, right-aligned, with --verbose.
class StepTable {
 public:
  StepTable(const Messages& messages, std::vector<std::string> headings)
      : messages_(messages), headings_(std::move(headings)) {}
  void row(const std::vector<std::string>& cells);

 private:
  const Messages& messages_;
  std::vector<std::string> headings_;
  bool headed_ = false;
};

}  // namespace asperity::cli
