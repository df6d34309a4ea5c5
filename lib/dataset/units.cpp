#include "dataset/units.hpp"

#include <memory>
#include <mutex>
#include <stdexcept>

#include <udunits2.h>

#include "grid/room.hpp"

namespace asperity {
namespace {

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

Unit parse(const std::string& name) {
  const ut_system* const known = units();
  require_room(room_for_unit);
  Unit unit(ut_parse(known, name.c_str(), UT_UTF8));
  if (!unit) throw std::invalid_argument("'" + name + "' is no known unit");
  return unit;
}

struct FreeConverter {
  void operator()(cv_converter* c) const { cv_free(c); }
};

}  // namespace

double unit_factor(const std::string& from, const std::string& to) {
  const std::lock_guard lock(library);
  const Silence silence;
  const Unit source = parse(from), target = parse(to);
  const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(source.get(), target.get()));
  if (!converter) throw std::invalid_argument("'" + from + "' does not measure what '" + to + "' measures");
  return cv_convert_double(converter.get(), 1.0) - cv_convert_double(converter.get(), 0.0);
}

}  // namespace asperity
