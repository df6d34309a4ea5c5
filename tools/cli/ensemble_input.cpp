#include "tools/cli/ensemble_input.hpp"

#include <cctype>
#include <cerrno>
#include <filesystem>
#include <glob.h>
#include <map>
#include <sstream>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "tools/cli/grid_words.hpp"
#include "tools/cli/place.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

using Names = std::vector<std::string>;

constexpr const char* argument = "INPUT";

// The name itself, if such a file exists or it is no pattern.
Names matches(const std::string& name) {
  if (name.find_first_of("*?[") == std::string::npos || std::filesystem::exists(name)) return {name};
  glob_t found{};
  const int outcome = glob(name.c_str(), 0, nullptr, &found);
  Names names(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  if (outcome != 0) throw UsageError(argument, "no file matches '" + name + "'");
  return names;
}

Names all_matches(const Names& patterns) {
  if (patterns.empty()) return {"-"};
  Names out;
  for (const std::string& pattern : patterns)
    for (std::string& name : matches(pattern)) out.push_back(std::move(name));
  return out;
}

// Before the first is read, for the work on those before a wrong one would be lost.
void check(const Tool& tool, const Names& names) {
  std::map<Identity, std::string> seen;
  for (const std::string& name : names) {
    const Identity own = identity_of_input(name);
    const auto [other, first] = seen.try_emplace(own, name);
    if (!first && !own.empty())
      throw UsageError(argument, "'" + name + "' is given twice" +
                                     (other->second == name ? "" : ", as '" + other->second + "' too") +
                                     ": the same surface is no further sample");
    if (names.size() > 1 && name != "-") {
      tool.reads(name);
      if (::access(name.c_str(), R_OK) != 0) throw std::system_error(errno, std::generic_category(), name);
    }
  }
}

// A table of numbers, not a list of names: whether it begins like one, and not with the name of a file.
bool is_table(const std::string& first_line) {
  const char first = first_line.empty() ? ' ' : first_line.front();
  const bool number = std::isdigit(static_cast<unsigned char>(first)) || first == '-' || first == '+' ||
                      first == '.' || first == '#';
  const bool words = first_line.find_first_of(" \t;") != std::string::npos;
  return (number || words) && !std::filesystem::exists(first_line);
}

// The names, one per line, if these bytes are no dataset and no map.
Names listed(const Tool& tool, const Bytes& bytes) {
  if (tool.format().known(bytes)) return {};
  std::istringstream lines{std::string(bytes)};
  Names out;
  for (std::string name; std::getline(lines, name);)
    if (!name.empty()) out.push_back(name);
  if (out.empty()) throw UsageError(argument, "the list on standard input is empty");
  return is_table(out.front()) ? Names() : out;
}

// Visits the dataset on standard input, one of so many, or returns the names that it lists.
Names from_standard_input(const Tool& tool, std::size_t of, const EnsembleInput::Visit& visit,
                          const EnsembleInput::VisitPath& taken) {
  if (stdin_is_terminal())
    throw UsageError(argument, "no input: name files, or pipe in a dataset or a list of files");
  tool.reads("-", of == 1 && tool.result_is_dataset());
  if (taken("/proc/self/fd/0")) return {};  // if it is a file
  std::optional<Bytes> bytes = read_all("-", tool.memory_bound());
  const Names names = listed(tool, *bytes);
  if (!names.empty()) return names;
  Dataset dataset = tool.read(*bytes, "-");
  bytes.reset();
  visit({std::move(dataset), "-", of});
  return {};
}

}  // namespace

Option EnsembleInput::declare(Tool& tool) {
  const Option out = tool.arguments(
      argument, files, "FILE",
      "Datasets or maps to read, or patterns such as 's_*.nc'; none or -: standard input, a dataset or a "
      "list of files, one per line");
  tool.input_format();
  return out;
}

void EnsembleInput::for_each(const Tool& tool, const Visit& visit, const VisitPath& taken) const {
  Names names = all_matches(files);
  check(tool, names);
  Progress progress(tool);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == "-") {
      const Names more = from_standard_input(tool, names.size(), visit, taken);
      if (more.empty()) continue;
      names.erase(names.begin() + static_cast<std::ptrdiff_t>(k));
      names.insert(names.begin() + static_cast<std::ptrdiff_t>(k), more.begin(), more.end());
      check(tool, names);
    }
    const bool alone = names.size() == 1;
    if (!alone) progress.count(static_cast<double>(k), static_cast<double>(names.size()), "surfaces");
    tool.reads(names[k], alone && tool.result_is_dataset());
    if (!taken(names[k])) visit({tool.read(names[k]), names[k], names.size()});
  }
}

void EnsembleGrid::add(const Tool& tool, const Grid& grid, const std::string& file, const std::string& unit) {
  if (!first_) {
    first_ = grid;
    file_ = file;
    unit_ = unit;
  }
  if (unit != unit_)
    throw DataError(file, "its unit, " + unit + ", differs from that of " + file_ + ", " + unit_ +
                              ": quantities of different kinds cannot be averaged");
  const std::string both =
      "its grid, " + described(grid) + ", differs from that of " + file_ + ", " + described(*first_);
  if (!same_spacing(grid, *first_))
    throw DataError(file,
                    both +
                        ": parameters depend on the spacing and cannot be averaged; measure the surfaces "
                        "separately, or thin the finer one (asperity-convert --decimate)");
  if (warned_ || same_grid(grid, *first_)) return;
  if (!alike_.empty()) throw DataError(file, both + ": " + alike_ + " needs surfaces of one grid");
  warned_ = true;
  tool.warn(
      file + ": " + both +
      ": extremes, correlation lengths and all errors depend on the size, but each surface has the same "
      "weight in the mean");
}

}  // namespace asperity::cli
