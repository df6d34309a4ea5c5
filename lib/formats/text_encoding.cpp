#include "formats/text_encoding.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"

namespace asperity {
namespace {

bool is_control(unsigned char c) { return c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f'; }

void append_utf8(std::string& out, char32_t c) {
  constexpr char32_t lead[] = {0, 0xc0, 0xe0, 0xf0};
  const std::size_t more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  const auto put = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  put(lead[more] | c >> 6 * more);
  for (std::size_t n = more; n-- > 0;) put(0x80 | (c >> 6 * n & 0x3f));
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
  const double nearly_all = share * static_cast<double>(bytes.size() / 2);
  return (static_cast<double>(zeros[0]) >= nearly_all && control[1] == 0) ||
         (static_cast<double>(zeros[1]) >= nearly_all && control[0] == 0);
}

void refuse_without_mark(std::string_view bytes, const std::string& variable) {
  if (lacks_mark(bytes))
    throw DataError(variable, "the text looks like UTF-16 without its byte-order mark: save it as UTF-8");
}

std::string utf8_from_utf16(std::string_view bytes) {
  constexpr char32_t replacement = 0xfffd;
  const bool big = bytes.starts_with("\xfe\xff");
  const auto unit = [&](std::size_t i) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
    return static_cast<char32_t>(big ? byte(i) * 256 + byte(i + 1) : byte(i + 1) * 256 + byte(i));
  };
  const auto half = [&](std::size_t i, char32_t first) {  // of a surrogate
    return i + 1 < bytes.size() && unit(i) >= first && unit(i) < first + 0x400;
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const bool high = half(i, 0xd800);
    if (high && half(i + 2, 0xdc00)) {
      append_utf8(out, 0x10000 + ((unit(i) - 0xd800) << 10) + (unit(i + 2) - 0xdc00));
      i += 2;
    } else {
      append_utf8(out, high || half(i, 0xdc00) ? replacement : unit(i));
    }
  }
  if (bytes.size() % 2 == 1) append_utf8(out, replacement);
  return out;
}

}  // namespace asperity
