#include "formats/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/error.hpp"

namespace asperity {
namespace {

constexpr char32_t replacement = 0xfffd;

bool is_control(unsigned char c) { return c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f'; }

// The next unit of 16 bits, removed; a single last byte is the replacement.
char32_t take_unit(std::string_view& bytes, bool big) {
  if (bytes.size() < 2) {
    bytes = {};
    return replacement;
  }
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const char32_t out = big ? byte(0) * 256u + byte(1) : byte(1) * 256u + byte(0);
  bytes.remove_prefix(2);
  return out;
}

char32_t take_character(std::string_view& bytes, bool big) {
  const char32_t high = take_unit(bytes, big);
  if (high < 0xd800 || high > 0xdfff) return high;
  std::string_view next = bytes;
  const char32_t low = next.empty() ? 0 : take_unit(next, big);
  if (high > 0xdbff || low < 0xdc00 || low > 0xdfff) return replacement;
  bytes = next;
  return 0x10000 + ((high - 0xd800) << 10) + (low - 0xdc00);
}

void append(std::string& out, char32_t c) {
  const auto put = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto rest = [&](int shift) { put(0x80 | ((c >> shift) & 0x3f)); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xc0 | (c >> 6));
    return rest(0);
  }
  if (c < 0x10000) {
    put(0xe0 | (c >> 12));
  } else {
    put(0xf0 | (c >> 18));
    rest(12);
  }
  rest(6);
  rest(0);
}

}  // namespace

bool has_control(std::string_view bytes) { return std::ranges::any_of(bytes, is_control); }

bool has_wide_control(std::string_view bytes) {
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto [low, high] =
        std::minmax({static_cast<unsigned char>(bytes[i]), static_cast<unsigned char>(bytes[i + 1])});
    if (high < 0x20 && (low > 0 || is_control(high))) return true;
  }
  return false;
}

bool is_utf16(std::string_view bytes) {
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

bool lacks_mark(std::string_view bytes) {
  constexpr std::size_t looked_at = 4096, least = 8;
  constexpr double share = 0.9;  // of characters below U+0100
  bytes = bytes.substr(0, std::min(looked_at, bytes.size() / 2 * 2));
  if (is_utf16(bytes) || bytes.size() < least) return false;
  std::array<std::size_t, 2> zeros{}, control{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    zeros[i % 2] += c == 0;
    control[i % 2] += is_control(c);
  }
  const auto nearly_all = share * static_cast<double>(bytes.size() / 2);
  for (const std::size_t high : {std::size_t{0}, std::size_t{1}})
    if (static_cast<double>(zeros[high]) >= nearly_all && control[1 - high] == 0) return true;
  return false;
}

void refuse_without_mark(std::string_view bytes, const std::string& variable) {
  if (lacks_mark(bytes))
    throw DataError(variable, "the text looks like UTF-16 without its byte-order mark: save it as UTF-8");
}

std::string utf8_from_utf16(std::string_view bytes) {
  const bool big = bytes.starts_with("\xfe\xff");
  bytes.remove_prefix(2);
  std::string out;
  out.reserve(bytes.size() / 2);
  while (!bytes.empty()) append(out, take_character(bytes, big));
  return out;
}

}  // namespace asperity
