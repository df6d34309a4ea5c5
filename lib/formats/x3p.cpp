#include "formats/x3p.hpp"

#include <cmath>
#include <vector>

#include <md5.h>
#include <pugixml.hpp>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/archive.hpp"
#include "formats/raster.hpp"
#include "formats/text_numbers.hpp"
#include "formats/x3p_list.hpp"

namespace asperity {
namespace {

const std::string main_file = "main.xml", checksum_file = "md5checksum.hex", data_file = "bindata/data.bin";

constexpr std::size_t most_of_main = 1 << 20, most_of_checksums = 1 << 16;  // bytes that are sensible
constexpr std::string_view elsewhere = "@";  // stands for a list that was taken out of main.xml

[[noreturn]] void refuse(const std::string& message) { throw DataError("map", message); }

[[noreturn]] void refuse_size(const std::string& name, std::size_t size) {
  refuse(name + " claims " + std::to_string(size) + " bytes, more than is sensible");
}

// ---- main.xml ----

std::string_view local_name(pugi::xml_node node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

// The first child of that name, or an empty node.
pugi::xml_node child(pugi::xml_node node, std::string_view name) {
  return node.find_child([&](pugi::xml_node c) { return local_name(c) == name; });
}

std::string_view text_of_child(pugi::xml_node node, std::string_view name) {
  return trimmed(child(node, name).child_value());
}

double number_in(pugi::xml_node node, std::string_view name, double otherwise) {
  const std::string_view text = text_of_child(node, name);
  if (text.empty()) return otherwise;
  const auto number = number_of(text);
  if (!number || !std::isfinite(*number))
    refuse(std::string(name) + " '" + std::string(text.substr(0, 24)) + "' is no number");
  return *number;
}

Index size_in(pugi::xml_node dimensions, std::string_view name) {
  const std::string_view text = text_of_child(dimensions, name);
  const auto size = to_number<Index>(text);
  if (!size) refuse(std::string(name) + " '" + std::string(text.substr(0, 24)) + "' is no size");
  return *size;
}

// A real list of numbers deflates less than 32-fold; a document of elements without end deflates a thousandfold.
std::string read_main(const ZipArchive& archive, const MemoryBound& memory) {
  const std::size_t size = archive.size(main_file), most = most_of_main + 32 * archive.stored_size(main_file);
  if (size > most) refuse_size(main_file, size);
  memory.require(static_cast<double>(size), "map");
  return archive.read(main_file);
}

void check_md5(std::string_view digits, std::string_view expected, const std::string& name) {
  if (lower(expected) != digits) refuse("the checksum of " + name + " is wrong: it is damaged");
}

// Lines of a checksum, and of the name of its file, which other programs put an asterisk or a path before.
void check_main(const ZipArchive& archive, std::string_view main) {
  if (!archive.has(checksum_file)) return;
  if (const std::size_t size = archive.size(checksum_file); size > most_of_checksums)
    refuse_size(checksum_file, size);
  const std::string list = archive.read(checksum_file), found = md5_of(main);
  for (std::string_view rest = list; !rest.empty();) {
    const std::string_view line = trimmed(take_line(rest)),
                           digits = line.substr(0, line.find_first_of(" \t*"));
    if (line.empty()) continue;
    if (digits.size() == line.size() || line.ends_with(main_file)) check_md5(found, digits, main_file);
  }
}

struct Head {
  Shape shape;
  std::array<double, 2> spacing;
  NumberType type;
  double increment, offset;
};

double spacing_of(pugi::xml_node axes, std::string_view name) {
  const pugi::xml_node axis = child(axes, name);
  if (text_of_child(axis, "AxisType") != "I") refuse(std::string(name) + " is no axis of even increments");
  const double out = number_in(axis, "Increment", 0);
  if (!(out > 0)) refuse("the increment of " + std::string(name) + " is not positive");
  return out;
}

NumberType type_of(std::string_view code) {
  constexpr std::pair<std::string_view, NumberType> types[] = {{"I", NumberType::int16},
                                                               {"L", NumberType::int32},
                                                               {"F", NumberType::float32},
                                                               {"D", NumberType::float64}};
  for (const auto& [name, type] : types)
    if (code == name) return type;
  refuse("the data type '" + std::string(code.substr(0, 24)) + "' of CZ is none of I, L, F, D");
}

Head head_of(pugi::xml_node root) {
  const pugi::xml_node first = child(root, "Record1"), axes = child(first, "Axes"), z = child(axes, "CZ");
  const std::string_view feature = text_of_child(first, "FeatureType");
  if (!feature.empty() && feature != "SUR")
    refuse("its feature type is '" + std::string(feature.substr(0, 24)) + "', not SUR, a surface");
  const pugi::xml_node dimensions = child(child(root, "Record3"), "MatrixDimension");
  if (size_in(dimensions, "SizeZ") != 1) refuse("it has more than one layer: SizeZ is not 1");
  Head out{.shape = {size_in(dimensions, "SizeX"), size_in(dimensions, "SizeY")},
           .spacing = {spacing_of(axes, "CX"), spacing_of(axes, "CY")},
           .type = type_of(text_of_child(z, "DataType")),
           .increment = number_in(z, "Increment", 1),
           .offset = number_in(z, "Offset", 0)};
  if (out.increment == 0) refuse("the increment of CZ is zero");
  return out;
}

// ---- the numbers ----

// An entry that must hold `bytes` of them, compared with a checksum if there is one.
std::string linked(const ZipArchive& archive, const std::string& name, std::size_t bytes,
                   std::string_view checksum) {
  const std::size_t size = archive.size(name);
  if (size != bytes)
    refuse("'" + name.substr(0, 64) + "' has " + std::to_string(size) + " bytes where the map's size needs " +
           std::to_string(bytes));
  std::string out = archive.read(name);
  if (!checksum.empty()) check_md5(md5_of(out), checksum, name.substr(0, 64));
  return out;
}

void leave_out_invalid(Field& values, std::string_view bits) {
  for (Index i = 0; i < values.rows(); ++i)
    for (Index j = 0; j < values.cols(); ++j) {
      const auto place = static_cast<std::size_t>(j * values.rows() + i);
      if ((static_cast<unsigned char>(bits[place / 8]) >> (place % 8) & 1) == 0) values(i, j) = Map::unknown;
    }
}

Field values_linked(const ZipArchive& archive, pugi::xml_node link, const Head& head,
                    const MemoryBound& memory) {
  const std::string name(text_of_child(link, "PointDataLink")), mask(text_of_child(link, "ValidPointsLink"));
  const std::size_t width = size_of(head.type);
  check_shape(head.shape, archive.size(name) / width, "map");
  memory.require_map(head.shape, "map");
  const auto cells = static_cast<std::size_t>(head.shape.cells());
  Field out = field_from(linked(archive, name, cells * width, text_of_child(link, "MD5ChecksumPointData")),
                         head.shape, {head.type, std::endian::little, Order::yx}, "map");
  if (!mask.empty())
    leave_out_invalid(out,
                      linked(archive, mask, (cells + 7) / 8, text_of_child(link, "MD5ChecksumValidPoints")));
  return out;
}

// The last of a Datum's numbers, which semicolons separate, is the height.
double datum(std::string_view text) {
  text = trimmed(text.substr(text.find_last_of(';') + 1));
  if (text.empty()) return Map::unknown;
  const auto number = number_of(text);
  if (!number) refuse("the Datum '" + std::string(text.substr(0, 24)) + "' is no number");
  return *number;
}

// Of the list's node, unless that says that the list is elsewhere.
Field values_listed(pugi::xml_node node, std::string_view list, Shape shape, const MemoryBound& memory) {
  constexpr std::size_t least = std::string_view("<Datum/>").size();
  memory.require_map(shape, "map");
  std::vector<double> values;
  values.reserve(list.size() / least);
  const auto take = [&](pugi::xml_node n) {
    if (local_name(n) == "Datum") values.push_back(datum(n.child_value()));
  };
  if (node.child_value() == elsewhere)
    for_each_element(list, take);
  else
    for (const pugi::xml_node n : node) take(n);
  check_shape(shape, values.size(), "map");
  if (static_cast<std::size_t>(shape.cells()) != values.size())
    refuse("it lists " + std::to_string(values.size()) + " points, more than its size");
  return Eigen::Map<const Field>(values.data(), shape.ny, shape.nx).transpose();
}

// ---- writing ----

std::string element(std::string_view name, std::string_view content) {
  return "<" + std::string(name) + ">" + std::string(content) + "</" + std::string(name) + ">\n";
}

std::string axis_of(std::string_view name, double increment) {
  return element(name, "\n" + element("AxisType", "I") + element("DataType", "D") +
                           element("Increment", shortest(increment)) + element("Offset", "0"));
}

std::string main_of(const Map& map, std::string_view checksum) {
  const std::string axes = axis_of("CX", map.spacing[0]) + axis_of("CY", map.spacing[1]) +
                           element("CZ", "\n" + element("AxisType", "A") + element("DataType", "D"));
  const std::string sizes = element("SizeX", std::to_string(map.values.rows())) +
                            element("SizeY", std::to_string(map.values.cols())) + element("SizeZ", "1");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n" +
         element("Record1", "\n" + element("Revision", "ISO5436 - 2000") + element("FeatureType", "SUR") +
                                element("Axes", "\n" + axes)) +
         element("Record3", "\n" + element("MatrixDimension", "\n" + sizes) +
                                element("DataLink", "\n" + element("PointDataLink", data_file) +
                                                        element("MD5ChecksumPointData", checksum))) +
         element("Record4", "\n" + element("ChecksumFile", checksum_file)) + "</p:ISO5436_2>\n";
}

}  // namespace

std::string md5_of(std::string_view bytes) {
  char digits[MD5_DIGEST_STRING_LENGTH];
  MD5Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digits);
  return digits;
}

bool recognises_x3p(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

Map decode_x3p(std::string_view bytes, const Reading& reading) {
  const ZipArchive archive(bytes, "map");
  const std::string main = read_main(archive, reading.memory);
  const MemoryBound memory = reading.memory.beside(main.size());
  check_main(archive, main);
  const ListPlace place = list_in(main);
  const std::string_view list = std::string_view(main).substr(place.begin, place.end - place.begin);
  if (main.size() - list.size() > most_of_main) refuse_size(main_file, main.size());
  std::string rest = main.substr(0, place.begin);
  if (!list.empty()) rest += elsewhere;
  rest += std::string_view(main).substr(place.end);
  pugi::xml_document document;
  if (const auto parsed = document.load_buffer_inplace(rest.data(), rest.size()); !parsed)
    refuse(std::string("main.xml is no XML: ") + parsed.description());
  const pugi::xml_node root = child(document, "ISO5436_2"), third = child(root, "Record3");
  const Head head = head_of(root);
  const pugi::xml_node link = child(third, "DataLink");
  Map map{.values = link ? values_linked(archive, link, head, memory)
                         : values_listed(child(third, "DataList"), list, head.shape, memory),
          .spacing = head.spacing,
          .units = "m"};
  if (head.increment != 1 || head.offset != 0) map.values = map.values * head.increment + head.offset;
  return map;
}

std::string encode_x3p(const Map& map, Order) {
  check_heights(map, "X3P");
  const std::string data = bytes_of(map.values, {NumberType::float64, std::endian::little, Order::yx});
  const std::string main = main_of(map, md5_of(data)), checksum = md5_of(main) + " *" + main_file + "\n";
  const ZipEntry entries[] = {{main_file, main}, {data_file, data}, {checksum_file, checksum}};
  return zip_of(entries);
}

}  // namespace asperity
