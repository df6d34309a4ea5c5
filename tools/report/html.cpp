#include "tools/report/html.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/words.hpp"

namespace asperity::report {
namespace {

constexpr struct {
  char character;
  const char* escape;
} escapes[] = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};

std::string entity_of(char c) {
  const auto code = static_cast<unsigned char>(c);
  if ((code < 0x20 && c != '\n' && c != '\t') || code == 0x7F) return "\uFFFD";
  const auto* own = std::ranges::find_if(escapes, [&](const auto& e) { return e.character == c; });
  return own == std::end(escapes) ? std::string(1, c) : own->escape;
}

std::string tsv_of(std::string_view columns) {
  return columns.empty() ? "" : fmt::format(" data-tsv=\"{}\"", columns);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : utf8_of(text)) out += entity_of(c);
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return out;
}

std::string element(std::string_view name, std::string_view content, std::string_view css_class) {
  if (content.empty()) return "";
  const std::string attribute = css_class.empty() ? "" : fmt::format(" class=\"{}\"", css_class);
  return fmt::format("<{}{}>{}</{}>\n", name, attribute, content, name);
}

std::string labelled(std::string_view name, std::string_view meaning) {
  return fmt::format("<th scope=\"row\" data-tsv=\"{0}\"><b>{0}</b> <span>{1}</span></th>", name, meaning);
}

std::string cell(std::string_view content, std::string_view css_class, std::string_view tsv) {
  return fmt::format("<td class=\"{}\"{}>{}</td>", css_class, tsv_of(tsv), content);
}

std::string table(std::initializer_list<std::string_view> columns, const std::string& rows,
                  std::string_view css_class) {
  std::string head;
  for (const std::string_view column : columns) {
    const auto bar = std::min(column.find('|'), column.size());
    head += fmt::format("<th scope=\"col\"{}>{}</th>",
                        tsv_of(column.substr(std::min(bar + 1, column.size()))), column.substr(0, bar));
  }
  return element("table", element("thead", element("tr", head)) + fmt::format("<tbody>{}</tbody>\n", rows),
                 css_class);
}

std::string folded(std::string_view title, std::string_view content) {
  return content.empty() ? "" : element("details", element("summary", title) + std::string(content));
}

}  // namespace asperity::report
