// Absurd arguments: what leaves the range of doubles is refused by its name, and nothing is written.
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "support.hpp"
#include "tools/cli/table.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string generate =
    "asperity-generate --shape 16x12 --size 1mm --rq 0.4um --length 3px --seed 7 --no-history -q ";

std::string refusal_of(const cli::Table& table) {
  try {
    cli::check_finite(table);
    return "";
  } catch (const DataError& error) {
    return error.name;
  }
}

}  // namespace

TEST_CASE("a result beyond the range of doubles is bad data by its name, and nothing is written",
          "[finite][contract]") {
  const std::string bodies = " --radius 50mm --young 208GPa --poisson 0.3 ";
  REQUIRE(shell(generate + "-o s.nc; asperity-contact s.nc" + bodies + "--load 1N -q -o p.nc").exit == 0);
  for (const auto& [run, name] :
       {std::pair("asperity-contact --smooth --shape 24x20 --size 1mm --radius 1e-300m --young 208GPa "
                  "--poisson 0.3 --load 20N",
                  "contact_hertz_"),
        std::pair("asperity-stress p.nc --depths 0:0.1mm:6 --above 1e308p0", "stress_above"),
        std::pair("asperity-stress p.nc --depths 0:0.1mm:6 --friction 1e300", "")}) {
    for (const std::string to : {" -o absurd.nc", " | cat"}) {
      const Outcome out = shell(run + to);
      CAPTURE(run, to, out.error);
      CHECK((out.exit == 4 || (std::string(name).empty() && out.exit == 2)));
      CHECK(out.error.find(name) != std::string::npos);
      CHECK(out.out.empty());
      CHECK_FALSE(std::filesystem::exists(scratch("absurd.nc")));
    }
  }
}

TEST_CASE("what is infinite or unknown by design is written", "[finite][contract]") {
  const std::string flat =
      "asperity-contact s.nc --radius inf --young inf,208GPa --poisson 0.3 --load 1N -q -o flat.nc";
  REQUIRE(shell(generate + "-o s.nc; " + flat).exit == 0);
  const Attributes& a = read_dataset("flat.nc").attributes;
  CHECK(std::isinf(a.number("contact_limit_pressure", 0)));
  CHECK(std::isinf(a.number("contact_radius_x", 0)));
  CHECK(std::isinf(a.number("contact_young", 0)));
}

TEST_CASE("a column of a table holds no other numbers than it says", "[finite][contract]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinite = std::numeric_limits<double>::infinity();
  auto table = [](double value, double error, double end) {
    return cli::Table{{{"value", "m"}, {"error", "m", cli::Holds::unknown}, {"end", "m", cli::Holds::open}},
                      {{1.0, 1.0, 1.0}, {value, error, end}}};
  };
  CHECK(refusal_of(table(1, nan, -infinite)).empty());
  CHECK(refusal_of(table(nan, 1, 1)) == "value");
  CHECK(refusal_of(table(infinite, 1, 1)) == "value");
  CHECK(refusal_of(table(1, -infinite, 1)) == "error");
}
