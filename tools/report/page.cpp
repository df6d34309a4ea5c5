#include "tools/report/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "dataset/layout.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/report/fields.hpp"
#include "tools/report/html.hpp"
#include "tools/report/parts.hpp"

namespace asperity::report {
namespace {

constexpr std::pair<const char*, const char*> stages[] = {{"kernel", "Autocorrelation and kernel"},
                                                          {"generate", "Surface"},
                                                          {"filter", "Filter"},
                                                          {"contact", "Contact"},
                                                          {"stress", "Stress below the surface"}};

constexpr std::string_view style = {
#include "page.css.inc"
};
constexpr std::string_view script = {
#include "page.js.inc"
};
constexpr std::string_view script_of_field = {
#include "field.js.inc"
};

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
  if (data.has("pressure"))
    out.push_back(c.flow.dataset.empty() ? "a contact" : "a contact with plastic flow");
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

std::string tile(const char* label, const std::string& text, const std::string& note) {
  return fmt::format("<div><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n", label, escaped(text),
                     escaped(note));
}

// A result with the error of the grid, where it has one, and what else there is to say.
std::string tile(const Attributes& a, const std::string& name, const char* label, const char* unit,
                 const std::string& note = "") {
  if (!a.find(name)) return "";
  const double error = a.number(name + "_error", NAN);
  const std::string known = error > 0 ? "± error of the grid" : note.empty() ? "no error known" : "";
  return tile(label, value_text(a.number(name, NAN), error, unit),
              known + (known.empty() || note.empty() ? "" : "; ") + note);
}

std::string tiles_of_surface(const Content& c) {
  std::string out;
  for (const auto& [name, label] : {std::pair{"Sq", "rms height Sq"}, {"Sdq", "rms slope Sdq"}})
    for (const Group& group : c.groups)
      for (const Parameter& row : group.rows)
        if (row.name == name && std::isfinite(row.value))
          out += tile(label, value_text(row),
                      std::isfinite(row.standard_error) ? "± standard error"
                      : row.note().empty()              ? "no error known"
                                                        : row.note());
  return out;
}

std::string tiles_of_contact(const Attributes& a) {
  std::string out;
  if (a.find("contact_area_corrected"))
    out += tile(a, "contact_area_corrected", "real contact area", "m2",
                value_text(a.number("contact_area", NAN), a.number("contact_area_error", NAN), "m2") +
                    " in whole cells");
  else
    out += tile(a, "contact_area", "real contact area", "m2", "whole cells");
  const std::string given = a.text("contact_prescribed");
  out +=
      tile(a, "contact_load", "load", "N", given == "load" || given == "mean_pressure" ? "prescribed" : "");
  out += tile(a, "contact_mean_pressure", "mean pressure", "Pa", "over the nominal area");
  const std::string highest = "contact_max_pressure", name = "maximum pressure";
  out += at_limit(a)
             ? tile(name.c_str(), value_text(a.number(highest, NAN), NAN, "Pa"), "the limit pressure itself")
             : tile(a, highest, name.c_str(), "Pa");
  return out + tile(a, "contact_approach", "approach", "m", given == "approach" ? "prescribed" : "");
}

std::string tiles_of_flow(const Content& c) {
  std::string out;
  if (c.flow.dataset.empty()) return out;
  const Attributes& a = c.dataset[0].data.attributes;
  const Values* dents = a.find("contact_dent");
  const double dent = dents && count(*dents) == 2 ? std::ranges::max(numbers(*dents)) : NAN,
               error = dent * a.number("contact_increment_error", NAN);
  out += tile("dent by plastic flow", value_text(dent, error, "m"),
              error > 0 ? "± error of the increments" : "no error known");
  for (const FlowVolume& v : c.flow.volumes)
    out += tile(v.words.c_str(), value_text(v.largest, NAN, v.unit), "at depth " + readable(v.depth, "m"));
  return out;
}

std::string tiles_of_stress(const Attributes& a) {
  const std::string depth = "at depth " + value_text(a.number("stress_max_depth", NAN),
                                                     a.number("stress_max_depth_error", NAN), "m");
  const double yield = a.number("contact_limit_pressure", INFINITY) / hardness,
               times = a.number("stress_max_von_mises", 0) / yield;
  return tile(a, "stress_max_von_mises", "largest von Mises stress", "Pa",
              depth + (times > 1 ? fmt::format("; {:.3g} times the yield stress", times) : "")) +
         tile(a, "stress_max_shear", "largest shear stress", "Pa", depth) +
         tile(a, "stress_max_principal", "largest principal stress", "Pa", depth);
}

// ---- tables ----

std::string parameters_of_surface(const Content& c) {
  if (c.groups.empty()) return "";
  std::string out = element("p",
                            "Measured from " + escaped(c.reference) +
                                ". Standard errors and 95\u00A0% intervals account for the correlation of "
                                "neighbouring points; an empty cell means that none is known.",
                            "soft");
  for (const Group& group : c.groups)
    out += folded(group.title, group.omitted.empty()
                                   ? measurements(group.rows)
                                   : element("p", "Not computed: " + escaped(group.omitted) + ".", "soft"));
  return out;
}

std::string by_stage(const Dataset& data, Role role, std::initializer_list<const char*> wanted) {
  std::string out;
  for (const auto& [stage, title] : stages)
    if (std::ranges::find(wanted, std::string_view(stage)) != wanted.end())
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

struct Section {
  const char* name;
  std::string title, content;
};

std::vector<Section> sections(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  const Figures shown = figures(c);
  const std::string of = c.groups.empty()
                             ? "Autocorrelation"
                             : "Statistics of " + (c.variable == "heights" ? "the surface" : c.variable);
  return {
      {"scene", "Material and load", by_stage(data, Role::parameter, {"contact", "stress"})},
      {"field", "Fields", viewer(data, c.fields) + shown.field},
      {"contact", "Contact",
       contact_results(data) + missing(c.no_grid_errors.contact) + contact_figures(data)},
      {"flow", "Plastic flow", missing(c.flow.unknown) + shown.flow},
      {"stress", "Stress below the surface",
       facts(data, Role::result, "stress") + missing(c.no_grid_errors.stress) + shown.stress},
      {"surface", of, shown.surface},
      {"parameters", "Measured parameters", parameters_of_surface(c)},
      {"accuracy", "Accuracy of the solvers",
       folded("Residuals, iterations, time",
              by_stage(data, Role::achieved, {"kernel", "generate", "contact", "stress"}))},
      {"making", "How the surface was made",
       folded("Parameters", by_stage(data, Role::parameter, {"kernel", "generate", "filter"}))},
      {"history", "History", history(data.attributes.text("history"))},
      {"contents", "Contents of the dataset", folded("Variables and other attributes", of_the_file(data))}};
}

std::string body(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  std::string links, content;
  for (const Section& s : sections(c)) {
    if (s.content.empty()) continue;
    links += fmt::format("<a href=\"#{}\">{}</a>\n", s.name, escaped(s.title));
    content +=
        fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", s.name, escaped(s.title), s.content);
  }
  const std::string tiles = tiles_of_surface(c) + tiles_of_contact(data.attributes) + tiles_of_flow(c) +
                            tiles_of_stress(data.attributes);
  return element("header", element("h1", escaped(c.title)) + element("p", escaped(what_it_is(c)), "soft")) +
         "<main>\n" + warnings(data, c.warned) + element("dl", tiles, "tiles") +
         fmt::format("<nav aria-label=\"Sections\">\n{}</nav>\n{}</main>\n", links, content) + foot(data);
}

}  // namespace

std::string page(const Content& content) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{}<script>\n{}{}</script>\n</body>\n</"
      "html>\n",
      escaped(content.title), style, body(content), script, script_of_field);
}

}  // namespace asperity::report
