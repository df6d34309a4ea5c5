#include "dataset/netcdf.hpp"

#include <filesystem>
#include <fstream>
#include <limits>
#include <pthread.h>

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;

namespace {

template <class T>
std::vector<T> extremes() {
  return {std::numeric_limits<T>::lowest(), T{0}, std::numeric_limits<T>::max()};
}

// Every type that a classic file can hold, `wide` those of CDF-5 too.
Dataset of_every_type(bool wide) {
  Dataset out;
  out.dimensions = {{"n", 3}, {"letters", 5}};
  auto add = [&](std::string name, Values values) {
    out.variables.push_back({std::move(name), {"n"}, std::move(values), {}});
    out.variables.back().attributes.set_values("same", out.variables.back().values);
  };
  add("int8", extremes<std::int8_t>());
  add("int16", extremes<std::int16_t>());
  add("int32", extremes<std::int32_t>());
  add("float32", extremes<float>());
  add("float64", extremes<double>());
  if (wide) {
    add("uint8", extremes<std::uint8_t>());
    add("uint16", extremes<std::uint16_t>());
    add("uint32", extremes<std::uint32_t>());
    add("int64", extremes<std::int64_t>());
    add("uint64", extremes<std::uint64_t>());
  }
  out.variables.push_back({"words", {"letters"}, std::string("rough"), {}});
  out.variables.push_back({"scalar", {}, std::vector<double>{1.5}, {}});
  out.attributes.set("text", "µ and more");
  return out;
}

bool same(const Attributes& a, const Attributes& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Attribute& x, const Attribute& y) {
    return x.name == y.name && x.values == y.values;
  });
}

bool same(const Dataset& a, const Dataset& b) {
  auto equal = [](const Variable& x, const Variable& y) {
    return x.name == y.name && x.dimensions == y.dimensions && x.values == y.values &&
           same(x.attributes, y.attributes);
  };
  return a.dimensions.size() == b.dimensions.size() && same(a.attributes, b.attributes) &&
         std::equal(a.variables.begin(), a.variables.end(), b.variables.begin(), b.variables.end(), equal);
}

std::string corpus(const std::string& name) { return ASPERITY_TEST_DATA "/../corpus/" + name; }

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a dataset of every classic type comes back from its bytes as it was, as CDF-2",
          "[netcdf][exact]") {
  const std::string bytes = encode_netcdf(of_every_type(false));
  CHECK(bytes.starts_with("CDF\002"));
  CHECK(same(decode_netcdf(bytes), of_every_type(false)));
}

TEST_CASE("types that CDF-2 lacks come back from CDF-5", "[netcdf][exact]") {
  const std::string bytes = encode_netcdf(of_every_type(true));
  CHECK(bytes.starts_with("CDF\005"));
  CHECK(same(decode_netcdf(bytes), of_every_type(true)));
}

TEST_CASE("encoding what was decoded gives the same bytes", "[netcdf][law]") {
  const std::string bytes = encode_netcdf(of_every_type(false));
  CHECK(encode_netcdf(decode_netcdf(bytes)) == bytes);
}

namespace {

// Heights and noise at the end, after variables whose bytes are no multiple of eight.
Dataset with_large_variables(Index nx, Index ny, bool wide) {
  Dataset out = of_every_type(wide);
  out.dimensions.push_back({"x", nx});
  out.dimensions.push_back({"y", ny});
  for (const char* name : {"heights", "noise"}) {
    out.variables.push_back({name, {"x", "y"}, std::vector<double>(), {}});
    out.variables.back().attributes.set_values("actual_range", Values(std::vector<double>{-1, 1}));
  }
  return out;
}

}  // namespace

