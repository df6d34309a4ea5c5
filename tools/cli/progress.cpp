#include "tools/cli/progress.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

namespace asperity::cli {
namespace {

constexpr double period = 0.2;       // between two drawings of the line [s]
constexpr double least_gain = 0.05;  // of the decades, before the time left is told
constexpr std::size_t shortest_bar = 8, longest_bar = 20;
constexpr std::size_t column = 9;  // characters of a table of steps, at least

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

// Name, bar, percentage and text; the bar gives way where the terminal is narrow.
void Progress::draw(double share, const std::string& text) {
  next_ = clock_.seconds() + period;
  share = std::clamp(share, 0.0, 1.0);
  const std::size_t width = terminal_width() - 1, others = name_.size() + text.size() + 12;
  const std::size_t bar = std::clamp(width - std::min(width, others), shortest_bar, longest_bar);
  const auto full = static_cast<std::size_t>(std::floor(share * static_cast<double>(bar)));
  std::string line = fmt::format("{}: [{}{}] {:3.0f} %  {}", name_, std::string(full, '#'),
                                 std::string(bar - full, '.'), std::floor(100 * share), text);
  line.resize(std::min(line.size(), width));
  std::cerr << '\r' << line << "\033[K" << std::flush;
  drawn_ = true;
}

void Progress::count(double done, double of, const std::string& units) {
  if (!shown_ || !is_due()) return;
  const double elapsed = clock_.seconds(), rate = done / elapsed;
  std::vector<std::string> words;
  if (done > 0) words.push_back(duration((of - done) / rate) + " left");
  if (!units.empty()) words.push_back(fmt::format("{:.0f} of {:.0f} {}", std::floor(done), of, units));
  if (!units.empty() && done > 0) words.push_back(fmt::format("{:.3g}/s", rate));
  draw(done / of, fmt::format("{}", fmt::join(words, ", ")));
}

void Progress::iterate(const IterationStatus& now) {
  const double share = std::max(decades_done(now.residual, now.tolerance), now.spent), at = clock_.seconds();
  const bool begins = now.stage != stage_.stage;
  if (begins) stage_ = {now.stage, at, share, now.steps};
  if (!(shown_ && (begins || is_due()))) return;
  const double elapsed = at - stage_.seconds, gained = share - stage_.share;
  std::string text = fmt::format("residual {:.1e}, {}", now.residual, now.stage);
  if (now.last && gained > least_gain) text = duration((1 - share) * elapsed / gained) + " left, " + text;
  if (now.steps > stage_.steps && elapsed > 0)
    text += fmt::format(", {:.3g} {}/s", (now.steps - stage_.steps) / elapsed, now.name);
  draw(share, text);
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
  const auto print = [&](const std::vector<std::string>& words) {
    std::string line;
    for (std::size_t c = 0; c < words.size(); ++c)
      line += fmt::format("{}{:>{}}", c == 0 ? "" : "  ", words[c], std::max(column, headings_[c].size()));
    tool_.detail(line);
  };
  if (!std::exchange(headed_, true)) print(headings_);
  print(cells);
}

}  // namespace asperity::cli
