// Headers of classic files that contradict themselves: what a name or a byte stands for must be one thing.
#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

template <class Number>
std::string big_endian(Number number) {
  std::string out;
  for (std::size_t byte = sizeof number; byte-- > 0;) out += static_cast<char>(number >> 8 * byte & 0xff);
  return out;
}

// The first of these bytes in others' place.
std::string with(std::string bytes, const std::string& from, const std::string& to) {
  const std::size_t at = bytes.find(from);
  REQUIRE(at != bytes.npos);
  return bytes.replace(at, from.size(), to);
}

// As the header writes it.
std::string name(const std::string& letters) { return big_endian(std::uint32_t{4}) + letters; }

// Two variables of four doubles each, on dimensions of two and four points.
Dataset two_variables() {
  Dataset out;
  out.dimensions = {{"dimA", 2}, {"dimB", 4}};
  for (const char* variable : {"varA", "varB"})
    out.variables.push_back({variable, {"dimB"}, std::vector<double>{1, 2, 3, 4}, {}});
  out.variables[0].attributes.set("attA", "m");
  out.variables[0].attributes.set("attB", "m");
  return out;
}

// Of two records, each of a double and a short of two variables.
Dataset before_records() {
  Dataset out;
  out.dimensions = {{"time", 0}};
  out.variables = {{"varA", {"time"}, std::vector<double>(), {}},
                   {"varB", {"time"}, std::vector<std::int16_t>(), {}}};
  return out;
}

std::string with_records(std::uint32_t told) {
  std::string out = encode_netcdf(before_records()).replace(4, 4, big_endian(told));
  for (const char record : {'\1', '\2'}) out += std::string(8, '\0') + record + std::string(3, '\0');
  return out;
}

}  // namespace

// A dimension found by its name had another length than that of the variable's number: the field was written
// beyond its memory, or read where nothing had been written.
TEST_CASE("a header with a name twice is refused", "[netcdf][contract]") {
  const std::string bytes = encode_netcdf(two_variables());
  REQUIRE_NOTHROW(decode_netcdf(bytes));
  for (const std::string kind : {"dim", "var", "att"}) {
    CAPTURE(kind);
    CHECK_THROWS_WITH(decode_netcdf(with(bytes, name(kind + "B"), name(kind + "A"))),
                      ContainsSubstring("'" + kind + "A' is twice in it"));
  }
  REQUIRE_NOTHROW(decode_netcdf(with(bytes, name("attB"), name("varA"))));  // names of different things
}

TEST_CASE("a variable that shares bytes with another or with the header is refused", "[netcdf][contract]") {
  const std::string bytes = encode_netcdf(two_variables());
  const std::uint64_t second = bytes.size() - 32, first = second - 32;
  const auto moved = [&](std::uint64_t to) {
    return decode_netcdf(with(bytes, big_endian(second), big_endian(to)));
  };
  REQUIRE_NOTHROW(moved(second));
  for (const std::uint64_t to : {first, first + 8, first + 24})
    CHECK_THROWS_WITH(moved(to), ContainsSubstring("varA and varB share bytes"));
  CHECK_THROWS_WITH(moved(first - 4), ContainsSubstring("the header and varB share bytes"));
  for (const std::uint64_t to : {second + 1, bytes.size(), std::uint64_t{0} - 8})
    CHECK_THROWS_WITH(moved(to), ContainsSubstring("varB ends beyond"));
}

TEST_CASE("records that share bytes are refused", "[netcdf][contract]") {
  const std::string bytes = with_records(2) + std::string(12, '\0');  // behind the end
  const std::uint64_t first = bytes.size() - 36;
  REQUIRE(numbers(decode_netcdf(bytes).at("varB").values) == std::vector<double>{256, 512});
  for (const std::uint64_t to : {first, first + 6, first + 12})
    CHECK_THROWS_WITH(decode_netcdf(with(bytes, big_endian(first + 8), big_endian(to))),
                      ContainsSubstring("share bytes"));
}

TEST_CASE("a number of records below 0, or of more than the file has bytes, is refused",
          "[netcdf][contract]") {
  for (const std::uint32_t told : {3u, 0x7fffffffu, 0xfffffffeu})
    CHECK_THROWS_AS(decode_netcdf(with_records(told)), DataError);
  for (Dataset wide :
       {before_records(), two_variables()}) {  // the second without a variable that has records
    wide.attributes.set_values("of CDF-5", std::vector<std::int64_t>{1});
    const std::string bytes = encode_netcdf(wide);
    REQUIRE(bytes.starts_with("CDF\005"));
    REQUIRE_NOTHROW(decode_netcdf(bytes));
    for (const std::uint64_t told : {~std::uint64_t{1}, std::uint64_t{1} << 63})
      CHECK_THROWS_AS(decode_netcdf(std::string(bytes).replace(4, 8, big_endian(told))), DataError);
  }
}

// A file before its first record was refused as cut short, if a record was to be longer than the file.
TEST_CASE("a variable without records needs no bytes, however long a record is", "[netcdf][contract]") {
  Dataset data = two_variables();
  data.dimensions.insert(data.dimensions.end(), {{"time", 0}, {"y", Index{1} << 62}, {"x", Index{1} << 62}});
  data.variables.push_back({"late", {"time", "y", "x"}, std::vector<double>(), {}});
  data.variables.push_back({"x", {"time"}, std::vector<double>(), {}});
  const Dataset read = decode_netcdf(encode_netcdf(data));
  CHECK(count(read.at("late").values) == 0);
  CHECK(numbers(read.at("varB").values) == std::vector<double>{1, 2, 3, 4});
}

// It would be written as a header that no reader takes.
TEST_CASE("a variable without values along another dimension than its first is not written",
          "[netcdf][contract]") {
  Dataset data;
  data.dimensions = {{"a", 3}, {"time", 0}};
  data.variables = {{"empty", {"a", "time"}, std::vector<double>(), {}}};
  CHECK_THROWS_WITH(encode_netcdf(data), ContainsSubstring("empty has no values along time"));
}

// Its points were counted by the dimension of its name: a spacing of two points spread over four.
TEST_CASE("an axis that is not on its own dimension is refused", "[netcdf][contract]") {
  Dataset data;
  set_grid(data, {{4, 4}, 1e-6, 1e-6});
  REQUIRE(grid_of(data).dx == Approx(1e-6));
  data.dimensions.push_back({"n", 2});
  data.find("x")->dimensions = {"n"};
  data.find("x")->values = std::vector<double>{0, 1e-6};
  CHECK_THROWS_WITH(grid_of(data), ContainsSubstring("must be on the dimension x alone"));
  data.find("x")->dimensions = {};
  data.find("x")->values = std::vector<double>{1e-6};
  CHECK_THROWS_AS(grid_of(data), DataError);
}
