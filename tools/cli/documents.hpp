/// What a tool prints about itself, from CLI11's list of its options: two lengths of help, the manual page,
/// completions for shells, a description for programs, and a file of the options; and what a user meant by an
/// option that it does not have.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/tool.hpp"

namespace CLI {
class App;
class Config;
class ConfigError;
class Error;
}  // namespace CLI

namespace asperity::cli {

/// "-o", "--output"; none for a positional argument.
std::vector<std::string> names_of(const CLI::Option& option);
/// It stands alone, without a value.
bool is_flag(const CLI::Option& option);
/// What follows its name: "FILE", "x|y", or "WORD" of a long list of words, which text_of() has.
std::string kind_of(const CLI::Option& option);
/// What can follow its name: nothing, the name of a file, one of some words, or something else.
enum class Value { none, file, word, other };
Value value_of(const CLI::Option& option);
/// "exponential|gaussian", the words of Value::word.
std::vector<std::string> words_of(const CLI::Option& option);
/// Its text, a list of words that is too long for its kind, and its default.
std::string text_of(const CLI::Option& option);
/// Words with a blank between them, in lines of at most `width` columns, each but the first after `indent`.
std::string flowing(const std::string& text, std::size_t width = std::string::npos,
                    const std::string& indent = "");

/// A paragraph of a page, or an item of a list.
struct Paragraph {
  bool item = false;
  std::string text;  ///< in one line
};
/// docs/accuracy/TOOL.md, which the build embeds, without its title and marks of code; nothing for a program
/// without such a page.
std::vector<Paragraph> accuracy_of(std::string_view tool);

/// All options, by their headings, for lines of `width` columns.
std::string long_help(const CLI::App& app, const Documents& more, std::size_t width);
/// Usage, example, and the first clause of the options that most need.
std::string short_help(const CLI::App& app, const Documents& more, std::size_t width);

/// In the man macros of roff.
std::string man_page(const CLI::App& app, const Documents& more);
/// A text as roff prints it: \ - ' ` ^ ~ and a period that begins a line are escaped, what is not ASCII
/// stands by its code point.
std::string roff(const std::string& text);

/// One JSON object: the tool, its options (name, kind, SI unit, text, which others it excludes)
/// and its exit statuses. Python's module asperity makes its functions of it (docs/python.md).
std::string description(const CLI::App& app, const Documents& more);

/// To be sourced, or found under share/bash-completion/completions.
std::string bash_completion(const CLI::App& app);
/// A function _TOOL for a folder of fpath.
std::string zsh_completion(const CLI::App& app);

// ---- the file of --config, cli/config.cpp ----

/// Reads options from a file: the flat part of TOML 1.0, one `key = value` for an option and its long name.
///
///     # comment
///     size = "3mm,2mm"        a text, with the escapes \" \\ \n \t, or 'literal'
///     threads = 2             a number, as TOML writes it
///     periodic = true         a flag
///     INPUT = ["a.nc", "b.nc"]
///
/// Tables, dates and text that is not TOML are errors that name the key or the line. toml++ recurses once per
/// part of a dotted key: a key has at most 8 parts, a file at most 1 MiB.
std::shared_ptr<CLI::Config> config_reader();
/// The options that were given, and as comments the defaults of others: read back, they give the same run.
std::string config_text(const CLI::App& app);

// ---- slips of the pen, cli/hints.cpp; docs/options.md lists all options ----

/// "there is no option --lenght: did you mean --length?", of "--lenght" or, in a file, "lenght".
std::string unknown_option(const CLI::App& app, const std::string& option);

/// ": did you mean contact?" of "contct"; "" where no tool is called nearly so.
std::string nearest_tool(const std::string& word);

/// Of any tool, "--size".
bool is_option(const std::string& name);
/// "; asperity-convert has --size"; "" of an option that neither this nor asperity-filter has.
std::string tool_with(const std::string& option);

/// The message of an error of CLI11.
std::string in_words(const CLI::Error& error);
std::string in_words(const CLI::App& app, const CLI::ConfigError& error);

}  // namespace asperity::cli
