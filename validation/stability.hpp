/// What the stages' tables of stiff and extreme cases share: a row a case, which says what became of it.
#pragma once

#include <cmath>
#include <exception>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"

namespace asperity {

/// How a case ended, and the figure that its outcome is judged by: at most `bound`.
struct Finding {
  std::string outcome;
  std::string measure;
  double figure = 0, bound = 0;
};

class StabilityTable {
 public:
  explicit StabilityTable(const char* stage) : stage_(stage) {}

  /// The case has an answer: call() returns its Finding.
  template <class Call>
  void answered(const std::string& name, const std::string& hard, Call call) const {
    try {
      const Finding f = call();
      print(name, hard, f.outcome, f.measure, fmt::format("{:.1e}", f.figure), fmt::format("{:.0e}", f.bound),
            f.figure <= f.bound);
    } catch (const std::exception& error) {
      print(name, hard, std::string("failed: ") + error.what(), "-", "-", "-", false);
    }
  }

  /// The case has none, and call() throws a ParameterError or a DataError that says so.
  template <class Call>
  void refused(const std::string& name, const std::string& hard, Call call) const {
    try {
      call();
      print(name, hard, "not refused", "-", "-", "-", false);
    } catch (const ParameterError& error) {
      print(name, hard, fmt::format("refused: {}: {}", error.name, error.what()), "-", "-", "-", true);
    } catch (const DataError& error) {
      print(name, hard, fmt::format("refused: {}: {}", error.name, error.what()), "-", "-", "-", true);
    } catch (const std::exception& error) {
      print(name, hard, std::string("failed: ") + error.what(), "-", "-", "-", false);
    }
  }

 private:
  void print(const std::string& name, const std::string& hard, const std::string& outcome,
             const std::string& measure, const std::string& figure, const std::string& bound,
             bool holds) const {
    fmt::print("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", stage_, name, hard, outcome, measure, figure, bound,
               holds ? "yes" : "no");
    std::fflush(stdout);
  }

  const char* stage_;
};

void kernel_stability();
void surface_stability();
void marginal_stability();
void statistics_stability();
void contact_stability();
void stress_stability();

}  // namespace asperity
