/// The surfaces of an ensemble: files named on the command line or matched by a pattern there, or named on standard
/// input one a line, or a single dataset on standard input. They are read one after the other.
#pragma once

#include <filesystem>
#include <functional>
#include <glob.h>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/stream.hpp"
#include "cli/tool.hpp"
#include "grid/error.hpp"

namespace asperity::cli {

struct EnsembleInput {
  std::vector<std::string> files;

  void declare(Tool& tool) {
    tool.app().add_option(
        "SURFACES", files,
        "Files, or patterns such as 's_*.nc'; none or -: standard input, a dataset or the names "
        "of files, one a line");
    tool.input_format();
  }

  using Visit = std::function<void(const Dataset&, const std::string&)>;
  using VisitPath = std::function<bool(const std::string&)>;

  /// visit(dataset, name) for one dataset after the other; but for files that `taken`, asked with their path, has
  /// dealt with itself.
  void for_each(
      const Tool& tool, const Visit& visit,
      const VisitPath& taken = [](const std::string&) { return false; }) const {
    if (files.empty()) return from_standard_input(tool, visit, taken);
    for (const std::string& name : files)
      if (name == "-")
        from_standard_input(tool, visit, taken);
      else
        for (const std::string& match : matches(name)) from_file(tool, match, visit, taken);
  }

 private:
  // The name itself where there is such a file, or no pattern in it.
  static std::vector<std::string> matches(const std::string& name) {
    if (name.find_first_of("*?[") == std::string::npos || std::filesystem::exists(name)) return {name};
    glob_t found{};
    const int outcome = glob(name.c_str(), 0, nullptr, &found);
    const std::vector<std::string> names(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
    if (outcome != 0) throw CLI::ValidationError("SURFACES", "no file matches '" + name + "'");
    return names;
  }
  static void from_file(const Tool& tool, const std::string& name, const Visit& visit,
                        const VisitPath& taken) {
    if (!taken(name)) visit(tool.read(name), name);
  }
  static void from_standard_input(const Tool& tool, const Visit& visit, const VisitPath& taken) {
    if (stdin_is_terminal())
      throw CLI::ValidationError("SURFACES", "none: name files, or pipe a dataset or a list of files in");
    if (taken("/proc/self/fd/0")) return;  // when it is a file
    std::optional<Bytes> bytes = read_all("-");
    if (tool.format().known(*bytes)) {
      const Dataset dataset = tool.format().dataset(*bytes, "-");
      bytes.reset();
      return visit(dataset, "-");
    }
    std::istringstream names{std::string(*bytes)};
    bool any = false;
    for (std::string name; std::getline(names, name);) {
      if (name.empty()) continue;
      any = true;
      from_file(tool, name, visit, taken);
    }
    if (!any) throw CLI::ValidationError("SURFACES", "the list on standard input names none");
  }
};

}  // namespace asperity::cli
