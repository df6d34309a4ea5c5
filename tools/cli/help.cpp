// The two lengths of help.
#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include "tools/cli/documents.hpp"
#include "tools/cli/toolbox.hpp"

namespace asperity::cli {
namespace {

constexpr std::size_t text_column = 26;  // where texts begin; a longer option has a line of its own

std::string usage(const CLI::App& app) {
  std::string out = "Usage: " + app.get_name() + " [OPTION]...";
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional())
      out += fmt::format(" [{}]{}", option->get_single_name(),
                         option->get_items_expected_max() > 1 ? "..." : "");
  return out + "\n";
}

// "  -o, --output FILE"
std::string head_of(const CLI::Option& option) {
  if (option.get_positional()) return "  " + option.get_single_name();
  const std::string names = fmt::format("  {}", fmt::join(names_of(option), ", "));
  return is_flag(option) ? names : names + " " + kind_of(option);
}

std::string entry(const CLI::Option& option, const std::string& text, std::size_t width) {
  std::string head = head_of(option);
  const std::string indent(text_column, ' ');
  head += head.size() + 2 > text_column ? "\n" + indent : std::string(text_column - head.size(), ' ');
  return head + flowing(text, width - text_column, indent) + "\n";
}

// Up to the first full stop, semicolon or colon.
std::string first_clause(const std::string& text) {
  return text.substr(0, std::min({text.find(". "), text.find("; "), text.find(": ")}));
}

// A command of one line in lines of at most `width` columns, which a shell takes as one.
std::string broken_command(const std::string& command, std::size_t width) {
  std::istringstream words(command);
  std::vector<std::string> parts(1);  // each a place where a line may begin
  for (std::string word, before; words >> word; before = word) {
    if (word == "\\") continue;  // it was in lines before
    if (before == "|" || (word.starts_with("-") && word != "-")) parts.emplace_back();
    parts.back() += (parts.back().empty() ? "" : " ") + word;
  }
  std::string out, line;
  for (const std::string& part : parts) {
    const bool full = !line.empty() && line.size() + part.size() + 3 > width;  // with " \\" after it
    if (full) out += line + (line.ends_with("|") ? "\n" : " \\\n"), line = "  ";
    line += (line.empty() || full ? "" : " ") + part;
  }
  return out + line;
}

std::string example_of(const Documents& more, std::size_t width) {
  if (more.example.empty()) return "";
  std::string out = "\nExample:\n";
  std::istringstream lines(broken_command(more.example, width - 2));
  for (std::string line; std::getline(lines, line);) out += "  " + line + "\n";
  return out;
}

std::string accuracy_in_lines(const std::string& tool, std::size_t width) {
  std::string out;
  for (const auto& [item, text] : accuracy_of(tool))
    out += (item          ? "  * "
            : out.empty() ? "  "
                          : "\n  ") +
           flowing(text, width - (item ? 4 : 2), item ? "    " : "  ") + "\n";
  return out.empty() ? "" : "\nAccuracy:\n" + out;
}

}  // namespace

std::string long_help(const CLI::App& app, const Documents& more, std::size_t width) {
  std::string out = flowing(app.get_description(), width) + "\n\n" + usage(app) + example_of(more, width);
  for (const std::string& group : app.get_groups()) {
    out += "\n" + (group == "Options" ? "Arguments" : group) + ":\n";
    for (const CLI::Option* option : app.get_options())
      if (option->get_group() == group) out += entry(*option, text_of(*option), width);
  }
  out += accuracy_in_lines(app.get_name(), width);
  std::string statuses;
  for (const auto& [code, meaning] : more.statuses)
    statuses += fmt::format("{}{} {}", statuses.empty() ? "" : ", ", code, meaning);
  const std::string values =
      "A quantity has a unit: 3mm, 0.4um, 208GPa, 5000N, 30deg. An option may also stand in the environment, "
      "as " +
      environment_name(app.get_name(), "OPTION") +
      ", or in the file of --config; the command line comes first.";
  if (app.get_option_no_throw("--config")) out += "\n" + flowing(values, width) + "\n";
  return out + flowing("Exit status: " + statuses + ".", width) + "\n";
}

std::string short_help(const CLI::App& app, const Documents& more, std::size_t width) {
  const std::string& name = app.get_name();
  std::string out =
      fmt::format("{}: {}\n", name, summary_of(name)) + usage(app) + example_of(more, width) + "\n";
  for (const std::string& wanted : more.essential) {
    const CLI::Option* option = app.get_option(wanted);
    out += entry(*option, first_clause(flowing(option->get_description())), width);
  }
  return out + "\nAll options: " + name + " --help\n";
}

}  // namespace asperity::cli
