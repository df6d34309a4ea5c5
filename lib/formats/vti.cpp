#include "formats/vti.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "formats/map.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

using Names = std::vector<std::string>;
using Points = std::vector<double>;

// ---- what the dataset holds ----

bool is_field(const Variable& v) { return v.dimensions == Names{"x", "y"}; }
bool is_volume(const Variable& v) { return v.dimensions == Names{"z", "x", "y"}; }
bool has_volumes(const Dataset& dataset) { return std::ranges::any_of(dataset.variables, is_volume); }

bool is_flags(const Variable& v) { return std::holds_alternative<std::vector<std::int8_t>>(v.values); }

Points ascending(Points points, const std::string& name) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i] > points[i - 1])) throw DataError(name, "its points do not ascend");
  return points;
}

Points coordinate_of(const Dataset& dataset, const std::string& name) {
  const Variable& axis = dataset.at(name);
  const double factor = factor_to("m", axis);
  Points out = present_numbers(axis);
  for (double& point : out) point *= factor;
  return ascending(std::move(out), name);
}

// Upwards, the deepest first.
Points heights_of_layers(const Dataset& dataset) {
  if (!has_volumes(dataset)) return {0.0};
  Points out = ascending(depths_of(dataset), "z");
  std::ranges::reverse(out);
  for (double& z : out) z = 0 - z;
  return out;
}

double step_of(const Points& points, double otherwise) {
  return points.size() < 2 ? otherwise
                           : (points.back() - points.front()) / static_cast<double>(points.size() - 1);
}

// Ranges of depths are sums of steps: far nearer than a millionth of one.
bool evenly_spaced(const Points& points) {
  const double step = step_of(points, 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(std::abs(points[i] - points.front() - static_cast<double>(i) * step) <= 1e-6 * step)) return false;
  return true;
}

// Into that of a field field_of converts; a volume keeps its own.
std::string unit_shown(const Variable& v) { return is_field(v) && !is_flags(v) ? si_unit_of(v) : unit_of(v); }

// Layer k of a variable; a field is its own only one.
Field layer_of(const Dataset& dataset, const Variable& variable, Index k) {
  if (is_field(variable) && !is_flags(variable))
    return field_of(dataset, variable.name, Missing::not_a_number);
  const Shape shape{dataset.length("x"), dataset.length("y")};
  const double missing = is_flags(variable) ? Map::unknown : mark_of(variable);
  return std::visit(
      [&](const auto& values) -> Field {
        using Matrix = Eigen::Array<typename std::decay_t<decltype(values)>::value_type, Eigen::Dynamic,
                                    Eigen::Dynamic, Eigen::RowMajor>;
        const Eigen::Map<const Matrix> layer(values.data() + k * shape.cells(), shape.nx, shape.ny);
        Field out = layer.template cast<double>();
        if (!std::isnan(missing)) out = (out == missing).select(Map::unknown, out);
        return out;
      },
      variable.values);
}

// ---- the arrays, and the bytes that follow the XML ----

using Arrays = std::vector<const Variable*>;

NumberType type_of(const Variable& v) { return is_flags(v) ? NumberType::int8 : NumberType::float64; }

// Of XML 1.0, which has no control characters, and none of ]]> but at the end of a section.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : one_line(text)) {
    const std::size_t at = std::string_view("&<>\"").find(c);
    constexpr std::string_view names[] = {"&amp;", "&lt;", "&gt;", "&quot;"};
    out += at == std::string_view::npos ? std::string_view(&c, 1) : names[at];
  }
  return out;
}

// Grows the XML; knows where in the appended bytes the next array stands.
class Document {
 public:
  explicit Document(std::string_view kind)
      : kind_(kind),
        xml_(fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" "
                         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n",
                         kind)) {}

  Document& operator<<(std::string_view text) {
    xml_ += text;
    return *this;
  }
  void declare(std::string_view name, NumberType type, std::size_t tuples, std::string_view unit) {
    constexpr std::string_view key = "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">";
    xml_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"appended\" offset=\"{}\"",
        type == NumberType::int8 ? "Int8" : "Float64", escaped(name), tuples, offset_);
    xml_ +=
        unit.empty() ? "/>\n" : fmt::format(">\n{}{}</InformationKey>\n</DataArray>\n", key, escaped(unit));
    offset_ += sizeof(std::uint64_t) + tuples * size_of(type);
  }
  void begin_data() {
    xml_ += fmt::format("</{}>\n<AppendedData encoding=\"raw\">\n_", kind_);
    xml_.reserve(xml_.size() + offset_ + 64);
  }
  void begin_array(std::size_t bytes) {
    const auto raw = bytes_of(std::uint64_t{bytes}, std::endian::little);
    xml_.append(raw.data(), raw.size());
  }
  void append(const Field& layer, NumberType type = NumberType::float64) { xml_ += bytes_of(layer, {type}); }
  std::string take() { return std::move(xml_ += "\n</AppendedData>\n</VTKFile>\n"); }

 private:
  std::string kind_, xml_;
  std::size_t offset_ = 0;
};

