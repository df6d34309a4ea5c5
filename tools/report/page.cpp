#include "tools/report/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/report/html.hpp"
#include "tools/report/parts.hpp"
#include "tools/report/style.hpp"

namespace asperity::report {
namespace {

constexpr std::pair<const char*, const char*> stages[] = {{"kernel", "Autocorrelation and kernel"},
                                                          {"generate", "Surface"},
                                                          {"contact", "Contact"},
                                                          {"stress", "Stress below the surface"}};

std::string section(const std::string& title, const std::string& content) {
  return content.empty() ? "" : element("section", element("h2", escaped(title)) + content);
}

// ---- description of the dataset ----

std::vector<std::string> parts(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  std::vector<std::string> out;
  const bool drawn = data.attributes.find("generate_seed") != nullptr;
  if (!c.groups.empty())
    out.push_back(c.variable != "heights" ? "the field " + c.variable
                  : drawn                 ? "a generated surface"
                                          : "a surface");
  if (data.has("kernel"))
    out.push_back(c.groups.empty() ? "a kernel and its autocorrelation"
                                   : "the kernel of its autocorrelation");
  if (data.has("pressure")) out.push_back("a contact");
  if (std::ranges::any_of(data.variables, [](const Variable& v) {
        const KnownResult* result = result_of_variable(v.name);
        return result && result->name == "stress";
      }))
    out.push_back(out.empty() ? "stress below a surface" : "the stress below the surface");
  return out;
}

std::string what_it_is(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  std::vector<std::string> list = parts(c);
  std::string out;
  for (std::size_t k = 0; k < list.size(); ++k)
    out += (k == 0 ? "" : k + 1 == list.size() ? " and " : ", ") + list[k];
  if (out.empty()) out = "a dataset";
  out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  if (!data.has("x") || !data.has("y")) return out + ".";
  const Grid grid = grid_of(data);
  return out + fmt::format(": {} × {} points, spacing {} × {}, size {} × {}{}.", grid.shape.nx, grid.shape.ny,
                           readable(grid.dx, "m"), readable(grid.dy, "m"), readable(grid.size_x(), "m"),
                           readable(grid.size_y(), "m"), cli::periodic_words(grid.periodic));
}

// ---- key numbers ----

std::string tile(const std::string& label, const std::string& text) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", label, escaped(text));
}

std::string tiles(const Content& c) {
  std::string out;
  for (const Group& group : c.groups)
    for (const Parameter& row : group.rows)
      if (row.name == "Sq") {
        const Measurement m = readable(row);
        out += tile("rms height Sq", m.value + (m.error.empty() ? "" : " ± " + m.error) + "\u00A0" + m.unit);
      }
  const Attributes& a = c.dataset[0].data.attributes;
  constexpr struct {
    const char *attribute, *label, *unit;
  } wanted[] = {{"contact_load", "load", "N"},
                {"contact_mean_pressure", "mean pressure", "Pa"},
                {"contact_max_pressure", "maximum pressure", "Pa"},
                {"contact_area", "real contact area", "m2"},
                {"stress_max_von_mises", "largest von Mises stress", "Pa"},
                {"stress_max_shear", "largest shear stress", "Pa"},
                {"stress_max_principal", "largest principal stress", "Pa"}};
  for (const auto& w : wanted)
    if (a.find(w.attribute)) out += tile(w.label, readable(a.number(w.attribute, NAN), w.unit));
  return element("dl", out, "tiles");
}

// ---- tables ----

std::string parameters_of_surface(const Content& c) {
  std::string out;
  for (const Group& group : c.groups) {
    out += element("h3", escaped(group.title));
    out += group.omitted.empty() ? measurements(group.rows)
                                 : element("p", "Not computed: " + escaped(group.omitted) + ".", "soft");
  }
  if (out.empty()) return "";
  std::string untold;
  if (!c.untold.empty())
    untold = element(
        "p", "Warning: no standard errors and intervals can be given: " + escaped(c.untold) + ".", "warning");
  return untold +
         element("p",
                 "Measured from " + escaped(c.reference) +
                     ". Standard errors and 95\u00A0% intervals account for the correlation of neighbouring "
                     "points; an empty cell means that none is known.",
                 "soft") +
         out;
}

std::string by_stage(const Dataset& data, Role role) {
  std::string out;
  for (const auto& [stage, title] : stages)
    if (const std::string table = facts(data, role, stage); !table.empty())
      out += element("h3", title) + table;
  return out;
}

std::string of_the_file(const Dataset& data) {
  const std::string others = other_attributes(data);
  return contents(data) + (others.empty() ? "" : element("h3", "Other attributes") + others);
}

std::string foot(const Dataset& data) {
  const std::string source = data.attributes.text("source");
  return element("footer",
                 fmt::format("Page written {} by asperity-report {}{}", cli::timestamp(), cli::version(),
                             source.empty() ? "." : ". The dataset was written by " + escaped(source) + "."));
}

std::string missing(const std::string& why) { return element("p", escaped(why), "soft"); }

std::string body(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  return element("header", element("h1", escaped(c.title)) + element("p", escaped(what_it_is(c)), "soft")) +
         warnings(data) + tiles(c) + section("Pictures", pictures(c.dataset, c.variable)) +
         section("Contact",
                 contact_results(data) + missing(c.no_grid_errors.contact) + contact_figures(data)) +
         section("Stress below the surface",
                 facts(data, Role::result, "stress") + missing(c.no_grid_errors.stress)) +
         section(c.variable == "heights" ? "Surface" : "Field " + c.variable, parameters_of_surface(c)) +
         section("Accuracy of the solvers", by_stage(data, Role::achieved)) +
         section("Parameters", by_stage(data, Role::parameter)) +
         section("History", history(data.attributes.text("history"))) +
         section("Contents of the dataset", of_the_file(data)) + foot(data);
}

}  // namespace

std::string page(const Content& content) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      escaped(content.title), style, body(content));
}

}  // namespace asperity::report
