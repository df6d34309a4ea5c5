#include "tools/cli/table.hpp"

#include <cmath>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "support.hpp"

using namespace asperity::cli;
using namespace asperity::test;

namespace {

const Table table{{{"lag", "m"}, {"acf", "1"}, {"word", ""}},
                  {{1e-6, 1.0 / 3.0, "a"}, {0.1 + 0.2, -0.5, "bc"}}};

}  // namespace

TEST_CASE("a number in a table reads back as the same double", "[table][exact]") {
  for (double x : {1.0 / 3.0, 0.1 + 0.2, 5e-324, 1.7976931348623157e308, -0.0})
    CHECK(std::strtod(shortest(x).c_str(), nullptr) == x);
}

TEST_CASE("a table in a pipe is one head line with units and tabs between", "[table][exact]") {
  CHECK(table.tsv() ==
        "# lag [m]\tacf [1]\tword\n1e-06\t0.3333333333333333\ta\n0.30000000000000004\t-0.5\tbc\n");
}

TEST_CASE("the columns of a table on a terminal stand one below the other", "[table][law]") {
  const std::string text = table.aligned();
  const auto end = text.find('\n');
  CHECK(text.substr(0, end).find("word") == text.substr(end + 1).find("a"));
}

TEST_CASE("a table as JSON keeps values, units and order", "[table][exact]") {
  const auto json = nlohmann::ordered_json::parse(table.json());
  CHECK(json["lag"]["unit"] == "m");
  CHECK(json["acf"]["values"][0].get<double>() == 1.0 / 3.0);
  CHECK(json.begin().key() == "lag");
}

TEST_CASE("what is not finite is null in JSON, for JSON has no word for it", "[table][contract]") {
  const asperity::Parameters q{{"Rq", std::nan(""), "m", std::nan(""), "rms height"}};
  const auto json = nlohmann::json::parse(json_of(q));
  CHECK(json["Rq"]["value"].is_null());
  CHECK_FALSE(json["Rq"].contains("standard_error"));
}
