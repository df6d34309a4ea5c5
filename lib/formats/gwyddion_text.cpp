/// Text export of a channel from Gwyddion.
///
///     # Channel: ZSensor
///     # Width: 10.00 µm          along a line, x; the height is along y; each has its own unit
///     # Height: 10.00 µm
///     # Value units: m
/// and a line of values for each y, from the top of the image, which is the smallest y here. Gwyddion
/// translates the words, so the size is read from the two lines with a number and a length, the first of
/// which is the width, the title from a line above them and the unit from one below, unless a line states it
/// in words that are known (formats/text_head.hpp). Decimal commas and exponents of three digits are
/// accepted. The size is that of the area of all pixels.
#include <optional>
#include <vector>

#include "dataset/bytes.hpp"
#include "formats/format.hpp"
#include "formats/refuse.hpp"
#include "formats/text_head.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

struct Length {
  double number;
  std::string_view unit;
};

// "10.00 µm" → {10.00, µm}; nothing without a number followed by a word.
std::optional<Length> stated_length(std::string_view text) {
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
  std::vector<HeadLine> others;
  std::size_t lines = 0;
};

// Removes the comments that begin with # from the text.
GwyddionHead take_comments(std::string_view& text) {
  GwyddionHead out;
  const auto first = [&] { return text.substr(0, text.find_first_of("\r\n")); };
  for (; text.starts_with('#') && is_comment(first(), Separator::tab); ++out.lines) {
    const std::string_view line = take_line(text);
    const std::size_t colon = line.find(':');
    const std::string_view value = colon == line.npos ? "" : trimmed(line.substr(colon + 1));
    if (const auto length = stated_length(value);
        length && (out.lengths.size() < 2 || is_length(length->unit))) {
      out.lengths.push_back(*length);
    } else if (out.lengths.empty() && out.channel.empty() && !is_unit(value)) {
      out.channel = value;
    } else {
      out.others.push_back({out.lines + 1, line});
      if (out.units.empty() && !out.lengths.empty()) out.units = value;
    }
  }
  return out;
}

double metres(const Length& length) {
  const double size = length.number * metres_per(length.unit);
  if (!(size > 0)) refuse("size {} in the header is not positive", shortest(length.number));
  return size;
}

bool is_gwyddion(std::string_view bytes) {
  bytes = bytes.substr(0, 4096);
  return take_comments(bytes).lengths.size() >= 2;
}

Map decode_gwyddion(std::string_view bytes, const Reading& reading) {
  const GwyddionHead head = take_comments(bytes);
  if (const std::size_t line = bytes.find("\n#"); line != bytes.npos)
    refuse_rest(bytes.substr(line + 1), "map");  // another head
  if (head.lengths.size() != 2)
    refuse("the header has {}, not a width and a height", counted(std::ssize(head.lengths), "size"));
  Map map{.values = matrix_of(bytes, "map", head.lines + 1, reading).transpose(),
          .title = std::string(head.channel)};
  map.spacing = {metres(head.lengths[0]) / static_cast<double>(map.values.rows()),
                 metres(head.lengths[1]) / static_cast<double>(map.values.cols())};
  const std::string stated = unit_of_values(head.others, "", reading);
  set_units(map, stated.empty() ? head.units : std::string_view(stated));
  return map;
}

std::string encode_gwyddion(const Map& map, Order) {
  const auto nx = static_cast<double>(map.values.rows()), ny = static_cast<double>(map.values.cols());
  std::string out = fmt::format("# Channel: {}\n# Width: {} m\n# Height: {} m\n",
                                map.title.empty() ? "heights" : one_line(map.title),
                                shortest(map.spacing[0] * nx), shortest(map.spacing[1] * ny));
  if (!map.units.empty()) out += fmt::format("# Value units: {}\n", one_line(map.units));
  return out + text_of(map.values.transpose());
}

}  // namespace

const Format format::gwyddion_text{
    "gwyddion-text", "", "Gwyddion text export with its header", is_gwyddion, decode_gwyddion,
    encode_gwyddion};

}  // namespace asperity
