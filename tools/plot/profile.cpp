#include <algorithm>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "tools/plot/curves.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {
namespace {

// The field along the section, within the range: a row per point, with position and value in SI.
Field trace_of(const Case& c, const std::string& variable, const Section& section, const Request& request) {
  Request along = request;
  (section.along_x ? along.y : along.x) = {-unlimited, unlimited};
  const Patch patch = patch_of(c.data, variable, along);
  const Field values = section.along_x ? patch.values : Field(patch.values.transpose());
  Field out(values.rows(), 2);
  for (Index k = 0; k < out.rows(); ++k)
    out.row(k) << (section.along_x ? patch.x_at(k) : patch.y_at(k)), values(k, section.index);
  if (out.rows() < 2)
    throw DataError(variable,
                    fmt::format("a profile along {} needs at least two points, found 1", section.along()));
  const auto there = out.col(1).isFinite().cast<int>().eval();
  if ((there.head(there.size() - 1) * there.tail(there.size() - 1)).maxCoeff() == 0)
    throw DataError(variable,
                    fmt::format("no two neighbouring points are there at {}: give another --section, "
                                "or draw a map",
                                section.label()));
  return out;
}

// The requested section; by default along both sides, or only along the side with more than one point.
std::vector<std::string> sections(const Request& request, const Dataset& data) {
  if (!request.section.empty()) return {request.section};
  const Shape shape = grid_of(data).shape;
  if (shape.ny < 2) return {"y=0"};
  if (shape.nx < 2) return {"x=0"};
  return {"y=0", "x=0"};
}

// Adds some room above and below, but none below zero for values that are never negative.
Range amid_room(Range r) {
  const double room = r.width() > 0 ? 0.06 * r.width() : 1;
  return {r.low == 0 ? 0 : r.low - room, r.high + room};
}

// A section of all cases.
struct Row {
  Section section;
  Curves curves = {};
};

std::vector<Row> rows_of(const Cases& cases, const std::string& variable, const Request& request) {
  std::vector<Row> out;
  for (const std::string& text : sections(request, cases[0].data)) {
    Row row{section_of(cases[0].data, text)};
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const Field trace = trace_of(cases[c], variable, section_of(cases[c].data, text), request);
      row.curves.line(trace.col(0), trace.col(1), line_colour(c));
    }
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace

Figure profile(const Cases& cases, const Request& request) {
  const std::string variable = request.variable_or("heights");
  const std::vector<Row> rows = rows_of(cases, variable, request);
  Range values = nothing;
  double reach = 0;
  for (const Row& row : rows) {
    values = united(values, row.curves.y);
    reach = std::max(reach, row.curves.x.magnitude());
  }
  const Quantity quantity = quantity_of(cases, variable);
  const Axis y = value_axis(request, values, amid_room(values), quantity, quantity.name);
  const Unit length = unit_for(reach, "m");
  Figure out{.aspect = rows.size() > 1 ? 0.32 : 0.45, .gap_y = 4.8};
  name_cases(out, cases);
  for (const auto& [section, curves] : rows) {
    Axis x = axis_of(curves.x, length, section.along());
    x.label += " at " + section.label();
    place(out.panels.emplace_back(), curves, x, y);
  }
  return out;
}

}  // namespace asperity::plot