TEST_CASE("a head and the values behind it are the bytes of the whole", "[netcdf][exact]") {
  for (bool wide : {false, true})
    for (std::size_t deferred : {1u, 2u}) {
      Dataset whole = with_large_variables(5, 3, wide);
      for (std::size_t v = 0; v < 2; ++v) {
        std::vector<double> values(15);
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] = 1 / (1.0 + static_cast<double>(i + 100 * v));
        (whole.variables.end() - 1 - static_cast<std::ptrdiff_t>(v))->values = values;
      }
      Dataset head = whole;
      std::string values;
      for (auto v = head.variables.end() - static_cast<std::ptrdiff_t>(deferred); v != head.variables.end();
           ++v) {
        values += encode_values(std::get<std::vector<double>>(v->values));
        v->values = std::vector<double>();
      }
      CAPTURE(wide, deferred);
      CHECK(encode_netcdf(head, deferred) + values == encode_netcdf(whole));
    }
}

// The bytes that fill a variable up to a multiple of four used to be whatever the memory held before.
TEST_CASE("the bytes between variables are zero", "[netcdf][contract]") {
  Dataset data;
  data.dimensions = {{"n", 1}};
  data.variables.push_back({"a", {"n"}, std::vector<std::int8_t>{-1}, {}});
  data.variables.push_back({"b", {"n"}, std::vector<std::int8_t>{-1}, {}});
  for (int i = 0; i < 20; ++i) {
    std::vector<std::string> dirty(100, std::string(8192 + 100 * static_cast<std::size_t>(i), '\x7f'));
    dirty.clear();
    CHECK(encode_netcdf(data).ends_with(std::string("\xff\0\0\0\xff\0\0\0", 8)));
  }
}

TEST_CASE("a head with other numbers in its attributes has the same length", "[netcdf][contract]") {
  Dataset data = with_large_variables(5, 3, false);
  const std::string before = encode_netcdf(data, 2);
  data.find("heights")->attributes.set_values("actual_range",
                                              Values(std::vector<double>{-1e-300, 12345.678}));
  CHECK(encode_netcdf(data, 2).size() == before.size());
  CHECK(encode_netcdf(data, 2) != before);
}

// 16 GiB a variable. CDF-2 holds one such, as the last.
TEST_CASE(
    "a head of what no memory holds is as short as any, CDF-2 with one large variable and CDF-5 with two",
    "[netcdf][contract]") {
  Dataset data = with_large_variables(1 << 16, 1 << 15, false);
  const std::string two = encode_netcdf(data, 2);
  CHECK(two.starts_with("CDF\005"));
  CHECK(two.size() < 4000);
  data.variables.pop_back();
  const std::string one = encode_netcdf(data, 1);
  CHECK(one.starts_with("CDF\002"));
  CHECK(one.size() < 4000);
}

// The last variable is a double, so that there is no padding behind it: every shorter file misses data.
TEST_CASE("a dataset cut short anywhere is refused", "[netcdf][contract]") {
  const std::string bytes = encode_netcdf(of_every_type(false));
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    CAPTURE(n, bytes.size());
    CHECK_THROWS_AS(decode_netcdf(bytes.substr(0, n)), DataError);
  }
}

TEST_CASE("a header that claims more values than the file has bytes is refused before they are allocated",
          "[netcdf][contract]") {
  Dataset small;
  small.dimensions = {{"n", 7}};
  small.variables.push_back({"v", {"n"}, std::vector<double>(7), {}});
  std::string bytes = encode_netcdf(small);
  const auto length = bytes.find(std::string("n\0\0\0\0\0\0\7", 8)) + 4;
  REQUIRE(length < bytes.size());
  bytes[length] = '\x7f';
  CHECK_THROWS_AS(decode_netcdf(bytes), DataError);
}

// Of a head that ended within one of the library's pieces of up to 8 KiB it said that the file was cut short.
TEST_CASE("small datasets are read whatever the length of their heads", "[netcdf][contract]") {
  Dataset small;
  small.dimensions = {{"n", 7}};
  small.variables.push_back({"v", {"n"}, std::vector<double>(7, 0.5), {}});
  for (std::size_t length = 1; length < 20000; length += 61) {
    CAPTURE(length);
    small.attributes.set("note", std::string(length, 'a'));
    CHECK(numbers(decode_netcdf(encode_netcdf(small)).at("v").values) == std::vector<double>(7, 0.5));
  }
}

