#include "formats/x3p_head.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"

namespace asperity::x3p {

std::string_view local_name(pugi::xml_node node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

pugi::xml_node child(pugi::xml_node node, std::string_view name) {
  const auto named = [&](pugi::xml_node c) { return local_name(c) == name; };
  const pugi::xml_node out = node.find_child(named);
  for (pugi::xml_node next = out.next_sibling(); next; next = next.next_sibling())
    if (named(next)) refuse("{} is there twice in main.xml: nothing says which counts, write it once", name);
  return out;
}

std::string_view text_of_child(pugi::xml_node node, std::string_view name) {
  return trimmed(child(node, name).child_value());
}

namespace {

double x3p_number(pugi::xml_node node, std::string_view name, double otherwise) {
  const std::string_view text = text_of_child(node, name);
  if (text.empty()) return otherwise;
  const auto number = number_of(text);
  if (!number || !std::isfinite(*number)) refuse("{} {} in main.xml is not a number", name, quoted(text));
  return *number;
}

Index size_in(pugi::xml_node dimensions, std::string_view name) {
  const std::string_view text = text_of_child(dimensions, name);
  const auto size = to_number<Index>(text);
  if (!size) refuse("{} {} in main.xml is not a whole number from 0", name, quoted(text));
  return *size;
}

double x3p_spacing(pugi::xml_node axes, std::string_view name) {
  const pugi::xml_node axis = child(axes, name);
  if (text_of_child(axis, "AxisType") != "I")
    refuse("axis {} in main.xml is not incremental (AxisType I): write points as text, columns x z or x y z",
           name);
  const double out = x3p_number(axis, "Increment", 0);
  if (!(out > 0)) refuse("Increment {} of {} in main.xml is not positive", out, name);
  return out;
}

NumberType x3p_type(std::string_view code) {
  constexpr std::pair<std::string_view, NumberType> types[] = {{"I", NumberType::int16},
                                                               {"L", NumberType::int32},
                                                               {"F", NumberType::float32},
                                                               {"D", NumberType::float64}};
  for (const auto& [name, type] : types)
    if (code == name) return type;
  refuse("number type {} is not supported, only I, L, F, D", quoted(code));
}

void take_heights(Head& head, pugi::xml_node z) {
  const std::string_view kind = text_of_child(z, "AxisType");
  if (!kind.empty() && kind != "A") refuse("axis CZ in main.xml is not absolute (AxisType A)");
  head.type = x3p_type(text_of_child(z, "DataType"));
  head.offset = x3p_number(z, "Offset", 0);
  const bool floats = head.type == NumberType::float32 || head.type == NumberType::float64;
  const double increment = x3p_number(z, "Increment", floats ? 1 : 0);
  if (increment == 0) refuse("Increment of CZ in main.xml is missing or 0");
  head.increment = floats ? 1 : increment;
  if (head.increment != increment)
    head.understood = fmt::format(
        "the floats are metres: Increment {} of CZ in main.xml, which is for integers, is not applied "
        "(`from` gwyddion applies it)",
        shortest(increment));
}

// To the round-off of single precision, which has 4e-8 for cos 90°.
Eigen::Array33i rotation_in(pugi::xml_node node) {
  constexpr double round_off = 1e-7;
  constexpr char way_out[] =
      "turn them in the program that wrote them, or take them as stored (`from` gwyddion)";
  Eigen::Array33i out = Eigen::Matrix3i::Identity();
  if (!node.first_child()) return out;
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j) {
      const std::string name = fmt::format("r{}{}", i + 1, j + 1);
      const double element = x3p_number(node, name, Map::unknown),
                   whole = std::clamp(std::round(element), -1.0, 1.0);
      if (!(std::abs(element - whole) <= round_off))
        refuse("Rotation in main.xml takes the points off their grid, {} is {}: {}", name, shortest(element),
               way_out);
      out(i, j) = static_cast<int>(whole);
    }
  const Eigen::Array33i sizes = out.abs();
  if ((sizes.rowwise().sum() != 1).any() || (sizes.colwise().sum() != 1).any() || sizes(2, 2) != 1)
    refuse("Rotation in main.xml takes the points off their grid, x and y not to x and y, or z not to z: {}",
           way_out);
  return out;
}

// Where a point goes: "(-y, x, z)".
std::string place_by(const Eigen::Array33i& rotation) {
  std::string out;
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j)
      if (rotation(i, j) != 0)
        out += fmt::format("{}{}{}", i > 0 ? ", " : "(", rotation(i, j) < 0 ? "-" : "", "xyz"[j]);
  return out + ")";
}

// The end of a comment or CDATA section that begins here; 0 if none begins.
std::size_t end_of_other_markup(std::string_view xml, std::size_t at) {
  constexpr std::pair<std::string_view, std::string_view> marks[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}};
  for (const auto& [begin, end] : marks)
    if (xml.substr(at).starts_with(begin)) return std::min(xml.find(end, at), xml.size() - 1);
  return 0;
}

