/// Options in a file: the flat part of TOML 1.0, one `key = value` for an option and its long name.
///
///     # comment
///     size = "3mm,2mm"        a text, with the escapes \" \\ \n \t, or 'literal'
///     threads = 2             a number, as TOML writes it
///     periodic = true         a flag
///     SURFACES = ["a.nc", "b.nc"]
///
/// Tables and dates, which no option is, and what is no TOML are errors that name the key or the line. Read by toml++,
/// which calls itself for each part of a dotted key: no key has more than 8 of them, and a file at most 1 MiB.
#pragma once

#include <CLI/CLI.hpp>

namespace asperity::cli {

class ConfigFile : public CLI::Config {
 public:
  /// The options that have been given, group by group as in --help, and as comments those that have defaults: what
  /// from_config reads back to the same run.
  std::string to_config(const CLI::App* app, bool defaults, bool descriptions,
                        std::string prefix) const override;
  std::vector<CLI::ConfigItem> from_config(std::istream& in) const override;
  std::string to_flag(const CLI::ConfigItem& item) const override;
};

/// Whether an option stands alone, without a value.
inline bool is_flag(const CLI::Option& option) { return option.get_expected_min() == 0; }

/// The message of an error in a file.
std::string in_words(const CLI::ConfigError& error);

}  // namespace asperity::cli
