#include "cli/progress.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

namespace asperity::cli {
namespace {

constexpr double period = 0.2;     // between two drawings of the line [s]
constexpr std::size_t bar = 20;    // characters
constexpr std::size_t column = 9;  // of a table of steps, at least

std::size_t terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string duration(double seconds) {
  const auto s = static_cast<long>(std::ceil(std::min(seconds, 1e9)));
  if (s < 100) return fmt::format("{} s", s);
  if (s < 100 * 60) return fmt::format("{} min", (s + 59) / 60);
  return fmt::format("{:.1f} h", static_cast<double>(s) / 3600);
}

}  // namespace

void Progress::show(double share, const std::string& text) {
  if (!shown_ || clock_.seconds() < next_) return;
  next_ = clock_.seconds() + period;
  share = std::clamp(share, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(std::floor(share * static_cast<double>(bar)));
  std::string line = fmt::format("{}: [{}{}] {:3.0f} %  {}", name_, std::string(full, '#'),
                                 std::string(bar - full, '.'), std::floor(100 * share), text);
  line.resize(std::min(line.size(), terminal_width() - 1));
  std::cerr << '\r' << line << "\033[K" << std::flush;
  drawn_ = true;
}

void Progress::count(double done, double of, const std::string& units) {
  if (!shown_ || clock_.seconds() < next_) return;
  const double elapsed = clock_.seconds(), rate = done / elapsed;
  std::string text = units.empty() ? "" : fmt::format("{:.0f} of {:.0f} {}", std::floor(done), of, units);
  if (done > 0 && !units.empty()) text += fmt::format(", {:.3g}/s", rate);
  if (done > 0) text += (text.empty() ? "" : ", ") + duration((of - done) / rate) + " left";
  show(done / of, text);
}

void Progress::wipe() {
  if (drawn_) std::cerr << "\r\033[K" << std::flush;
  drawn_ = false;
}

double decades_done(double residual, double tolerance) {
  return residual > 0 ? std::clamp(std::log(residual) / std::log(tolerance), 0.0, 1.0) : 1;
}

void StepTable::row(const std::vector<std::string>& cells) {
  if (!tool_.verbose()) return;
  if (!headed_) print(headings_);
  headed_ = true;
  print(cells);
}

void StepTable::print(const std::vector<std::string>& cells) const {
  std::string line;
  for (std::size_t c = 0; c < cells.size(); ++c)
    line += fmt::format("{}{:>{}}", c == 0 ? "" : "  ", cells[c], std::max(column, headings_[c].size()));
  tool_.detail(line);
}

}  // namespace asperity::cli
