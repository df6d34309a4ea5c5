#include "dataset/catalogue.hpp"

#include <iterator>
#include <utility>

namespace asperity {
namespace {

// Units that variables of these names must have, up to a factor.
constexpr std::pair<std::string_view, std::string_view> units[] = {
    {"m", "heights gap displacement displacement_plastic heights_residual"}, {"Pa", "pressure von_mises"}};

// Words of the table, separated by blanks.
bool has(std::string_view words, std::string_view name) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (fits(words.substr(0, end), name)) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

template <class Is>
const KnownResult* result_that(Is is) {
  const auto found = std::ranges::find_if(catalogue::results, is);
  return found == std::end(catalogue::results) ? nullptr : found;
}

}  // namespace

std::string_view unit_needed(std::string_view variable) {
  for (const auto& [unit, names] : units)
    if (has(names, variable)) return unit;
  return "";
}

const KnownResult* result_of_variable(std::string_view name) {
  return result_that([&](const KnownResult& r) { return has(r.variables, name); });
}

const KnownResult* result_of_attribute(std::string_view name) {
  const KnownAttribute* known = known_attribute(name);
  return result_that(
      [&](const KnownResult& r) { return known && !r.prefix.empty() && known->name.starts_with(r.prefix); });
}

const KnownResult* result_of(std::string_view name) {
  const KnownResult* of_variable = result_of_variable(name);
  return of_variable ? of_variable : result_of_attribute(name);
}

}  // namespace asperity