struct Block {
  const Dataset& dataset;
  Points x, y, z;
  Arrays fields, volumes;

  explicit Block(const Dataset& data)
      : dataset(data), x(coordinate_of(data, "x")), y(coordinate_of(data, "y")), z(heights_of_layers(data)) {
    for (const Variable& v : data.variables) {
      const std::size_t tuples = x.size() * y.size() * (is_volume(v) ? z.size() : 1);
      if (std::holds_alternative<std::string>(v.values) || count(v.values) != tuples) continue;
      if (is_field(v)) fields.push_back(&v);
      if (is_volume(v)) volumes.push_back(&v);
    }
    if (fields.empty() && volumes.empty())
      throw DataError("dataset", "it has no field on (x, y) and no volume on (z, x, y)");
  }

  std::string extent() const {
    return fmt::format("0 {} 0 {} 0 {}", x.size() - 1, y.size() - 1, z.size() - 1);
  }
  void declare(Document& document, const Arrays& arrays) const {
    for (const Variable* v : arrays) document.declare(v->name, type_of(*v), count(v->values), unit_shown(*v));
  }
  void append(Document& document, const Arrays& arrays) const {
    for (const Variable* v : arrays) {
      document.begin_array(count(v->values) * size_of(type_of(*v)));
      const Index layers = is_volume(*v) ? static_cast<Index>(z.size()) : 1;
      for (Index k = layers; k-- > 0;) document.append(layer_of(dataset, *v, k), type_of(*v));
    }
  }
};

// `geometry` is what the element of the whole says of its points, unless their coordinates are listed.
std::string encode(const Block& block, std::string_view kind, std::string_view geometry, bool coordinates) {
  using Axes = std::vector<std::pair<const char*, const Points*>>;
  const Axes axes = coordinates ? Axes{{"x", &block.x}, {"y", &block.y}, {"z", &block.z}} : Axes{};
  Document document(kind);
  const bool volumes = !block.volumes.empty();
  document << fmt::format("<{} WholeExtent=\"{}\"{}>\n", kind, block.extent(), geometry);
  if (volumes && !block.fields.empty()) {
    document << "<FieldData>\n";
    block.declare(document, block.fields);
    document << "</FieldData>\n";
  }
  document << fmt::format("<Piece Extent=\"{}\">\n<PointData>\n", block.extent());
  block.declare(document, volumes ? block.volumes : block.fields);
  document << "</PointData>\n";
  if (coordinates) document << "<Coordinates>\n";
  for (const auto& [name, points] : axes) document.declare(name, NumberType::float64, points->size(), "m");
  document << (coordinates ? "</Coordinates>\n</Piece>\n" : "</Piece>\n");
  document.begin_data();
  block.append(document, block.fields);
  block.append(document, block.volumes);
  for (const auto& [name, points] : axes) {
    document.begin_array(points->size() * sizeof(double));
    document.append(Eigen::Map<const Field>(points->data(), 1, static_cast<Index>(points->size())));
  }
  return document.take();
}

}  // namespace

std::string encode_vti(const Dataset& dataset) {
  const Block block(dataset);
  const Grid grid = grid_of(dataset);
  if (!evenly_spaced(block.z))
    throw DataError("z",
                    "its depths are not evenly spaced, as image data needs: write a rectilinear grid, vtr");
  const std::string geometry = fmt::format(
      " Origin=\"{} {} {}\" Spacing=\"{} {} {}\"", shortest(block.x.front()), shortest(block.y.front()),
      shortest(block.z.front()), shortest(grid.dx), shortest(grid.dy), shortest(step_of(block.z, grid.dx)));
  return encode(block, "ImageData", geometry, false);
}

std::string encode_vtr(const Dataset& dataset) { return encode(Block(dataset), "RectilinearGrid", "", true); }

}  // namespace asperity
