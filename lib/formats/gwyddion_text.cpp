#include "formats/gwyddion_text.hpp"

#include <optional>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/rest.hpp"
#include "formats/head.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

// "# Key: value" → {Key, value}.
struct Entry {
  std::string_view key, value;
};

std::optional<Entry> entry_of(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (!line.starts_with('#') || colon == line.npos) return std::nullopt;
  return Entry{trimmed(line.substr(1, colon - 1)), trimmed(line.substr(colon + 1))};
}

// "10.00 µm" → {10.00, µm}; nothing where no number stands first, or no word behind it.
struct Length {
  double number;
  std::string_view unit;
};

std::optional<Length> length_of(std::string_view text) {
  const std::size_t blank = text.find_first_of(" \t");
  if (blank == text.npos) return std::nullopt;
  const std::string_view word = text.substr(0, blank);
  const auto number = number_of(word, word.find(',') == word.npos ? Comma::none : Comma::decimal);
  if (!number) return std::nullopt;
  return Length{*number, trimmed(text.substr(blank))};
}

struct GwyddionHead {
  std::vector<Length> lengths;
  std::string_view channel, units;
  std::size_t lines = 0;
};

// Takes the lines that begin with # off the text.
GwyddionHead take_head(std::string_view& text) {
  GwyddionHead out;
  for (; text.starts_with('#'); ++out.lines) {
    const auto entry = entry_of(take_line(text));
    if (!entry) continue;
    if (const auto length = length_of(entry->value))
      out.lengths.push_back(*length);
    else if (out.lengths.empty())
      out.channel = entry->value;
    else
      out.units = entry->value;
  }
  return out;
}

double metres(const Length& length) {
  const double size = length.number * metres_per(length.unit, "map");
  if (!(size > 0)) throw DataError("map", "its size " + shortest(length.number) + " is not positive");
  return size;
}

}  // namespace

bool recognises_gwyddion_text(std::string_view bytes) {
  std::string_view head = bytes.substr(0, 4096);
  return take_head(head).lengths.size() >= 2;
}

Map decode_gwyddion_text(std::string_view bytes, const Reading& reading) {
  const GwyddionHead head = take_head(bytes);
  if (const std::size_t line = bytes.find("\n#"); line != bytes.npos)
    refuse_rest(bytes.substr(line + 1), "map");  // another head
  if (head.lengths.size() < 2) throw DataError("map", "its head does not state a width and a height");
  Map map{.values = matrix_of(bytes, "map", head.lines + 1, reading).transpose(),
          .title = std::string(head.channel)};
  map.spacing = {metres(head.lengths[0]) / static_cast<double>(map.values.rows()),
                 metres(head.lengths[1]) / static_cast<double>(map.values.cols())};
  set_units(map, head.units);
  return map;
}

std::string encode_gwyddion_text(const Map& map, Order) {
  const double nx = static_cast<double>(map.values.rows()), ny = static_cast<double>(map.values.cols());
  const auto entry = [](std::string_view key, std::string_view value) { return head_line(key, ": ", value); };
  std::string out = entry("# Channel", map.title.empty() ? "heights" : map.title);
  out += entry("# Width", shortest(map.spacing[0] * nx) + " m") +
         entry("# Height", shortest(map.spacing[1] * ny) + " m");
  if (!map.units.empty()) out += entry("# Value units", map.units);
  return out + text_of(map.values.transpose());
}

}  // namespace asperity
