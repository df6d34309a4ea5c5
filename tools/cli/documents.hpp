/// What a tool prints about itself, from CLI11's list of its options: two lengths of help, the manual page,
/// completions for shells, and a description for programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/tool.hpp"

namespace CLI {
class App;
}

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

}  // namespace asperity::cli
