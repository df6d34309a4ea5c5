/// What a tool tells of itself from CLI11's list of its options: its manual page, and completions for shells,
/// of options, the words of a choice and names of files.
#pragma once

#include <string>
#include <vector>

#include "tools/cli/tool.hpp"

namespace CLI {
class App;
}

namespace asperity::cli {

struct ExitStatus {
  Exit code;
  const char* meaning;
};
inline constexpr ExitStatus exit_statuses[] = {{done, "done"},
                                               {runtime_error, "input or output failed"},
                                               {usage_error, "wrong usage"},
                                               {not_converged, "not converged"},
                                               {bad_data, "bad input data"}};

/// "-o", "--output"; none where its place tells what it is.
std::vector<std::string> names_of(const CLI::Option& option);
/// It stands alone, without a value.
bool is_flag(const CLI::Option& option);
/// Words with a blank between them, in lines of at most `width`, each but the first behind `indent`.
std::string flowing(const std::string& text, std::size_t width = std::string::npos,
                    const std::string& indent = "");

/// In the man macros of roff.
std::string man_page(const CLI::App& app, const std::string& example, const std::string& accuracy);
/// A text as roff prints it: \ - ' ` ^ ~ and a period that begins a line are escaped, what is not ASCII
/// stands by its code point.
std::string roff(const std::string& text);

/// To be sourced, or found under share/bash-completion/completions.
std::string bash_completion(const CLI::App& app);
/// A function _TOOL for a folder of fpath.
std::string zsh_completion(const CLI::App& app);

}  // namespace asperity::cli
