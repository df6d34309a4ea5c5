#include "tools/cli/datasets.hpp"

#include <memory>
#include <utility>

#include "core/parallel.hpp"
#include "core/words.hpp"
#include "dataset/catalogue.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "tools/cli/messages.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/ordered_work.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/run_settings.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

thread_local std::string last_read;

constexpr const char* warnings_suffix = "warnings";

// Of the attributes that a tool writes: "contact_".
std::string prefix_of(const std::string& tool) { return tool.substr(tool.find('-') + 1) + "_"; }

// The file gets its name in order.
void put(const Dataset& dataset, const std::string& name) {
  const auto file = std::make_shared<OutputFile>(name);
  write_netcdf(dataset, [&](std::string_view bytes) { file->write(bytes); });
  in_order([file] { file->close(); });
}

// As early as can be: of a tool that writes either, what neither may be written into.
void check_output_name(const std::string& name, bool dataset, bool table, bool json) {
  if (!table) return check_dataset_name(name);
  if (!dataset || !names_dataset(extension_of(name))) check_table_name(name, json);
}

}  // namespace

void Datasets::input() {
  takes_input_ = true;
  options_.argument("INPUT", input_, "FILE", "Dataset or map to read; - is standard input");
  input_format();
}

void Datasets::input_format() {
  reads_ = true;
  options_.choice(
      "--from", format_.format, InputFormat::names(),
      "Format of the input; auto: by its first bytes, else by the extension of its name; gwyddion: through "
      "that program, if it is installed, which auto does with bytes of no other format that are no text",
      "Input");
  options_.text(
      "--channel", format_.channel, "NAME",
      "Map to read from a file of several (gwy, sur, gwyddion): its name or its number. Default: the "
      "only one, or the only one of heights",
      "Input");
  options_.choice("--from-order", format_.order, {"xy", "yx"},
                  "Order of a bare matrix (text, npy, NetCDF without x and y); xy: a line for each x, yx: a "
                  "line for each y",
                  "Input");
}

void Datasets::declare_memory() {
  if (reads_ && !options_.has("--memory"))
    settings_.memory("Memory limit for reading: the bytes of an input plus three times its map");
}

void Datasets::declare_output() {
  if (writes_dataset_ || writes_table_)
    options_.text("-o,--output", output_, "FILE",
                  std::string("Output file; - is standard output") +
                      (writes_any_ || !writes_dataset_
                           ? ""
                           : ". A dataset is NetCDF: name it FILE.nc, or without an extension"),
                  "Common");
  if (writes_table_) {
    options_.flag("--json", json_, "Print one JSON object instead of a table", "Common");
    options_.choice(
        "--table", table_, {"auto", "text", "tsv"},
        "Form of a table where one is printed; text: aligned and rounded, with errors behind ±; tsv: "
        "tab-separated, with all digits, for programs; auto: text on a terminal, else tsv",
        "Common");
  }
  if (reports_)
    options_.text("--report", report_, "FILE.json", "Write residuals and other results as one JSON object",
                  "Common");
}

void Datasets::declare_history() {
  if (writes_dataset_)
    options_.flag("--no-history", no_history_, "Do not record the command in the dataset's history",
                  "Common");
}

void Datasets::check_outputs() {
  const bool writes_something = writes_dataset_ || writes_table_;
  if (writes_dataset_ && !writes_any_ && !writes_table_) refuse_terminal(output_);
  if (writes_something && !writes_any_) check_output_name(output_, writes_dataset_, writes_table_, json_);
  if (!report_.empty()) check_table_name(report_, true, "report");
  result_is_dataset_ = writes_dataset_ && !writes_table_;
  if (writes_something) writes("output", output_);
  if (!report_.empty()) writes("report", report_);
  if (!options_.config_file().empty()) reads(options_.config_file());
  last_read.clear();
}

bool Datasets::lacks_input() const { return takes_input_ && input_ == "-" && stdin_is_terminal(); }

bool Datasets::output_is_terminal() const { return output_ == "-" && stdout_is_terminal(); }

Dataset Datasets::read() const { return read(input_); }

Dataset Datasets::read(const std::string& name, std::size_t held) const {
  const std::string first = first_bytes(name);
  if (!looks_like_netcdf(first) || !format_.netcdf(first))
    return read(read_all(name, settings_.memory_bound(held)), name, held);
  return read_by(name, first, [&] { return open_netcdf(name, settings_.memory_bound(held)); });
}

Dataset Datasets::read(const Bytes& bytes, const std::string& name, std::size_t held) const {
  return read_by(name, bytes, [&] { return format_.dataset(bytes, name, settings_.memory_bound(held)); });
}

Dataset Datasets::read(Bytes&& bytes, const std::string& name, std::size_t held) const {
  if (!format_.netcdf(bytes)) return read(std::as_const(bytes), name, held);
  return read_by(name, bytes, [&] {
    const MemoryBound left = settings_.memory_bound(held + bytes.size());
    return open_netcdf(std::move(bytes), left);
  });
}

