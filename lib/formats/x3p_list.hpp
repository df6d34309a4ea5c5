/// The DataList of an X3P's main.xml, apart from the rest: a parser's nodes take twenty times the memory of the map, so that
/// it sees the list by pieces.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace pugi {
class xml_node;
}

namespace asperity {

/// Where the content of the first DataList stands; at the end, and empty, where there is none.
struct ListPlace {
  std::size_t begin, end;
};
ListPlace list_in(std::string_view xml);

/// Calls take(element) for all of a list. Throws DataError("map", …) where it is no XML.
void for_each_element(std::string_view list, const std::function<void(pugi::xml_node)>& take);

}  // namespace asperity
