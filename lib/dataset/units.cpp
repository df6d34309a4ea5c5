#include "dataset/units.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include <udunits2.h>

#include "core/room.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

constexpr std::size_t longest_unit = 64;  // in a message

struct FreeUnit {
  void operator()(ut_unit* u) const { ut_free(u); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

// UDUNITS speaks on standard error unless told not to; whoever else uses it in this process finds it as it was.
class Silence {
 public:
  Silence() : former_(ut_set_error_message_handler(ut_ignore)) {}
  ~Silence() { ut_set_error_message_handler(former_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  ut_error_message_handler former_;
};

// UDUNITS' parser keeps global state.
std::mutex library;

// For want of memory UDUNITS' parsers end the program.
constexpr std::size_t room_for_database = 2 << 20, room_for_unit = 1 << 18;

// The database of units, read once.
const ut_system* units() {
  static const std::unique_ptr<ut_system, decltype(&ut_free_system)> system(
      (require_room(room_for_database), ut_read_xml(nullptr)), &ut_free_system);
  if (!system) throw std::runtime_error("the units database of UDUNITS-2 cannot be read");
  return system.get();
}

// None of a name that it does not know. UDUNITS prints the line ends in a name on standard output.
Unit known(const std::string& name) {
  const ut_system* const all = units();
  if (std::ranges::any_of(name, [](unsigned char c) { return c < 0x20; })) return nullptr;
  require_room(room_for_unit);
  const std::size_t first = std::min(name.find_first_not_of(' '), name.size()),
                    behind = name.find_last_not_of(' ') + 1;  // of writers of fixed widths
  return Unit(ut_parse(all, utf8_of(name.substr(first, behind - first)).c_str(), UT_UTF8));
}

Unit parse(const std::string& name) {
  Unit unit = known(name);
  if (!unit) throw std::invalid_argument("'" + one_line(name, longest_unit) + "' is no known unit");
  return unit;
}

struct FreeConverter {
  void operator()(cv_converter* c) const { cv_free(c); }
};
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

// None where the two measure different things, or one the inverse of the other, for which UDUNITS has a converter.
Converter converter_of(const Unit& from, const Unit& to) {
  if (!from || !to) return nullptr;
  Converter out(ut_get_converter(from.get(), to.get()));
  return out && std::isfinite(cv_convert_double(out.get(), 0.0)) ? std::move(out) : nullptr;
}

}  // namespace

double unit_factor(const std::string& from, const std::string& to) {
  const std::lock_guard lock(library);
  const Silence silence;
  const Converter converter = converter_of(parse(from), parse(to));
  const std::string own = "'" + one_line(from, longest_unit) + "'";
  if (!converter) throw std::invalid_argument(own + " does not measure what '" + to + "' measures");
  if (cv_convert_double(converter.get(), 0.0) != 0)
    throw std::invalid_argument(own + " counts from another zero than '" + to +
                                "': no factor makes one the other");
  return cv_convert_double(converter.get(), 1.0);
}

bool measures(const std::string& unit, const std::string& other) {
  const std::lock_guard lock(library);
  const Silence silence;
  return converter_of(known(unit), known(other)) != nullptr;
}

}  // namespace asperity
