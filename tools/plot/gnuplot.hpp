/// Pictures through gnuplot, the only door to that program.
///
/// A script is text with the numbers of each plot inline, as doubles in binary: nothing is rounded, nothing
/// passes through a shell or a named file. User's text enters only through gnuplot_string(), which leaves no
/// command, macro or end of a string to read.
///
/// T. Williams, C. Kelley et al., gnuplot 5.4: an interactive plotting program (2020).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/field.hpp"

namespace asperity::plot {

/// Something drawn with numbers of its own: "'-' binary …" without the dash, and the numbers.
struct Layer {
  std::string command;
  std::vector<double> numbers;
};

/// The rows of a table, drawn as `style` says: "with lines lw 2".
Layer points(const Field& table, std::string_view style);

/// A field of cells of dx × dy whose first centre is (x, y), on paper ("plot") or in space ("splot"); a cell
/// that is not a number stays empty.
struct Lattice {
  double x, y, dx, dy;
  bool in_space = false;
};
Layer raster(const Field& cells, Lattice at, std::string_view style);

class Script {
 public:
  template <class... T>
  void line(fmt::format_string<T...> format, T&&... values) {
    text_ += fmt::format(format, std::forward<T>(values)...) + '\n';
  }
  void add(const Script& commands) { text_ += commands.text_; }
  /// `verb` is "plot" or "splot".
  void draw(std::string_view verb, const std::vector<Layer>& layers);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Text as a gnuplot string in double quotes, one line of UTF-8: of ASCII all but letters, blanks and most
/// digits by octal numbers. (In single quotes gnuplot 5.4 misreads a pair of them at either end.)
std::string gnuplot_string(std::string_view text);

struct Picture {
  std::string bytes;
  std::string remarks;  ///< what gnuplot wrote to standard error
};

/// Runs the gnuplot found on PATH; the same script gives the same bytes, a PDF without its date. Throws
/// std::runtime_error where there is none or it fails.
Picture run_gnuplot(const Script& script);

}  // namespace asperity::plot
