// Writes a dataset as one HTML page: parameters, tables with errors, pictures, history.
#include <filesystem>
#include <optional>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "stats/measure.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/table.hpp"
#include "tools/cli/tool.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/report/page.hpp"

using namespace asperity;

namespace {

struct Options {
  cli::FieldOptions measured;
  std::string title, output = "-";
};

report::Group group_of(const cli::Tool& tool, const Sample& sample, const Preparation& preparation,
                       Group group, const std::string& title) try {
  const MeasureOptions options{.groups = {group}, .preparation = preparation};
  const Parameters rows = measure(sample, group, options);
  if (group == Group::spatial) warn_of_decays(tool, rows, options.sal_level, sample.grid());
  return {title, rows, missing(rows)};
} catch (const DataError& error) {
  return {title, {}, error.what()};
}

// A broken field is refused. Of a sound field, groups that cannot be computed give their reason instead.
std::vector<report::Group> groups_of(const cli::Tool& tool, const Dataset& data, const Options& o,
                                     std::string& why_untold) {
  const bool absent = !data.has(o.measured.variable) && !tool.given("--variable");
  if (absent) return {};
  field_of(data, o.measured.variable, Missing::not_a_number);
  std::optional<Sample> sample;
  try {
    sample.emplace(o.measured.read(tool, data), tool.thread_count());
  } catch (const DataError& error) {
    return {{"Height parameters", {}, error.what()}};
  }
  warn_of_few(tool, sample->size());
  why_untold = too_few(sample->size());
  const Preparation preparation = o.measured.asked;
  return {group_of(tool, *sample, preparation, Group::height, "Height parameters"),
          group_of(tool, *sample, preparation, Group::spatial, "Spatial parameters"),
          group_of(tool, *sample, preparation, Group::hybrid, "Hybrid parameters")};
}

std::string reference_of(const Preparation& asked) {
  const Form& form = asked.form;
  const bool polynomial = form.kind == Form::Kind::polynomial && form.degree > 1;
  std::string out = polynomial ? "a polynomial of " + form.words() : "the " + form.words();
  if (asked.shorter.given())
    out += ", waves below " + cli::format_quantity(asked.shorter.wavelength, "m") + " removed";
  if (asked.longer.given())
    out += ", waves above " + cli::format_quantity(asked.longer.wavelength, "m") + " removed";
  return out;
}

std::string title_of(const cli::Tool& tool, const std::string& title) {
  if (!title.empty()) return title;
  const std::string& name = tool.input_name();
  return name == "-" ? "Report" : std::filesystem::path(name).stem().string();
}

int report_on(cli::Tool& tool, const Options& o) {
  cli::check_page_name(o.output);
  tool.writes("output", o.output);
  plot::Cases dataset{{tool.read(), ""}};
  const Dataset& data = dataset[0].data;
  std::string untold;
  const std::vector<report::Group> groups = groups_of(tool, data, o, untold);
  for (const report::Group& group : groups) cli::check_finite(group.rows);
  const bool any =
      !groups.empty() || data.has("pressure") || data.has("acf_achieved") || data.has("von_mises");
  if (!any)
    throw DataError("heights",
                    "the dataset has no such variable, nor pressure, von_mises or a kernel: "
                    "give a dataset with one of them, or --variable NAME");
  const report::NoGridErrors no_grid_errors = report::add_grid_errors(tool, dataset[0].data);
  cli::write_all(o.output, report::page({dataset, title_of(tool, o.title), o.measured.variable,
                                         reference_of(o.measured.asked), groups, untold, no_grid_errors}));
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-report",
                 "Writes one self-contained HTML page about a dataset: parameters, measured values with "
                 "standard errors and 95 % intervals, accuracy of the solvers, pictures and history");
  Options options;
  tool.input();
  options.measured.declare(tool);
  tool.text("--title", options.title, "TEXT", "Title of the page. Default: file name", "Page");
  tool.text("-o,--output", options.output, "FILE.html", "Output file; - is standard output", "Page");
  tool.threads();
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px --seed 7 "
      "| asperity-report -o surface.html");
  tool.essential({"INPUT", "-o", "--title", "--variable", "--remove-form", "--lambda-s", "--lambda-c",
                  "--correlation", "--threads", "--from", "--quiet"});
  return tool.run(argc, argv, [&] { return report_on(tool, options); });
}
