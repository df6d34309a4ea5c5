#include "formats/text_blocks.hpp"

#include <algorithm>
#include <cctype>

#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

constexpr std::size_t longest = 256;  // of a comment, in bytes; the rest does not count

// The words of a comment without numbers and digits, a blank behind each; "" without a letter.
std::string words_in(std::string_view comment) {
  comment = comment.substr(0, longest);
  comment.remove_prefix(std::min(comment.find_first_not_of("#%;"), comment.size()));
  std::string out;
  for (comment = trimmed(comment); !comment.empty(); comment = trimmed(comment)) {
    const std::size_t end = std::min(comment.find_first_of(" \t"), comment.size());
    const std::string_view word = comment.substr(0, end);
    comment.remove_prefix(end);
    if (number_of(word) || number_of(word, Comma::decimal)) continue;
    for (const char c : lower(word))
      if (std::isdigit(static_cast<unsigned char>(c)) == 0) out += c;
    out += ' ';
  }
  const auto letter = [](unsigned char c) { return c >= 0x80 || std::isalpha(c) != 0; };
  return std::ranges::any_of(out, letter) ? out : "";
}

bool names_block(const std::string& words) {
  constexpr std::string_view names[] = {"block", "channel", "data", "frame", "image", "layer", "map"};
  constexpr std::ptrdiff_t most_words = 3;
  const std::string first = words.substr(0, words.find_first_of(" :=,_-"));
  return std::ranges::find(names, first) != std::end(names) && std::ranges::count(words, ' ') <= most_words;
}

}  // namespace

void TextBlocks::comment(std::string_view line, bool above) {
  std::string words = words_in(line);
  if (words.empty()) return;
  if (above)
    heads_.insert(std::move(words));
  else if (below_.empty() && (names_block(words) || heads_.contains(words)))
    below_ = "the comment " + quoted(line);
}

void TextBlocks::numbers(std::size_t line, bool first) {
  if (first || below_.empty()) {
    several_ |= !first;
  } else if (second_ == 0) {
    second_ = line;
    parted_by_ = below_;
  }
  below_.clear();
}

}  // namespace asperity
