/// The record of a run: program, time, command; and tables of quantities, by which results become attributes.
///
///     constexpr Quantity<Contact> solution[] = {{"contact_load", &Contact::load}, …};
///     record(data.attributes, solution, contact);      // and read_back(data.attributes, solution, contact)
///
/// A table pairs names of the catalogue with members of a struct; labels, units and columns of tables follow
/// from the name (dataset/catalogue.hpp).
#pragma once

#include <cmath>
#include <ctime>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "dataset/catalogue.hpp"
#include "dataset/dataset.hpp"

namespace asperity::cli {

std::string version();    ///< Asperity's
std::string libraries();  ///< that the tools use, with their versions
std::string source();     ///< "Asperity VERSION (libraries)", the dataset's attribute

/// An argument as a shell would need it.
std::string shell_word(const std::string& argument);
/// The seconds since 1970 that SOURCE_DATE_EPOCH asks for, where it is set. Throws ParameterError where they
/// are no whole number from 0 to the end of 9999.
std::optional<std::time_t> source_date();
/// The time of the run in UTC, as ISO 8601, or the one that SOURCE_DATE_EPOCH asks for.
std::string timestamp();
/// Seconds as a dataset records them: 0 where SOURCE_DATE_EPOCH is set.
double on_record(double seconds);

/// For --time, "1.52 s, CPU 2.9 s (2.7 s user, 0.2 s system), peak memory 61 MB", with finished children.
std::string usage_of_run(double wall_seconds);

/// The global attributes whose names begin with `prefix` as one JSON object.
std::string report_of(const Dataset& dataset, const std::string& prefix);

// ---- tables of quantities ----

/// Whether a value is recorded.
using Kept = bool (*)(double value);
constexpr bool always(double) { return true; }
constexpr bool if_known(double value) { return value == value; }
constexpr bool if_above_0(double value) { return value > 0; }
inline bool if_finite(double value) { return std::isfinite(value); }

/// An attribute and the member of a T that it holds.
template <class T>
struct Quantity {
  AttributeName name;
  std::variant<double T::*, int T::*, long T::*, bool T::*> member;
  Kept kept = always;
};

/// Counts and bools become whole numbers; seconds are on_record().
template <class T>
void record(Attributes& a, const Quantity<T>& quantity, const T& from) {
  auto set = [&](auto member) {
    const auto value = from.*member;
    if (!quantity.kept(static_cast<double>(value))) return;
    if constexpr (std::is_integral_v<decltype(value)>)
      a.set(quantity.name.text, static_cast<int>(value));
    else
      a.set(quantity.name.text, quantity.name.known().unit == "s" ? on_record(value) : value);
  };
  std::visit(set, quantity.member);
}

template <class T, std::size_t n>
void record(Attributes& a, const Quantity<T> (&quantities)[n], const T& from) {
  for (const Quantity<T>& quantity : quantities) record(a, quantity, from);
}

inline std::string error_name(std::string_view name) { return std::string(name) + "_error"; }

/// NAME_error, where the quantity is recorded and its error known.
template <class T>
void record_error(Attributes& a, const Quantity<T>& quantity, const T& errors) {
  const double error = errors.*std::get<double T::*>(quantity.member);
  if (!std::isnan(error) && a.find(quantity.name.text)) a.set(error_name(quantity.name.text), error);
}

/// Each quantity, followed by its error.
template <class T, std::size_t n>
void record(Attributes& a, const Quantity<T> (&quantities)[n], const T& from, const T& errors) {
  for (const Quantity<T>& quantity : quantities) record(a, quantity, from), record_error(a, quantity, errors);
}

/// The recorded numbers, apart from counts; others stay as they are.
template <class T, std::size_t n>
void read_back(const Attributes& a, const Quantity<T> (&quantities)[n], T& into) {
  for (const auto& [name, member, kept] : quantities)
    if (const auto* number = std::get_if<double T::*>(&member))
      into.** number = a.number(name.text, into.**number);
    else if (const auto* yes = std::get_if<bool T::*>(&member))
      into.** yes = a.number(name.text, into.**yes) != 0;
}

}  // namespace asperity::cli
