#include "tools/cli/ensemble_input.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <glob.h>
#include <map>
#include <sstream>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
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
  const std::string first = first_line.substr(0, first_line.find_first_of(" \t;,"));
  const bool table =
      first.size() < first_line.size() || first_line.front() == '#' || to_number<double>(first);
  return table && !std::filesystem::exists(first_line);
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

// Standard input's list in its place.
void replace(Names& names, std::size_t place, const Names& listed) {
  const auto at = names.begin() + static_cast<std::ptrdiff_t>(place);
  names.insert(names.erase(at), listed.begin(), listed.end());
}

Bytes piped(const Tool& tool) {
  if (stdin_is_terminal())
    throw UsageError(argument, "no input: name files, or pipe in a dataset or a list of files");
  return read_all("-", tool.memory_bound());
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

bool EnsembleInput::takes_standard_input() const {
  return files.empty() || std::ranges::find(files, "-") != files.end();
}

std::size_t EnsembleInput::resolve(const Tool& tool) {
  files = all_matches(files);
  check(tool, files);
  const auto place = std::ranges::find(files, "-");
  if (place == files.end()) return files.size();
  piped_ = piped(tool);
  if (const Names names = listed(tool, *piped_); !names.empty()) {
    replace(files, static_cast<std::size_t>(place - files.begin()), names);
    check(tool, files);
    piped_.reset();
  }
  return files.size();
}

Dataset EnsembleInput::only(const Tool& tool) {
  Dataset out;
  for_each(tool, [&](EnsembleMember&& member) { out = std::move(member.data); });
  return out;
}

void EnsembleInput::for_each(const Tool& tool, const Visit& visit, const VisitPath& taken) {
  const Failed none;
  visit_all({tool, visit, taken, none});
}

void EnsembleInput::for_each(const Tool& tool, const Visit& visit, const Failed& failed) {
  const VisitPath none = [](const std::string&) { return false; };
  visit_all({tool, visit, none, failed});
}

// The next surface, unless it cannot be read and the others go on.
void EnsembleInput::visit_one(const Run& run, const std::string& name, std::size_t of,
                              const std::function<Dataset()>& read) {
  std::optional<Dataset> data;
  try {
    data = read();
  } catch (const DataError& error) {
    if (of == 1 || !run.failed) throw;
    run.failed(name, run.tool.in_file(error));
  }
  if (data) run.visit({std::move(*data), name, of});
}

// Visits the dataset on standard input, one of so many, or returns the names that it lists.
Names EnsembleInput::from_standard_input(const Run& run, std::size_t of) {
  run.tool.reads("-", of == 1 && run.tool.result_is_dataset());
  if (!piped_ && run.taken("/proc/self/fd/0")) return {};  // if it is a file
  if (!piped_) piped_ = piped(run.tool);
  const Names names = listed(run.tool, *piped_);
  if (names.empty())
    visit_one(run, "-", of, [&] {
      if (of > 1) return run.tool.read(*piped_, "-");  // kept for another visit
      return run.tool.read(std::move(*std::exchange(piped_, {})), "-");
    });
  if (of == 1) piped_.reset();
  return names;
}

void EnsembleInput::visit_all(const Run& run) {
  Names names = all_matches(files);
  check(run.tool, names);
  Progress progress(run.tool);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names.size() > 1) run.tool.about(names[k]);
    if (names[k] == "-") {
      const Names more = from_standard_input(run, names.size());
      if (more.empty()) continue;
      replace(names, k, more);
      check(run.tool, names);
      if (names.size() > 1) run.tool.about(names[k]);
    }
    const bool alone = names.size() == 1;
    if (!alone) progress.count(static_cast<double>(k), static_cast<double>(names.size()), "surfaces");
    run.tool.reads(names[k], alone && run.tool.result_is_dataset());
    if (!run.taken(names[k])) visit_one(run, names[k], names.size(), [&] { return run.tool.read(names[k]); });
  }
  run.tool.about("");
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
                        "separately, or thin the finer one (asperity-filter --decimate)");
  if (warned_ || same_grid(grid, *first_)) return;
  if (!alike_.empty()) throw DataError(file, both + ": " + alike_ + " needs surfaces of one grid");
  warned_ = true;
  tool.warn(
      file + ": " + both +
      ": extremes, correlation lengths and all errors depend on the size, but each surface has the same "
      "weight in the mean");
}

}  // namespace asperity::cli
