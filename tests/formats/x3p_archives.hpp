/// X3P files as other programs write them: deflated, with a name space and metadata; and as nobody should.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <zip.h>

#include "formats/format.hpp"
#include "formats/raster.hpp"
#include "formats/x3p_head.hpp"

namespace asperity::test {

using Entries = std::vector<std::pair<std::string, std::string>>;

/// A deflated archive.
inline std::string deflated(const Entries& entries) {
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_source_keep(target);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
  for (const auto& [name, bytes] : entries)
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, bytes.data(), bytes.size(), 0), 0);
  zip_close(archive);
  zip_stat_t stat;
  zip_source_stat(target, &stat);
  std::string out(stat.size, '\0');
  zip_source_open(target);
  zip_source_read(target, out.data(), out.size());
  zip_source_free(target);
  return out;
}

/// What main.xml says.
struct Description {
  std::string feature = "SUR", type = "D", z = "", rotation = "";  ///< z: further elements of CZ
  std::string size_x = "3", size_y = "2", size_z = "1", dx = "1.5e-006", dy = "+4E-6";
  std::string third = "";  ///< what follows MatrixDimension
};

inline std::string main_xml(const Description& d) {
  return "\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- from an instrument -->\n"
         "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\r\n<p:Record1><Revision>ISO5436 - "
         "2000</Revision><FeatureType>" +
         d.feature + "</FeatureType><Axes><CX><AxisType>I</AxisType><DataType>L</DataType><Increment> " +
         d.dx + " </Increment><Offset>7e-5</Offset></CX><CY><AxisType>I</AxisType><Increment>" + d.dy +
         "</Increment></CY><CZ><AxisType>A</AxisType><DataType>" + d.type + "</DataType>" + d.z + "</CZ>" +
         d.rotation +
         "</Axes></p:Record1><Record2><Comment>&lt;none&gt;</Comment></Record2><Record3>"
         "<MatrixDimension><SizeX>" +
         d.size_x + "</SizeX><SizeY>" + d.size_y + "</SizeY><SizeZ>" + d.size_z +
         "</SizeZ></MatrixDimension>" + d.third + "</Record3></p:ISO5436_2>";
}

inline std::string link(const std::string& data, const std::string& mask = "") {
  const std::string valid = mask.empty() ? ""
                                         : "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>"
                                           "<MD5ChecksumValidPoints>" +
                                               x3p::md5_of(mask) + "</MD5ChecksumValidPoints>";
  return "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>" +
         x3p::md5_of(data) + "</MD5ChecksumPointData>" + valid + "</DataLink>";
}

/// An archive of a description, its numbers and, if there is one, a mask.
inline std::string foreign_x3p(Description d, const std::string& data, const std::string& mask = "") {
  d.third = link(data, mask);
  const std::string main = main_xml(d);
  Entries entries{{"bindata/data.bin", data},
                  {"main.xml", main},
                  {"md5checksum.hex", x3p::md5_of(main) + " *main.xml\n"}};
  if (!mask.empty()) entries.emplace_back("bindata/valid.bin", mask);
  return deflated(entries);
}

/// 3 × 2 whole heights, and as a file of numbers of a type, x fastest.
inline Field whole_heights() {
  Field z(3, 2);
  z << 1, -2, 30, 400, -5, 32000;
  return z;
}

inline std::string numbers_of_type(NumberType type) {
  return bytes_of(whole_heights(), {type, std::endian::little, Order::yx});
}

inline Map decode(const std::string& bytes) { return format::x3p.decode(bytes, Order::xy); }

}  // namespace asperity::test