// The library copies a name of any length into its caller's 257 bytes.
TEST_CASE("a name of more than 256 bytes is refused", "[netcdf][contract]") {
  const std::string name(256, 'x');
  Dataset small;
  small.dimensions = {{name, 7}};
  small.variables.push_back({"v", {name}, std::vector<double>(7), {}});
  std::string bytes = encode_netcdf(small);
  CHECK(decode_netcdf(bytes).length(name) == 7);
  const auto at = bytes.find(name);
  bytes.insert(at, 4, 'x')[at - 1] = 4;  // its length is the big-endian word before it
  CHECK_THROWS_WITH(decode_netcdf(bytes), ContainsSubstring("a name of 260 bytes"));
}

// The library asks for the memory that a count claims before it looks: an attribute of 2^62 numbers ended a
// run under the address sanitizer. Counts are 4 or 8 bytes, and stand at multiples of 4.
TEST_CASE("a head of whose words one is replaced is refused, or holds no more values than there are bytes",
          "[netcdf][contract]") {
  for (const bool wide : {false, true}) {
    const std::string bytes = encode_netcdf(of_every_type(wide));
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4)
      for (const char* word : {"\x7f\xff\xff\xff", "\xff\xff\xff\xff", "\x40\0\0\0", "\0\0\0\x0c"}) {
        CAPTURE(wide, at);
        try {
          std::size_t values = 0;
          for (const Variable& v : decode_netcdf(std::string(bytes).replace(at, 4, word, 4)).variables)
            values += count(v.values);
          CHECK(values <= bytes.size());
        } catch (const DataError&) {
          SUCCEED();
        }
      }
  }
}

TEST_CASE("a file on disk whose head claims more than it holds is refused", "[netcdf][contract]") {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("asperity-head-" + std::to_string(std::random_device()()));
  const std::string bytes = encode_netcdf(of_every_type(false));
  const auto refused = [&](const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
    try {
      open_netcdf(path.string());
      return false;
    } catch (const DataError&) {
      return true;
    }
  };
  CHECK(!refused(bytes));
  // The number of dimensions stands behind the magic, the number of records and the list's tag.
  CHECK(refused(std::string(bytes).replace(12, 4, "\x7f\xff\xff\xff")));
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    CAPTURE(n);
    CHECK(refused(bytes.substr(0, n)));
  }
  std::filesystem::remove(path);
}

TEST_CASE("a NetCDF-4 file holds what the classic one does that it was made from", "[netcdf][exact]") {
  const Dataset classic = decode_netcdf(content(corpus("netcdf/cdf2")));
  CHECK(same(decode_netcdf(content(corpus("netcdf4/whole"))), classic));
}

TEST_CASE("a NetCDF-4 file without its values is refused", "[netcdf][contract]") {
  CHECK_THROWS_AS(decode_netcdf(content(corpus("netcdf4/never-written"))), DataError);
}

// The library once forked to read NetCDF-4, and set how the end of children is heard meanwhile: of whatever
// program used it.
TEST_CASE("the library starts no process to read NetCDF-4", "[netcdf][contract]") {
  static int forks = 0;
  REQUIRE(::pthread_atfork([] { ++forks; }, nullptr, nullptr) == 0);
  decode_netcdf(content(corpus("netcdf4/whole")));
  open_netcdf(corpus("netcdf4/whole"));
  CHECK(forks == 0);
}

TEST_CASE("bytes that are no NetCDF are refused", "[netcdf][contract]") {
  for (const char* text : {"", "CDF", "hello, surface", "\x89HDF\r\n\x1a\n"})
    CHECK_THROWS_AS(decode_netcdf(text), DataError);
}
