#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "tools/measure/height_tables.hpp"
#include "tools/plot/figure.hpp"
#include "tools/plot/layout.hpp"
#include "tools/report/fields.hpp"
#include "tools/report/html.hpp"
#include "tools/report/parts.hpp"

namespace asperity::report {
namespace {

constexpr Index most_of_map = 192;      // blocks along a side
constexpr double width_of_image = 720;  // pixels

// Curves that the pointer reads, a field in blocks, or a picture in pixels.
enum class Kind { curves, map, image };

struct Wanted {
  std::string title;
  plot::Figure (*describe)(const plot::Cases&, const plot::Request&);
  std::string variable;
  Kind kind = Kind::curves;
  std::vector<std::string_view> told = {};  // the parameters that its description gives
  std::string section = {};
};

bool is_field(const Dataset& data, const std::string& name) {
  const Variable* variable = data.find(name);
  return variable && variable->dimensions == std::vector<std::string>{"x", "y"};
}

// Through the largest stress if the volume gives its position.
Wanted section_of(const Dataset& data) {
  const bool placed = data.at("von_mises").dimensions.size() == 3 && data.attributes.find("stress_max_y");
  const std::string largest = data.length("x") < 2 ? "x=max" : "y=max";
  return {
      "Section of the von Mises stress", plot::section, "von_mises", Kind::image, {}, placed ? largest : ""};
}

bool live_section(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  return has_volume(data) && !c.fields.empty();
}

// What the live field replaces.
std::vector<Wanted> of_field(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  std::vector<Wanted> out;
  for (const std::string& name : c.fields)
    if (name == c.variable || name == "pressure")
      out.push_back({"Map of " + name, plot::map, name, Kind::map});
  if (is_field(data, c.variable) && !c.fields.empty())
    out.push_back({"Profiles of " + c.variable, plot::profile, c.variable});
  if (std::ranges::find(c.fields, "contact") != c.fields.end())
    out.push_back({"State of contact", plot::contact, "contact", Kind::map});
  if (live_section(c)) out.push_back(section_of(data));
  return out;
}

std::vector<Wanted> of_flow(const Content& c) {
  std::vector<Wanted> out;
  for (const FlowVolume& v : c.flow.volumes)
    out.push_back({"Section through the " + v.words, plot::section, v.variable, Kind::image, {}, v.section});
  return out;
}

std::vector<Wanted> of_stress(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  std::vector<Wanted> out;
  if (!data.has("von_mises")) return out;
  if (!live_section(c)) out.push_back(section_of(data));
  out.push_back({"Largest stress by depth", plot::maxima, "von_mises"});
  return out;
}

std::vector<Wanted> of_surface(const Content& c) {
  const Dataset& data = c.dataset[0].data;
  const std::string& v = c.variable;
  std::vector<Wanted> out;
  const bool field = is_field(data, v), whole = field && !cli::counted_cells(data, v);
  if (field && c.fields.empty()) out.push_back({"Profile of " + v, plot::profile, v});
  if (v == "heights" && (field || data.has("acf_achieved")))
    out.push_back({"Autocorrelation", plot::acf, "", Kind::curves, {"Sal", "Str"}});
  if (field) out.push_back({"Distribution of " + v, plot::pdf, v, Kind::curves, {"Sq", "Ssk", "Sku"}});
  if (whole) {  // of a part of the cells there is a distribution alone
    out.push_back({"Material ratio of " + v, plot::abbott, v, Kind::curves, {"Sk", "Spk", "Svk"}});
    out.push_back({"Spectra of " + v, plot::psd, v, Kind::curves, {"Sdq"}});
    out.push_back({"Quantiles of " + v, plot::qq, v, Kind::curves, {"Ssk", "Sku"}});
  }
  return out;
}

// ---- gnuplot's picture as an element of the page ----

std::string_view trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  return first == line.npos ? "" : line.substr(first);
}

// The page has the symbols once, no titles and names of gnuplot's, and no paper below.
std::string content_of(std::string_view svg, bool with_symbols) {
  std::vector<std::string_view> lines;
  bool symbols = false;
  for (std::string_view rest = svg.substr(svg.find("<g id=\"gnuplot_canvas\">")); !rest.empty();) {
    const auto end = std::min(rest.find('\n'), rest.size() - 1);
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    symbols = symbols || line.starts_with("<defs>");
    const bool empty = line == "</g>" && !lines.empty() && lines.back().starts_with("<g fill=");
    if (empty)
      lines.pop_back();
    else if (line.starts_with("<g id="))
      lines.emplace_back("<g>");
    else if (!line.empty() && line != "</svg>" && !line.starts_with("<rect x=\"0\" y=\"0\"") &&
             (with_symbols || !symbols))
      lines.push_back(line);
    symbols = symbols && !line.starts_with("</defs>");
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string key_of(const plot::Figure& figure) {
  std::string out = plot::line_colour(0) + std::string(" \n");  // of a figure of one curve
  for (const plot::LegendEntry& e : figure.legend)
    out += fmt::format("{} {}\n", e.colour == "black" ? "#000000" : e.colour, e.name);
  return out;
}

// Where page.js finds the axes.
std::string panels_of(const plot::Figure& figure, const plot::Layout& at) {
  std::string out;
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const auto& [label, x, y, commands, layers] = figure.panels[k];
    if (!x || !y) continue;
    const plot::Range across = plot::drawn(*x), up = plot::drawn(*y);
    out += fmt::format(
        "<rect class=\"panel\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" "
        "data-x=\"{} {}\" data-y=\"{} {}\" data-log=\"{}{}\" data-xlabel=\"{}\" data-ylabel=\"{}\"/>\n",
        at.x_of(k), static_cast<double>(at.pixels.ny) - at.y_of(k) - at.panel_height, at.panel_width,
        at.panel_height, across.low, across.high, up.low, up.high, x->logarithmic ? "x" : "",
        y->logarithmic ? "y" : "", escaped(x->label), escaped(y->label));
  }
  return out +
         "<circle class=\"ring\" r=\"9\" fill=\"none\" stroke=\"black\" stroke-width=\"3\" "
         "visibility=\"hidden\"/>\n";
}

std::string description(const Content& c, const Wanted& w, const plot::Figure& figure) {
  std::vector<std::string> words;
  for (const Group& group : c.groups)
    for (const Parameter& row : group.rows)
      if (std::ranges::find(w.told, row.name) != w.told.end() && std::isfinite(row.value))
        words.push_back(row.name + " " + value_text(row));
  if (words.empty() && !figure.title.empty()) words.push_back(figure.title);
  return escaped(fmt::format("{}{}{}", w.title, words.empty() ? "" : ": ", fmt::join(words, ", ")));
}

std::string image_of(const plot::Figure& figure, plot::Request request, const std::string& words) {
  const Shape full = plot::layout_of(figure, request).pixels;
  const double scale = width_of_image / static_cast<double>(full.nx);
  request.pixels = {std::lround(scale * static_cast<double>(full.nx)),
                    std::lround(scale * static_cast<double>(full.ny))};
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", words,
                     base64(plot::run_gnuplot(plot::script_of(figure, request)).bytes));
}

std::string svg_of(const plot::Figure& figure, const plot::Request& request, const std::string& words,
                   Kind kind, bool with_symbols) {
  const plot::Layout layout = plot::layout_of(figure, request);
  const std::string svg = plot::run_gnuplot(plot::script_of(figure, request)).bytes,
                    head = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\"",
                                       layout.pixels.nx, layout.pixels.ny, words),
                    content = content_of(svg, with_symbols);
  if (kind != Kind::curves) return head + ">" + content + "</svg>";
  return head + fmt::format(" data-key=\"{}\">{}{}</svg>", escaped(key_of(figure)), content,
                            panels_of(figure, layout));
}

