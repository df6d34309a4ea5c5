#include "tools/cli/repeated.hpp"

#include <algorithm>
#include <utility>

#include "core/words.hpp"

namespace asperity::cli {
namespace {

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

std::optional<std::string> Repeated::first(const std::string& surface, const std::string& text) {
  const bool named = text.starts_with(surface + ": ");
  const std::string own = named ? text.substr(surface.size() + 2) : text, words = without_numbers(own);
  if (!told_.insert(surface + ": " + own).second) return std::nullopt;
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

std::vector<std::string> Repeated::rest() {
  std::vector<std::string> out;
  for (const auto& [words, more, surface, text] : std::exchange(kinds_, {}))
    if (more == 1)
      out.push_back(surface + ": " + text);
    else if (more > 1)
      out.push_back(counted(more, "more surface") + ", up to " + surface + ": " + text);
  return out;
}

}  // namespace asperity::cli
