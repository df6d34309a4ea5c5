/// Completion scripts of a tool for shells: options, the words of a choice, names of files.
#pragma once

#include <string>
#include <vector>

#include "tools/cli/option.hpp"

namespace asperity::cli {

/// To be sourced, or found under share/bash-completion/completions.
std::string bash_completion(const std::string& tool, const std::vector<Option>& options);
/// A function _TOOL for a folder of fpath.
std::string zsh_completion(const std::string& tool, const std::vector<Option>& options);

}  // namespace asperity::cli
