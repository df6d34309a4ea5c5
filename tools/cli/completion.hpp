/// Completion scripts of a tool for shells, from the same table of options as --help: options, the words of a choice,
/// names of files.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace asperity::cli {

/// To be sourced, or found under share/bash-completion/completions.
std::string bash_completion(const CLI::App& app);
/// A function _TOOL for a folder of fpath.
std::string zsh_completion(const CLI::App& app);

}  // namespace asperity::cli
