/// Options in a file: the flat part of TOML 1.0, one `key = value` for an option and its long name.
///
///     # comment
///     size = "3mm,2mm"        a text, with the escapes \" \\ \n \t, or 'literal'
///     threads = 2             a number, as TOML writes it
///     periodic = true         a flag
///     INPUT = ["a.nc", "b.nc"]
///
/// Tables, dates and text that is not TOML are errors that name the key or the line. toml++ recurses once per
/// part of a dotted key: a key has at most 8 parts, a file at most 1 MiB.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class App;
class Config;
}  // namespace CLI

namespace asperity::cli {

/// Reads such a file.
std::shared_ptr<CLI::Config> config_reader();
/// The options that were given, and as comments the defaults of others: read back, they give the same run.
std::string config_text(const CLI::App& app);

}  // namespace asperity::cli
