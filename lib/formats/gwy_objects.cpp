#include "formats/gwy_objects.hpp"

#include <cstdint>

#include "formats/raster.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

std::string_view take_bytes(std::string_view& bytes, std::size_t size) {
  if (size > bytes.size())
    refuse("the file is cut short: a component needs {} bytes more", size - bytes.size());
  const std::string_view out = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return out;
}

std::size_t take_count(std::string_view& bytes) {
  return number_from<std::uint32_t>(take_bytes(bytes, 4).data(), std::endian::little);
}

std::string_view take_string(std::string_view& bytes) {
  const std::size_t end = bytes.find('\0');
  if (end == bytes.npos) refuse("the file is cut short: a name has no end");
  const std::string_view out = bytes.substr(0, end);
  bytes.remove_prefix(end + 1);
  return out;
}

// The size of a number of this type, 0 if it is none.
std::size_t size_of_number(char type) {
  switch (type) {
    case 'b':
    case 'c':
      return 1;
    case 'i':
      return 4;
    case 'q':
    case 'd':
      return 8;
    default:
      return 0;
  }
}

// Strings or objects; each takes a byte at least, so that a false number of them ends with the bytes.
std::string_view take_several(std::string_view& bytes, char type) {
  const std::string_view all = bytes;
  const std::size_t count = take_count(bytes);
  for (std::size_t i = 0; i < count; ++i)
    type == 'S' ? static_cast<void>(take_string(bytes)) : static_cast<void>(take_gwy_object(bytes));
  return all.substr(0, all.size() - bytes.size());
}

}  // namespace

GwyComponent take_gwy_object(std::string_view& bytes) {
  GwyComponent out{.type = 'o'};
  out.kind = take_string(bytes);
  out.value = take_bytes(bytes, take_count(bytes));
  return out;
}

std::optional<GwyComponent> GwyComponents::next() {
  if (rest_.empty()) return std::nullopt;
  GwyComponent out;
  out.name = take_string(rest_);
  out.type = take_bytes(rest_, 1).front();
  if (const std::size_t size = size_of_number(out.type)) {
    out.value = take_bytes(rest_, size);
  } else if (const std::size_t each = size_of_number(static_cast<char>(out.type + ('a' - 'A')))) {
    out.value = take_bytes(rest_, each * take_count(rest_));
  } else if (out.type == 's') {
    out.value = take_string(rest_);
  } else if (out.type == 'o') {
    const GwyComponent object = take_gwy_object(rest_);
    out.kind = object.kind;
    out.value = object.value;
  } else if (out.type == 'S' || out.type == 'O') {
    out.value = take_several(rest_, out.type);
  } else {
    refuse("component {} has an unknown type, {}", quoted(out.name), quoted({&out.type, 1}));
  }
  return out;
}

}  // namespace asperity
