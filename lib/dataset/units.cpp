#include "dataset/units.hpp"

#include <memory>
#include <stdexcept>

#include <udunits2.h>

namespace asperity {
namespace {

struct FreeUnit {
  void operator()(ut_unit* u) const { ut_free(u); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

// The database of units, read once. UDUNITS speaks on stderr unless told not to.
const ut_system* units() {
  static const std::unique_ptr<ut_system, decltype(&ut_free_system)> system = [] {
    ut_set_error_message_handler(ut_ignore);
    return std::unique_ptr<ut_system, decltype(&ut_free_system)>(ut_read_xml(nullptr), &ut_free_system);
  }();
  if (!system) throw std::runtime_error("the units database of UDUNITS-2 cannot be read");
  return system.get();
}

Unit parse(const std::string& name) {
  Unit unit(ut_parse(units(), name.c_str(), UT_UTF8));
  if (!unit) throw std::invalid_argument("'" + name + "' is no known unit");
  return unit;
}

struct FreeConverter {
  void operator()(cv_converter* c) const { cv_free(c); }
};

}  // namespace

double unit_factor(const std::string& from, const std::string& to) {
  const Unit source = parse(from), target = parse(to);
  const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(source.get(), target.get()));
  if (!converter) throw std::invalid_argument("'" + from + "' does not measure what '" + to + "' measures");
  return cv_convert_double(converter.get(), 1.0) - cv_convert_double(converter.get(), 0.0);
}

}  // namespace asperity
