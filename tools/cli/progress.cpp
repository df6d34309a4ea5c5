#include "tools/cli/progress.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fcntl.h>
#include <iostream>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

constexpr double period = 0.2;  // between two drawings of the line [s]
constexpr double least_time = 1, least_counted = 0.01, least_decades = 0.05;  // before the time left is shown
constexpr std::size_t shortest_bar = 8, longest_bar = 20, longest_line = 80;
constexpr std::size_t column_width = 9;  // characters of a table of steps, at least
constexpr const char* erased = "\r\033[K";

std::size_t terminal_width() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::min<std::size_t>(size.ws_col, longest_line) : longest_line;
}

std::string duration(double seconds) {
  const auto s = static_cast<long>(std::ceil(std::clamp(seconds, 1.0, 1e9)));
  if (s < 100) return fmt::format("{} s", s);
  if (s < 100 * 60) return fmt::format("{} min", (s + 59) / 60);
  return fmt::format("{:.1f} h", static_cast<double>(s) / 3600);
}

}  // namespace

void TimeLeft::start(double seconds, double share) {
  *this = {};
  begin_ = seconds;
  share_ = share;
}

std::optional<double> TimeLeft::at(double seconds, double share, double least) {
  const double elapsed = seconds - begin_, gained = share - share_;
  if (elapsed < least_time || !(gained >= least)) return std::nullopt;
  const double end = seconds + (1 - share) * elapsed / gained;
  const double smoothing = std::max(least_time, elapsed / 5);
  end_ = known_ ? end + (end_ - end) * std::exp((seconds_ - seconds) / smoothing) : end;
  const double expected = std::max(end_ - seconds, 0.0), counted = left_ + seconds_ - seconds;
  const bool keeps = known_ && expected > counted && expected < std::max(counted + 2, 1.5 * counted);
  // Where it is a little too short, it falls at half the pace until it is not.
  left_ = keeps ? std::max(counted + (seconds - seconds_) / 2, 0.0) : expected;
  seconds_ = seconds;
  known_ = true;
  return left_;
}

// An inherited descriptor shares its lock with the other tools of a pipe: the terminal is opened anew.
// Where it cannot be opened, every tool draws.
bool Progress::take_line() {
  if (line_ >= 0 || !stderr_is_terminal()) return true;
  char name[256] = {};
  if (::ttyname_r(STDERR_FILENO, name, sizeof name) != 0) return true;
  const int fd = ::open(name, O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) return true;
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    const bool taken = errno == EWOULDBLOCK;
    ::close(fd);
    return !taken;
  }
  line_ = fd;
  return true;
}

// Name, bar, percentage and the words that fit; the bar gives way where the terminal is narrow.
void Progress::draw(const std::vector<std::string>& words) {
  next_ = clock_.seconds() + period;
  if (!take_line()) return;
  const std::size_t width = terminal_width() - 1;
  std::string text;
  std::size_t others = name_.size() + 12;
  for (const std::string& word : words) {
    const std::string more = (text.empty() ? "" : ", ") + word;
    if (others + shortest_bar + text.size() + more.size() <= width) text += more;
  }
  others += text.size();
  const std::size_t bar = std::clamp(width - std::min(width, others), shortest_bar, longest_bar);
  const auto full = static_cast<std::size_t>(std::floor(bar_ * static_cast<double>(bar)));
  std::string line = fmt::format("{}: [{}{}] {:3.0f} %  {}", name_, std::string(full, '#'),
                                 std::string(bar - full, '.'), std::floor(100 * bar_), text);
  line.resize(std::min(line.size(), width));
  std::cerr << "\r" + line + "\033[K" << std::flush;
  drawn_ = true;
}

// A stage that begins takes `portion` of what is left of the bar. Whether the line is to be drawn.
bool Progress::reach(const std::vector<std::string>& words, double share, double portion, double steps) {
  if (!shown_) return false;
  const double at = clock_.seconds();
  const bool begins = !stage_ || words != stage_->words;
  if (begins) {
    stage_ = {words, at, steps, share_, portion * (1 - share_)};
    left_.start(at, share);
  }
  if (begin_ < 0) begin_ = bar_;
  share_ = std::max(share_, stage_->share + stage_->portion * share);
  bar_ = std::max(bar_, begin_ + portion_ * (1 - begin_) * share_);
  return begins || at >= next_;
}

std::optional<double> Progress::time_left(double least) {
  const double reached = stage_->portion > 0 ? (share_ - stage_->share) / stage_->portion : 1;
  return left_.at(clock_.seconds(), reached, least);
}

std::string Progress::rate(double steps, const std::string& name) const {
  return fmt::format("{:.3g}{}/s", (steps - stage_->steps) / (clock_.seconds() - stage_->seconds), name);
}

void Progress::count(double done, double of, const std::string& units) {
  if (!reach({}, std::clamp(done / of, 0.0, 1.0), 1, done)) return;
  std::vector<std::string> words;
  const std::optional<double> left = time_left(least_counted);
  if (left) words.push_back(duration(*left) + " left");
  if (!units.empty()) words.push_back(fmt::format("{:.0f} of {:.0f} {}", std::floor(done), of, units));
  if (left && !units.empty()) words.push_back(rate(done, ""));
  draw(words);
}

void Progress::iterate(const IterationStatus& now) {
  const double share = std::max(decades_done(now.residual, now.tolerance), now.spent);
  if (!reach(now.stage, std::clamp(share, 0.0, 1.0), now.portion, now.steps)) return;
  std::vector<std::string> words = now.stage;
  words.push_back(fmt::format("residual {:.1e}", now.residual));
  const std::optional<double> left = time_left(least_decades);
  if (left && now.last) words.insert(words.begin(), duration(*left) + " left");
  if (now.steps > stage_->steps) words.push_back(rate(now.steps, " " + now.name));
  draw(words);
}

void Progress::wipe() {
  if (std::exchange(drawn_, false)) std::cerr << erased << std::flush;
  if (const int fd = std::exchange(line_, -1); fd >= 0) ::close(fd);
}

void Progress::say(const std::string& message) {
  wipe();
  std::cerr << (stderr_is_terminal() ? erased : "") + message + "\n" << std::flush;
}

void Progress::clear() {
  wipe();
  if (stderr_is_terminal()) std::cerr << erased << std::flush;
}

double decades_done(double residual, double tolerance) {
  return residual > 0 ? std::clamp(std::log(residual) / std::log(tolerance), 0.0, 1.0) : 1;
}

void StepTable::row(const std::vector<std::string>& cells) {
  if (!messages_.verbose()) return;
  const auto print = [&](const std::vector<std::string>& words) {
    std::string line;
    for (std::size_t c = 0; c < words.size(); ++c)
      line +=
          fmt::format("{}{:>{}}", c == 0 ? "" : "  ", words[c], std::max(column_width, headings_[c].size()));
    messages_.detail(line);
  };
  if (!std::exchange(headed_, true)) print(headings_);
  print(cells);
}

}  // namespace asperity::cli
