#include "formats/channels.hpp"

#include <algorithm>
#include <vector>

#include "formats/map.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr std::size_t most_listed = 8;

// "0 'Topography', 1 'Phase'"
std::string list_of(std::span<const Channel> channels) {
  std::string out;
  for (const Channel& channel : channels.first(std::min(channels.size(), most_listed)))
    out += fmt::format("{}{}{}", out.empty() ? "" : ", ", channel.number,
                       channel.title.empty() ? "" : " " + quoted(channel.title));
  return out + (channels.size() > most_listed ? ", …" : "");
}

// The places of the channels that satisfy a condition.
template <class Condition>
std::vector<std::size_t> places(std::span<const Channel> channels, Condition condition) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (condition(channels[i])) out.push_back(i);
  return out;
}

}  // namespace

std::size_t chosen_channel(std::span<const Channel> channels, std::string_view name) {
  if (channels.empty()) refuse("the file holds no map");
  if (name.empty()) {
    if (channels.size() == 1) return 0;
    const auto heights = places(channels, [](const Channel& c) { return is_length(c.unit); });
    if (heights.size() == 1) return heights.front();
    refuse("the file has {} channels, {} of them heights: choose one with `channel`: {}", channels.size(),
           heights.size(), list_of(channels));
  }
  const std::string wanted = one_line(name);
  auto found = places(channels, [&](const Channel& c) { return c.title == wanted; });
  if (found.empty())
    if (const auto number = to_number<Index>(name))
      found = places(channels, [&](const Channel& c) { return c.number == *number; });
  if (found.size() == 1) return found.front();
  if (found.empty()) refuse("the file has no channel {}, only {}", quoted(name), list_of(channels));
  refuse("the file has {} channels {}: choose by number: {}", found.size(), quoted(name), list_of(channels));
}

}  // namespace asperity
