/// Text as HTML; text from files is never interpreted as markup.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace asperity::report {

/// Escaped for an element or a quoted attribute; control characters except line feeds and tabs become U+FFFD.
std::string escaped(std::string_view text);

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

/// `<name class="…">content</name>` for content in HTML; "" if the content is empty.
std::string element(std::string_view name, std::string_view content, std::string_view css_class = "");

// Parts of tables, from HTML.
std::string labelled(std::string_view name, std::string_view meaning);  ///< the head of a row
/// `tsv`: the columns that the cell is when the table is copied, where they are not its <data> or its text.
std::string cell(std::string_view content, std::string_view css_class, std::string_view tsv = "");
/// The heads of columns may end in "|" and their `tsv`.
std::string table(std::initializer_list<std::string_view> columns, const std::string& rows,
                  std::string_view css_class);
/// Closed on a screen until the reader opens it, open on paper.
std::string folded(std::string_view title, std::string_view content);

}  // namespace asperity::report
