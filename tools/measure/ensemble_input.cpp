#include "tools/measure/ensemble_input.hpp"

#include <filesystem>
#include <glob.h>
#include <sstream>

#include "core/error.hpp"
#include "tools/cli/grid_words.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

using Names = std::vector<std::string>;

// The name itself, if such a file exists or it is no pattern.
Names matches(const std::string& name) {
  if (name.find_first_of("*?[") == std::string::npos || std::filesystem::exists(name)) return {name};
  glob_t found{};
  const int outcome = glob(name.c_str(), 0, nullptr, &found);
  Names names(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  if (outcome != 0) throw UsageError("SURFACES", "no file matches '" + name + "'");
  return names;
}

Names all_matches(const Names& patterns) {
  if (patterns.empty()) return {"-"};
  Names out;
  for (const std::string& pattern : patterns)
    for (std::string& name : matches(pattern)) out.push_back(std::move(name));
  return out;
}

// The names, one per line.
Names listed(const Bytes& bytes) {
  std::istringstream lines{std::string(bytes)};
  Names out;
  for (std::string name; std::getline(lines, name);)
    if (!name.empty()) out.push_back(name);
  if (out.empty()) throw UsageError("SURFACES", "the list on standard input is empty");
  return out;
}

// Visits the dataset on standard input, or returns the names that it lists.
Names from_standard_input(const Tool& tool, const EnsembleInput::Visit& visit,
                          const EnsembleInput::VisitPath& taken) {
  if (stdin_is_terminal())
    throw UsageError("SURFACES", "no input: name files, or pipe in a dataset or a list of files");
  tool.reads("-");
  if (taken("/proc/self/fd/0")) return {};  // if it is a file
  std::optional<Bytes> bytes = read_all("-", tool.memory_bound());
  if (!tool.format().known(*bytes)) return listed(*bytes);
  Dataset dataset = tool.format().dataset(*bytes, "-", tool.memory_bound());
  bytes.reset();
  tool.settle(dataset);
  visit(dataset, "-");
  return {};
}

}  // namespace

void EnsembleInput::declare(Tool& tool) {
  tool.arguments("SURFACES", files, "TEXT",
                 "Files, or patterns such as 's_*.nc'; none or -: standard input, a dataset or a list of "
                 "files, one per line");
  tool.input_format();
}

void EnsembleInput::for_each(const Tool& tool, const Visit& visit, const VisitPath& taken) const {
  Names names = all_matches(files);
  Progress progress(tool);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == "-") {
      const Names more = from_standard_input(tool, visit, taken);
      if (more.empty()) continue;
      names.erase(names.begin() + static_cast<std::ptrdiff_t>(k));
      names.insert(names.begin() + static_cast<std::ptrdiff_t>(k), more.begin(), more.end());
    }
    if (names.size() > 1)
      progress.count(static_cast<double>(k), static_cast<double>(names.size()), "surfaces");
    tool.reads(names[k]);
    if (!taken(names[k])) visit(tool.read(names[k]), names[k]);
  }
}

void EnsembleGrid::add(const Tool& tool, const Grid& grid, const std::string& file) {
  if (!first_) {
    first_ = grid;
    file_ = file;
  }
  const std::string both =
      "its grid, " + described(grid) + ", differs from that of " + file_ + ", " + described(*first_);
  if (!same_spacing(grid, *first_))
    throw DataError(file,
                    both +
                        ": parameters depend on the spacing and cannot be averaged; measure the surfaces "
                        "separately, or thin the finer one (asperity-convert --decimate)");
  if (warned_ || same_grid(grid, *first_)) return;
  if (sizes_ == Sizes::alike) throw DataError(file, both + ": the test needs surfaces of one grid");
  warned_ = true;
  tool.warn(
      file + ": " + both +
      ": extremes, correlation lengths and all errors depend on the size, but each surface has the same "
      "weight in the mean");
}

}  // namespace asperity::cli
