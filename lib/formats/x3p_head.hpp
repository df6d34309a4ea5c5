/// What main.xml of an X3P says of its numbers: Record1 and the size in Record3; its DataList in pieces:
/// parsed whole, it needs twenty times the memory of the map; and checksums.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include <Eigen/Core>
#include <pugixml.hpp>

#include "formats/map.hpp"
#include "formats/raster.hpp"

namespace asperity::x3p {

/// Elements by their names without the name space: the only child, or an empty node; its text without blanks.
std::string_view local_name(pugi::xml_node node);
pugi::xml_node child(pugi::xml_node node, std::string_view name);
std::string_view text_of_child(pugi::xml_node node, std::string_view name);

struct Head {
  Shape shape;
  std::array<double, 2> spacing;
  NumberType type = NumberType::float64;
  double increment = 1, offset = 0;
  Eigen::Array33i rotation;     ///< a permutation of x and y with signs, and a sign of z
  std::string understood = {};  ///< of what is read otherwise than by other programs, for a person
};

/// Throws DataError("map", …) for what is neither a surface on a grid nor a profile.
Head head_of(pugi::xml_node root);
/// Numbers of a file become heights: z = r33 Increment number + Offset, with x and y where R takes them.
void make_heights(Map& map, const Head& head);

/// The position of the content of the first DataList; empty and at the end if there is none.
struct ListPlace {
  std::size_t begin, end;
};
ListPlace list_in(std::string_view xml);

/// Calls take(element) for each element of a list. Throws DataError("map", …) if it is not valid XML.
void for_each_element(std::string_view list, const std::function<void(pugi::xml_node)>& take);

/// The MD5 of bytes (RFC 1321), 32 digits in lower case.
std::string md5_of(std::string_view bytes);

}  // namespace asperity::x3p
