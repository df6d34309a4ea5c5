#include "tools/stress/options.hpp"

#include <cmath>

#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"
#include "tools/stress/quantity.hpp"

namespace asperity::cli {
void StressOptions::declare(Tool& tool) {
  const std::string where = "Where", content = "What";
  tool.input();
  tool.text(
      "--depths", depths, "DEPTHS",
      "Layers: FROM:TO:COUNT, such as 0:1mm:32 at equal steps or 0.5px:1mm:32:geometric at equal ratios, or "
      "0,10um,50um; px is the shorter side of a cell",
      where);
  tool.text("--section", section, "PLANE",
            "Of the layers only a vertical plane, y=0 or x=0.2mm: through the cell centres nearest to it",
            where);
  tool.flag("--maximum", maximum,
            "Search for the largest von Mises stress, its place and depth; needs no --depths", where);
  tool.text(
      "--points", points, "FILE",
      "A table of the stress at points instead: three lengths a line, x, y and depth, in metres or with "
      "their units; - is standard input",
      where);
  tool.text("--components", components, "LIST",
            "Of " + stress_words() + "; or all, the stresses without directions", content);
  tool.number(
      "--above", above,
      "Leave out stresses whose modulus is below this share of Hertz's pressure, or of the largest where "
      "there is none: they are _FillValue",
      content);
  tool.choice("--resolution", resolution, {"adapted", "full"},
              "Deep layers from wider cells, within 2e-6 of the largest pressure; or every one in full",
              content);
  declare_body(tool);
  tool.memory(
      "Largest result that is kept for a pipe, which needs its range first; a larger one is computed again "
      "for each variable. Into files layers go as they are made");
  tool.output();
  tool.table();
  tool.report();
  tool.threads();
}

void StressOptions::declare_body(Tool& tool) {
  const std::string which = "Body", load = "Friction";
  tool.number("--poisson", poisson, "Poisson's ratio, instead of the dataset's", which);
  tool.integer("--body", body, {1, 2}, "Which body's ratio to take from the dataset, 1 or 2", which);
  const Option slides =
      tool.number("--friction", friction,
                  "Coefficient of friction: a traction of so much of the pressure acts too", load);
  tool.text("--friction-angle", friction_angle, "ANGLE",
            "Its direction from x towards y, in which the other body slides: 30, 30deg, 0.5rad", load)
      .needs(slides);
}

void StressOptions::check(Tool& tool) const {
  const bool layers = !depths.empty(), table = !points.empty();
  auto refuse = [&](bool wrong, const char* option, const std::string& why) {
    if (wrong) throw UsageError(option, why);
  };
  refuse(!layers && !table && !maximum, "depths", "is needed, or --maximum or --points");
  refuse(table && (layers || maximum), "points", "is a table of its own: no --depths and no --maximum");
  refuse(!layers && tool.given("--section"), "section", "needs --depths");
  refuse(!layers && tool.given("--above"), "above", "needs --depths");
  refuse(!layers && !table && tool.given("--components"), "components", "needs --depths or --points");
  refuse(tool.given("--above") && !(above > 0 && std::isfinite(above)), "above", "it must be positive");
  refuse(!table && tool.json(), "json", "prints the table of --points, which is not given");
  refuse(table && tool.given("--report"), "report", "is of a dataset; --points is a table");
  refuse(points == "-" && tool.input_name() == "-", "points", "standard input is the dataset already");
  tool.writes_dataset(!table);
  table ? check_table_name(tool.output_name(), tool.json()) : check_dataset_name(tool.output_name());
  if (!table) refuse_terminal(tool.output_name());
}

}  // namespace asperity::cli
