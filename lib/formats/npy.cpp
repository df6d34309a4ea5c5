/// NumPy's .npy, versions 1, 2 and 3.
///
///     \x93NUMPY, two bytes of version, the head's length (two bytes in version 1, else four, little-endian)
///     {'descr': '<f8', 'fortran_order': False, 'shape': (5, 3), }
///     padded with blanks and ended by a line feed, and then the numbers
/// descr is < or > (least or most significant byte first) or | (one byte), and f2, f4, f8, i1, i2, i4, i8,
/// u1, u2, u4, u8 or b1 (bool, 0 or 1). Arrays of two dimensions are read; Order gives the index of the array
/// that is x, for any storage order. NaN is a missing point. The file has neither size nor units.
///
/// Files are written in version 1 with doubles, '<f8', last index fastest, starting at a multiple of 64
/// bytes.
///
/// NumPy reference, numpy.lib.format, https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#include <algorithm>
#include <cmath>
#include <vector>

#include "formats/format.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";

// Reads Python literals one after the other from the text.
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
    if (!take(token)) refuse_here();
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
    if (!out.in_range || out.number < 0) refuse_here();
    text_ = out.rest;
    take("L");  // Python 2's
    return out.number;
  }

  // Calls item() for each item of a list with commas, which may end with a comma.
  template <class Item>
  void list(std::string_view begin, std::string_view end, Item item) {
    expect(begin);
    while (!take(end)) {
      item();
      if (take(",")) continue;
      return expect(end);
    }
  }

 private:
  [[noreturn]] void refuse_here() const { refuse("the header cannot be read at {}", quoted(text_)); }
  void skip_blanks() { text_.remove_prefix(std::min(text_.find_first_not_of(" \n"), text_.size())); }

  std::string_view text_;
};

struct NpyHead {
  std::string_view descr;
  bool fortran = false;
  std::vector<Index> shape;
};

void take_shape(Literals& text, std::vector<Index>& shape) {
  shape.clear();
  text.list("(", ")", [&] { shape.push_back(text.integer()); });
  if (shape.size() != 2)
    refuse("the array has {}, a map has 2", counted(static_cast<std::int64_t>(shape.size()), "dimension"));
}

NpyHead description_of(Literals text) {
  NpyHead out;
  std::vector<std::string_view> keys;
  text.list("{", "}", [&] {
    const std::string_view key = text.string();
    text.expect(":");
    if (std::ranges::find(keys, key) != keys.end()) refuse("{} is given twice in the header", quoted(key));
    keys.push_back(key);
    if (key == "descr")
      out.descr = text.string();
    else if (key == "fortran_order")
      out.fortran = text.truth();
    else if (key == "shape")
      take_shape(text, out.shape);
    else
      refuse("key {} in the header is not supported", quoted(key));
  });
  if (out.descr.empty()) refuse("descr is missing in the header");
  if (out.shape.empty()) refuse("shape is missing in the header");
  return out;
}

struct Kind {
  std::string_view name;
  NumberType type;
};

// Half precision is read as bits.
constexpr std::string_view half = "f2";
constexpr Kind kinds[] = {
    {"b1", NumberType::uint8},   {"i1", NumberType::int8},    {"u1", NumberType::uint8},
    {"i2", NumberType::int16},   {"u2", NumberType::uint16},  {"i4", NumberType::int32},
    {"u4", NumberType::uint32},  {"i8", NumberType::int64},   {"u8", NumberType::uint64},
    {"f4", NumberType::float32}, {"f8", NumberType::float64}, {half, NumberType::uint16}};

NumberType npy_type(std::string_view descr) {
  for (const Kind& kind : kinds)
    if (descr.substr(1) == kind.name && std::string_view("<>|").find(descr[0]) != descr.npos &&
        (descr[0] != '|' || size_of(kind.type) == 1))
      return kind.type;
  refuse("number type {} is not supported", quoted(descr));
}

// IEEE 754's binary16: a sign, five bits of exponent, ten of fraction.
double half_of_bits(double number) {
  const auto bits = static_cast<unsigned>(number);
  const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 1023);
  double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  if (exponent == 31) size = fraction == 0 ? HUGE_VAL : std::nan("");
  return bits >> 15 ? -size : size;
}

bool is_npy(std::string_view bytes) { return bytes.starts_with(npy_magic); }

// Removes the header from the bytes.
std::string_view take_npy_head(std::string_view& bytes) {
  if (!is_npy(bytes)) refuse("the file is not a NumPy array");
  const std::size_t width = bytes.size() > 6 && bytes[6] == 1 ? 2 : 4, begin = 8 + width;
  if (bytes.size() < begin) refuse_cut_header();
  if (bytes[6] < 1 || bytes[6] > 3)
    refuse("version {:d} of .npy is not supported, only 1 to 3", int{bytes[6]});
  const std::size_t size = width == 2 ? number_from<std::uint16_t>(bytes.data() + 8, std::endian::little)
                                      : number_from<std::uint32_t>(bytes.data() + 8, std::endian::little);
  if (bytes.size() - begin < size) refuse_cut_header();
  const std::string_view head = bytes.substr(begin, size);
  bytes.remove_prefix(begin + size);
  return head;
}

Map decode_npy(std::string_view bytes, const Reading& reading) {
  const NpyHead described = description_of(Literals(take_npy_head(bytes)));
  Shape shape{described.shape[0], described.shape[1]};
  if (reading.order == Order::yx) std::swap(shape.nx, shape.ny);
  const Raster raster{npy_type(described.descr),
                      described.descr[0] == '>' ? std::endian::big : std::endian::little,
                      described.fortran == (reading.order == Order::xy) ? Order::yx : Order::xy};
  Map map{.values = field_from(bytes, shape, raster, reading.memory)};
  if (described.descr.substr(1) == half) map.values = map.values.unaryExpr(&half_of_bits);
  leave_out_infinite(map);
  return map;
}

std::string encode_npy(const Map& map, Order order) {
  auto [first, second] = shape_of(map.values);
  if (order == Order::yx) std::swap(first, second);
  std::string head =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", first, second);
  const std::size_t before = npy_magic.size() + 4;
  head.append(63 - (before + head.size()) % 64, ' ') += '\n';
  std::string out = std::string(npy_magic) + std::string("\x01\x00", 2);
  out += static_cast<char>(head.size() % 256);
  out += static_cast<char>(head.size() / 256);
  return out + head + bytes_of(map.values, {.order = order});
}

}  // namespace

const Format format::npy{"npy", "npy", "NumPy array", is_npy, decode_npy, encode_npy};

}  // namespace asperity
