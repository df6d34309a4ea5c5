/// asperity-plot: figures of a dataset, drawn by gnuplot.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/cli/tool.hpp"
#include "tools/measure/stats_options.hpp"
#include "tools/plot/figure.hpp"
#include "tools/plot/source.hpp"
#include "tools/plot/table.hpp"

using namespace asperity;

namespace {

struct Kind {
  const char* name;
  plot::Figure (*describe)(const plot::Cases&, const plot::Request&);
};
constexpr Kind kinds[] = {{"map", plot::map},       {"surface", plot::surface},   {"profile", plot::profile},
                          {"acf", plot::acf},       {"psd", plot::psd},           {"pdf", plot::pdf},
                          {"qq", plot::qq},         {"abbott", plot::abbott},     {"contact", plot::contact},
                          {"sweep", plot::sweep},   {"von-mises", plot::section}, {"section", plot::section},
                          {"maxima", plot::maxima}, {"features", plot::features}};

std::vector<std::string> names_of_kinds() {
  std::vector<std::string> out;
  for (const Kind& kind : kinds) out.emplace_back(kind.name);
  return out;
}

struct Options {
  plot::Request request;
  std::vector<std::string> inputs{"-"};
  std::string output = "-", labels, scale_by, above, pruning = "5%";
  std::array<double, 2> x{-plot::unlimited, plot::unlimited}, y = x, depth{0, plot::unlimited};
};

void declare_figure(cli::Tool& tool, Options& o) {
  const std::string group = "Figure";
  tool.choice(
          "--kind", o.request.kind, names_of_kinds(),
          "Kind of figure; map: false colours, of a single row its profile; surface: perspective view; "
          "profile: heights along x and y; acf: autocorrelation and its target; psd: power spectral "
          "densities of rings and profiles; pdf: histogram and Gaussian; qq: heights against the quantiles "
          "of a Gaussian; abbott: material ratio curve with Sk, Spk and Svk; contact: contact states; "
          "sweep: load over approach and area over load, of the table of asperity-contact --sweep; "
          "von-mises: vertical section of this stress; section: vertical section of --variable; maxima: "
          "largest stress by depth, of a dataset or of the table of asperity-stress --result maxima; "
          "features: "
          "hills and peaks on the map, as asperity-stats --parameters feature has them",
          group)
      .required();
  tool.text(
      "--variable", o.request.variable, "NAME",
      "Field on (x, y) to draw, on (z, x, y) in a section: heights, pressure, stress_zz, ... Default: by "
      "--kind",
      group);
  tool.text("--section", o.request.section, "AXIS=PLACE",
            "Place of a section or profile; y=0, x=0.2mm, or y=max: through the largest von Mises stress, of "
            "several "
            "inputs each through its own; y=max-of-all: all through the largest of all. It runs through the "
            "nearest "
            "row of cells. Default: y=0, or x=0 of a single row; profiles along both",
            group);
  tool.may_be_empty(tool.text("--title", o.request.title, "TEXT",
                              "Title of the figure; \"\": none. Default: key values", group));
  tool.input_format();
  tool.text("--labels", o.labels, "A,B,...", "Names of the inputs in the figure. Default: file names", group);
  cli::pruning_option(tool, o.pruning, group);
  tool.flag("--scale-bar", o.request.scale_bar, "Draw a bar of a round length in place of the axes of a map",
            group);
}

void declare_sheet(cli::Tool& tool, Options& o) {
  const std::string group = "Figure";
  tool.integer("--columns", o.request.columns, 1,
               "Number of panels in a row; 1, 2, 3 are for print 8, 11.5, 15 cm wide. Default: one row",
               group)
      .without_default();
  tool.counts("--pixels", o.request.pixels, {200, 10'000, "at which a picture takes 400 MB"},
              "Size of the picture; letters grow with the width. For a PDF only the proportions count: it is "
              "8, 11.5 or 15 cm wide for 1, 2 or 3 columns. Default: fits the figure",
              group);
  tool.choice("--to", o.request.format, {"png", "svg", "pdf"},
              "Format on standard output; the name of a file decides its own", group);
  tool.text("-o,--output", o.output, "FILE.png|.svg|.pdf", "Output file; - is standard output", group)
      .required();
}

void declare_scales(cli::Tool& tool, Options& o) {
  const std::string group = "Scales";
  tool.quantities("--x-range", o.x, "m", "Lowest and highest x to draw", group).without_default();
  tool.quantities("--y-range", o.y, "m", "Lowest and highest y to draw", group).without_default();
  tool.quantities("--depth-range", o.depth, "m", "Lowest and highest depth to draw in a section", group)
      .without_default();
  tool.text(
      "--range", o.request.range, "LOW,HIGH",
      "Lowest and highest value of the colours or the axis, with unit; 1%:99%: colours of all values but 1 % "
      "at either end. Default: all values, of heights 0.5%:99.5% where that is less than an eighth of them",
      group);
  tool.choice("--scale-by", o.scale_by, {"p0"},
              "Divide stresses by this; p0: the Hertz pressure stored in the dataset", group);
  tool.text("--above", o.above, "STRESS",
            "Leave out smaller stresses of a section; 100MPa, 0.1p0 (of the Hertz pressure) or 0.1pmax (of "
            "the largest contact pressure)",
            group);
}

std::string extension_of(const std::string& output) {
  const std::string extension = std::filesystem::path(output).extension();
  return extension.empty() ? "" : extension.substr(1);
}

// From the file's name, or from --to for standard output, pipes and devices.
std::string format_of(const Options& o) {
  const bool stream = !cli::replaces_file(o.output), given = stream && !o.request.format.empty();
  const std::string format = given ? o.request.format : extension_of(o.output);
  if (format == "png" || format == "svg" || format == "pdf") {
    if (!stream && !o.request.format.empty() && o.request.format != format)
      cli::refuse("to", o.request.format, "contradicts the extension of " + o.output + ": omit it");
    return format;
  }
  if (stream) throw cli::UsageError("output", "'" + o.output + "' needs --to png, svg or pdf");
  cli::refuse("output", o.output, "does not end in .png, .svg or .pdf");
}

plot::Range rising(const char* option, std::array<double, 2> range) {
  if (!(range[0] < range[1]))
    throw cli::UsageError(option, "the lower bound, " + cli::format_quantity(range[0], "m") +
                                      ", is not below the upper bound, " +
                                      cli::format_quantity(range[1], "m"));
  return {range[0], range[1]};
}

// Each option and the kinds that it changes.
constexpr std::pair<const char*, std::string_view> uses[] = {
    {"variable", "map surface profile psd pdf qq abbott contact section von-mises maxima features"},
    {"pruning", "features"},
    {"section", "profile section von-mises"},
    {"scale-bar", "map contact features"},
    {"x-range", "map surface profile acf contact section von-mises features"},
    {"y-range", "map surface profile contact section von-mises features"},
    {"range", "map surface profile qq abbott section von-mises maxima features"},
    {"depth-range", "section von-mises maxima"},
    {"scale-by", "section von-mises maxima"},
    {"above", "section von-mises"},
    {"columns", "map surface acf pdf qq abbott contact section von-mises features"}};

void require_use(const cli::Tool& tool, const std::string& kind) {
  for (const auto& [option, kinds_with] : uses) {
    const bool used = (' ' + std::string(kinds_with) + ' ').find(' ' + kind + ' ') != std::string::npos;
    if (tool.given(std::string("--") + option) && !used)
      throw cli::UsageError(option, "cannot be combined with --kind " + kind + ", which does not use it");
  }
}

plot::Request request_of(const cli::Tool& tool, const Options& o) {
  plot::Request request = o.request;
  request.format = format_of(o);
  request.x = rising("x-range", o.x);
  request.y = rising("y-range", o.y);
  request.depth = rising("depth-range", o.depth);
  request.titled = tool.given("--title");
  request.scale_by_hertz = o.scale_by == "p0";
  if (!is_utf8(request.title)) throw cli::UsageError("title", "is not valid UTF-8");
  require_use(tool, request.kind);
  request.pruning = cli::parse_pruning(o.pruning);
  if (!o.above.empty()) request.above = cli::StressBound(o.above);
  cli::refuse_terminal(o.output, "a picture");
  return request;
}

std::vector<std::string> labels_of(const Options& o) {
  std::vector<std::string> out;
  if (o.labels.empty()) {
    for (const std::string& name : o.inputs)
      out.push_back(utf8_of(std::filesystem::path(name).stem().string()));
  } else {
    std::istringstream list(o.labels);
    for (std::string label; std::getline(list, label, ',');) out.push_back(label);
  }
  if (out.size() != o.inputs.size())
    throw cli::UsageError("labels", counted(std::ssize(out), "label") + " for " +
                                        counted(std::ssize(o.inputs), "input") + ": give one for each");
  if (!std::ranges::all_of(out, is_utf8)) throw cli::UsageError("labels", "is not valid UTF-8");
  return out;
}

// A dataset, or where a kind draws what the tools print, a table.
Dataset read(const cli::Tool& tool, const Options& o, const std::string& name, std::size_t held) {
  const bool tables = o.request.kind == "sweep" || o.request.kind == "maxima";
  if (!tables) return tool.read(name, held);
  const Bytes bytes = cli::read_all(name, tool.memory_bound(held));
  if (tool.format().netcdf(bytes)) return tool.read(bytes, name, held);
  tool.reads(name);
  return plot::dataset_of_table(bytes);
}

plot::Cases read_cases(const cli::Tool& tool, const Options& o) {
  constexpr std::size_t most = 6;
  if (o.inputs.size() > most)
    throw cli::UsageError("INPUT", std::to_string(o.inputs.size()) + " inputs do not fit in one figure: " +
                                       "give at most " + std::to_string(most));
  if (std::ranges::count(o.inputs, "-") > 1)
    throw cli::UsageError("INPUT", "standard input (-) can be given only once");
  if (std::ranges::count(o.inputs, "-") == 1 && cli::stdin_is_terminal())
    throw cli::UsageError("INPUT", "pipe a dataset in or name a file");
  const std::vector<std::string> labels = labels_of(o);
  plot::Cases out;
  std::size_t held = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    out.push_back({read(tool, o, o.inputs[i], held), labels[i]});
    held += out.back().data.size_in_memory();
  }
  return out;
}

// Of the first case with something to say; all have been drawn.
void warn_of_heights(const cli::Tool& tool, const plot::Request& request, const plot::Cases& cases) {
  constexpr std::string_view drawn_by = " map surface profile psd pdf qq abbott features ";
  if (request.variable_or("heights") != "heights" ||
      drawn_by.find(' ' + request.kind + ' ') == std::string_view::npos)
    return;
  for (const plot::Case& c : cases) {
    const Proportions of(field_of(c.data, "heights", Missing::not_a_number), grid_of(c.data));
    cli::warn_of_proportions(tool, of, si_unit_of(c.data.at("heights")));
    if (of.implausible()) return;
  }
}

int draw(cli::Tool& tool, const Options& options) {
  tool.writes("output", options.output);
  plot::Request request = request_of(tool, options);
  const plot::Cases cases = read_cases(tool, options);
  request.section = plot::section_of_all(cases, request.section);
  const auto* kind = std::ranges::find(kinds, request.kind, &Kind::name);
  const plot::Figure figure = kind->describe(cases, request);
  const plot::Picture picture = plot::run_gnuplot(plot::script_of(figure, request));
  if (!picture.remarks.empty()) tool.detail("gnuplot: " + picture.remarks);
  cli::write_all(options.output, picture.bytes);
  for (const std::string& note : figure.notes) tool.note(note);
  warn_of_heights(tool, request, cases);
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-plot", "Draws figures of one dataset, or of several side by side, with gnuplot");
  Options options;
  tool.arguments("INPUT", options.inputs, "FILE...",
                 "Datasets, or tables, to draw on shared scales; - is standard input");
  declare_figure(tool, options);
  declare_sheet(tool, options);
  declare_scales(tool, options);
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px --seed 7 "
      "| asperity-plot --kind map -o heights.png");
  tool.essential({"INPUT", "-o", "--kind", "--variable", "--section", "--x-range", "--y-range", "--range",
                  "--title", "--labels", "--columns", "--pixels"});
  return tool.run(argc, argv, [&] { return draw(tool, options); });
}
