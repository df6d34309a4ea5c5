/// X3P, ISO 5436-2 and ISO 25178-72: a zip archive with main.xml, which describes the map, and its numbers.
///
///     Record1/Axes     CX, CY: AxisType I, Increment [m]; CZ: DataType I (int16), L (int32), F, D, Increment
///                      [m] of integers, and Offset (default 0) [m]
///                      Rotation: r11 … r33 of Q = R P + T, the place of a point, with T from the Offsets
///     Record3          MatrixDimension SizeX, SizeY, SizeZ; DataLink to a file of numbers, little-endian,
///                      x fastest, with its MD5; or DataList, a Datum for each number
///     md5checksum.hex  the MD5 of main.xml
/// Lengths are metres, and so are floats, whatever Increment says: as in iso5436_2.xsd, openGPS and x3ptools,
/// while Gwyddion and SurfaceTopography multiply; a note says so. R must keep the points on their grid (half
/// and quarter turns about z, mirrors, a map turned over, whose heights change their sign); a note says so. A
/// missing point is NaN or infinite (Alicona), an empty Datum, or one whose bit (least significant first) is
/// 0 in the file named by ValidPointsLink. A profile (FeatureType PRF) is a single line, and may lack CY: its
/// spacing in y is then that in x. Integers are signed, as in openGPS and Gwyddion, unlike
/// SurfaceTopography. Ignored are name spaces of elements, the name of the root, and the folder of main.xml,
/// from which links lead. Checksums are optional but must be correct. Point clouds (PCL), axes with places of
/// their own and more than one layer are refused. main.xml without its DataList may have 1 MiB, and
/// md5checksum.hex 64 KiB.
///
/// Memory    of reading, twice the map, and main.xml. A DataList is parsed in pieces.
///
/// Files are written with doubles, NaN for missing points, and uncompressed: deflate saves only 4 % for a
/// measured surface. A single line along x is written as a profile, which Gwyddion 2.62 does not read.
///
/// ISO 25178-72:2017, Geometrical product specifications: Surface texture: Areal, part 72, XML file format
#include <vector>

#include <pugixml.hpp>

#include "core/module.hpp"
#include "formats/archive.hpp"
#include "formats/format.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"
#include "formats/x3p_head.hpp"

