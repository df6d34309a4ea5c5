/// A dataset in memory: dimensions, variables and attributes, in the order in which they stand in the file.
///
/// It is plain data: what Asperity does not understand is kept, its type included, and written again.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
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
/// Their bytes.
std::size_t size_in_memory(const Values& values);

struct Attribute {
  std::string name;
  Values values;
};

/// Named attributes in order; setting one that exists replaces its value where it stands.
class Attributes {
 public:
  void set(std::string_view name, std::string_view text);
  /// Throws DataError(name, …) for a number that is not finite, unless by the catalogue it may be.
  void set(std::string_view name, double number);
  void set(std::string_view name, int number);
  void set_values(std::string_view name, Values values);
  void erase(std::string_view name);

  const Values* find(std::string_view name) const;
  /// The text, or "" when there is no such attribute or it is a number.
  std::string text(std::string_view name) const;
  /// The first number, or `otherwise` when there is none.
  double number(std::string_view name, double otherwise) const;

  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  std::size_t size() const { return list_.size(); }

 private:
  std::vector<Attribute> list_;
};

struct Dimension {
  std::string name;
  Index length = 0;
};

struct Variable {
  std::string name;
  std::vector<std::string> dimensions;
  Values values;
  Attributes attributes;
};

class Dataset {
 public:
  std::vector<Dimension> dimensions;
  std::vector<Variable> variables;
  Attributes attributes;  ///< global
  /// What a reader settled that its user may want to know, a line each; of no file.
  std::vector<std::string> notes;

  bool has(std::string_view variable) const { return find(variable) != nullptr; }
  const Variable* find(std::string_view variable) const;
  Variable* find(std::string_view variable);
  /// The variable; throws DataError naming it when there is none.
  const Variable& at(std::string_view variable) const;
  /// Adds the variable, or replaces the one of that name where it stands.
  Variable& put(Variable variable);
  void erase(std::string_view variable);

  /// The bytes of all values.
  std::size_t size_in_memory() const;

  /// The length of a dimension, or -1.
  Index length(std::string_view dimension) const;
  /// Adds a dimension, or changes its length after erasing every variable that uses it with another length.
  void set_dimension(std::string_view name, Index length);
};

/// The values converted to double.
std::vector<double> numbers(const Values& values);

}  // namespace asperity
