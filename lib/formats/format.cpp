#include "formats/format.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

bool has_extension(const Format& format, std::string_view extension) {
  return !extension.empty() &&
         fmt::format(" {} ", format.extensions).find(fmt::format(" {} ", extension)) != std::string::npos;
}

// The first bytes, some in the middle and the last without their padding: numbers may follow a long head of
// words.
std::array<std::string_view, 3> samples_of(std::string_view bytes) {
  constexpr std::size_t size = 4096;
  if (bytes.size() <= size) return {bytes};
  std::size_t end = std::max(bytes.find_last_not_of(std::string_view("\0\x1a", 2)) + 1, size);
  end -= end % 2;
  return {bytes.substr(0, size), bytes.substr(end / 4 * 2, size), bytes.substr(end - size, size)};
}

constexpr std::size_t most_listed = 8;

// "0 'Topography', 1 'Phase'"
std::string list_of_channels(std::span<const Channel> channels) {
  std::string out;
  for (const Channel& channel : channels.first(std::min(channels.size(), most_listed)))
    out += fmt::format("{}{}{}", out.empty() ? "" : ", ", channel.number,
                       channel.title.empty() ? "" : " " + quoted(channel.title));
  return out + (channels.size() > most_listed ? ", …" : "");
}

// The places of the channels that satisfy a condition.
template <class Condition>
std::vector<std::size_t> channels_where(std::span<const Channel> channels, Condition condition) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (condition(channels[i])) out.push_back(i);
  return out;
}

}  // namespace

std::span<const Format> formats() {
#define ASPERITY_LISTED(name) format::name,
  static const Format all[] = {ASPERITY_FORMATS(ASPERITY_LISTED)};
#undef ASPERITY_LISTED
  return all;
}

std::size_t chosen_channel(std::span<const Channel> channels, std::string_view name) {
  if (channels.empty()) refuse("the file holds no map");
  if (name.empty()) {
    if (channels.size() == 1) return 0;
    const auto heights = channels_where(channels, [](const Channel& c) { return is_length(c.unit); });
    if (heights.size() == 1) return heights.front();
    refuse("the file has {} channels, {} of them heights: choose one with `channel`: {}", channels.size(),
           heights.size(), list_of_channels(channels));
  }
  const std::string wanted = one_line(name);
  auto found = channels_where(channels, [&](const Channel& c) { return c.title == wanted; });
  if (found.empty())
    if (const auto number = to_number<Index>(name))
      found = channels_where(channels, [&](const Channel& c) { return c.number == *number; });
  if (found.size() == 1) return found.front();
  if (found.empty()) refuse("the file has no channel {}, only {}", quoted(name), list_of_channels(channels));
  refuse("the file has {} channels {}: choose by number: {}", found.size(), quoted(name),
         list_of_channels(channels));
}

bool is_text(std::string_view bytes) {
  const bool wide = is_utf16(bytes) || lacks_mark(bytes);
  return std::ranges::none_of(samples_of(bytes), wide ? has_wide_control : has_control);
}

std::string_view foreign_format(std::string_view bytes, std::string_view file_name) {
  // Of binary and of text files, and those of force curves and electrochemistry.
  for (const std::string_view head : {"\\*File list", "?*File list", "\\*Force file list", "\\*EC File list"})
    if (bytes.starts_with(head)) return "a file of Nanoscope (Bruker, Veeco)";
  if (is_text(bytes)) return "";
  if (bytes.starts_with("WSxM file copyright")) return "a file of WSxM";
  return lower(file_name).ends_with(".nms") ? "a file of NanoFocus (.nms)" : "";
}

const Format& format_named(std::string_view name, const std::string& option) {
  std::string names;
  for (const Format& format : formats()) {
    if (format.name == name) return format;
    names += fmt::format("{}{}", names.empty() ? "" : "|", format.name);
  }
  throw ParameterError(option, fmt::format("'{}' is none of {}", name, names));
}

const Format* format_by_extension(std::string_view file_name) {
  const std::string_view name = file_name.substr(file_name.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  const std::string extension = dot == name.npos ? "" : lower(name.substr(dot + 1));
  for (const Format& format : formats())
    if (has_extension(format, extension)) return &format;
  return nullptr;
}

const Format* known_format(std::string_view bytes, std::string_view file_name) {
  for (const Format& format : formats())
    if (format.recognises && format.recognises(bytes)) return &format;
  if (!foreign_format(bytes, file_name).empty()) return nullptr;
  if (is_text(bytes)) return &format::text;
  const Format* const format = format_by_extension(file_name);
  const auto zeros = [](std::string_view sample) { return sample.find('\0') != sample.npos; };
  const bool named = format && !format->recognises && !is_utf16(bytes);
  return named && std::ranges::none_of(samples_of(bytes), zeros) ? format : nullptr;
}

const Format& format_of(std::string_view bytes, std::string_view file_name) {
  if (bytes.empty()) refuse("the file is empty");
  if (const Format* format = known_format(bytes, file_name)) return *format;
  if (const std::string_view foreign = foreign_format(bytes, file_name); !foreign.empty())
    refuse("{}, which no reader here knows: convert it with Gwyddion", foreign);
  refuse("unknown format: neither the first bytes nor the file extension identifies it");
}

}  // namespace asperity
