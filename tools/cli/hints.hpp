/// What a user meant by an option that the tool does not have: one of another tool, or one spelt nearly so.
/// docs/options.md lists all options.
#pragma once

#include <string>

namespace CLI {
class App;
class ConfigError;
class Error;
}  // namespace CLI

namespace asperity::cli {

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
