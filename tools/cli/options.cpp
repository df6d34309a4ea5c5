#include "tools/cli/options.hpp"

#include <algorithm>
#include <cmath>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "tools/cli/documents.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

constexpr const char* common = "Common";

}  // namespace

Options::Options(std::string name, std::string description)
    : app_(std::make_unique<CLI::App>(std::move(description), name)), name_(std::move(name)) {
  app_->set_help_flag();
  app_->allow_config_extras(CLI::config_extras_mode::error);
}

Options::~Options() = default;

Option Option::required() const { return {of->required()}; }
Option Option::needs(Option other) const { return {of->needs(other.of)}; }
Option Option::excludes(Option other) const { return {of->excludes(other.of)}; }
Option Option::without_default() const { return {of->default_str("")}; }

Option Options::parsed(const std::string& name, const std::string& kind, const std::string& text,
                       const std::string& group, const std::string& shown, const Read& read) {
  const std::string key = name.substr(name.find_first_not_of('-'));
  CLI::Option* option = app_->add_option_function<std::string>(
      name, [key, read](const std::string& given) { read(key, given); }, text);
  option->group(group)->type_name(kind);
  if (!shown.empty()) option->default_str(shown);
  return {option};
}

Option Options::flag(const std::string& name, bool& value, const std::string& text,
                     const std::string& group) {
  return {app_->add_flag(name, value, text)->group(group)};
}

Option Options::integer(const std::string& name, int& value, const Bounds& bounds, const std::string& text,
                        const std::string& group) {
  return parsed(name, "N", text, group, std::to_string(value), into(value, parse_count, bounds));
}

Option Options::number(const std::string& name, double& value, const std::string& text,
                       const std::string& group) {
  const auto read = [](const std::string& key, const std::string& given) {
    if (given.find(',') != given.npos) refuse(key, given, "is more than one number");
    return parse_quantities(key, given, "1")[0];
  };
  return parsed(name, "NUMBER", text, group, std::isnan(value) ? "" : shortest(value), into(value, read));
}

Option Options::text(const std::string& name, std::string& value, const std::string& what,
                     const std::string& text, const std::string& group) {
  const auto read = [](const std::string&, const std::string& given) { return given; };
  return parsed(name, what, text, group, value, into(value, read));
}

Option Options::texts(const std::string& name, std::vector<std::string>& values, const std::string& what,
                      const std::string& text, const std::string& group) {
  return {app_->add_option(name, values, text)->group(group)->type_name(what)->allow_extra_args(false)};
}

Option Options::choice(const std::string& name, std::string& value, const std::vector<std::string>& among,
                       const std::string& text, const std::string& group) {
  const std::string list = fmt::format("{}", fmt::join(among, "|"));
  const auto read = [list, among](const std::string& key, const std::string& given) {
    if (std::ranges::find(among, given) == among.end()) refuse(key, given, "is none of " + list);
    return given;
  };
  return parsed(name, list, text, group, value, into(value, read));
}

Option Options::words(const std::string& name, std::vector<std::string>& value,
                      const std::vector<std::string>& among, const std::string& text,
                      const std::string& group) {
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

Option Options::in_units(const std::string& unit, Option option) {
  documents_.units[option.of->get_single_name()] = unit;
  return option;
}

Option Options::quantity(const std::string& name, double& value, const std::string& unit,
                         const std::string& text, const std::string& group) {
  const std::string shown = std::isnan(value) ? "" : format_quantity(value, unit);
  return in_units(unit, parsed(name, "QUANTITY", text, group, shown, into(value, parse_quantity, unit)));
}

Option Options::quantities(const std::string& name, std::array<double, 2>& values, const std::string& unit,
                           const std::string& text, const std::string& group) {
  const std::string shown =
      std::isnan(values[0]) ? "" : format_quantity(values[0], unit) + "," + format_quantity(values[1], unit);
  return in_units(unit, parsed(name, "A[,B]", text, group, shown, into(values, parse_quantities, unit)));
}

Option Options::lengths(const std::string& name, std::array<SampledLength, 2>& values,
                        const std::string& text, const std::string& group) {
  return in_units("m", parsed(name, "A[,B]", text, group, "", into(values, parse_lengths)));
}

Option Options::counts(const std::string& name, Shape& value, const Bounds& bounds, const std::string& text,
                       const std::string& group) {
  const std::string shown = value.nx > 0 ? std::to_string(value.nx) + "x" + std::to_string(value.ny) : "";
  return parsed(name, "AxB", text, group, shown, into(value, parse_counts, bounds));
}

Option Options::argument(const std::string& name, std::string& value, const std::string& kind,
                         const std::string& text) {
  return {app_->add_option(name, value, text)->type_name(kind)->capture_default_str()};
}

Option Options::arguments(const std::string& name, std::vector<std::string>& values, const std::string& kind,
                          const std::string& text) {
  CLI::Option* option = app_->add_option(name, values, text)->type_name(kind);
  return {values.empty() ? option : option->capture_default_str()};
}

Option Options::step(const std::string& name, const std::string& kind, const std::string& text,
                     const std::string& group) {
  CLI::Option* option = app_->add_option_function<std::vector<std::string>>(
      name, [](const std::vector<std::string>&) {}, text);
  option->group(group)->type_name(kind)->allow_extra_args(false)->configurable(false);
  step_options_.push_back(option);
  return {option};
}

void Options::steps_in_a_text(const std::string& group) {
  text("--steps", steps_text_, "TEXT",
       "The steps as they would stand here, '--remove-form plane --lambda-s 8um': for a file of --config and "
       "for the environment, which have no order. Steps on the command line replace them",
       group);
}

void Options::config() {
  app_->config_formatter(config_reader());
  app_->set_config("--config", "", "Read options from a TOML file, as --dump-config writes it")
      ->group(common)
      ->type_name("FILE.toml");
}

void Options::dump_config() {
  flag("--dump-config", dump_config_,
       "Print the options given here, in the environment and by --config as a file for --config, with the "
       "defaults as comments, and exit",
       common)
      .of->configurable(false);
}

void Options::documents() {
  const auto prints = [this](const std::string& name, const std::string& what, auto text) {
    app_->add_flag_callback(
            name, [text] { throw Printout{text()}; }, what)
        ->group(common)
        ->configurable(false);
  };
  prints("--man", "Print the manual page, for man -l, and exit",
         [this] { return man_page(*app_, documents_); });
  parsed("--completion", "bash|zsh", "Print the completion script for a shell and exit", common, "",
         [this](const std::string& key, const std::string& shell) {
           if (shell != "bash" && shell != "zsh") refuse(key, shell, "is none of bash|zsh");
           throw Printout{shell == "bash" ? bash_completion(*app_) : zsh_completion(*app_)};
         })
      .of->configurable(false);
  prints("--describe",
         "Print the tool, its options and exit statuses as one JSON object, for programs, and exit",
         [this] { return description(*app_, documents_); });
  prints("--version", "Print the versions of the tool and its libraries and exit",
         [this] { return name_ + " " + version() + " (" + libraries() + ")\n"; });
  prints("-h", "Print the most used options and exit",
         [this] { return short_help(*app_, documents_, columns_of(STDOUT_FILENO)); });
  prints("--help", "Print all options and exit",
         [this] { return long_help(*app_, documents_, columns_of(STDOUT_FILENO)); });
}

}  // namespace asperity::cli
