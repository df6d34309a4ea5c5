#include "tools/cli/lineage.hpp"

#include <algorithm>
#include <utility>

#include "dataset/catalogue.hpp"
#include "tools/cli/plain_text.hpp"

namespace asperity::cli {
namespace {

using Names = std::vector<std::string>;

using Gone = std::vector<const KnownResult*>;

bool has(const Gone& gone, const KnownResult* result) {
  return std::ranges::find(gone, result) != gone.end();
}

// Where it says that it was computed from another field than the heights, on that one.
bool rests_on(const Dataset& data, const KnownResult& result, const Gone& gone) {
  const std::string from = data.attributes.text(std::string(result.name) + "_variable");
  return std::ranges::any_of(words_of(result.rests_on), [&](std::string_view base) {
    return has(gone, result_of(base == "heights" && !from.empty() ? std::string_view(from) : base));
  });
}

Gone stale(const Dataset& data, std::string_view replaced, std::string_view input) {
  const KnownResult* const kept = result_of(input);
  Gone gone{&*std::ranges::find(known_results(), replaced, &KnownResult::name)};
  for (std::size_t before = 0; before != gone.size();) {
    before = gone.size();
    for (const KnownResult& r : known_results())
      if (&r != kept && !has(gone, &r) && rests_on(data, r, gone)) gone.push_back(&r);
  }
  return gone;
}

bool is_coordinate(const Variable& v) { return v.dimensions == Names{v.name}; }

// Erases variables, and the dimensions with their coordinates that are left bare by it.
template <class Predicate>
void erase_variables(Dataset& data, Predicate gone) {
  Names bare;
  for (const Variable& v : data.variables)
    if (gone(v)) bare.insert(bare.end(), v.dimensions.begin(), v.dimensions.end());
  std::erase_if(data.variables, gone);
  std::erase_if(bare, [&](const std::string& dimension) {
    return dimension == "x" || dimension == "y" ||
           std::ranges::any_of(data.variables, [&](const Variable& v) {
             return !is_coordinate(v) && std::ranges::find(v.dimensions, dimension) != v.dimensions.end();
           });
  });
  const auto is_bare = [&](const auto& item) { return std::ranges::find(bare, item.name) != bare.end(); };
  std::erase_if(data.variables, is_bare);
  std::erase_if(data.dimensions, is_bare);
}

// "heights_residual, stress_*": many of one result stand together.
std::string in_short(const Names& names) {
  constexpr std::ptrdiff_t few = 2;
  std::string line;
  Gone shortened;
  for (const std::string& name : names) {
    const KnownResult* const result = result_of(name);
    if (has(shortened, result)) continue;
    const auto all = std::ranges::count(names, result, [](const std::string& n) { return result_of(n); });
    const bool many = result && all > few;
    if (many) shortened.push_back(result);
    line += line.empty() ? "" : ", ";
    line += many ? std::string(result->prefix) + "*" : name;
  }
  return line;
}

}  // namespace

void drop_results(Dataset& data, std::string_view result, std::string_view input) {
  const Gone gone = stale(data, result, input);
  erase_variables(
      data, [&](const Variable& v) { return v.name != input && has(gone, result_of_variable(v.name)); });
  for (const Attribute& a : Attributes(data.attributes))
    if (has(gone, result_of_attribute(a.name))) data.attributes.erase(a.name);
}

void drop_variable(Dataset& data, std::string_view name) {
  erase_variables(data, [&](const Variable& v) { return v.name == name; });
}

void drop_surface(Dataset& data, std::string_view result) {
  drop_results(data, result);
  erase_variables(data, [](const Variable& v) {
    return !is_coordinate(v) &&
           std::ranges::any_of(v.dimensions, [](const std::string& d) { return d == "x" || d == "y"; });
  });
}

void replace_surface(const Tool& tool, Dataset& data, const Map& map, bool another) {
  const Inventory before(data);
  const Attributes former = data.attributes;
  Dataset now = dataset_of(map);
  drop_surface(data, "kernel");
  for (const Attribute& a : former)
    if (!another && a.name.starts_with("filter_")) data.attributes.set_values(a.name, a.values);
  for (const Dimension& d : now.dimensions) data.set_dimension(d.name, d.length);
  for (Variable& v : now.variables) data.put(std::move(v));
  before.tell(tool, data, "map");
}

Inventory::Inventory(const Dataset& data) {
  for (const Variable& v : data.variables)
    if (!is_coordinate(v)) names_.push_back(v.name);
  for (const Attribute& a : data.attributes)
    if (!a.name.ends_with("_warnings")) names_.push_back(a.name);
}

std::vector<std::string> Inventory::missing_in(const Dataset& now) const {
  Names out;
  for (const std::string& name : names_)
    if (!now.has(name) && !now.attributes.find(name)) out.push_back(name);
  return out;
}

void Inventory::tell(const Tool& tool, const Dataset& now, const std::string& replaced,
                     std::string_view coming) const {
  Names gone = missing_in(now);
  const std::vector<std::string_view> written = words_of(coming);
  std::erase_if(gone, [&](const std::string& name) {
    return std::ranges::any_of(written, [&](std::string_view word) { return fits(word, name); });
  });
  if (!gone.empty()) tool.note("dropped results of the former " + replaced + ": " + in_short(gone));
}

}  // namespace asperity::cli