Dataset Datasets::read_by(const std::string& name, std::string_view first_bytes,
                          const std::function<Dataset()>& decoded) const {
  const bool netcdf = format_.netcdf(first_bytes);
  reads(name, result_is_dataset_ && netcdf);
  if (netcdf)
    format_.found(first_bytes, name);  // refuses what is given for a map alone
  else
    messages_.detail(format_.reason(first_bytes, name));
  Dataset data = decoded();
  settle(data, name);
  return data;
}

void Datasets::settle(Dataset& dataset, const std::string& name) const {
  const std::string of = name == "-" ? "" : name + ": ";
  for (const std::string& line : settle_lengths(dataset)) messages_.warn(of + line);
  for (const std::string& line : std::exchange(dataset.notes, {})) messages_.note(of + line);
}

void Datasets::writes(const std::string& option, const std::string& name) {
  Identity own = identity_of_output(name);
  if (own.empty() && name == "-") own = name;
  const auto [other, alone] = outputs_.try_emplace(own, Output{option, name});
  if (!alone && !own.empty())
    refuse(option, name, "is the file of --" + other->second.option + " too: give it another name");
  require_writable(name);
}

void Datasets::reads(const std::string& name, bool passed_on) const {
  last_read = name;
  in_order([name] { last_read = name; });
  const Identity own = identity_of_input(name);
  const auto same = outputs_.find(own);
  if (own.empty() || same == outputs_.end()) return;
  const auto& [option, output] = same->second;
  if (passed_on && replaces_file(output) && option == "output") return;
  refuse(option, output, "is an input of this run: give the output another name");
}

// "rough.nc: heights: ...", "map.txt: line 3 ..."
std::string Datasets::in_file(const DataError& error) const {
  std::string line = sentence(error.name, error.what());
  const KnownResult* result = result_of_variable(error.name);
  const bool missing = dynamic_cast<const MissingVariable*>(&error) != nullptr;
  if (missing && (error.name == "x" || error.name == "y")) line += ". `size` gives a bare array its axes";
  if (missing && result != nullptr && result->name != "heights")
    line += ". asperity-" + std::string(result->prefix.substr(0, result->prefix.find('_'))) + " computes it";
  const bool named = last_read.empty() || last_read == "-" || line.starts_with(last_read + ": ");
  return named ? line : last_read + ": " + line;
}

void Datasets::write(Dataset& dataset) { write(dataset, output_); }

void Datasets::write(Dataset& dataset, const std::string& name, const std::vector<std::string>& lines) const {
  if (!settings_.is_first_rank()) return;
  refuse_terminal(name);
  if (!writes_any_) check_dataset_name(name);
  sign(dataset, lines);
  if (works_alone() && !replaces_file(name))  // what is written into a pipe is seen at once
    return in_order([name, dataset] { put(dataset, name); });
  put(dataset, name);
  write_report(dataset);
}

void Datasets::sign(Dataset& dataset, const std::vector<std::string>& lines) const {
  dataset.attributes.set("Conventions", "CF-1.8");
  dataset.attributes.set("source", source());
  const std::string own = prefix_of(options_.name());
  if (std::ranges::find(known_results(), own, &KnownResult::prefix) != known_results().end())
    record_warnings(dataset.attributes, own);
  if (no_history_) return;
  std::string entry = timestamp() + ": " + options_.command_line();
  for (const std::string& line : lines) entry += "\n  " + line;
  add_history(dataset, entry);
}

void Datasets::record_warnings(Attributes& attributes, std::string_view prefix) const {
  record_warnings(attributes, prefix, messages_.take_warnings());
}

void Datasets::record_warnings(Attributes& attributes, std::string_view prefix,
                               const std::vector<std::string>& warnings) const {
  std::string known = "\n";
  for (const Attribute& a : attributes)
    if (a.name.ends_with(warnings_suffix)) known += attributes.text(a.name) + "\n";
  const std::string name = std::string(prefix) + warnings_suffix;
  std::string lines = attributes.text(name);
  for (const std::string& warning : warnings) {
    const std::string line = one_line(with_options(warning, options_));
    if (known.find("\n" + line + "\n") == known.npos) lines += (lines.empty() ? "" : "\n") + line;
  }
  if (!lines.empty()) attributes.set(name, lines);
}

void Datasets::write_report(const Dataset& dataset) const {
  if (!report_.empty()) write_all(report_, report_of(dataset, prefix_of(options_.name())));
}

void Datasets::write_text(const std::string& text) const {
  if (!settings_.is_first_rank()) return;
  if (output_is_terminal())
    Progress::clear();
  else
    Progress::wipe();
  write_all(output_, text);
}

}  // namespace asperity::cli
