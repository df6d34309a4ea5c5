/// Draws pictures with gnuplot; no other code calls that program.
///
/// A script is text with the numbers of each plot inline, as binary doubles: nothing is rounded, and neither
/// a shell nor a named file is involved. User text enters only through gnuplot_string(), which escapes
/// commands, macros and ends of strings.
///
/// T. Williams, C. Kelley et al., gnuplot 5.4: an interactive plotting program (2020).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/field.hpp"

namespace asperity::plot {

/// One plot with its own numbers: "'-' binary …" without the dash, and the numbers; or of a block of data
/// that commands have made, "$lines".
struct Layer {
  std::string command;
  std::vector<double> numbers;
  std::string from = "'-'";
};

/// The rows of a table, drawn in the `style`: "with lines lw 2".
Layer points(const Field& table, std::string_view style);

/// A field of cells of dx × dy with first centre (x, y), in the plane ("plot") or in space ("splot"); a NaN
/// cell stays empty.
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

/// Text as a gnuplot string in double quotes, one line of UTF-8: ASCII characters except letters, blanks and
/// most digits become octal numbers. (In single quotes gnuplot 5.4 misreads a pair of quotes at either end.)
std::string gnuplot_string(std::string_view text);

struct Picture {
  std::string bytes;
  std::string remarks;  ///< what gnuplot wrote to standard error
};

/// Runs the gnuplot found on PATH; the same script gives the same bytes, a PDF without its date. Throws
/// std::runtime_error if gnuplot is missing or fails.
Picture run_gnuplot(const Script& script);

}  // namespace asperity::plot
