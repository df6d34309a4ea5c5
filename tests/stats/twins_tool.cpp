// asperity-stats --errors.
#include <nlohmann/json.hpp>

#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;
using Json = nlohmann::json;

namespace {

void draw() {
  static const bool drawn =
      shell(
          "asperity-generate -q --add kernel --shape 64x48 --size 1mm,0.5mm --rq 0.4um --length "
          "40um,30um --seed 1 -o t.nc")
          .exit == 0;
  REQUIRE(drawn);
}

Json stats(const std::string& options) {
  return Json::parse(require("asperity-stats -q --json " + options).out);
}

}  // namespace

TEST_CASE("errors are those of theory, of twins, of whichever holds, or none",
          "[stats-tool][twins][contract]") {
  draw();
  const Json theory = stats("--errors theory t.nc"), twins = stats("--errors twins t.nc"),
             own = stats("t.nc"), none = stats("--errors none t.nc");
  for (const char* name : {"Sa", "Sq", "Ssk"}) {
    CAPTURE(name);
    CHECK(own[name] == theory[name]);
    CHECK(twins[name]["value"] == theory[name]["value"]);
    CHECK(twins[name]["note"] == "error from 60 twins");
    CHECK_FALSE(none[name].contains("standard_error"));
  }
  for (const char* name : {"Sp", "Sv", "Sz"}) {
    CAPTURE(name);
    CHECK_FALSE(theory[name].contains("standard_error"));
    CHECK(own[name] == twins[name]);
    CHECK(own[name]["interval_95"].size() == 2);
  }
  CHECK_FALSE(twins["N"].contains("standard_error"));
  CHECK(stats("--errors twins --threads 1 t.nc") == stats("--errors twins --threads 3 t.nc"));
  const std::string above = "t.nc --remove-form plane";
  CHECK(stats(above)["Sq"] == stats(above + " --errors theory")["Sq"]);
}

TEST_CASE("several surfaces have the errors of their spread, and no twins unless asked for",
          "[stats-tool][twins][contract]") {
  draw();
  require("asperity-generate -q --seed 2 < t.nc > u.nc");
  const Json plain = stats("t.nc u.nc"), asked = stats("t.nc u.nc --errors twins");
  CHECK(plain == stats("t.nc u.nc --errors theory"));
  const std::string text = asked.dump();
  CHECK(text != plain.dump());
}

TEST_CASE("what is too large for quick twins says which option has them", "[stats-tool][twins][contract]") {
  require("asperity-generate -q --shape 400x400 --size 1mm --rq 0.4um --length 20um --seed 1 -o large.nc");
  const Outcome all = shell("asperity-stats large.nc --parameters all");
  CHECK(all.exit == 0);
  CHECK_THAT(all.error, ContainsSubstring("--errors twins"));
  CHECK_FALSE(Json::parse(require("asperity-stats -q --json --parameters all large.nc").out)["Sz"].contains(
      "standard_error"));
}

// The slope from seven points does not fit into five. With the errors, the reason was left out.
TEST_CASE("asperity-stats without errors still says why a value is missing", "[stats-tool][contract]") {
  const std::string narrow = "asperity-generate --shape 5x64 --size 0.1mm,1mm --rq 0.4um --length 4px | ";
  for (const char* errors : {"none", "auto"}) {
    const std::string table = require(narrow + "asperity-stats --profile x --errors " + errors).out;
    CHECK_THAT(table, ContainsSubstring("no value: no profile has this parameter"));
  }
}
