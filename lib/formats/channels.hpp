/// The choice among the channels of a file that holds several maps.
///
/// A name is that of one channel, or its number in the file. Without a name the only channel is meant, or the
/// only one whose unit is a length: the heights. Anything else is refused, with the channels' numbers and
/// names.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/field.hpp"

namespace asperity {

struct Channel {
  Index number = 0;
  std::string title = {};      ///< one line, or ""
  std::string_view unit = {};  ///< of the values, as the file spells it
};

/// The place in `channels`. Throws DataError("map", …) when none or several are meant.
std::size_t chosen_channel(std::span<const Channel> channels, std::string_view name);

}  // namespace asperity
