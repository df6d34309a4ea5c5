#include <zlib.h>

#include "core/error.hpp"
#include "formats/raster.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

template <class T>
void put(std::string& bytes, std::size_t place, T number) {
  const auto raw = bytes_of(number, std::endian::little);
  bytes.replace(place, raw.size(), raw.data(), raw.size());
}

template <class T>
std::string numbers(const std::vector<int>& values) {
  std::string out;
  for (const int value : values) {
    const auto raw = bytes_of(static_cast<T>(value), std::endian::little);
    out.append(raw.data(), raw.size());
  }
  return out;
}

// A head of 2 × 3 points of 32 bits, 0.5 mm × 0.25 mm, in steps of 0.5 µm from 10 µm, as long comments as said.
std::string head(int type = 2, int bits = 32) {
  std::string out = "DIGITAL SURF" + std::string(500, '\0');
  put(out, 14, std::int16_t{1});
  put(out, 18, static_cast<std::int16_t>(type));
  out.replace(20, 30, "rough" + std::string(25, ' '));
  put(out, 98, static_cast<std::int16_t>(bits));
  put(out, 108, 2);
  put(out, 112, 3);
  put(out, 120, 0.5f);
  put(out, 124, 0.25f);
  put(out, 128, 0.5f);
  for (const std::size_t place : {180, 196}) out.replace(place, 2, "mm");
  for (const std::size_t place : {212, 260}) out.replace(place, 2, "\xb5m");
  put(out, 474, 10.f);
  return out;
}

std::string with(std::string bytes, std::size_t place, auto number) {
  put(bytes, place, number);
  return bytes;
}

std::string zlib_of(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  REQUIRE(compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                   bytes.size()) == Z_OK);
  return out.substr(0, size);
}

// In pieces of their own, all as large as the first.
std::string deflated(const std::vector<std::string>& pieces) {
  std::string sizes = numbers<std::int32_t>({static_cast<int>(pieces.size())}), out;
  for (const std::string& piece : pieces) {
    const std::string small = zlib_of(piece);
    sizes += numbers<std::int32_t>({static_cast<int>(piece.size()), static_cast<int>(small.size())});
    out += small;
  }
  return sizes + out;
}

std::string compressed(std::string bytes) { return bytes.replace(0, 12, "DSCOMPRESSED"); }

Map read(const std::string& bytes, const std::string& channel = "") {
  Reading reading;
  reading.channel = channel;
  return format::sur.decode(bytes, reading);
}

const std::vector<int> six{0, 1, 2, 3, -4, 20};

}  // namespace

// Height 10 µm + n 0.5 µm: Mountains writes a profile and the surface that it is of with other heights of zero.
TEST_CASE("a SUR is read with its size, its heights above zero, and its name, line by line",
          "[formats][exact]") {
  const std::string commented = with(with(head(), 334, std::int16_t{3}), 336, std::int16_t{2}) + "abcde";
  for (const std::string& bytes :
       {head() + numbers<std::int32_t>(six), head(2, 16) + numbers<std::int16_t>(six),
        commented + numbers<std::int32_t>(six), compressed(head()) + deflated({numbers<std::int32_t>(six)}),
        compressed(head(2, 16)) +
            deflated({numbers<std::int16_t>({0, 1}), numbers<std::int16_t>({2, 3, -4, 20})})}) {
    const Map map = read(bytes);
    REQUIRE(shape_of(map.values) == Shape{2, 3});
    CHECK(relative_error(map.values(0, 0), 10e-6) <= 2 * epsilon);
    CHECK(relative_error(map.values(1, 0), 10.5e-6) <= 2 * epsilon);
    CHECK(relative_error(map.values(0, 1), 11e-6) <= 2 * epsilon);
    CHECK(relative_error(map.values(1, 2), 20e-6) <= 2 * epsilon);
    CHECK(relative_error(map.spacing[0], 0.5e-3) <= 2 * epsilon);
    CHECK(relative_error(map.spacing[1], 0.25e-3) <= 2 * epsilon);
    CHECK(map.title == "rough");
  }
}

TEST_CASE("points of a SUR outside its range are missing where it says that points are", "[formats][exact]") {
  const auto marked = [&](int special) {
    std::string out = with(with(head(), 100, -2), 104, 19);
    put(out, 86, static_cast<std::int16_t>(special));
    return read(out + numbers<std::int32_t>(six)).values;
  };
  CHECK(!marked(0).hasNaN());
  CHECK(marked(1).isNaN().count() == 2);
  CHECK(std::isnan(marked(1)(0, 2)));
  CHECK(std::isnan(marked(1)(1, 2)));
}

TEST_CASE("a PRO is a map of one line with the same spacing in y", "[formats][exact]") {
  const Map map = read(with(with(head(1), 112, 1), 124, 0.f) + numbers<std::int32_t>({1, 2}));
  REQUIRE(shape_of(map.values) == Shape{2, 1});
  CHECK(map.spacing[1] == map.spacing[0]);
}

