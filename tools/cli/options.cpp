// What a tool can be told, and how --help tells it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "tools/cli/config.hpp"
#include "tools/cli/documents.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {
namespace {

constexpr const char* common = "Common";

// In place of running.
[[noreturn]] void tell(const std::string& text) { throw CLI::Success(text, CLI::ExitCodes::Success); }

// The default of --memory [byte]: half of the machine's; 1 GiB where the system does not tell.
std::size_t half_of_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages < 1 || page < 1) return std::size_t{1} << 30;
  return static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(page);
}

}  // namespace

Tool::Tool(std::string name, std::string description)
    : app_(std::make_unique<CLI::App>(std::move(description), name)),
      name_(std::move(name)),
      memory_(half_of_memory()) {
  documents_.statuses = {{done, "done"},
                         {runtime_error, "input or output failed"},
                         {usage_error, "wrong usage"},
                         {not_converged, "not converged"},
                         {bad_data, "bad input data"}};
  app_->set_help_flag();
  app_->allow_config_extras(CLI::config_extras_mode::error);
}

Option Option::required() const { return {of->required()}; }
Option Option::needs(Option other) const { return {of->needs(other.of)}; }
Option Option::excludes(Option other) const { return {of->excludes(other.of)}; }
Option Option::without_default() const { return {of->default_str("")}; }

Option Tool::parsed(const std::string& name, const std::string& kind, const std::string& text,
                    const std::string& group, const std::string& shown, const Read& read) {
  const std::string key = name.substr(name.find_first_not_of('-'));
  CLI::Option* option = app_->add_option_function<std::string>(
      name, [key, read](const std::string& given) { read(key, given); }, text);
  option->group(group)->type_name(kind);
  if (!shown.empty()) option->default_str(shown);
  return {option};
}

Option Tool::flag(const std::string& name, bool& value, const std::string& text, const std::string& group) {
  return {app_->add_flag(name, value, text)->group(group)};
}

Option Tool::integer(const std::string& name, int& value, const Bounds& bounds, const std::string& text,
                     const std::string& group) {
  return parsed(name, "N", text, group, std::to_string(value), into(value, parse_count, bounds));
}

Option Tool::number(const std::string& name, double& value, const std::string& text,
                    const std::string& group) {
  const auto read = [](const std::string& key, const std::string& given) {
    if (given.find(',') != given.npos) refuse(key, given, "is more than one number");
    return parse_quantities(key, given, "1")[0];
  };
  return parsed(name, "NUMBER", text, group, std::isnan(value) ? "" : shortest(value), into(value, read));
}

Option Tool::text(const std::string& name, std::string& value, const std::string& what,
                  const std::string& text, const std::string& group) {
  const auto read = [](const std::string&, const std::string& given) { return given; };
  return parsed(name, what, text, group, value, into(value, read));
}

Option Tool::texts(const std::string& name, std::vector<std::string>& values, const std::string& what,
                   const std::string& text, const std::string& group) {
  return {app_->add_option(name, values, text)->group(group)->type_name(what)->allow_extra_args(false)};
}

Option Tool::choice(const std::string& name, std::string& value, const std::vector<std::string>& among,
                    const std::string& text, const std::string& group) {
  const std::string list = fmt::format("{}", fmt::join(among, "|"));
  const auto read = [list, among](const std::string& key, const std::string& given) {
    if (std::ranges::find(among, given) == among.end()) refuse(key, given, "is none of " + list);
    return given;
  };
  return parsed(name, list, text, group, value, into(value, read));
}

Option Tool::words(const std::string& name, std::vector<std::string>& value,
                   const std::vector<std::string>& among, const std::string& text, const std::string& group) {
  const auto read = [among](const std::string& key, const std::string& given) {
    std::vector<std::string> out = split(given, ',');
    for (const std::string& word : out) {
      if (std::ranges::find(among, word) == among.end())
        refuse(key, word, "is none of " + fmt::format("{}", fmt::join(among, "|")));
      if (std::ranges::count(out, word) > 1) refuse(key, word, "is given twice");
    }
    return out;
  };
  return parsed(name, "WORD,...", text, group, fmt::format("{}", fmt::join(value, ",")), into(value, read));
}

Option Tool::in_units(const std::string& unit, Option option) {
  documents_.units[option.of->get_single_name()] = unit;
  return option;
}

Option Tool::quantity(const std::string& name, double& value, const std::string& unit,
                      const std::string& text, const std::string& group) {
  const std::string shown = std::isnan(value) ? "" : format_quantity(value, unit);
  return in_units(unit, parsed(name, "QUANTITY", text, group, shown, into(value, parse_quantity, unit)));
}

Option Tool::quantities(const std::string& name, std::array<double, 2>& values, const std::string& unit,
                        const std::string& text, const std::string& group) {
  const std::string shown =
      std::isnan(values[0]) ? "" : format_quantity(values[0], unit) + "," + format_quantity(values[1], unit);
  return in_units(unit, parsed(name, "A[,B]", text, group, shown, into(values, parse_quantities, unit)));
}

Option Tool::lengths(const std::string& name, std::array<SampledLength, 2>& values, const std::string& text,
                     const std::string& group) {
  return in_units("m", parsed(name, "A[,B]", text, group, "", into(values, parse_lengths)));
}

Option Tool::counts(const std::string& name, Shape& value, const Bounds& bounds, const std::string& text,
                    const std::string& group) {
  const std::string shown = value.nx > 0 ? std::to_string(value.nx) + "x" + std::to_string(value.ny) : "";
  return parsed(name, "AxB", text, group, shown, into(value, parse_counts, bounds));
}

