#include "dataset/conventions.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/unread.hpp"

namespace asperity {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr const char* packing_attributes[] = {"scale_factor", "add_offset",    "valid_range", "valid_min",
                                              "valid_max",    "missing_value", "_Unsigned"};

bool is_text(const Values& values) { return std::holds_alternative<std::string>(values); }
bool is_floating(const Values& values) {
  return std::holds_alternative<std::vector<float>>(values) ||
         std::holds_alternative<std::vector<double>>(values);
}

[[noreturn]] void refuse(const Variable& variable, const std::string& attribute, const std::string& what) {
  throw DataError(variable.name,
                  "attribute " + attribute + " is " + what + ": correct it in the file (ncatted)");
}

std::string text_of(double value) { return in_digits(value, 6); }

// As in the Users Guide: the second smallest number of signed types, the largest of unsigned types; for 64
// bits the next one.
template <class T>
constexpr T fill_of_type() {
  if constexpr (std::is_floating_point_v<T>) return static_cast<T>(default_fill);
  constexpr T beyond = sizeof(T) == 8;  // 64 bits: one further
  return static_cast<T>(std::is_signed_v<T> ? std::numeric_limits<T>::min() + 1 + beyond
                                            : std::numeric_limits<T>::max() - beyond);
}

// Empty for bytes and text.
Values default_fill_of(const Values& values) {
  return std::visit(
      []<class List>(const List&) -> Values {
        using T = typename List::value_type;
        return sizeof(T) == 1 ? List() : List(1, fill_of_type<T>());
      },
      values);
}

// The number in this type; nothing if an integer type cannot hold it.
template <class T>
std::optional<T> as(double value) {
  if constexpr (std::is_floating_point_v<T>) return static_cast<T>(value);
  constexpr double least = static_cast<double>(std::numeric_limits<T>::min());
  const bool fits = value >= least && value < std::ldexp(1.0, std::numeric_limits<T>::digits);
  return fits && value == std::nearbyint(value) ? std::optional(static_cast<T>(value)) : std::nullopt;
}

// A list of one number in the type of these values; empty if the type cannot hold it.
Values alone(double number, const Values& values) {
  return std::visit(
      [&]<class List>(const List&) -> Values {
        const auto value = as<typename List::value_type>(number);
        return value ? List(1, *value) : List();
      },
      values);
}

std::optional<double> among(const Values& values, double number) {
  const std::vector<double> list = numbers(alone(number, values));
  return list.empty() ? std::nullopt : std::optional(list[0]);
}

// The same bits read as signed or unsigned integers.
template <class List>
Values with_sign(const List& list, bool sign) {
  using T = typename List::value_type;
  if constexpr (std::is_integral_v<T> && !std::is_same_v<List, std::string>) {
    if (sign) return std::vector<std::make_signed_t<T>>(list.begin(), list.end());
    return std::vector<std::make_unsigned_t<T>>(list.begin(), list.end());
  }
  return list;
}

// The range of the numbers that are not missing, in the type of the values.
void set_range(Variable& variable) {
  const double mark = mark_of(variable);
  const Values range = std::visit(
      [&]<class List>(const List& list) -> Values {
        List out;
        for (const auto v : list) {
          if (const auto value = static_cast<double>(v); std::isnan(value) || value == mark) continue;
          if (out.empty()) out = {v, v};
          out[0] = std::min(out[0], v);
          out[1] = std::max(out[1], v);
        }
        return out;
      },
      variable.values);
  if (count(range) == 0) return variable.attributes.erase("actual_range");
  variable.attributes.set_values("actual_range", range);
}

// In the Users Guide bounds refer to unpacked values, in CF to packed integers.
void refuse_floating_bounds(const Variable& variable) {
  for (const char* attribute : {"valid_range", "valid_min", "valid_max"})
    if (const Values* values = variable.attributes.find(attribute); values && is_floating(*values))
      refuse(variable, attribute, "floating-point for packed integers; CF needs it in the packed type");
}

}  // namespace

double mark_of(const Variable& variable) {
  for (const char* attribute : {"_FillValue", "missing_value"})
    if (variable.attributes.find(attribute)) return variable.attributes.number(attribute, none);
  const std::vector<double> fill = numbers(default_fill_of(variable.values));
  return fill.empty() ? none : fill[0];
}

std::vector<double> present_numbers(const Variable& variable) {
  std::vector<double> out =
      numbers(variable.unread ? values_of(variable, 0, count(variable)) : variable.values);
  std::ranges::replace(out, mark_of(variable), none);
  return out;
}

// ---- attributes of a variable ----

Conventions::Conventions(const Variable& packed) {
  if (is_text(packed.values)) return;
  plain_ = std::ranges::none_of(packing_attributes,
                                [&](const char* name) { return packed.attributes.find(name); });
  take_sign(packed);
  take_packing(packed);
  take_range(packed);
  take_marks(packed);
}

std::vector<double> Conventions::numbers_in(const Variable& variable, const char* attribute) const {
  const Values* values = variable.attributes.find(attribute);
  if (!values) return {};
  if (is_text(*values)) refuse(variable, attribute, "text instead of a number");
  if (count(*values) == 0) refuse(variable, attribute, "empty");
  return numbers(values->index() == variable.values.index() ? own_type(*values) : *values);
}