namespace asperity {
namespace {

using namespace x3p;

const std::string main_file = "main.xml", checksum_file = "md5checksum.hex", data_file = "bindata/data.bin";

constexpr std::size_t most_of_main = 1 << 20, most_of_checksums = 1 << 16;  // limits in bytes
constexpr std::string_view elsewhere = "@";  // replaces a list cut out of main.xml

[[noreturn]] void refuse_size(std::string_view name, std::size_t size) {
  refuse("{} claims {} bytes, more than is allowed", name, size);
}

// ---- main.xml ----

// What another program's archive is, and the way out.
[[noreturn]] void refuse_other(const ZipArchive& archive) {
  constexpr std::pair<std::string_view, std::string_view> kinds[] = {
      {".npy", "arrays of NumPy (npz), not X3P: save the map alone, by np.save"},
      {"xl/workbook", "a workbook of Excel, not X3P: save its sheet as text (CSV)"},
      {"content.xml", "an OpenDocument, not X3P: save its sheet as text (CSV)"}};
  const std::string name = archive.names().empty() ? "" : archive.names().front();
  for (const std::string& entry : archive.names())
    for (const auto& [part, words] : kinds)
      if (entry.find(part) != entry.npos) refuse("the archive holds {}", words);
  refuse(
      "the zip archive, with {}, is not X3P, for main.xml is missing: extract its map, or try Gwyddion if an "
      "instrument wrote it (`from` gwyddion)",
      quoted(name));
}

// Deflate compresses a list of numbers less than 32-fold, but endless equal elements a thousandfold.
std::string read_main(const ZipArchive& archive, const MemoryBound& memory) {
  if (!archive.has(main_file)) refuse_other(archive);
  const auto [index, size, stored] = archive.entry(main_file);
  if (size > most_of_main + 32 * stored) refuse_size(main_file, size);
  memory.require(static_cast<double>(size), "map");
  return archive.read(main_file);
}

void check_md5(std::string_view digits, std::string_view expected, std::string_view name,
               std::string_view way_out = "") {
  if (lower(expected) != digits) refuse("{} is damaged: its checksum is wrong{}", name, way_out);
}

// Each line is a checksum and a file name; other programs put an asterisk or a path before the name.
void check_main(const ZipArchive& archive, std::string_view main) {
  if (!archive.has(checksum_file)) return;
  if (const std::size_t size = archive.entry(checksum_file).size; size > most_of_checksums)
    refuse_size(checksum_file, size);
  const std::string list = archive.read(checksum_file), found = md5_of(main);
  for (std::string_view rest = list; !rest.empty();) {
    const std::string_view line = trimmed(take_line(rest)),
                           digits = line.substr(0, line.find_first_of(" \t*"));
    if (line.empty()) continue;
    if (digits.size() == line.size() || line.ends_with(main_file))
      check_md5(found, digits, main_file, " (was it edited? Then leave out md5checksum.hex)");
  }
}

// ---- the numbers ----

// An entry that must have `bytes` bytes, and the checksum if there is one.
std::string linked(const ZipArchive& archive, const std::string& name, std::size_t bytes,
                   std::string_view checksum) {
  const std::size_t size = archive.entry(name).size;
  if (size != bytes) refuse("'{:.64}' has {} bytes, the map needs {}", name, size, bytes);
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
  check_shape(head.shape, archive.entry(name).size / width);
  memory.require_map(head.shape, "map");
  const auto cells = static_cast<std::size_t>(head.shape.cells());
  Field out = field_from(linked(archive, name, cells * width, text_of_child(link, "MD5ChecksumPointData")),
                         head.shape, {head.type});
  if (!mask.empty())
    leave_out_invalid(out,
                      linked(archive, mask, (cells + 7) / 8, text_of_child(link, "MD5ChecksumValidPoints")));
  return out;
}

// The height is the last number of a Datum, after semicolons.
double datum(std::string_view text) {
  text = trimmed(text.substr(text.find_last_of(';') + 1));
  if (text.empty()) return Map::unknown;
  const auto number = number_of(text);
  if (!number) refuse("Datum {} in main.xml is not a number", quoted(text));
  return *number;
}

// From the node of the list, or from `list` if it was cut out.
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
  check_shape(shape, values.size());
  if (static_cast<std::size_t>(shape.cells()) != values.size())
    refuse("main.xml lists {} points, its header gives {} x {}", values.size(), shape.nx, shape.ny);
  return Eigen::Map<const Field>(values.data(), shape.ny, shape.nx).transpose();
}

bool is_x3p(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

Map decode_x3p(std::string_view bytes, const Reading& reading) {
  const std::unique_ptr<const ZipArchive> opened = ZipArchive::open(bytes, main_file);
  const ZipArchive& archive = *opened;
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
    refuse("main.xml is not valid XML: {}", parsed.description());
  const pugi::xml_node root = document.document_element(), third = child(root, "Record3"),
                       link = child(third, "DataLink");
  if (link && child(third, "DataList")) refuse("main.xml has both a DataLink and a DataList: omit one");
  const Head head = head_of(root);
  Map map{.values = link ? values_linked(archive, link, head, memory)
                         : values_listed(child(third, "DataList"), list, head.shape, memory),
          .spacing = head.spacing,
          .units = "m",
          .understood = head.understood};
  leave_out_infinite(map);
  make_heights(map, head);
  require_finite(map);
  return map;
}

// ---- writing ----

// Takes the kind, two spacings, two numbers of points, the data file, its checksum, and the checksum file.
constexpr char main_form[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n"
    "<Record1>\n<Revision>ISO5436 - 2000</Revision>\n<FeatureType>{}</FeatureType>\n<Axes>\n"
    "<CX>\n<AxisType>I</AxisType>\n<DataType>D</DataType>\n<Increment>{}</Increment>\n<Offset>0</Offset>\n</"
    "CX>\n"
    "<CY>\n<AxisType>I</AxisType>\n<DataType>D</DataType>\n<Increment>{}</Increment>\n<Offset>0</Offset>\n</"
    "CY>\n"
    "<CZ>\n<AxisType>A</AxisType>\n<DataType>D</DataType>\n</CZ>\n</Axes>\n</Record1>\n<Record3>\n"
    "<MatrixDimension>\n<SizeX>{}</SizeX>\n<SizeY>{}</SizeY>\n<SizeZ>1</SizeZ>\n</MatrixDimension>\n"
    "<DataLink>\n<PointDataLink>{}</PointDataLink>\n<MD5ChecksumPointData>{}</MD5ChecksumPointData>\n</"
    "DataLink>\n"
    "</Record3>\n<Record4>\n<ChecksumFile>{}</ChecksumFile>\n</Record4>\n</p:ISO5436_2>\n";

std::string encode_x3p(const Map& map, Order) {
  check_heights(map, "X3P");
  const std::string data = bytes_of(map.values);
  const std::string main = fmt::format(main_form, map.values.cols() == 1 ? "PRF" : "SUR",
                                       shortest(map.spacing[0]), shortest(map.spacing[1]), map.values.rows(),
                                       map.values.cols(), data_file, md5_of(data), checksum_file);
  const std::string checksum = fmt::format("{} *{}\n", md5_of(main), main_file);
  const ZipEntry entries[] = {{main_file, main}, {data_file, data}, {checksum_file, checksum}};
  return zip_of(entries);
}

}  // namespace

std::unique_ptr<ZipArchive> ZipArchive::open(std::string_view bytes, std::string_view top) {
  static const auto open_zip = ASPERITY_FROM_MODULE("asperity_zip", asperity_open_zip);
  std::unique_ptr<ZipArchive> out;
  open_zip(bytes, top, out);
  return out;
}

std::string zip_of(std::span<const ZipEntry> entries) {
  static const auto make_zip = ASPERITY_FROM_MODULE("asperity_zip", asperity_make_zip);
  std::string out;
  make_zip(entries, out);
  return out;
}

const Format format::x3p{"x3p", "x3p", "X3P, ISO 5436-2 and ISO 25178-72", is_x3p, decode_x3p, encode_x3p};

}  // namespace asperity
