#include "dataset/rest.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace asperity {

void refuse_rest(std::string_view rest, const std::string& variable) {
  if (std::ranges::all_of(rest, [](char c) { return c == '\0'; })) return;
  throw DataError(variable,
                  std::to_string(rest.size()) +
                      " bytes follow its end, perhaps those of another one: give each in a file, or a "
                      "stream, of its own");
}

}  // namespace asperity
