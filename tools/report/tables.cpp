#include <cmath>
#include <numbers>

#include <fmt/ranges.h>

#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "tools/report/html.hpp"
#include "tools/report/parts.hpp"

namespace asperity::report {
namespace {

std::string data_element(double value, const std::string& text) {
  return std::isfinite(value) ? fmt::format("<data value=\"{}\">{}</data>", shortest(value), text) : text;
}

// An unknown bound leaves the interval open.
std::string interval(double low, double high, const Measurement& m) {
  const bool below = std::isfinite(low), above = std::isfinite(high);
  const std::string from = data_element(low, m.low), to = data_element(high, m.high);
  return below && above ? from + " to " + to : below ? "above " + from : above ? "below " + to : "";
}

std::string bound_in_si(double end) { return std::isfinite(end) ? shortest(end) : ""; }

// The unit that a column is shown in, and that of its exact values.
std::string unit_element(const std::string& si, const std::string& shown) {
  return fmt::format("<data value=\"{}\">{}</data>", escaped(si), escaped(shown));
}

std::string row_of(const Parameter& row) {
  const Measurement m = readable(row);
  const auto ends = row.interval_95();
  const bool known = !m.error.empty();
  const std::string note = row.note();
  std::string out =
      labelled(escaped(row.name), escaped(note.empty() ? row.meaning : row.meaning + "; " + note));
  out += cell((row.is_bound ? "&lt;\u00A0" : "") + data_element(row.value, m.value), "number");
  out += cell(known ? data_element(row.standard_error, m.error) : "", "number error");
  out += cell(known ? interval(ends.low, ends.high, m) : "", "number interval",
              known ? bound_in_si(ends.low) + "\t" + bound_in_si(ends.high) : "\t");
  return element("tr", out + cell(unit_element(row.unit, m.unit), "unit"));
}

// A result, the same of smooth bodies, and their ratio.
struct Comparison {
  const char* label;
  double value, smooth;
  const char* unit;
  double error = NAN;  // of the grid
  std::string remark = {};
};

std::string with_error(double value, double error, const std::string& unit) {
  if (!(error > 0)) return data_element(value, readable(value, unit));
  const Measurement m = readable(Parameter{"", value, unit, error, ""});
  return data_element(value, m.value) + " ± " + data_element(error, m.error) + "\u00A0" + m.unit;
}

std::string row_of(const Comparison& c, bool with_smooth) {
  std::string out = labelled(c.label, c.remark);
  out += cell(with_error(c.value, c.error, c.unit), "number",
              fmt::format("{}\t{}\t{}", shortest(c.value), c.error > 0 ? shortest(c.error) : "", c.unit));
  if (!with_smooth) return element("tr", out);
  const bool known = std::isfinite(c.smooth);
  out += cell(known ? data_element(c.smooth, readable(c.smooth, c.unit)) : "", "number smooth");
  out += cell(known ? digits_of(c.value / c.smooth) : "", "number ratio");
  return element("tr", out);
}

std::string share(double part, double whole, const char* of) {
  return part >= 0 && whole > 0 ? fmt::format("{:.3g}\u00A0% of {}", 100 * part / whole, of) : "";
}

struct Smooth {
  double area, stiffness;
};

// Hertz's; of a line contact by (8), (9) of contact/bodies.hpp, of a point contact from δ ~ Q^⅔.
template <class Value>
Smooth smooth_of(const Grid& grid, Value value) {
  const double b = value("hertz_half_width"), length = grid.periodic.x ? grid.size_x() : grid.size_y();
  if (b > 0)
    return {2 * b * length, std::numbers::pi * value("composite_modulus") * length /
                                (2 * std::log(2 * value("approach_datum") / b))};
  return {std::numbers::pi * value("hertz_radius_x") * value("hertz_radius_y"),
          1.5 * value("load") / value("hertz_approach")};
}

std::vector<Comparison> comparisons(const Dataset& data) {
  auto value = [&](const char* name) {
    return data.attributes.number(std::string("contact_") + name, std::nan(""));
  };
  const Grid grid = grid_of(data);
  const double area = value("area"), plastic = value("plastic_area");
  const Smooth smooth = smooth_of(grid, value);
  auto figure = [&](const char* label, const char* name, double of_smooth, const char* unit,
                    const std::string& remark = {}) {
    return Comparison{label, value(name), of_smooth, unit, value((std::string(name) + "_error").c_str()),
                      remark};
  };
  Comparison pressure = figure("maximum pressure", "max_pressure", value("hertz_pressure"), "Pa");
  if (at_limit(data.attributes)) pressure.error = NAN, pressure.remark = "the limit pressure itself";
  Comparison at_its_limit =
      figure("area at the limit pressure", "plastic_area", NAN, "m2", share(plastic, area, "the contact"));
  if (!std::isfinite(value("limit_pressure"))) at_its_limit.value = NAN;
  return {figure("load", "load", NAN, "N"),
          figure("approach", "approach", value("hertz_approach"), "m"),
          pressure,
          figure("real contact area", "area_corrected", smooth.area, "m2", "without the bias of whole cells"),
          figure("area of the cells in contact", "area", smooth.area, "m2",
                 share(area, grid.size_x() * grid.size_y(), "the domain")),
          at_its_limit,
          figure("mean gap", "mean_gap", NAN, "m"),
          figure("stiffness", "stiffness", smooth.stiffness, "N/m")};
}

}  // namespace

bool at_limit(const Attributes& a) {
  constexpr double round_off = 1e-12;
  return a.number("contact_max_pressure", 0) >=
         (1 - round_off) * a.number("contact_limit_pressure", INFINITY);
}

std::string measurements(const Parameters& rows) {
  std::string body;
  for (const auto& row : rows) body += row_of(row);
  return table({"quantity", "value", "standard error", "95\u00A0% interval|low_95\thigh_95", "unit"}, body,
               "measurements");
}

std::string contact_results(const Dataset& data) {
  if (!data.attributes.find("contact_load") || !data.has("x") || !data.has("y")) return "";
  const bool with_smooth = data.attributes.find("contact_hertz_pressure") != nullptr;
  std::string body;
  for (const Comparison& c : comparisons(data))
    if (std::isfinite(c.value)) body += row_of(c, with_smooth);
  const bool errors = data.attributes.find("contact_area_error") != nullptr;
  const char* value = errors ? "value ± error of the grid|value\terror\tunit" : "value|value\terror\tunit";
  if (!with_smooth) return table({"quantity", value}, body, "results");
  return table({"quantity", value, "smooth bodies (Hertz)", "ratio"}, body, "results");
}

std::string contents(const Dataset& data) {
  std::string body;
  for (const Variable& v : data.variables) {
    std::vector<std::string> lengths;
    for (const std::string& d : v.dimensions) lengths.push_back(fmt::format("{} = {}", d, data.length(d)));
    const std::string unit = v.attributes.text("units");
    body += element("tr", labelled(escaped(v.name), escaped(v.attributes.text("long_name"))) +
                              cell(escaped(fmt::format("{}", fmt::join(lengths, ", "))), "dimensions") +
                              cell(escaped(unit == "1" ? "" : unit), "unit"));
  }
  return table({"variable", "dimensions", "unit"}, body, "contents");
}

}  // namespace asperity::report
