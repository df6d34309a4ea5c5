#include "formats/x3p_parts.hpp"

#include <algorithm>
#include <utility>

#include <md5.h>
#include <pugixml.hpp>

#include "formats/refuse.hpp"

namespace asperity {
namespace {

// The end of a comment or CDATA section that begins here; 0 if none begins.
std::size_t behind_no_markup(std::string_view xml, std::size_t at) {
  constexpr std::pair<std::string_view, std::string_view> marks[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}};
  for (const auto& [begin, end] : marks)
    if (xml.substr(at).starts_with(begin)) return std::min(xml.find(end, at), xml.size() - 1);
  return 0;
}

// The first element from this position.
std::size_t find_element(std::string_view list, std::size_t from) {
  std::size_t at = list.find('<', from);
  while (at != list.npos && at + 1 < list.size() && list[at + 1] == '/') at = list.find('<', at + 1);
  return std::min(at, list.size());
}

}  // namespace

ListPlace list_in(std::string_view xml) {
  for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
    if (const std::size_t behind = behind_no_markup(xml, at); behind > 0) {
      at = behind;
      continue;
    }
    const std::size_t end = std::min(xml.find_first_of(" \t\r\n/><", at + 1), xml.size());
    const std::string_view name = xml.substr(at + 1, end - at - 1);
    if (name.substr(name.find(':') + 1) != "DataList") continue;
    const std::size_t begin = xml.find('>', end), close = xml.find("</" + std::string(name), end);
    if (close == xml.npos || begin > close) break;
    return {begin + 1, close};
  }
  return {xml.size(), xml.size()};
}

void for_each_element(std::string_view list, const std::function<void(pugi::xml_node)>& take) {
  constexpr std::size_t piece = 1 << 16;
  for (pugi::xml_document document; !list.empty();) {
    const std::size_t end = find_element(list, piece);
    constexpr unsigned parts = pugi::parse_default | pugi::parse_fragment;
    const auto parsed = document.load_buffer(list.data(), end, parts, pugi::encoding_utf8);
    if (!parsed) refuse("DataList in main.xml is not valid XML: {}", parsed.description());
    for (const pugi::xml_node node : document) take(node);
    list.remove_prefix(end);
  }
}

std::string md5_of(std::string_view bytes) {
  char digits[MD5_DIGEST_STRING_LENGTH];
  MD5Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digits);
  return digits;
}

}  // namespace asperity