// The first element from this position.
std::size_t find_element(std::string_view list, std::size_t from) {
  std::size_t at = list.find('<', from);
  while (at != list.npos && at + 1 < list.size() && list[at + 1] == '/') at = list.find('<', at + 1);
  return std::min(at, list.size());
}

}  // namespace

Head head_of(pugi::xml_node root) {
  const pugi::xml_node first = child(root, "Record1"), axes = child(first, "Axes");
  if (!first) refuse("main.xml is not that of an X3P: Record1 is missing");
  const std::string_view feature = text_of_child(first, "FeatureType");
  const bool profile = feature == "PRF";
  if (!feature.empty() && feature != "SUR" && !profile)
    refuse(
        "FeatureType {} in main.xml is not supported, only SUR, a surface, and PRF, a profile: write points "
        "as text, columns x y z",
        quoted(feature));
  const pugi::xml_node dimensions = child(child(root, "Record3"), "MatrixDimension");
  if (size_in(dimensions, "SizeZ") != 1) refuse("the file has more than one layer: SizeZ is not 1");
  const Shape shape{size_in(dimensions, "SizeX"), size_in(dimensions, "SizeY")};
  if (profile && shape.ny != 1)
    refuse(
        "the file is a profile, FeatureType PRF, but SizeY is {} and not 1: write its lines as a surface, "
        "SUR",
        shape.ny);
  const double dx = x3p_spacing(axes, "CX");
  Head out{.shape = shape,
           .spacing = {dx, profile && !child(axes, "CY") ? dx : x3p_spacing(axes, "CY")},
           .rotation = rotation_in(child(axes, "Rotation"))};
  take_heights(out, child(axes, "CZ"));
  if (out.rotation.matrix() != Eigen::Matrix3i::Identity())
    out.understood += fmt::format("{}Rotation in main.xml takes points (x, y, z) to {}",
                                  out.understood.empty() ? "" : "; ", place_by(out.rotation));
  return out;
}

void make_heights(Map& map, const Head& head) {
  const Eigen::Array33i& r = head.rotation;
  if (r(0, 1) != 0) {
    map.values = map.values.transpose().eval();
    std::swap(map.spacing[0], map.spacing[1]);
  }
  if (r.row(0).sum() < 0) map.values = map.values.colwise().reverse().eval();
  if (r.row(1).sum() < 0) map.values = map.values.rowwise().reverse().eval();
  const double factor = head.increment * r(2, 2);
  if (factor != 1 || head.offset != 0) map.values = map.values * factor + head.offset;
}

ListPlace list_in(std::string_view xml) {
  for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
    if (const std::size_t end = end_of_other_markup(xml, at); end > 0) {
      at = end;
      continue;
    }
    const std::size_t end = std::min(xml.find_first_of(" \t\r\n/><", at + 1), xml.size());
    const std::string_view name = xml.substr(at + 1, end - at - 1);
    if (name.substr(name.find(':') + 1) != "DataList") continue;
    const std::size_t begin = xml.find('>', end), close = xml.find("</" + std::string(name), end);
    if (close == xml.npos || begin > close) break;
    return {begin + 1, close};
  }
  return {xml.size(), xml.size()};
}

void for_each_element(std::string_view list, const std::function<void(pugi::xml_node)>& take) {
  constexpr std::size_t piece = 1 << 16;
  for (pugi::xml_document document; !list.empty();) {
    const std::size_t end = find_element(list, piece);
    constexpr unsigned parts = pugi::parse_default | pugi::parse_fragment;
    const auto parsed = document.load_buffer(list.data(), end, parts, pugi::encoding_utf8);
    if (!parsed) refuse("DataList in main.xml is not valid XML: {}", parsed.description());
    for (const pugi::xml_node node : document) take(node);
    list.remove_prefix(end);
  }
}

