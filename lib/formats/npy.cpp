#include "formats/npy.hpp"

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/raster.hpp"

namespace asperity {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

// Python's literals in a row, each taken off the text.
class Literals {
 public:
  explicit Literals(std::string_view text) : text_(text) {}

  bool take(std::string_view token) {
    skip_blanks();
    if (!text_.starts_with(token)) return false;
    text_.remove_prefix(token.size());
    return true;
  }

  void expect(std::string_view token) {
    if (!take(token)) refuse();
  }

  std::string_view string() {
    expect("'");
    const std::string_view out = text_.substr(0, text_.find('\''));
    text_.remove_prefix(out.size());
    expect("'");
    return out;
  }

  bool truth() {
    if (take("True")) return true;
    expect("False");
    return false;
  }

  Index integer() {
    skip_blanks();
    const auto out = leading_number<Index>(text_);
    if (!out.in_range || out.number < 0) refuse();
    text_ = out.rest;
    take("L");  // Python 2's
    return out.number;
  }

  [[noreturn]] void refuse() const {
    throw DataError("map", "its head is not understood at '" + one_line(text_, 24) + "'");
  }

 private:
  void skip_blanks() { text_.remove_prefix(std::min(text_.find_first_not_of(" \n"), text_.size())); }

  std::string_view text_;
};

struct Described {
  std::string_view descr;
  bool fortran = false;
  std::vector<Index> shape;
};

std::vector<Index> take_shape(Literals& text) {
  std::vector<Index> out;
  text.expect("(");
  while (!text.take(")")) {
    out.push_back(text.integer());
    if (text.take(",")) continue;
    text.expect(")");
    break;
  }
  if (out.size() != 2)
    throw DataError("map", "its array has " + counted(static_cast<std::int64_t>(out.size()), "dimension") +
                               ", where a map has two");
  return out;
}

Described description_of(Literals text) {
  Described out;
  text.expect("{");
  while (!text.take("}")) {
    const std::string_view key = text.string();
    text.expect(":");
    if (key == "descr")
      out.descr = text.string();
    else if (key == "fortran_order")
      out.fortran = text.truth();
    else if (key == "shape")
      out.shape = take_shape(text);
    else
      throw DataError("map", "its head has the key '" + one_line(key, 24) + "'");
    if (!text.take(",")) {
      text.expect("}");
      break;
    }
  }
  if (out.descr.empty() || out.shape.empty())
    throw DataError("map", "its head does not state " + std::string(out.descr.empty() ? "descr" : "shape"));
  return out;
}

struct Kind {
  std::string_view name;
  NumberType type;
};

// A half is read as its bits.
constexpr std::string_view half = "f2";
constexpr Kind kinds[] = {
    {"b1", NumberType::uint8},   {"i1", NumberType::int8},    {"u1", NumberType::uint8},
    {"i2", NumberType::int16},   {"u2", NumberType::uint16},  {"i4", NumberType::int32},
    {"u4", NumberType::uint32},  {"i8", NumberType::int64},   {"u8", NumberType::uint64},
    {"f4", NumberType::float32}, {"f8", NumberType::float64}, {half, NumberType::uint16}};

NumberType type_of(std::string_view descr) {
  for (const Kind& kind : kinds)
    if (descr.substr(1) == kind.name && std::string_view("<>|").find(descr[0]) != descr.npos &&
        (descr[0] != '|' || size_of(kind.type) == 1))
      return kind.type;
  throw DataError("map", "its numbers are of type '" + one_line(descr, 24) + "', which is not read");
}

// IEEE 754's binary16: a sign, five bits of exponent, ten of fraction.
double half_of_bits(double number) {
  const auto bits = static_cast<unsigned>(number);
  const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 1023);
  double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  if (exponent == 31) size = fraction == 0 ? HUGE_VAL : std::nan("");
  return bits >> 15 ? -size : size;
}

struct Parts {
  std::string_view head, numbers;
};

Parts parts_of(std::string_view bytes) {
  if (!recognises_npy(bytes)) throw DataError("map", "it does not begin as NumPy's .npy");
  const std::size_t width = bytes.size() > 6 && bytes[6] == 1 ? 2 : 4, begin = 8 + width;
  if (bytes.size() < begin) throw DataError("map", "its head has no end");
  if (bytes[6] < 1 || bytes[6] > 3)
    throw DataError("map",
                    "it is of version " + std::to_string(bytes[6]) + " of NumPy's .npy; 1 to 3 are read");
  const std::size_t size = width == 2 ? number_from<std::uint16_t>(bytes.data() + 8, std::endian::little)
                                      : number_from<std::uint32_t>(bytes.data() + 8, std::endian::little);
  if (bytes.size() - begin < size) throw DataError("map", "its head has no end");
  return {bytes.substr(begin, size), bytes.substr(begin + size)};
}

}  // namespace

bool recognises_npy(std::string_view bytes) { return bytes.starts_with(magic); }

Map decode_npy(std::string_view bytes, const Reading& reading) {
  const auto [head, numbers] = parts_of(bytes);
  const Described described = description_of(Literals(head));
  Shape shape{described.shape[0], described.shape[1]};
  if (reading.order == Order::yx) std::swap(shape.nx, shape.ny);
  const Raster raster{type_of(described.descr),
                      described.descr[0] == '>' ? std::endian::big : std::endian::little,
                      described.fortran == (reading.order == Order::xy) ? Order::yx : Order::xy};
  Map map{.values = field_from(numbers, shape, raster, "map", reading.memory)};
  if (described.descr.substr(1) == half) map.values = map.values.unaryExpr(&half_of_bits);
  return map;
}

std::string encode_npy(const Map& map, Order order) {
  const auto [nx, ny] = shape_of(map.values);
  const auto [first, second] = order == Order::xy ? std::pair(nx, ny) : std::pair(ny, nx);
  std::string head = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(first) + ", " +
                     std::to_string(second) + "), }";
  const std::size_t before = magic.size() + 4;
  head.append(63 - (before + head.size()) % 64, ' ') += '\n';
  std::string out = std::string(magic) + std::string("\x01\x00", 2);
  out += static_cast<char>(head.size() % 256);
  out += static_cast<char>(head.size() / 256);
  return out + head + bytes_of(map.values, {NumberType::float64, std::endian::little, order});
}

}  // namespace asperity
