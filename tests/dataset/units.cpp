#include "dataset/units.hpp"

#include <stdexcept>

#include <udunits2.h>

#include "support.hpp"

using namespace asperity;

namespace {

int said = 0;

int count_message(const char*, va_list) { return ++said; }

}  // namespace

// The library once silenced UDUNITS for good, whoever else used it in the process.
TEST_CASE("a unit is understood or refused without a word, and UDUNITS' message handler stays the program's",
          "[units][contract]") {
  const ut_error_message_handler former = ut_set_error_message_handler(&count_message);
  CHECK(unit_factor("nm", "m") == 1e-9);
  for (const char* unit : {"word", "s", "1e999 m", "m^^2", "", "V\nV", "\n", "m\n"})
    CHECK_THROWS_AS(unit_factor(unit, "m"), std::invalid_argument);
  CHECK(said == 0);
  CHECK(ut_set_error_message_handler(former) == &count_message);
}
