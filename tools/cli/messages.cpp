#include "tools/cli/messages.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/parallel.hpp"
#include "core/words.hpp"
#include "tools/cli/documents.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/ordered_work.hpp"
#include "tools/cli/progress.hpp"

namespace asperity::cli {
namespace {

// Of the one of several datasets that this thread works on.
thread_local bool of_one = false;
thread_local std::vector<std::string> warnings_of_one;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// What two warnings of one kind have in common.
std::string without_numbers(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    const bool exponent = c == 'e' && k > 0 && is_digit(text[k - 1]) && k + 1 < text.size() &&
                          (is_digit(text[k + 1]) || text[k + 1] == '-' || text[k + 1] == '+');
    if (!is_digit(c) && c != '.' && c != '-' && c != '+' && !exponent) out += c;
  }
  return out;
}

}  // namespace

std::optional<std::string> Messages::Repeated::first(const std::string& surface, const std::string& text) {
  const bool named = text.starts_with(surface + ": ");
  const std::string own = named ? text.substr(surface.size() + 2) : text, words = without_numbers(own);
  if (!seen_.insert(surface + ": " + own).second) return std::nullopt;
  const auto known = std::ranges::find(kinds_, words, &Kind::words);
  if (known == kinds_.end()) {
    kinds_.push_back({words});
    return surface + ": " + own;
  }
  ++known->more;
  known->surface = surface;
  known->text = own;
  return std::nullopt;
}

std::vector<std::string> Messages::Repeated::rest() {
  std::vector<std::string> out;
  for (const auto& [words, more, surface, text] : std::exchange(kinds_, {}))
    if (more == 1)
      out.push_back(surface + ": " + text);
    else if (more > 1)
      out.push_back(counted(more, "more surface") + ", up to " + surface + ": " + text);
  return out;
}

void Messages::declare(Options& options) {
  options.flag("-q,--quiet", quiet_, "Print warnings and errors only", "Common");
  options.flag("-v,--verbose", verbose_,
               "Print details on standard error: a line for each step of an iteration", "Common");
}

void Messages::say(const std::string& line) { Progress::say(one_line(line)); }

void Messages::warn(const std::string& text, bool kept) const {
  if (kept) keep(one_line(with_options(text, options_)));
  in_order([this, text] {
    const std::optional<std::string> line = subject_.empty() ? text : warnings_.first(subject_, text);
    if (!line) return;
    printed_.push_back(one_line(with_options(*line, options_)));
    say(tool_ + ": warning: " + printed_.back());
  });
}

void Messages::keep(const std::string& warning) const {
  if (of_one || works_alone()) return warnings_of_one.push_back(warning);
  const std::scoped_lock lock(mutex_);
  of_run_.push_back(warning);
}

std::vector<std::string> Messages::take_warnings() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> out;
  for (const auto& each : {of_run_, std::exchange(warnings_of_one, {})})
    for (const std::string& line : each)
      if (std::ranges::find(out, line) == out.end()) out.push_back(line);
  return out;
}

void Messages::go_on_with(std::vector<std::string>&& taken) const {
  if (of_one || works_alone()) warnings_of_one = std::move(taken);
}

void Messages::note(const std::string& text) const {
  in_order([this, text] {
    const std::optional<std::string> line = subject_.empty() ? text : notes_.first(subject_, text);
    if (line && !quiet_) say(tool_ + ": " + with_options(*line, options_));
  });
}

void Messages::about(const std::string& surface) const {
  of_one = !surface.empty();
  warnings_of_one.clear();
  in_order([this, surface] {
    subject_ = surface;
    if (!surface.empty()) return;
    of_run_ = printed_;
    for (const std::string& line : warnings_.rest()) warn(line);
    for (const std::string& line : notes_.rest()) note(line);
  });
}

void Messages::detail(const std::string& text) const {
  if (verbose_) in_order([text] { say(text); });
}

std::string sentence(const std::string& subject, const std::string& text) {
  constexpr std::string_view verbs[] = {"is ",  "are ",     "needs ", "cannot ", "must ",
                                        "has ", "belongs ", "does ",  "applies "};
  const bool verb = std::ranges::any_of(verbs, [&](std::string_view v) { return text.starts_with(v); });
  return subject + (verb ? " " : ": ") + text;
}

std::string with_options(std::string text, const Options& options) {
  std::string elsewhere;
  for (std::size_t at = 0; (at = text.find('`', at)) != text.npos;) {
    const std::size_t end = text.find('`', at + 1);
    if (end == text.npos) break;
    const std::string option = "--" + text.substr(at + 1, end - at - 1);
    if (!is_option(option)) {
      at = end;
      continue;
    }
    text.replace(at, end - at + 1, option);
    at += option.size();
    if (elsewhere.empty() && !options.has(option)) elsewhere = tool_with(option);
  }
  return text + elsewhere;
}

}  // namespace asperity::cli
