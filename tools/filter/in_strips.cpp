#include "tools/filter/in_strips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "dataset/field_file.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "stats/filter/missing.hpp"
#include "tools/cli/dataset_stream.hpp"
#include "tools/cli/heights_words.hpp"
#include "tools/cli/large_file.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/measure/preparation_words.hpp"

namespace asperity::cli {
namespace {

constexpr double netcdf_fill = 9.969209968386869e36;  // NetCDF's own for doubles

template <class Visit>
void for_each_strip(const FieldParts& parts, std::size_t memory, Visit visit) {
  constexpr std::size_t bytes_a_point = 80;  // of a strip, with those it is made of
  const Index nx = parts.grid.shape.nx;
  const auto most = static_cast<Index>(memory / (bytes_a_point * size(parts.grid.shape.ny)));
  const Index rows = std::clamp<Index>(most, 1, nx);
  for (Index first = 0; first < nx; first += rows) visit(parts.rows(first, std::min(rows, nx - first)));
}

struct Survey {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool holes = false;

  void add(const Field& strip) {
    if (strip.isInf().any()) throw DataError("heights", "a value is infinite");
    holes = holes || has_missing(strip);
    if (strip.isNaN().all()) return;
    low = std::min(low, strip.minCoeff<Eigen::PropagateNumbers>());
    high = std::max(high, strip.maxCoeff<Eigen::PropagateNumbers>());
  }
};

// The head, in which the new map has no values yet.
void put_map(Dataset& data, const FieldParts& parts, const Survey& survey, const std::string& variable) {
  const Variable& former = data.at(variable);
  const std::string units = si_unit_of(former), title = former.attributes.text("long_name"),
                    name = units == "m" ? "heights" : "values";
  if (!(survey.low <= survey.high)) throw DataError(name, "all points are missing");
  drop_surface(data, "kernel");
  set_grid(data, parts.grid);
  defer_values(data, name, {"x", "y"}, {survey.low, survey.high}, {units, title.empty() ? name : title});
  if (survey.holes) data.find(name)->attributes.set("_FillValue", netcdf_fill);
}

}  // namespace

void filter_in_strips(Tool& tool, const Chain& chain, const std::string& path, const std::string& variable,
                      const std::string& output) {
  if (const std::string whole = chain.needs_whole_map(); !whole.empty()) refuse_strips(path, whole);
  const FieldFile file(path, variable, tool.memory_bound());
  Dataset data = file.dataset();
  tool.settle(data, path);
  FieldParts parts{file.grid(),
                   [&](Index first, Index count) { return file.rows(first, count); },
                   {},
                   removed_degree(data, variable)};
  const Inventory before(data);
  const std::vector<std::string> lines = chain(tool, parts, si_unit_of(data.at(variable)));
  const double share = filled_share(data, variable);
  Survey survey;
  Proportions proportions(parts.grid);
  for_each_strip(parts, tool.memory(), [&](const Field& strip) {
    survey.add(strip);
    proportions.add(strip);
  });
  warn_of_proportions(tool, proportions, si_unit_of(data.at(variable)));
  put_map(data, parts, survey, variable);
  set_preparation(data, parts.degree, share);
  before.tell(tool, data, "map");
  tool.sign(data, lines);
  DatasetStream out(output);
  out.head(data, 1);
  for_each_strip(parts, tool.memory(), [&](const Field& strip) {
    out.values(survey.holes ? Field(strip.isNaN().select(netcdf_fill, strip)) : strip);
  });
  out.close();
}

}  // namespace asperity::cli
