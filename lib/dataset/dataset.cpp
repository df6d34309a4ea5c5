#include "dataset/dataset.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "dataset/catalogue.hpp"
#include "dataset/unread.hpp"

namespace asperity {
namespace {

// The first element of a list that has this name, or null.
template <class List>
auto* pointer_to(List& list, std::string_view name) {
  const auto at = std::ranges::find_if(list, [&](const auto& item) { return item.name == name; });
  return at == list.end() ? nullptr : &*at;
}

}  // namespace

std::size_t count(const Values& values) {
  return std::visit([](const auto& v) { return v.size(); }, values);
}

std::size_t size_in_memory(const Values& values) {
  return std::visit([](const auto& v) { return v.size() * sizeof(v[0]); }, values);
}

std::vector<double> numbers(const Values& values) {
  return std::visit([](const auto& v) { return std::vector<double>(v.begin(), v.end()); }, values);
}

void Attributes::set_values(std::string_view name, Values values) {
  if (Attribute* present = pointer_to(list_, name))
    present->values = std::move(values);
  else
    list_.push_back({std::string(name), std::move(values)});
}

void Attributes::set(std::string_view name, std::string_view text) { set_values(name, std::string(text)); }
void Attributes::set(std::string_view name, double number) {
  const KnownAttribute* known = std::isfinite(number) ? nullptr : known_attribute(name);
  if (!std::isfinite(number) && !(known && known->open))
    throw DataError(std::string(name), std::string("the result is ") +
                                           (std::isnan(number) ? "not a number" : "infinite") +
                                           ": the parameters exceed double precision");
  set_values(name, std::vector<double>{number});
}
void Attributes::set(std::string_view name, int number) {
  set_values(name, std::vector<std::int32_t>{number});
}

void Attributes::erase(std::string_view name) {
  std::erase_if(list_, [&](const Attribute& a) { return a.name == name; });
}

const Values* Attributes::find(std::string_view name) const {
  const Attribute* present = pointer_to(list_, name);
  return present ? &present->values : nullptr;
}

std::string Attributes::text(std::string_view name) const {
  const Values* values = find(name);
  const auto* text = values ? std::get_if<std::string>(values) : nullptr;
  return text ? *text : std::string();
}

double Attributes::number(std::string_view name, double otherwise) const {
  const Values* values = find(name);
  if (!values || std::holds_alternative<std::string>(*values) || count(*values) == 0) return otherwise;
  return std::visit([](const auto& v) { return static_cast<double>(v[0]); }, *values);
}

const Variable* Dataset::find(std::string_view variable) const { return pointer_to(variables, variable); }
Variable* Dataset::find(std::string_view variable) { return pointer_to(variables, variable); }

const Variable& Dataset::at(std::string_view variable) const {
  if (const Variable* present = find(variable)) return *present;
  std::string names;
  for (const Variable& v : variables) names += (names.empty() ? "" : ", ") + v.name;
  const bool other = variable == "heights" && has("values");  // the map, of another quantity than lengths
  throw MissingVariable(std::string(variable), "is missing; the dataset has " +
                                                   (names.empty() ? std::string("no variables") : names) +
                                                   (other ? ": its map is `variable` values" : ""));
}

Variable& Dataset::put(Variable variable) {
  if (Variable* present = find(variable.name)) return *present = std::move(variable);
  return variables.emplace_back(std::move(variable));
}

void Dataset::erase(std::string_view variable) {
  std::erase_if(variables, [&](const Variable& v) { return v.name == variable; });
}

std::size_t Dataset::size_in_memory() const {
  std::size_t out = 0;
  for (const Variable& v : variables) out += asperity::size_in_memory(v);
  return out;
}

Index Dataset::length(std::string_view dimension) const {
  const Dimension* present = pointer_to(dimensions, dimension);
  return present ? present->length : -1;
}

void Dataset::set_dimension(std::string_view name, Index length) {
  Dimension* present = pointer_to(dimensions, name);
  if (!present) {
    dimensions.push_back({std::string(name), length});
  } else if (present->length != length) {
    std::erase_if(variables, [&](const Variable& v) {
      return std::ranges::find(v.dimensions, name) != v.dimensions.end();
    });
    present->length = length;
  }
}

}  // namespace asperity
