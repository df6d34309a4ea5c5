// Converts surface maps between file formats.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "dataset/axis_order.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "formats/format.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/cli/tool.hpp"
#include "tools/convert/map_options.hpp"

using namespace asperity;

namespace {

// Formats for whole datasets besides NetCDF.
constexpr std::pair<std::string_view, std::string (*)(const Dataset&)> for_paraview[] = {{"vti", encode_vti},
                                                                                         {"vtr", encode_vtr}};

std::string extensions() {
  std::string out = ".nc, .vti, .vtr";
  for (const Format& format : formats())
    for (const std::string& word : cli::split(std::string(format.extensions), ' '))
      if (!word.empty() && out.find("." + word) == out.npos) out += ", ." + word;
  return out;
}

struct Options {
  std::string to = "auto", to_order = "xy", variable = "heights";
  bool surface = false;
  cli::MapOptions map;

  std::string target(const std::string& output) const {
    if (to != "auto") return to;
    const std::string extension = cli::extension_of(output);
    if (cli::names_dataset(extension)) return "netcdf";
    if (extension == "vti" || extension == "vtr") return extension;
    if (const Format* found = format_by_extension("." + extension)) return std::string(found->name);
    throw cli::UsageError(
        "output", "'" + output + "' has no known extension: use one of " + extensions() + ", or give --to");
  }
};

std::vector<std::string> targets() {
  std::vector<std::string> out{"auto", "netcdf", "vti", "vtr"};
  for (const Format& format : formats()) out.emplace_back(format.name);
  return out;
}

Dataset opened(const cli::Tool& tool, const Options& options, cli::Bytes bytes) {
  const MemoryBound left = tool.memory_bound(bytes.size());
  Dataset data = open_netcdf(std::move(bytes), left);
  tool.settle(data);
  return options.map.completed(std::move(data), options.variable, tool.format().order_of_matrix());
}

// As the options say, and as it will be read.
Map applied(const cli::Tool& tool, const Options& options, Map map) {
  Map out = options.map.applied(std::move(map));
  const auto [dx, dy] = out.spacing;
  if (dx > 0 && dy > 0)
    cli::warn_of_proportions(tool, Proportions(out.values, {shape_of(out.values), dx, dy}),
                             out.units.empty() ? "m" : out.units);
  return out;
}

Map map_from(const cli::Tool& tool, const cli::InputFormat& format, const Options& options,
             cli::Bytes bytes) {
  return applied(tool, options,
                 format.netcdf(bytes) ? map_of(opened(tool, options, std::move(bytes)), options.variable)
                                      : format.map(bytes, tool.input_name(), tool.memory_bound()));
}

// Everything except fields below the surface.
Dataset without_depth(Dataset data) {
  std::erase_if(data.variables, [](const Variable& v) { return std::ranges::count(v.dimensions, "z") > 0; });
  std::erase_if(data.dimensions, [](const Dimension& d) { return d.name == "z"; });
  return data;
}

// Whether --variable names a field that is not yet the map.
bool names_another(const cli::Tool& tool, const Dataset& data, const std::string& variable) {
  if (!tool.given("--variable")) return false;
  data.at(variable);
  return variable != "heights" && (variable != "values" || data.has("heights"));
}

// A dataset keeps everything unless its map changes.
Dataset dataset_from(const cli::Tool& tool, const cli::InputFormat& format, const Options& options,
                     std::optional<cli::Bytes> bytes) {
  if (!format.netcdf(*bytes)) {
    Dataset out = dataset_of(map_from(tool, format, options, std::move(*bytes)));
    for (const std::string& line : std::exchange(out.notes, {})) tool.note(line);
    return out;
  }
  Dataset data = opened(tool, options, std::move(*bytes));
  bytes.reset();
  const bool another = names_another(tool, data, options.variable);
  if (options.map.changes() || another)
    cli::replace_surface(tool, data, applied(tool, options, map_of(data, options.variable)), another);
  return options.surface ? without_depth(std::move(data)) : data;
}

bool says_periodic(const Dataset& data, const char* axis) {
  const Variable* const coordinate = data.find(axis);
  return coordinate != nullptr && coordinate->attributes.number("periodic", 0) != 0;
}

void note_periodic(const cli::Tool& tool, const std::string& target, bool periodic) {
  if (periodic) tool.note(target + " does not hold that the map is periodic");
}

// Every format except NetCDF.
std::string encoded(const cli::Tool& tool, const cli::InputFormat& format, const Options& options,
                    const std::string& target, std::optional<cli::Bytes> bytes) {
  for (const auto& [name, encode] : for_paraview)
    if (target == name) {
      const Dataset data = dataset_from(tool, format, options, std::move(bytes));
      note_periodic(tool, target, says_periodic(data, "x") || says_periodic(data, "y"));
      return encode(data);
    }
  if (options.surface)
    throw cli::UsageError("surface", "needs --to netcdf, vti or vtr: " + target + " holds one map only");
  const Map map = map_from(tool, format, options, std::move(*bytes));
  std::string out = format_named(target, "to").encode(map, options.to_order == "yx" ? Order::yx : Order::xy);
  for (const std::string& line : notes_of(map)) tool.note(line);
  note_periodic(tool, target, map.periodic.any());
  return out;
}

int convert(cli::Tool& tool, const Options& options) {
  const std::string target = options.target(tool.output_name());
  std::optional<cli::Bytes> bytes = cli::read_all(tool.input_name(), tool.memory_bound());
  cli::InputFormat format = tool.format();
  tool.reads(tool.input_name(), format.found(*bytes, tool.input_name()) == target);
  if (!format.netcdf(*bytes)) tool.detail(format.reason(*bytes, tool.input_name()));
  format.reading = options.map.reading(*bytes, format.found(*bytes, tool.input_name()));
  if (target == "netcdf") {
    Dataset data = dataset_from(tool, format, options, std::move(bytes));
    if (options.to_order == "yx") data = to_viewer_axes(std::move(data));
    tool.write(data);
    return cli::done;
  }
  const std::string out = encoded(tool, format, options, target, std::move(bytes));
  if (!is_text(out)) cli::refuse_terminal(tool.output_name(), target);
  tool.write_text(out);
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-convert",
      "Converts surface maps between file formats, and datasets for ParaView. Lengths and heights become "
      "metres. Missing points stay missing. A dataset keeps all its variables, but when its map gets another "
      "size or unit, or is another --variable, results of the former surface are dropped. asperity-filter "
      "levels, fills, crops or "
      "resamples a map.");
  Options o;
  tool.input();
  o.map.declare(tool);
  tool.choice("--to", o.to, targets(),
              "Format of the output; auto: from the extension of --output, else netcdf. vti and vtr are for "
              "ParaView; uneven depths need vtr",
              "Result");
  tool.choice(
      "--to-order", o.to_order, {"xy", "yx"},
      "Order of a bare matrix (text, npy); xy: a line for each x, yx: a line for each y. With netcdf, "
      "yx suits VTK, ParaView and other viewers: fields on (y, x), volumes on (z, y, x), z upwards",
      "Result");
  tool.flag("--surface", o.surface,
            "Omit fields below the surface; for netcdf, vti and vtr. vti and vtr then show the fields on "
            "(x, y) as one layer at z = 0 instead of as field data",
            "Result");
  tool.text("--variable", o.variable, "NAME", "Field on (x, y) to read; it becomes the map", "Result");
  tool.output_of_any_format();
  tool.example("asperity-convert map.x3p -o map.gsf");
  tool.essential({"INPUT", "-o", "--to", "--from", "--size", "--unit", "--variable", "--xyz", "--missing"});
  return tool.run(argc, argv, [&] { return convert(tool, o); });
}
