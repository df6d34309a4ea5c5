/// How far a long computation is: one line on standard error that is redrawn a few times a second and wiped in the end,
/// or with --verbose a table of its steps.
#pragma once

#include <string>
#include <vector>

#include "cli/tool.hpp"
#include "grid/stopwatch.hpp"

namespace asperity::cli {

class Progress {
 public:
  explicit Progress(const Tool& tool) : name_(tool.name()), shown_(tool.shows_progress()) {}
  ~Progress() { wipe(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A bar of this share, 0 … 1, and the text behind it.
  void show(double share, const std::string& text);
  /// The same of work that goes on steadily: "17 of 40 surfaces, 3.1/s, 7 s left".
  void count(double done, double of, const std::string& units);
  /// Before anything else is said on standard error.
  void wipe();

 private:
  std::string name_;
  bool shown_, drawn_ = false;
  Stopwatch clock_;
  double next_ = 0;  ///< when the line may be redrawn [s]
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
  void print(const std::vector<std::string>& cells) const;

  const Tool& tool_;
  std::vector<std::string> headings_;
  bool headed_ = false;
};

}  // namespace asperity::cli