TEST_CASE("of a SUR with several surfaces the only one of heights is read, or the one that is named",
          "[formats][contract]") {
  std::string first = with(head(13), 80, std::int16_t{2}) + numbers<std::int32_t>(six),
              second = head(13) + numbers<std::int32_t>({6, 5, 4, 3, 2, 1});
  second.replace(20, 5, "other");
  CHECK(read(first + second, "other").values(0, 0) > read(first + second, "0").values(0, 0));
  CHECK_THROWS_WITH(read(first + second),
                    ContainsSubstring("choose one with `channel`: 0 'rough', 1 'other'"));
  second.replace(212, 2, "V ").replace(260, 2, "V ");
  CHECK(read(first + second).title == "rough");
  CHECK(read(first + second, "1").units == "V");
  CHECK(read(first).title == "rough");  // its head says more than there is
}

// A step of 2^-31 of the range, on either side of the height of zero; half of it is lost, and 24 bits of a spacing.
TEST_CASE("what is written as SUR is read again the same to half a step, missing points too",
          "[formats][exact]") {
  for (Map map : {map_with_holes(), small_map()})
    for (const double size : {1.0, 1e-6, 1e-12}) {
      map.values *= size;
      const Map again = read(format::sur.encode(map, Order::xy));
      CHECK((again.values.isNaN() == map.values.isNaN()).all());
      const double range = size * (1e3 + 0.5);
      const auto error = map.values.isNaN().select(0.0, (again.values - map.values).abs());
      CHECK(error.maxCoeff() <= 1.001 * std::ldexp(range, -32));
      CHECK(relative_error(again.spacing[0], map.spacing[0]) <= std::ldexp(1.0, -24));
      CHECK(again.units == "m");
      CHECK(again.title == "heights");
    }
  const Map flat{.values = Field::Constant(3, 2, 1.0 / 3), .spacing = {1, 1}, .units = "V"};
  const Map again = read(format::sur.encode(flat, Order::xy));
  CHECK(relative_error(again.values(2, 1), 1.0 / 3) <= 2 * epsilon);
  CHECK(again.units == "V");
}

// The number of a missing point once was that of the height 0, far outside the range.
TEST_CASE("heights far from zero with a missing point are written as SUR", "[formats][exact]") {
  Map map{
      .values = Field::Constant(3, 2, 1) + 1e-6 * random_field({3, 2}, 4), .spacing = {1, 1}, .units = "m"};
  map.values(1, 1) = std::nan("");
  const Map again = read(format::sur.encode(map, Order::xy));
  CHECK(again.values.isNaN().count() == 1);
  CHECK(map.values.isNaN().select(0.0, (again.values - map.values).abs()).maxCoeff() <=
        std::ldexp(1e-5, -32) + 4 * epsilon);  // half a step of a range below 10 µm; roundings of 1 m
}

TEST_CASE("a map that SUR cannot hold is not written as one", "[formats][contract]") {
  Map map = small_map();
  map.spacing[1] = Map::unknown;
  CHECK_THROWS_WITH(format::sur.encode(map, Order::xy), ContainsSubstring("no size, which SUR needs"));
  map = small_map();
  map.units = "a very long unit";
  CHECK_THROWS_WITH(format::sur.encode(map, Order::xy), ContainsSubstring("15 characters"));
  map = small_map();
  map.values(0, 0) = 1e35;
  CHECK_THROWS_WITH(format::sur.encode(map, Order::xy), ContainsSubstring("single precision"));
}

TEST_CASE("a SUR that lies about itself is refused with what is wrong", "[formats][contract]") {
  const auto refused = [](const std::string& bytes, const std::string& words) {
    CHECK_THROWS_WITH(read(bytes), ContainsSubstring(words));
  };
  const std::string data = numbers<std::int32_t>(six), good = head() + data;
  refused("DIGITAL SURF", "header has no end");
  refused(with(good, 12, std::int16_t{257}), "byte order 257");
  refused(with(good, 18, std::int16_t{12}), "object type 12");
  refused(with(good, 94, 1024), "1024 numbers per point");
  refused(with(good, 98, std::int16_t{8}), "numbers of 8 bits");
  refused(with(good, 108, -1), "the map has no points");
  refused(with(good, 112, 0x7fffffff), "cut short");
  refused(with(good, 334, std::int16_t{-1}), "cut short");
  refused(with(good, 120, 0.f), "the spacing 0 in the header is not positive");
  refused(with(good, 128, 0.f), "the step of heights 0 in the header is not positive");
  refused(with(good, 474, std::nanf("")), "the height of zero, nan");
  refused(with(good, 260, std::int16_t{'n'}), "two units of height, 'µm' and 'n'");
  refused(good + "more", "4 bytes follow its end");
  const std::string small = compressed(head());
  refused(small + deflated({data, "more"}), "more numbers than its header gives");
  refused(small + deflated({data.substr(4)}), "cut short");
  refused(small + numbers<std::int32_t>({-1, 24, 24}) + std::string(100, 'x'), "cut short");
  refused(small + numbers<std::int32_t>({1, 24, 30}) + std::string(30, 'x'), "the zlib data are damaged");
}