// ---- checksums ----

// MD5 after R. Rivest, The MD5 message-digest algorithm, RFC 1321 (1992), section 3. X3P asks for it to find
// damage; no secret depends on it. None of the libraries that the project is linked with has it. OpenSSL
// would be one more, and refuses it where a system admits approved algorithms only.
namespace {

constexpr std::size_t md5_block = 64;  // bytes that are mixed into the state at a time
using Md5State = std::array<std::uint32_t, 4>;

// T of section 3.4.
std::array<std::uint32_t, 64> make_md5_sines() {
  std::array<std::uint32_t, 64> out{};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<std::uint32_t>(std::ldexp(std::abs(std::sin(static_cast<double>(i + 1))), 32));
  return out;
}
const std::array<std::uint32_t, 64> md5_sines = make_md5_sines();

// Little-endian, as the message is in words.
template <std::size_t bytes, class Word>
std::array<char, bytes> md5_bytes(Word word) {
  std::array<char, bytes> out{};
  for (std::size_t b = 0; b < bytes; ++b) out[b] = static_cast<char>(word >> 8 * b);
  return out;
}

// A round: 16 steps that mix a word each, in the order first + stride k.
template <unsigned round, unsigned first, unsigned stride, class Mix>
void md5_round(Md5State& s, const std::array<std::uint32_t, 16>& words, std::array<int, 4> turns,
               const Mix& mix) {
#pragma GCC unroll 16
  for (unsigned k = 0; k < 16; ++k) {
    const std::uint32_t sum =
        s[0] + mix(s[1], s[2], s[3]) + words[(first + stride * k) % 16] + md5_sines[16 * round + k];
    const int turn = turns[k % 4];
    s = {s[3], s[1] + (sum << turn | sum >> (32 - turn)), s[1], s[2]};
  }
}

void md5_mix(Md5State& state, const char* block) {
  std::array<std::uint32_t, 16> words{};
  for (std::size_t b = 0; b < md5_block; ++b)
    words[b / 4] |= std::uint32_t{static_cast<unsigned char>(block[b])} << 8 * (b % 4);
  Md5State s = state;
  md5_round<0, 0, 1>(s, words, {7, 12, 17, 22}, [](auto x, auto y, auto z) { return (x & y) | (~x & z); });
  md5_round<1, 1, 5>(s, words, {5, 9, 14, 20}, [](auto x, auto y, auto z) { return (x & z) | (y & ~z); });
  md5_round<2, 5, 3>(s, words, {4, 11, 16, 23}, [](auto x, auto y, auto z) { return x ^ y ^ z; });
  md5_round<3, 0, 7>(s, words, {6, 10, 15, 21}, [](auto x, auto y, auto z) { return y ^ (x | ~z); });
  for (std::size_t i = 0; i < s.size(); ++i) state[i] += s[i];
}

// Behind the message: a bit, zeros, and its length in bits, which end with a block.
std::string md5_tail(std::string_view rest, std::uint64_t message_bytes) {
  std::string out(rest);
  out += '\x80';
  out.resize((out.size() + 8 + md5_block - 1) / md5_block * md5_block - 8);
  const auto bits = md5_bytes<8>(8 * message_bytes);
  return out.append(bits.data(), bits.size());
}

}  // namespace

std::string md5_of(std::string_view bytes) {
  Md5State state{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
  std::string_view rest = bytes;
  for (; rest.size() >= md5_block; rest.remove_prefix(md5_block)) md5_mix(state, rest.data());
  const std::string tail = md5_tail(rest, bytes.size());
  for (std::size_t at = 0; at < tail.size(); at += md5_block) md5_mix(state, tail.data() + at);
  std::string out;
  for (const std::uint32_t word : state)
    for (const char byte : md5_bytes<4>(word)) {
      constexpr std::string_view digits = "0123456789abcdef";
      out += digits[static_cast<unsigned char>(byte) >> 4];
      out += digits[byte & 15];
    }
  return out;
}

}  // namespace asperity::x3p
