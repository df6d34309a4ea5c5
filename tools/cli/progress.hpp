/// How far a long computation is: a line on standard error, redrawn a few times a second and wiped before
/// anything else is said there, or with --verbose a table of its steps.
#pragma once

#include <string>
#include <vector>

#include "core/stopwatch.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// Where an iteration is whose residual falls to its tolerance; the bar shows the share of the decades.
struct IterationStatus {
  std::string stage;  ///< such as the grid; the time left is reckoned anew where it changes
  double residual = 1, tolerance = 0;
  double spent = 0;  ///< share of the steps that it may take, where that is more
  double steps = 0;
  std::string name = {};  ///< of the steps: "products"
  bool last = true;       ///< no other stage is known to follow: the time left is told
};

class Progress {
 public:
  explicit Progress(const Tool& tool) : name_(tool.name()), shown_(tool.shows_progress()) {}
  ~Progress() { wipe(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Of work that goes on steadily: "7 s left, 17 of 40 surfaces, 3.1/s".
  void count(double done, double of, const std::string& units);
  /// "7 s left, residual 1.3e-04, 64x64, 85 products/s": if each decade takes as long.
  void iterate(const IterationStatus& now);
  /// The line of whichever progress it is, before anything else is said there.
  static void wipe();

 private:
  bool is_due() const { return clock_.seconds() >= next_; }
  void draw(double share, const std::string& text);

  static inline bool drawn_ = false;
  std::string name_;
  bool shown_;
  Stopwatch clock_;
  double next_ = 0;  ///< when the line may be redrawn [s]
  struct Beginning {
    std::string stage;
    double seconds = 0, share = 0, steps = 0;
  } stage_;
};

/// How far a residual has come from 1 down to its tolerance, on a logarithmic scale: 0 … 1.
double decades_done(double residual, double tolerance);

/// The steps of an iteration under a line of headings, right-aligned, with --verbose.
class StepTable {
 public:
  StepTable(const Tool& tool, std::vector<std::string> headings)
      : tool_(tool), headings_(std::move(headings)) {}
  void row(const std::vector<std::string>& cells);

 private:
  const Tool& tool_;
  std::vector<std::string> headings_;
  bool headed_ = false;
};

}  // namespace asperity::cli
