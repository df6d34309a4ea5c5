/// Datasets for ParaView: VTK's XML image data (.vti), or a rectilinear grid (.vtr) for uneven depths.
///
/// Points are the cell centres in metres. A depth becomes the height -z, so that the body lies below its
/// surface and x, y, z are right-handed. Numbers are raw and little-endian, appended to the XML after lengths
/// of 64 bits: doubles, or Int8 for masks and flags; missing points are NaN. Each array has its unit as
/// vtkDataArray::UNITS_LABEL.
///
/// In a dataset with volumes (z, x, y) these are the point data; fields (x, y) belong to no layer and become
/// field data, nx·ny numbers each, x fastest. A dataset without volumes becomes one layer at z = 0 with the
/// fields as point data. Stress components remain separate arrays (stress_xx, …).
///
/// Memory    the bytes of the file, and one layer.
///
/// VTK File Formats, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "dataset/unread.hpp"
#include "formats/format.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

using Names = std::vector<std::string>;
using Points = std::vector<double>;

// ---- content of the dataset ----

bool is_field(const Variable& v) { return v.dimensions == Names{"x", "y"}; }
bool is_volume(const Variable& v) { return v.dimensions == Names{"z", "x", "y"}; }
bool has_volumes(const Dataset& dataset) { return std::ranges::any_of(dataset.variables, is_volume); }

bool is_flags(const Variable& v) { return std::holds_alternative<std::vector<std::int8_t>>(v.values); }

Points ascending(Points points, const std::string& name) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i] > points[i - 1])) throw DataError(name, "coordinates are not in ascending order");
  return points;
}

Points coordinate_of(const Dataset& dataset, const std::string& name) {
  const Variable& axis = dataset.at(name);
  const double factor = factor_to("m", axis);
  Points out = present_numbers(axis);
  for (double& point : out) point *= factor;
  return ascending(std::move(out), name);
}

// Heights, with the deepest layer first.
Points heights_of_layers(const Dataset& dataset) {
  if (!has_volumes(dataset)) return {0.0};
  Points out = ascending(depths_of(dataset), "z");
  std::ranges::reverse(out);
  for (double& z : out) z = 0 - z;
  return out;
}

double depth_step(const Points& points, double otherwise) {
  return points.size() < 2 ? otherwise
                           : (points.back() - points.front()) / static_cast<double>(points.size() - 1);
}

// Ranges of depths are sums of steps, with errors far below a millionth of a step.
bool evenly_spaced(const Points& points) {
  const double step = depth_step(points, 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(std::abs(points[i] - points.front() - static_cast<double>(i) * step) <= 1e-6 * step)) return false;
  return true;
}

// The unit of a field after field_of; a volume keeps its own.
std::string unit_shown(const Variable& v) { return is_field(v) && !is_flags(v) ? si_unit_of(v) : unit_of(v); }

// Layer k of a variable; a field has a single layer.
Field layer_of(const Dataset& dataset, const Variable& variable, Index k) {
  if (is_field(variable) && !is_flags(variable))
    return field_of(dataset, variable.name, Missing::not_a_number);
  const Shape shape{dataset.length("x"), dataset.length("y")};
  const double missing = is_flags(variable) ? Map::unknown : mark_of(variable);
  return std::visit(
      [&](const auto& values) -> Field {
        using Matrix = Eigen::Array<typename std::decay_t<decltype(values)>::value_type, Eigen::Dynamic,
                                    Eigen::Dynamic, Eigen::RowMajor>;
        const Eigen::Map<const Matrix> layer(values.data(), shape.nx, shape.ny);
        Field out = layer.template cast<double>();
        if (!std::isnan(missing)) out = (out == missing).select(Map::unknown, out);
        return out;
      },
      values_of(variable, static_cast<std::size_t>(k * shape.cells()),
                static_cast<std::size_t>(shape.cells())));
}

// ---- the arrays and the bytes after the XML ----

// Its numbers are computed when written, one layer at a time.
struct Array {
  std::string name, unit;
  NumberType type;
  std::size_t tuples;
  Index layers;
  std::function<Field(Index layer)> layer;
};
using Arrays = std::vector<Array>;

struct Block {
  Points x, y, z;
  Arrays fields, volumes;

