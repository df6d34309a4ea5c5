/// Checksums of an X3P, and its DataList read in pieces: parsed whole, it needs twenty times the map's
/// memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace pugi {
class xml_node;
}

namespace asperity {

/// The position of the content of the first DataList; empty and at the end if there is none.
struct ListPlace {
  std::size_t begin, end;
};
ListPlace list_in(std::string_view xml);

/// Calls take(element) for each element of a list. Throws DataError("map", …) if it is not valid XML.
void for_each_element(std::string_view list, const std::function<void(pugi::xml_node)>& take);

/// The MD5 of bytes, 32 digits in lower case.
std::string md5_of(std::string_view bytes);

}  // namespace asperity
