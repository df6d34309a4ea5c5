/// A dataset in memory: dimensions, variables and attributes in the order of the file.
///
/// It is plain data: unknown variables and attributes pass through unchanged, with their types. Values may be
/// left in the file until they are needed (dataset/unread.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/field.hpp"

namespace asperity {

/// The values of a variable (row-major) or of an attribute, in the external type of the file.
using Values = std::variant<std::string, std::vector<std::int8_t>, std::vector<std::uint8_t>,
                            std::vector<std::int16_t>, std::vector<std::uint16_t>, std::vector<std::int32_t>,
                            std::vector<std::uint32_t>, std::vector<std::int64_t>, std::vector<std::uint64_t>,
                            std::vector<float>, std::vector<double>>;

/// Number of elements.
std::size_t count(const Values& values);
/// Number of bytes.
std::size_t size_in_memory(const Values& values);

struct Attribute {
  std::string name;
  Values values;
};

/// Named attributes in order; setting an existing one replaces its value in place.
class Attributes {
 public:
  void set(std::string_view name, std::string_view text);
  /// Throws DataError(name, …) for a number that is not finite, unless the catalogue allows it.
  void set(std::string_view name, double number);
  void set(std::string_view name, int number);
  void set_values(std::string_view name, Values values);
  /// Of a name that is not among them.
  void add(Attribute attribute) { list_.push_back(std::move(attribute)); }
  void erase(std::string_view name);

  const Values* find(std::string_view name) const;
  /// The text, or "" if there is no such attribute or it is a number.
  std::string text(std::string_view name) const;
  /// The first number, or `otherwise` if there is none.
  double number(std::string_view name, double otherwise) const;

  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  std::size_t size() const { return list_.size(); }

 private:
  std::vector<Attribute> list_;
};

struct Unread;

struct Dimension {
  std::string name;
  Index length = 0;
};

struct Variable {
  std::string name;
  std::vector<std::string> dimensions;
  Values values;
  Attributes attributes;
  /// Where the values are, if they are still in a file; `values` then has their type, but no elements.
  std::shared_ptr<const Unread> unread = nullptr;
};

class Dataset {
 public:
  std::vector<Dimension> dimensions;
  std::vector<Variable> variables;
  Attributes attributes;  ///< global
  /// Notes of the reader for the user, one line each; not part of the file.
  std::vector<std::string> notes;

  bool has(std::string_view variable) const { return find(variable) != nullptr; }
  const Variable* find(std::string_view variable) const;
  Variable* find(std::string_view variable);
  /// The variable; throws DataError with its name if there is none.
  const Variable& at(std::string_view variable) const;
  /// Adds the variable, or replaces the one of that name in place.
  Variable& put(Variable variable);
  void erase(std::string_view variable);

  /// The bytes of all values.
  std::size_t size_in_memory() const;

  /// The length of a dimension, or -1.
  Index length(std::string_view dimension) const;
  /// Adds a dimension, or changes its length and erases every variable on it with another length.
  void set_dimension(std::string_view name, Index length);
};

/// The values converted to double.
std::vector<double> numbers(const Values& values);

}  // namespace asperity
