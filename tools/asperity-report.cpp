// Writes a dataset as one HTML page: parameters, tables with errors, pictures, history.
#include <filesystem>
#include <memory>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "stats/measure.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/table.hpp"
#include "tools/cli/tool.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/measure/height_tables.hpp"
#include "tools/report/fields.hpp"
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

// A field, measured once for tables and figures; the sample is missing where the field cannot be measured.
struct Measured {
  std::shared_ptr<const Sample> sample = nullptr;
  std::vector<report::Group> groups = {};
};

// A broken field is refused. Of a sound field, groups that cannot be computed give their reason instead.
Measured measured(const cli::Tool& tool, const Dataset& data, const Options& o) {
  const bool absent = !data.has(o.measured.variable) && !tool.given("--variable");
  if (absent) return {};
  field_of(data, o.measured.variable, Missing::not_a_number);
  Measured out;
  try {
    out.sample = std::make_shared<const Sample>(o.measured.read(tool, data), tool.thread_count());
  } catch (const DataError& error) {
    return {nullptr, {{"Height parameters", {}, error.what()}}};
  }
  warn_of_few(tool, out.sample->size());
  for (const auto& [group, title] : {std::pair{Group::height, "Height parameters"},
                                     {Group::material, "Material ratio parameters"},
                                     {Group::spatial, "Spatial parameters"},
                                     {Group::hybrid, "Hybrid parameters"}})
    out.groups.push_back(group_of(tool, *out.sample, o.measured.asked, group, title));
  return out;
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

// With the field as it was measured, where a form or waves were removed; but not a pressure or a gap, whose
// zeros count.
plot::Cases measured_case(const Dataset& data, const Measured& of, bool prepared) {
  plot::Cases out{{data, "", of.sample}};
  if (!of.sample || !prepared) return out;
  const Surface& s = of.sample->surface();
  if (cli::counted_cells(data, s.variable)) return out;
  const Field& z = s.heights;
  Variable& v = *out[0].data.find(s.variable);
  v.values = std::vector<double>(z.data(), z.data() + z.size());
  v.unread = nullptr;
  v.attributes.set("units", s.units);
  for (const char* name :
       {"scale_factor", "add_offset", "_FillValue", "missing_value", "valid_range", "valid_min", "valid_max"})
    v.attributes.erase(name);
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
  const auto [sample, groups] = measured(tool, data, o);
  for (const report::Group& group : groups) cli::check_finite(group.rows);
  const bool any =
      !groups.empty() || data.has("pressure") || data.has("acf_achieved") || data.has("von_mises");
  if (!any)
    throw DataError("heights",
                    "the dataset has no such variable, nor pressure, von_mises or a kernel: "
                    "give a dataset with one of them, or --variable NAME");
  const report::NoGridErrors no_grid_errors = report::add_grid_errors(tool, dataset[0].data);
  const std::string reference = reference_of(o.measured.asked);
  const plot::Cases as_measured = measured_case(data, {sample, groups}, reference != "the mean");
  cli::write_all(o.output,
                 report::page({dataset, as_measured, title_of(tool, o.title), o.measured.variable, reference,
                               groups, tool.warnings(), no_grid_errors,
                               report::fields_of(data, o.measured.variable), report::flow_of(tool, data)}));
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