Option Tool::bytes(const std::string& name, std::size_t& value, const std::string& text,
                   const std::string& group) {
  return parsed(name, "SIZE", text, group, format_bytes(value), into(value, parse_bytes));
}

Option Tool::argument(const std::string& name, std::string& value, const std::string& kind,
                      const std::string& text) {
  return {app_->add_option(name, value, text)->type_name(kind)->capture_default_str()};
}

Option Tool::arguments(const std::string& name, std::vector<std::string>& values, const std::string& kind,
                       const std::string& text) {
  CLI::Option* option = app_->add_option(name, values, text)->type_name(kind);
  return {values.empty() ? option : option->capture_default_str()};
}

void Tool::input() {
  takes_input_ = true;
  argument("INPUT", input_, "FILE", "Dataset or map to read; - is standard input");
  input_format();
}

void Tool::memory(const std::string& text) {
  bytes(
      "--memory", memory_,
      text + ". A larger input is refused; 16 MiB are always allowed. Default: half of the machine's memory",
      "Resources")
      .without_default();
}

void Tool::input_format() {
  reads_ = true;
  choice(
      "--from", format_.format, InputFormat::names(),
      "Format of the input; auto: by its first bytes, else by the extension of its name; gwyddion: through "
      "that program, if it is installed, which auto does with bytes of no other format that are no text",
      "Input");
  text("--channel", format_.channel, "NAME",
       "Map to read from a file of several (gwy, sur, gwyddion): its name or its number. Default: the only "
       "one, "
       "or the only one of heights",
       "Input");
  choice("--from-order", format_.order, {"xy", "yx"},
         "Order of a bare matrix (text, npy, NetCDF without x and y); xy: a line for each x, yx: a line for "
         "each y",
         "Input");
}

// Options of several tools come last in --help, in one order.
void Tool::add_common() {
  if (reads_ && !app_->get_option_no_throw("--memory"))
    memory("Memory limit for reading: the bytes of an input plus three times its map");
  if (writes_dataset_ || writes_table_)
    text("-o,--output", output_, "FILE",
         std::string("Output file; - is standard output") +
             (writes_any_ || !writes_dataset_
                  ? ""
                  : ". A dataset is NetCDF: name it FILE.nc, or without an extension"),
         common);
  if (writes_table_) flag("--json", json_, "Print one JSON object instead of a table", common);
  if (reports_)
    text("--report", report_, "FILE.json", "Write residuals and other results as one JSON object", common);
  if (seeded_) add_seed();
  if (threaded_)
    integer("--threads", threads_, {0, 4096, "more than a machine has"},
            "Number of threads; 0: all of the machine. They share the work on a large surface; of several "
            "small ones each takes one",
            common);
  if (writes_dataset_)
    flag("--no-history", no_history_, "Do not record the command in the dataset's history", common);
  if (computes_) add_running();
  add_documents();
}

void Tool::add_running() {
  app_->config_formatter(config_reader());
  app_->set_config("--config", "", "Read options from a TOML file, as --dump-config writes it")
      ->group(common)
      ->type_name("FILE.toml");
  flag("-q,--quiet", quiet_, "Print warnings and errors only", common);
  flag("-v,--verbose", verbose_, "Print details on standard error: a line for each step of an iteration",
       common);
  choice(
      "--progress", progress_, {"auto", "always", "never"},
      "Show the progress of a long computation on standard error; auto: on a terminal, without --quiet and "
      "--verbose",
      common);
  flag("--dump-config", dump_config_,
       "Print the options given here, in the environment and by --config as a file for --config, with the "
       "defaults as comments, and exit",
       common)
      .of->configurable(false);
  flag("--time", time_, "Print time and peak memory on standard error at the end", common);
}

void Tool::add_documents() {
  app_->add_flag_callback(
          "--man", [this] { tell(man_page(*app_, documents_)); },
          "Print the manual page, for man -l, and exit")
      ->group(common)
      ->configurable(false);
  parsed("--completion", "bash|zsh", "Print the completion script for a shell and exit", common, "",
         [this](const std::string& key, const std::string& shell) {
           if (shell != "bash" && shell != "zsh")
             throw ParameterError(key, "'" + shell + "' is none of bash|zsh");
           tell(shell == "bash" ? bash_completion(*app_) : zsh_completion(*app_));
         })
      .of->configurable(false);
  app_->add_flag_callback(
          "--describe", [this] { tell(description(*app_, documents_)); },
          "Print the tool, its options and exit statuses as one JSON object, for programs, and exit")
      ->group(common)
      ->configurable(false);
  app_->set_version_flag("--version", name_ + " " + version() + " (" + libraries() + ")\n",
                         "Print the versions of the tool and its libraries and exit")
      ->group(common)
      ->configurable(false);
  const auto help = [this](const std::string& name, auto of, const std::string& what) {
    app_->add_flag_callback(
            name, [this, of] { tell(of(*app_, documents_, columns_of(STDOUT_FILENO))); }, what)
        ->group(common)
        ->configurable(false);
  };
  help("-h", short_help, "Print the most used options and exit");
  help("--help", long_help, "Print all options and exit");
}

void Tool::add_seed() {
  parsed("--seed", "N",
         "Seed of the random numbers, 0 to 2^53; without it a random seed. The seed is always recorded",
         common, "", [this](const std::string& key, const std::string& given) {
           seed_ = to_number<std::uint64_t>(given);
           if (!seed_ || *seed_ > std::uint64_t{1} << 53)
             throw ParameterError(key,
                                  "'" + given + "' is not a whole number from 0 to 2^53 = 9007199254740992");
         });
  integer("--stream", stream_, 0,
          "Number of the ensemble; streams of one seed never share a surface, so that parallel jobs may "
          "share the seed "
          "and differ in the stream",
          common);
}

}  // namespace asperity::cli
