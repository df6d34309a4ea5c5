#include "tools/plot/text.hpp"

#include <algorithm>

#include "core/words.hpp"

namespace asperity::plot {
namespace {

bool begins(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

// Of the character that begins here.
double width_at(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead >= 0xE3) return 1.1;  // from U+3000
  const auto among = [&](std::string_view some) { return some.find(text[0]) != some.npos; };
  if (among("MWmw@%")) return 1;
  if (among("+=<>~#")) return 0.84;
  if (among(" fijlrtIJ.,:;|'![]()/-")) return 0.42;
  for (const std::string_view sign : {"−", "×", "±", "≤", "≥"})
    if (text.starts_with(sign)) return 0.84;
  return text[0] >= 'A' && text[0] <= 'Z' ? 0.78 : letter_width;
}

std::vector<std::string> characters_of(const std::string& text) {
  std::vector<std::string> out;
  for (const char c : text) {
    if (begins(c) || out.empty()) out.emplace_back();
    out.back() += c;
  }
  return out;
}

}  // namespace

double letters(std::string_view text) { return static_cast<double>(std::ranges::count_if(text, begins)); }

double length_of(std::string_view text) {
  double out = 0;
  for (std::size_t k = 0; k < text.size(); ++k)
    if (begins(text[k])) out += width_at(text.substr(k));
  return out;
}

std::string shortened(const std::string& text, double most) {
  const std::string line = one_line(text);
  if (length_of(line) <= most) return line;
  const std::vector<std::string> all = characters_of(line);
  std::string head, tail;
  double length = 1;  // of the ellipsis
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string& next = k % 2 == 0 ? all[k / 2] : all[all.size() - 1 - k / 2];
    length += length_of(next);
    if (length > most) break;
    k % 2 == 0 ? head += next : tail = next + tail;
  }
  while (head.ends_with(' ')) head.pop_back();
  while (tail.starts_with(' ')) tail.erase(0, 1);
  return head + "…" + tail;
}

std::vector<std::string> broken(const std::string& text, double most, std::size_t lines) {
  std::vector<std::string> out;
  std::string rest = one_line(text);
  while (!rest.empty()) {
    const auto after_comma = [&](std::size_t place) { return place > 0 && rest[place - 1] == ','; };
    std::size_t cut = 0;  // the last blank up to which the rest fits
    for (auto at = rest.find(' '); at != rest.npos && length_of(rest.substr(0, at)) <= most;
         at = rest.find(' ', at + 1))
      if (rest[at - 1] == ',' || !(after_comma(cut) && 2 * length_of(rest.substr(0, cut)) >= most)) cut = at;
    if (length_of(rest) <= most || cut == 0 || out.size() + 1 >= lines) {
      out.push_back(shortened(rest, most));
      break;
    }
    out.push_back(rest.substr(0, cut));
    rest = rest.substr(rest.find_first_not_of(' ', cut) == rest.npos ? rest.size()
                                                                     : rest.find_first_not_of(' ', cut));
  }
  return out;
}

}  // namespace asperity::plot