  explicit Block(const Dataset& data)
      : x(coordinate_of(data, "x")), y(coordinate_of(data, "y")), z(heights_of_layers(data)) {
    for (const Variable& v : data.variables) {
      const std::size_t layers = is_volume(v) ? z.size() : 1, tuples = x.size() * y.size() * layers;
      if (std::holds_alternative<std::string>(v.values) || count(v) != tuples) continue;
      if (!is_field(v) && !is_volume(v)) continue;
      (is_volume(v) ? volumes : fields)
          .push_back({v.name, unit_shown(v), is_flags(v) ? NumberType::int8 : NumberType::float64, tuples,
                      static_cast<Index>(layers), [&](Index k) { return layer_of(data, v, k); }});
    }
    if (fields.empty() && volumes.empty())
      throw DataError("dataset", "the dataset has no field on (x, y) and no volume on (z, x, y)");
  }

  std::string extent() const {
    return fmt::format("0 {} 0 {} 0 {}", x.size() - 1, y.size() - 1, z.size() - 1);
  }
};

Array coordinate(std::string name, const Points& points) {
  const auto all = [&](Index) {
    return Field(Eigen::Map<const Field>(points.data(), 1, static_cast<Index>(points.size())));
  };
  return {std::move(name), "m", NumberType::float64, points.size(), 1, all};
}

// For XML 1.0, which has no control characters and allows ]]> only at the end of a section.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : one_line(text)) {
    const std::size_t at = std::string_view("&<>\"").find(c);
    constexpr std::string_view names[] = {"&amp;", "&lt;", "&gt;", "&quot;"};
    out += at == std::string_view::npos ? std::string_view(&c, 1) : names[at];
  }
  return out;
}

// An element of arrays that begin at `place` in the appended bytes; moves `place` to their end.
std::string declared(std::string_view element, const Arrays& arrays, std::size_t& place) {
  std::string out = fmt::format("<{}>\n", element);
  for (const Array& a : arrays) {
    out += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"appended\" offset=\"{}\"",
        a.type == NumberType::int8 ? "Int8" : "Float64", escaped(a.name), a.tuples, place);
    out += a.unit.empty() ? "/>\n"
                          : fmt::format(
                                ">\n<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}"
                                "</InformationKey>\n</DataArray>\n",
                                escaped(a.unit));
    place += sizeof(std::uint64_t) + a.tuples * size_of(a.type);
  }
  return out + fmt::format("</{}>\n", element);
}

// `geometry` holds attributes of the grid element; empty if coordinates are listed.
std::string encode_block(const Block& block, std::string_view kind, std::string_view geometry,
                         const Arrays& coordinates) {
  const bool volumes = !block.volumes.empty();
  std::size_t size = 0;
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<{0} WholeExtent=\"{1}\"{2}>\n",
      kind, block.extent(), geometry);
  if (volumes && !block.fields.empty()) out += declared("FieldData", block.fields, size);
  out += fmt::format("<Piece Extent=\"{}\">\n", block.extent());
  out += declared("PointData", volumes ? block.volumes : block.fields, size);
  if (!coordinates.empty()) out += declared("Coordinates", coordinates, size);
  out += fmt::format("</Piece>\n</{}>\n<AppendedData encoding=\"raw\">\n_", kind);
  out.reserve(out.size() + size + 64);
  for (const Arrays* arrays : {&block.fields, &block.volumes, &coordinates})
    for (const Array& a : *arrays) {
      const auto bytes = bytes_of(std::uint64_t{a.tuples * size_of(a.type)}, std::endian::little);
      out.append(bytes.data(), bytes.size());
      for (Index k = a.layers; k-- > 0;) out += bytes_of(a.layer(k), {a.type});
    }
  return std::move(out += "\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace

std::string encode_vti(const Dataset& dataset) {
  const Block block(dataset);
  const Grid grid = grid_of(dataset);
  if (!evenly_spaced(block.z))
    throw DataError("z", "depths are not evenly spaced, which vti needs: write vtr");
  const std::string geometry =
      fmt::format(" Origin=\"{} {} {}\" Spacing=\"{} {} {}\"", shortest(block.x.front()),
                  shortest(block.y.front()), shortest(block.z.front()), shortest(grid.dx), shortest(grid.dy),
                  shortest(depth_step(block.z, grid.dx)));
  return encode_block(block, "ImageData", geometry, {});
}

std::string encode_vtr(const Dataset& dataset) {
  const Block block(dataset);
  return encode_block(block, "RectilinearGrid", "",
                      {coordinate("x", block.x), coordinate("y", block.y), coordinate("z", block.z)});
}

}  // namespace asperity