std::string drawn(const Content& c, const plot::Cases& cases, const Wanted& w, bool with_symbols) {
  plot::Request request;
  request.variable = w.variable;
  request.section = w.section;
  request.format = w.kind == Kind::image ? "png" : "svg";
  request.most_blocks = most_of_map;
  const plot::Figure figure = w.describe(cases, request);
  const std::string words = description(c, w, figure);
  if (w.kind == Kind::image) return image_of(figure, request, words);
  return svg_of(figure, request, words, w.kind, with_symbols);
}

std::string gallery(const Content& c, const plot::Cases& cases, const std::vector<Wanted>& all,
                    const char* css_class, bool& with_symbols) {
  std::string shown, omitted;
  for (const Wanted& w : all) try {
      const std::string picture = drawn(c, cases, w, with_symbols);
      with_symbols = with_symbols && w.kind == Kind::image;
      const char* output = w.kind == Kind::curves ? "<output></output>" : "";
      shown += element("figure", picture + element("figcaption", escaped(w.title) + output));
    } catch (const DataError& error) {
      omitted +=
          element("p", escaped(w.title + " is not drawn: " + error.name + ": " + error.what() + "."), "soft");
    }
  return element("div", shown, css_class) + omitted;
}

}  // namespace

Figures figures(const Content& content) {
  bool with_symbols = true;  // once a page
  return {gallery(content, content.dataset, of_field(content), "figures still", with_symbols),
          gallery(content, content.measured, of_surface(content), "figures", with_symbols),
          gallery(content, content.flow.dataset, of_flow(content), "figures", with_symbols),
          gallery(content, content.dataset, of_stress(content), "figures", with_symbols)};
}

}  // namespace asperity::report
