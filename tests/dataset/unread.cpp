// Values that are left in the file until they are needed.
#include "dataset/unread.hpp"

#include <filesystem>
#include <fstream>
#include <random>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Larger than the pieces in which values are read, and no multiple of them.
constexpr Index rows = 301, columns = 217;

Dataset surface() {
  Dataset out;
  set_grid(out, {{rows, columns}, 1e-6, 2e-6});
  set_field(out, "heights", random_field({rows, columns}, 3), {"m", "height"});
  set_table(out, "kernel", random_field({5, 7}, 4), {"k"}, {"l"}, {"m", "kernel"});
  std::vector<std::int8_t> mask(static_cast<std::size_t>(rows * columns));
  mask[17] = 1;
  out.put({"mask", {"x", "y"}, mask, {}});
  return out;
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes) { put(bytes); }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  void put(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
  std::string path() const { return path_; }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("asperity-unread-" + std::to_string(std::random_device()()));
};

Bytes kept(const std::string& text) {
  Bytes out;
  text.copy(out.room(text.size()), text.size());
  out.add(text.size());
  return out;
}

std::string word(std::uint32_t number) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 0xff);
  return out;
}
std::string name(std::string text) {
  const auto length = static_cast<std::uint32_t>(text.size());
  text.resize((text.size() + 3) / 4 * 4);
  return word(length) + text;
}

// By the format's grammar: CDF-1 with `told` records of three shorts a and of two bytes b, each padded to
// four bytes. The places of the values follow from the length of the header.
std::string with_records(std::uint32_t told) {
  const auto variable = [&](const char* of, std::uint32_t dimension, std::uint32_t type,
                            std::uint32_t begin) {
    return name(of) + word(2) + word(0) + word(dimension) + word(0) + word(0) + word(type) + word(0) +
           word(begin);
  };
  const auto head = [&](std::uint32_t end) {
    return "CDF\1" + word(told) + word(10) + word(3) + name("t") + word(0) + name("three") + word(3) +
           name("two") + word(2) + word(0) + word(0) + word(11) + word(2) + variable("a", 1, 3, end) +
           variable("b", 2, 1, end + 8);
  };
  std::string out = head(static_cast<std::uint32_t>(head(0).size()));
  for (char r = 0; r < 2; ++r) {
    for (char k = 0; k < 3; ++k) out += {1, static_cast<char>(10 * r + k)};
    out += std::string(2, '\0') + std::string{static_cast<char>(20 + r), static_cast<char>(30 + r), 0, 0};
  }
  return out;
}

}  // namespace

TEST_CASE("a file is read alike at once, when needed, from disk and from memory", "[unread][exact]") {
  const std::string bytes = encode_netcdf(surface());
  const TemporaryFile file(bytes);
  const Dataset whole = decode_netcdf(bytes), on_disk = open_netcdf(file.path()),
                in_memory = open_netcdf(kept(bytes));
  for (const Dataset* lazy : {&on_disk, &in_memory}) {
    for (const char* field : {"heights", "kernel", "mask"}) {
      const Variable& v = lazy->at(field);
      REQUIRE(v.unread);
      CHECK(count(v.values) == 0);
      CHECK(count(v) == count(whole.at(field)));
      CHECK(values_of(v, 0, count(v)) == whole.at(field).values);
    }
    CHECK(!lazy->at("x").unread);
    const Field a = field_of(*lazy, "heights", Missing::not_a_number),
                b = field_of(whole, "heights", Missing::not_a_number);
    CHECK(a.isNaN().count() == 1);
    CHECK((a == b).count() == rows * columns - 1);
    CHECK((table_of(*lazy, "kernel") == table_of(whole, "kernel")).all());
    CHECK(lazy->size_in_memory() == whole.size_in_memory());
  }
}

TEST_CASE("what nobody has read is written as it was", "[unread][exact]") {
  const std::string bytes = encode_netcdf(surface());
  const TemporaryFile file(bytes);
  const Dataset data = open_netcdf(file.path());
  std::filesystem::remove(file.path());  // as where the output takes the input's place
  CHECK(encode_netcdf(data) == bytes);
  Dataset loaded = data;
  load(loaded);
  CHECK(encode_netcdf(loaded) == bytes);
}

TEST_CASE("a file that becomes shorter while it is read is refused", "[unread][contract]") {
  const std::string bytes = encode_netcdf(surface());
  const TemporaryFile file(bytes);
  const Dataset data = open_netcdf(file.path());
  file.put(bytes.substr(0, bytes.size() / 2));
  CHECK_THROWS_WITH(field_of(data, "heights", Missing::not_a_number), ContainsSubstring("cut short"));
  CHECK_THROWS_AS(encode_netcdf(data), DataError);
}

// The order of viewers, descending coordinates and packed values are changed on reading, so that values are
// read at once.
TEST_CASE("values that reading changes are alike, left in the file or not", "[unread][exact]") {
  Dataset data = surface();
  std::ranges::reverse(std::get<std::vector<double>>(data.find("x")->values));
  data.find("heights")->attributes.set("scale_factor", 0.5);
  const std::string bytes = encode_netcdf(data);
  const TemporaryFile file(bytes);
  Dataset lazy = open_netcdf(file.path());
  load(lazy);
  CHECK(encode_netcdf(lazy) == encode_netcdf(decode_netcdf(bytes)));
}

TEST_CASE("records lie one behind the other, each with all its variables", "[unread][exact]") {
  for (const std::uint32_t told : {2u, 0xffffffffu}) {  // the number of records, or a stream's
    const std::string bytes = with_records(told);
    CAPTURE(told);
    const TemporaryFile file(bytes);
    for (const Dataset& data : {decode_netcdf(bytes), open_netcdf(file.path())}) {
      CHECK(data.length("t") == 2);
      const Variable &a = data.at("a"), &b = data.at("b");
      CHECK(numbers(values_of(a, 0, 6)) == std::vector<double>{256, 257, 258, 266, 267, 268});
      CHECK(numbers(values_of(a, 2, 2)) == std::vector<double>{258, 266});
      CHECK(numbers(values_of(b, 0, 4)) == std::vector<double>{20, 30, 21, 31});
    }
    CHECK_THROWS_AS(decode_netcdf(with_records(3)), DataError);
  }
}
