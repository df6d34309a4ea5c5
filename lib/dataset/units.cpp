#include "dataset/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include <udunits2.h>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/words.hpp"
#include "dataset/beside.hpp"
#include "dataset/catalogue.hpp"
#include "dataset/conventions.hpp"

namespace asperity {
namespace {

constexpr std::size_t longest_unit = 64;  // in a message

template <auto release>
struct Release {
  void operator()(auto* owned) const { release(owned); }
};
using Unit = std::unique_ptr<ut_unit, Release<ut_free>>;
using Converter = std::unique_ptr<cv_converter, Release<cv_free>>;

// Silences UDUNITS, which otherwise prints to standard error, and restores the former handler.
class Silence {
 public:
  Silence() : former_(ut_set_error_message_handler(ut_ignore)) {}
  ~Silence() { ut_set_error_message_handler(former_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  ut_error_message_handler former_;
};

// UDUNITS' parser has global state.
std::mutex library;

// UDUNITS' parsers end the program when memory runs out.
constexpr std::size_t room_for_database = 2 << 20, room_for_unit = 1 << 18;

// The database that UDUNITS2_XML_PATH names, else the one beside this library, else that of the installation.
ut_system* database() {
  const std::string own = std::getenv("UDUNITS2_XML_PATH") ? "" : beside_library("udunits/udunits2.xml");
  return ut_read_xml(own.empty() ? nullptr : own.c_str());
}

// Read once.
const ut_system* units() {
  static const std::unique_ptr<ut_system, Release<ut_free_system>> system(
      (require_memory(room_for_database), database()));
  if (!system)
    throw std::runtime_error("cannot read the units database of UDUNITS-2: check its installation");
  return system.get();
}

// Null for an unknown name. UDUNITS prints line ends in a name to standard output, and passes over a bracket
// that was not opened.
Unit known(const std::string& name) {
  const ut_system* const all = units();
  if (std::ranges::any_of(name, [](unsigned char c) { return c < 0x20; }) ||
      std::ranges::count(name, '(') != std::ranges::count(name, ')'))
    return nullptr;
  require_memory(room_for_unit);
  const std::size_t first = std::min(name.find_first_not_of(' '), name.size()),
                    end = name.find_last_not_of(' ') + 1;  // padding by programs with fixed widths
  return Unit(ut_parse(all, utf8_of(name.substr(first, end - first)).c_str(), UT_UTF8));
}

Unit parse(const std::string& name) {
  Unit unit = known(name);
  if (!unit) throw std::invalid_argument("'" + one_line(name, longest_unit) + "' is not a known unit");
  return unit;
}

// Null if the two measure different quantities, or inverse ones, for which UDUNITS has a converter.
Converter converter_of(const Unit& from, const Unit& to) {
  if (!from || !to) return nullptr;
  Converter out(ut_get_converter(from.get(), to.get()));
  return out && std::isfinite(cv_convert_double(out.get(), 0.0)) ? std::move(out) : nullptr;
}

// Whether both are known, and one is a multiple of the other; not so where their zeros or signs differ.
bool is_multiple(const std::string& unit, const std::string& of) {
  const std::lock_guard lock(library);
  const Silence silence;
  const Converter converter = converter_of(known(unit), known(of));
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0) return false;
  const double factor = cv_convert_double(converter.get(), 1.0);
  return factor > 0 && std::isfinite(factor);
}

}  // namespace

double unit_factor(const std::string& from, const std::string& to) {
  const std::lock_guard lock(library);
  const Silence silence;
  const Converter converter = converter_of(parse(from), parse(to));
  const std::string own = "'" + one_line(from, longest_unit) + "'";
  if (!converter) throw std::invalid_argument(own + " cannot be converted to '" + to + "'");
  if (cv_convert_double(converter.get(), 0.0) != 0)
    throw std::invalid_argument(own + " cannot be converted to '" + to + "': their zeros differ");
  return cv_convert_double(converter.get(), 1.0);
}

std::string unit_of(const Variable& variable) {
  const std::string unit = variable.attributes.text("units");
  return unit.empty() ? variable.attributes.text("unit") : unit;
}

std::string si_unit_of(const Variable& variable) {
  if (const auto needed = unit_needed(variable.name); !needed.empty()) return std::string(needed);
  const std::string own = unit_of(variable);
  for (const char* unit : {"m", "Pa"})
    if (is_multiple(own, unit)) return unit;
  return own.empty() ? "1" : own;
}

double factor_to(std::string_view unit, const Variable& variable) {
  const std::string own = unit_of(variable), needed(unit);
  if (own == needed || (own.empty() && needed == "1")) return 1;
  if (own.empty())
    throw DataError(variable.name, "has no unit: add the attribute units, " + needed + " or a multiple");
  try {
    const double factor = unit_factor(own, needed);
    if (factor > 0 && std::isfinite(factor)) return factor;
  } catch (const std::invalid_argument& e) {
    throw DataError(variable.name, std::string(e.what()) + ": correct its attribute units");
  }
  throw DataError(variable.name,
                  "'" + own + "' is not a multiple of '" + needed + "': correct its attribute units");
}

std::optional<std::vector<double>> lags_of(const Variable& axis) {
  const std::string unit = unit_of(axis);
  const bool samples = unit.empty() || unit == "1" || unit == "px";
  const double factor = samples ? 1 : factor_to("m", axis);
  std::vector<double> lags = present_numbers(axis);
  for (double& lag : lags) lag *= factor;
  if (!samples) return lags;
  for (std::size_t i = 1; i < lags.size(); ++i)
    if (!(std::abs(lags[i] - lags[i - 1] - 1) <= 1e-3))
      throw DataError(axis.name,
                      "lags without a unit must count samples in steps of 1: add the attribute units");
  return std::nullopt;
}

}  // namespace asperity
