#include "tools/report/page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "tools/cli/record.hpp"
#include "tools/report/facts.hpp"
#include "tools/report/html.hpp"
#include "tools/report/pictures.hpp"
#include "tools/report/readable.hpp"
#include "tools/report/style.hpp"
#include "tools/report/tables.hpp"

namespace asperity::report {
namespace {

struct Stage {
  const char *prefix, *title;
};
constexpr Stage stages[] = {{"kernel", "Autocorrelation and kernel"},
                            {"generate", "Surface"},
                            {"contact", "Contact"},
                            {"stress", "Stress below the surface"}};

std::string section(const std::string& title, const std::string& content) {
  return content.empty() ? "" : element("section", element("h2", escaped(title)) + content);
}

// ---- what the dataset is ----

std::vector<std::string> parts(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  std::vector<std::string> out;
  const bool drawn = data.attributes.find("generate_seed") != nullptr;
  if (!c.groups.empty())
    out.push_back(c.variable != "heights" ? "the field " + c.variable
                  : drawn                 ? "a drawn surface"
                                          : "a surface");
  if (data.has("kernel"))
    out.push_back(c.groups.empty() ? "a kernel and its autocorrelation"
                                   : "the kernel of its autocorrelation");
  if (data.has("pressure")) out.push_back("a contact");
  if (std::ranges::any_of(data.variables, [](const Variable& v) {
        const KnownResult* result = result_of_variable(v.name);
        return result && result->name == "stress";
      }))
    out.push_back(out.empty() ? "stress below a surface" : "the stress below it");
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
  return out + fmt::format(": {} × {} points of {} × {}, {} × {} in all{}.", grid.shape.nx, grid.shape.ny,
                           readable(grid.dx, "m"), readable(grid.dy, "m"), readable(grid.size_x(), "m"),
                           readable(grid.size_y(), "m"), grid.periodic ? ", periodic" : "");
}

// ---- the numbers that a reader looks for first ----

const cli::Quantities::Row* find_row(const Content& c, const std::string& name) {
  for (const Group& group : c.groups)
    for (const auto& row : group.rows)
      if (row.name == name) return &row;
  return nullptr;
}

std::string tile(const std::string& label, const std::string& text) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", label, escaped(text));
}

std::string tiles(const Content& c) {
  std::string out;
  if (const auto* row = find_row(c, "Sq")) {
    const Measurement m = readable(*row);
    out += tile("rms height Sq", m.value + (m.error.empty() ? "" : " ± " + m.error) + "\u00A0" + m.unit);
  }
  const Attributes& a = c.dataset[0].data.attributes;
  constexpr struct {
    const char *attribute, *label, *unit;
  } wanted[] = {{"contact_load", "load", "N"},
                {"contact_max_pressure", "largest pressure", "Pa"},
                {"contact_area", "real contact area", "m2"},
                {"stress_max_von_mises", "largest von Mises stress", "Pa"}};
  for (const auto& w : wanted)
    if (a.find(w.attribute)) out += tile(w.label, readable(a.number(w.attribute, NAN), w.unit));
  return out.empty() ? "" : element("dl", out, "tiles");
}

std::string warnings(const Dataset& data) {
  std::string out;
  for (const std::string& text : warnings_of(data))
    out += fmt::format("<p class=\"warning\" role=\"alert\">Warning: {}</p>\n", escaped(text));
  return out;
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
  const std::string untold =
      c.untold.empty()
          ? ""
          : element("p", "Warning: standard errors and intervals are " + escaped(c.untold) + ".", "warning");
  return untold +
         element("p",
                 "Measured above " + escaped(c.reference) +
                     ". Standard errors and 95\u00A0% intervals allow for the correlation of neighbouring "
                     "points; where a quantity has none, none is known.",
                 "soft") +
         out;
}

std::string by_stage(const std::vector<Fact>& list, Role role) {
  std::string out;
  for (const Stage& stage : stages) {
    const std::string table = facts(list, role, stage.prefix);
    if (!table.empty()) out += element("h3", stage.title) + table;
  }
  return out;
}

std::string of_the_file(const Dataset& data) {
  std::string out = contents(data), list = facts(other_attributes(data), Role::parameter, "");
  return list.empty() ? out : out + element("h3", "Other attributes") + list;
}

std::string foot(const Dataset& data) {
  const std::string source = data.attributes.text("source");
  return element("footer",
                 fmt::format("Reported {} by asperity-report {}{}", cli::timestamp(), cli::version(),
                             source.empty() ? "." : ". The dataset was written by " + escaped(source) + "."));
}

std::string body(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  const std::vector<Fact> list = facts_of(data);
  return element("header", element("h1", escaped(c.title)) + element("p", escaped(what_it_is(c)), "soft")) +
         warnings(data) + tiles(c) + section("Pictures", pictures(c.dataset, c.variable)) +
         section("Contact", contact_results(data)) +
         section("Stress below the surface", facts(list, Role::result, "stress")) +
         section(c.variable == "heights" ? "Surface" : "Field " + c.variable, parameters_of_surface(c)) +
         section("What the solvers achieved", by_stage(list, Role::achieved)) +
         section("Parameters in effect", by_stage(list, Role::parameter)) +
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
