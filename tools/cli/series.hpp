/// Many values in one option: words between separators.
#pragma once

#include <string>
#include <vector>

namespace asperity::cli {

/// "a,b,,c" at ',' is a, b, an empty word and c; an empty text is one empty word.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace asperity::cli