std::optional<double> Conventions::number_in(const Variable& variable, const char* attribute) const {
  const std::vector<double> list = numbers_in(variable, attribute);
  if (list.size() > 1) refuse(variable, attribute, "a list of " + std::to_string(list.size()) + " numbers");
  return list.empty() ? std::nullopt : std::optional(list[0]);
}

void Conventions::take_sign(const Variable& variable) {
  own_ = std::visit([]<class List>(const List&) -> Values { return List(); }, variable.values);
  if (!variable.attributes.find("_Unsigned")) return;
  const std::string word = variable.attributes.text("_Unsigned");
  if (word != "true" && word != "false") refuse(variable, "_Unsigned", "not true or false");
  own_ = std::visit([&](const auto& list) { return with_sign(list, word == "false"); }, own_);
}

// Attributes of the variable's own type have the intended sign of its values.
Values Conventions::own_type(const Values& values) const {
  const bool sign =
      std::visit([]<class List>(const List&) { return std::is_signed_v<typename List::value_type>; }, own_);
  return std::visit([&](const auto& list) { return with_sign(list, sign); }, values);
}

void Conventions::take_packing(const Variable& variable) {
  for (const auto& [attribute, target] : {std::pair{"scale_factor", &scale_}, {"add_offset", &offset_}}) {
    const auto number = number_in(variable, attribute);
    if (!number) continue;
    if (!std::isfinite(*number) || (target == &scale_ && *number == 0))
      refuse(variable, attribute, text_of(*number));
    *target = *number;
  }
  doubles_ = scale_ != 1 || offset_ != 0;
}

void Conventions::take_range(const Variable& variable) {
  std::vector<double> range = numbers_in(variable, "valid_range");
  if (range.empty()) range = {least_, greatest_};
  if (range.size() != 2)
    refuse(variable, "valid_range", "a list of " + std::to_string(range.size()) + " numbers instead of 2");
  range[0] = std::max(number_in(variable, "valid_min").value_or(range[0]), range[0]);
  range[1] = std::min(number_in(variable, "valid_max").value_or(range[1]), range[1]);
  if (doubles_ && !is_floating(own_)) refuse_floating_bounds(variable);
  if (!(range[0] <= range[1]))
    refuse(variable, "valid_range", text_of(range[0]) + " to " + text_of(range[1]) + ", which is empty");
  const bool single =
      std::holds_alternative<std::vector<float>>(own_);  // 0.1 as float differs from 0.1 as double
  least_ = single ? static_cast<double>(static_cast<float>(range[0])) : range[0];
  greatest_ = single ? static_cast<double>(static_cast<float>(range[1])) : range[1];
}

void Conventions::take_marks(const Variable& variable) {
  if (const auto fill = number_in(variable, "_FillValue")) {
    const auto mark = among(own_, *fill);
    if (!mark) refuse(variable, "_FillValue", text_of(*fill) + ", which its type cannot hold");
    marks_.push_back(*mark);
    plain_ = plain_ && variable.attributes.find("_FillValue")->index() == own_.index();
  }
  const std::vector<double> fill = numbers(own_type(default_fill_of(variable.values)));
  const bool given = !marks_.empty();
  for (const double number : numbers_in(variable, "missing_value"))
    if (const auto mark = among(own_, number)) marks_.push_back(*mark);
  if (!given) marks_.insert(marks_.end(), fill.begin(), fill.end());
  if (!marks_.empty()) mark_ = marks_[0];
  const bool bounded = std::isfinite(least_) || std::isfinite(greatest_);
  if (!mark_ && bounded) doubles_ = true;  // bytes: no number can be the mark
  if (doubles_ && (mark_ || bounded)) mark_ = default_fill;
}

// ---- plain values ----

bool Conventions::missing(double packed) const {
  return packed < least_ || packed > greatest_ || std::ranges::find(marks_, packed) != marks_.end();
}

Values Conventions::unpacked(Values packed) const {
  if (plain_) return packed;
  if (packed.index() != own_.index()) packed = own_type(packed);
  if (!doubles_ && !mark_) return packed;
  return std::visit(
      [&]<class List>(List& list) -> Values {
        using T = typename List::value_type;
        if (!doubles_) {
          for (T& v : list)
            if (missing(static_cast<double>(v))) v = static_cast<T>(*mark_);
          return std::move(list);
        }
        std::vector<double> out(list.begin(), list.end());
        for (double& v : out) v = missing(v) ? *mark_ : v * scale_ + offset_;
        return out;
      },
      packed);
}

Variable Conventions::unpacked(Variable packed) const {
  if (plain_) return packed;
  for (const char* attribute : {"flag_values", "flag_masks"})
    if (const Values* values = packed.attributes.find(attribute);
        values && values->index() == packed.values.index())
      packed.attributes.set_values(attribute, own_type(*values));
  const bool named = !packed.attributes.find("_FillValue") && packed.attributes.find("missing_value");
  packed.values = unpacked(std::move(packed.values));
  for (const char* attribute : packing_attributes) packed.attributes.erase(attribute);
  if (mark_)
    packed.attributes.set_values(named ? "missing_value" : "_FillValue", alone(*mark_, packed.values));
  if (packed.attributes.find("actual_range")) set_range(packed);
  return packed;
}

Dataset with_plain_values(Dataset dataset) {
  for (Variable& variable : dataset.variables)
    if (const Conventions says(variable); !says.plain()) {
      load(variable);
      variable = says.unpacked(std::move(variable));
    }
  return dataset;
}

}  // namespace asperity
