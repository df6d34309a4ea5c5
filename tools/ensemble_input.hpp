/// The surfaces of an ensemble: files named on the command line, or on standard input one a line, or a single
/// dataset on standard input. They are read one after the other.
#pragma once

#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/stream.hpp"
#include "cli/tool.hpp"
#include "dataset/netcdf.hpp"
#include "grid/error.hpp"

namespace asperity::cli {

struct EnsembleInput {
  std::vector<std::string> files;

  void declare(Tool& tool) {
    tool.app().add_option("SURFACES", files,
                          "Files; none or -: standard input, a dataset or the names of files, one a line");
  }

  /// visit(dataset, name) for one dataset after the other.
  void for_each(const std::function<void(const Dataset&, const std::string&)>& visit) const {
    if (files.empty()) return from_standard_input(visit);
    for (const std::string& name : files)
      if (name == "-")
        from_standard_input(visit);
      else
        visit(Tool::read(name), name);
  }

 private:
  static void from_standard_input(const std::function<void(const Dataset&, const std::string&)>& visit) {
    if (stdin_is_terminal())
      throw CLI::ValidationError("SURFACES", "none: name files, or pipe a dataset or a list of files in");
    const std::string bytes = read_all("-");
    if (bytes.starts_with("CDF")) return visit(decode_netcdf(bytes), "-");
    std::istringstream names(bytes);
    for (std::string name; std::getline(names, name);)
      if (!name.empty()) visit(Tool::read(name), name);
  }
};

}  // namespace asperity::cli
