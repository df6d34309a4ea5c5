#include "tools/stress/options.hpp"

#include <fmt/format.h>

#include "tools/cli/output_name.hpp"
#include "tools/cli/section.hpp"
#include "tools/cli/stream.hpp"
#include "tools/stress/quantity.hpp"

namespace asperity::cli {

void StressOptions::declare(Tool& tool) {
  const std::string where = "Where";
  tool.shares_ranks();
  surfaces.declare(tool);
  tool.text("--depths", depths, "DEPTHS",
            "Depths of the layers; 0:1mm:32 (equal steps), 0.5px:1mm:32:geometric (equal ratios) or "
            "0,10um,50um. px is the shorter side of a cell",
            where);
  tool.text("--section", section, "AXIS=PLACE",
            "Compute one vertical section only; y=0, x=0.2mm, or y=max: through the largest stress, that of "
            "--of. It runs through the nearest row of cells",
            where);
  declare_maximum(tool);
  tool.text("--points", points, "FILE",
            "Print a table of the stress at points instead; x, y and depth with their units on each line "
            "(1um 0 5um), or under a header with units, '# x [um] y [um] depth [um]'; - is standard input. "
            "On a side or corner of cells a stress that steps is the mean of theirs, if the load repeats "
            "along one axis at most",
            where);
  tool.choice(
      "--result", result, {"dataset", "maxima"},
      "Write the dataset, or print maxima. maxima: the largest stress in each layer of --depths, that of "
      "--of, and its place",
      "Result");
  declare_content(tool);
  declare_body(tool);
  tool.memory(
      "Memory limit for a result that goes into a pipe, which needs its range first; a larger one is "
      "computed again for each variable. Files receive their layers one by one");
  tool.output();
  tool.table();
  tool.report();
  tool.threads();
  tool.essential({"--depths", "--maximum", "--components", "--section", "--points", "--above", "--friction",
                  "--friction-angle", "--poisson", "--body", "--report", "--output"});
}

void StressOptions::declare_maximum(Tool& tool) {
  const std::string where = "Where";
  tool.flag("--maximum", maximum,
            "Search for the largest stress, its place and depth; --depths are not needed", where);
  tool.choice("--of", of, {"von_mises", "max_shear", "principal"},
              "Stress of --maximum and of --result maxima; von_mises, max_shear: by Tresca, or principal: "
              "the largest one, positive in tension",
              where);
  tool.text(
      "--below", below, "DEPTH",
      "Depth from which on --maximum searches; 2px, 10um. px is the shorter side of a cell. Default: the "
      "surface",
      where);
  tool.words("--add", add, {"grid_errors"},
             "Further results to write; grid_errors: by how much the grid may put the value and the depth of "
             "--maximum off, from the contact on half and a quarter as many cells a side",
             where);
}

void StressOptions::declare_content(Tool& tool) {
  const std::string content = "What";
  tool.text("--components", components, "LIST",
            "Quantities to compute; all: every stress, without directions. One or more of " + stress_words(),
            content);
  tool.text("--above", above, "STRESS",
            "Leave out stresses of smaller magnitude; 100MPa, 0.1p0 (of the Hertz pressure) or 0.1pmax (of "
            "the largest contact pressure). They become _FillValue",
            content);
  tool.choice("--resolution", resolution, {"adapted", "full"},
              "Cells of deep layers; adapted: wider ones where they suffice; full: all of them", content);
}

void StressOptions::declare_body(Tool& tool) {
  const std::string which = "Body", load = "Friction";
  tool.number("--poisson", poisson, "Poisson's ratio in place of the dataset's", which);
  tool.integer("--body", body, {1, 2}, "Body whose Poisson's ratio is taken from the dataset, 1 or 2", which);
  const Option slides =
      tool.number("--friction", friction,
                  "Coefficient of friction; a traction of this share of the pressure acts too", load);
  tool.text("--friction-angle", friction_angle, "ANGLE",
            "Direction in which the other body slides, from +x towards +y: 30deg, 0.5rad", load)
      .needs(slides);
}

namespace {

void refuse_if(bool wrong, const char* option, const std::string& why) {
  if (wrong) throw UsageError(option, why);
}

}  // namespace

void StressOptions::check(Tool& tool) {
  check_content(tool);
  check_ranks(tool);
  threads = tool.thread_count();
  memory = tool.memory_bound();
  if (!above.empty()) static_cast<void>(StressBound(above));
  refuse_if(points == "-" && surfaces.takes_standard_input(), "points",
            "standard input is the dataset: name a file");
  surfaces_ = surfaces.resolve(tool);
  check_output(tool);
}

void StressOptions::check_content(const Tool& tool) const {
  const bool layers = !depths.empty(), maxima = result == "maxima", table = maxima || !points.empty();
  const bool searches = maximum || through_maximum(section);
  refuse_if(!layers && points.empty() && !maximum, "depths", "is required, or --maximum or --points");
  refuse_if(!points.empty() && (layers || maximum || maxima), "points",
            "cannot be combined with --depths, --maximum or --result maxima");
  refuse_if(maxima && !layers, "result", "maxima needs --depths");
  for (const char* option : {"--maximum", "--section", "--above", "--below", "--components", "--report"})
    refuse_if(maxima && tool.given(option), option + 2, "cannot be combined with --result maxima");
  refuse_if(adds("grid_errors") && !maximum, "add", "grid_errors needs --maximum");
  refuse_if(!layers && tool.given("--section"), "section", "needs --depths");
  refuse_if(!layers && tool.given("--above"), "above", "needs --depths");
  refuse_if(!layers && !table && tool.given("--components"), "components", "needs --depths or --points");
  refuse_if(!searches && !maxima && tool.given("--of"), "of", "needs --maximum or --result maxima");
  refuse_if(!searches && tool.given("--below"), "below", "needs --maximum");
}

// Several ranks share one body: what needs the whole field at each place, or further contacts, is refused.
void StressOptions::check_ranks(const Tool& tool) const {
  if (tool.ranks().count() == 1) return;
  const std::string why = fmt::format("by {} ranks: start one process", tool.ranks().count());
  refuse_if(!points.empty(), "points", "cannot be computed " + why);
  refuse_if(adds("grid_errors"), "add", "grid_errors cannot be computed " + why);
}

void StressOptions::check_output(Tool& tool) const {
  const bool table = prints_table();
  refuse_if(several() && !points.empty(), "points", "are those of one surface, but INPUT names several");
  refuse_if(several() && !depths.empty() && result != "maxima", "depths",
            "writes the dataset of one surface, but INPUT names several: use --maximum or --result maxima");
  refuse_if(!table && tool.json(), "json",
            "prints a table: add --points or --result maxima, or leave --json out");
  refuse_if(table && tool.given("--report"), "report", "belongs to a dataset, but a table is printed");
  tool.writes_dataset(!table);
  table ? check_table_name(tool.output_name(), tool.json()) : check_dataset_name(tool.output_name());
  if (!table) refuse_terminal(tool.output_name());
}

}  // namespace asperity::cli
