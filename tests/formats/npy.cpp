#include "core/error.hpp"
#include "formats/format.hpp"
#include "formats/raster.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// As NumPy writes it, in version 1 to 3.
std::string npy(const std::string& head, const std::string& numbers, char version = 1) {
  std::string out = "\x93NUMPY";
  out += {version, '\0', static_cast<char>(head.size()), '\0'};
  if (version > 1) out += {'\0', '\0'};
  return out + head + numbers;
}

std::string dictionary(const std::string& descr, const std::string& shape = "(1, 2)",
                       const std::string& fortran = "False") {
  return "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }   \n";
}

}  // namespace

TEST_CASE("a .npy is read in every type of number and order of its bytes", "[formats][exact]") {
  const auto pair = [](const std::string& descr, const std::string& numbers) {
    const Map map = format::npy.decode(npy(dictionary(descr), numbers), Order::xy);
    return std::array{map.values(0, 0), map.values(0, 1)};
  };
  CHECK(pair("|b1", std::string("\0\1", 2)) == std::array{0.0, 1.0});
  CHECK(pair("|i1", "\xff\x7f") == std::array{-1.0, 127.0});
  CHECK(pair("|u1", "\xff\x7f") == std::array{255.0, 127.0});
  CHECK(pair("<i2", std::string("\xfe\xff\x00\x01", 4)) == std::array{-2.0, 256.0});
  CHECK(pair(">i2", std::string("\xff\xfe\x01\x00", 4)) == std::array{-2.0, 256.0});
  CHECK(pair(">u2", std::string("\xff\xfe\x01\x00", 4)) == std::array{65534.0, 256.0});
  CHECK(pair("<i4", std::string("\xff\xff\xff\xff\0\0\1\0", 8)) == std::array{-1.0, 65536.0});
  CHECK(pair("<u4", std::string("\xff\xff\xff\xff\0\0\1\0", 8)) == std::array{4294967295.0, 65536.0});
  CHECK(pair(">i8", std::string(8, '\xff') + std::string("\0\0\0\1\0\0\0\0", 8)) ==
        std::array{-1.0, 4294967296.0});
  CHECK(pair("<u8", std::string(8, '\xff') + std::string("\0\0\0\1\0\0\0\0", 8)) ==
        std::array{18446744073709551616.0, 16777216.0});
  CHECK(pair("<f4", std::string("\0\0\x80\x3f\0\0\x20\xc0", 8)) == std::array{1.0, -2.5});
  CHECK(pair(">f4", std::string("\x3f\x80\0\0\xc0\x20\0\0", 8)) == std::array{1.0, -2.5});
  CHECK(pair(">f8", std::string("\x3f\xf0\0\0\0\0\0\0\xc0\x04\0\0\0\0\0\0", 16)) == std::array{1.0, -2.5});
}

// 0x3c00 = 1, 0xc100 = -2.5, 0x0001 = 2⁻²⁴, 0x7bff = 65504, 0x7e00 no number.
TEST_CASE("halves are read, the subnormal, the largest and the missing too", "[formats][exact]") {
  const Map map = format::npy.decode(
      npy(dictionary(">f2", "(5, 1)"), std::string("\x3c\0\xc1\0\0\1\x7b\xff\x7e\0", 10)), Order::xy);
  CHECK(map.values(0, 0) == 1);
  CHECK(map.values(1, 0) == -2.5);
  CHECK(map.values(2, 0) == std::ldexp(1, -24));
  CHECK(map.values(3, 0) == 65504);
  CHECK(std::isnan(map.values(4, 0)));
}

// The array is [[0, 1, 2], [3, 4, 5]] in both files.
TEST_CASE("the indices of a .npy mean what Order says, however the numbers lie in the file",
          "[formats][exact]") {
  Field z(2, 3);
  z << 0, 1, 2, 3, 4, 5;
  const std::string rows = npy(dictionary("|u1", "(2, 3)"), std::string("\0\1\2\3\4\5", 6)),
                    columns = npy(dictionary("|u1", "(2L, 3L)", "True"), std::string("\0\3\1\4\2\5", 6), 2);
  for (const std::string& bytes : {rows, columns}) {
    CHECK(same(format::npy.decode(bytes, Order::xy).values, z));
    CHECK(same(format::npy.decode(bytes, Order::yx).values, z.transpose()));
    CHECK(std::isnan(format::npy.decode(bytes, Order::xy).spacing[0]));
  }
}

TEST_CASE("what is written as .npy is read again the same, its numbers at a multiple of 64 bytes",
          "[formats][exact]") {
  for (const Order order : {Order::xy, Order::yx})
    for (const Index ny : {1, 10, 100, 1000, 10000}) {
      Map map = map_with_holes();
      map.values = random_field({3, ny}, 1);
      map.values(2, 0) = std::nan("");
      const std::string bytes = format::npy.encode(map, order);
      CHECK((bytes.size() - 24 * static_cast<std::size_t>(ny)) % 64 == 0);
      CHECK(same(format::npy.decode(bytes, order).values, map.values));
    }
}

TEST_CASE("a .npy that lies about itself is refused with what is wrong", "[formats][contract]") {
  const auto refused = [](const std::string& bytes, const std::string& with) {
    CHECK_THROWS_WITH(format::npy.decode(bytes, Order::xy), ContainsSubstring(with));
  };
  refused("NUMPY", "is not a NumPy array");
  refused("\x93NUMPY", "no end");
  refused(std::string("\x93NUMPY\x01\0\xff\xff{", 11), "no end");
  refused(npy(dictionary("<f8"), std::string(16, '\0'), 4), "version 4");
  refused(npy(dictionary("<f8"), "12345678"), "cut short");
  refused(npy(dictionary("<f8", "(2,)"), std::string(16, '\0')), "has 1 dimension");
  refused(npy(dictionary("<f8", "(1, 1, 2)"), std::string(16, '\0')), "has 3 dimensions");
  refused(npy(dictionary("<f8", "()"), std::string(16, '\0')), "has 0 dimensions");
  refused(npy(dictionary("<f8", "(4611686018427387904, 8)"), std::string(16, '\0')), "cut short");
  refused(npy(dictionary("<f8", "(-1, 8)"), std::string(16, '\0')), "cannot be read at '-1, 8)");
  refused(npy(dictionary("<f8", "(0, 8)"), std::string(16, '\0')), "the map has no points");
  refused(npy(dictionary("<c16"), std::string(32, '\0')), "number type '<c16' is not supported");
  refused(npy(dictionary("|f8"), std::string(16, '\0')), "type '|f8'");
  refused(npy(dictionary("f"), std::string(16, '\0')), "type 'f'");
  refused(npy("{'shape': (1, 2)}", "ab"), "descr is missing in the header");
  refused(npy("{'descr': '|u1'}", "ab"), "shape is missing in the header");
  refused(npy("{'descr': [('x', '|u1')]}", "ab"), "cannot be read at '[(");
  refused(npy("{'descr': '|u1", "ab"), "cannot be read");
  refused(npy("{'descr': '|u1', 'descr': '|i1'}", "ab"), "'descr' is given twice");
  refused(npy("{'size': 3}", "ab"), "key 'size' in the header");
  refused(npy("{'fortran_order': 1}", "ab"), "cannot be read at '1}'");
}
