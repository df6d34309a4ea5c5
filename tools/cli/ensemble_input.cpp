#include "tools/cli/ensemble_input.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <glob.h>
#include <map>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "dataset/unread.hpp"
#include "formats/format.hpp"
#include "formats/text_numbers.hpp"
#include "tools/cli/file_identity.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/cli/turns.hpp"

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

// The names in a list, one per line.
Names listed(const Tool& tool, const std::string& list) {
  tool.reads(list);
  const Bytes bytes = read_all(list, tool.memory_bound());
  std::string_view rest = bytes;
  Names out;
  while (!rest.empty())
    if (const std::string_view name = take_line(rest); !name.empty()) out.emplace_back(name);
  if (out.empty()) refuse("files-from", list, "lists no file: write one name per line");
  if (!is_text(bytes))
    refuse("files-from", list, "is not a list of files, one name per line: name a dataset itself as INPUT");
  if (std::ranges::find(out, "-") != out.end())
    refuse("files-from", list, "lists '-', but standard input has no name: list files, or give - as INPUT");
  return out;
}

// Bytes of names are no map; these look like some.
bool look_like_names(std::string_view bytes) {
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  return is_text(bytes) && line.find_first_of(" \t;,#") == line.npos && !to_number<double>(line);
}

Bytes piped(const Tool& tool) {
  if (stdin_is_terminal()) throw UsageError(argument, "no input: name files, or pipe in a dataset");
  return read_all("-", tool.memory_bound());
}

}  // namespace

EnsembleInput::Declared EnsembleInput::declare(Tool& tool) {
  const Option input = tool.arguments(
      argument, files, "FILE",
      "Datasets or maps to read, or patterns such as 's_*.nc'; none or -: a dataset on standard input");
  const Option list = tool.text(
      "--files-from", list_, "FILE",
      "List of the files to read in place of INPUT, one name per line; - is standard input", "Input");
  tool.input_format();
  return {input, list.excludes(input)};
}

bool EnsembleInput::takes_standard_input() const {
  return list_.empty() ? files.empty() || std::ranges::find(files, "-") != files.end() : list_ == "-";
}

std::size_t EnsembleInput::resolve(const Tool& tool) {
  if (std::exchange(resolved_, true)) return files.size();
  const int ranks = tool.ranks().count();
  if (ranks > 1 && takes_standard_input())
    throw UsageError(argument, "standard input reaches the first rank alone: name a file");
  files = list_.empty() ? all_matches(files) : listed(tool, list_);
  check(tool, files);
  if (ranks > 1 && files.size() > 1)
    throw UsageError(argument,
                     fmt::format("{} surfaces cannot be shared by {} ranks: start a process for each",
                                 files.size(), ranks));
  return files.size();
}

Dataset EnsembleInput::only(const Tool& tool) {
  Dataset out;
  for_each(tool, [&](EnsembleMember&& member) { out = std::move(member.data); });
  return out;
}

// The surfaces as they come, on threads of their own where that pays.
class EnsembleInput::Visits {
 public:
  using Read = std::function<Dataset()>;

  const Run& run;

  explicit Visits(const Run& of) : run(of), progress_(of.tool) {}

  /// A file.
  void add(const std::string& name, std::size_t number, std::size_t of) {
    const Read read = [this, name] { return run.tool.read(name); };
    std::error_code none;
    if (turns_ && std::filesystem::is_regular_file(name, none))
      return turns_->add([this, name, number, of, read] {
        begin(name, number, of);
        if (std::optional<EnsembleMember> member = opened(name, number, of, read)) visit(std::move(*member));
      });
    finish();
    begin(name, number, of);
    add_read(name, number, of, read);
  }
  /// Reads a surface now; the first decides how many are visited at once.
  void add_read(const std::string& name, std::size_t number, std::size_t of, const Read& read) {
    std::optional<EnsembleMember> member = opened(name, number, of, read);
    if (!member) return;
    if (!turns_) turns_.emplace(of > 1 ? datasets_at_once(run.tool, shape_of(member->data)) : 1);
    turns_->add([this, one = std::move(*member)]() mutable { visit(std::move(one)); });
  }
  void begin(const std::string& name, std::size_t number, std::size_t of) {
    if (of > 1) {
      run.tool.about(name);
      in_turn([this, number, of] {
        progress_.count(static_cast<double>(number - 1), static_cast<double>(of), "surfaces");
      });
    }
    run.tool.reads(name, of == 1 && run.tool.result_is_dataset());
  }
  /// Until all so far have been told of.
  void finish() {
    if (turns_) turns_->finish();
  }

 private:
  static Shape shape_of(const Dataset& data) {
    auto points = [&](std::string_view axis) {
      const Variable* const found = data.find(axis);
      return found == nullptr ? Index{0} : static_cast<Index>(count(*found));
    };
    return {points("x"), points("y")};
  }
  // Nothing of one that cannot be read, if the others go on.
  std::optional<EnsembleMember> opened(const std::string& name, std::size_t number, std::size_t of,
                                       const Read& read) const try {
    return EnsembleMember{read(), name, number, of};
  } catch (const DataError& error) {
    if (of == 1 || !run.failed) throw;
    in_turn([this, name, why = run.tool.in_file(error)] { run.failed(name, why); });
    return std::nullopt;
  }
  // A large one among small ones has all threads, in its turn.
  void visit(EnsembleMember&& member) const {
    if (!works_alone() || !is_worth_all_threads(shape_of(member.data))) return run.visit(std::move(member));
    in_turn([this, one = std::move(member)]() mutable { run.visit(std::move(one)); });
  }

  Progress progress_;
  std::optional<Turns> turns_ = {};  ///< from the first surface on
};

// The dataset on standard input, one of so many. It is kept for another visit.
void EnsembleInput::visit_standard_input(Visits& visits, std::size_t number, std::size_t of) {
  const Run& run = visits.run;
  if (of > 1) run.tool.about("-");
  run.tool.reads("-", of == 1 && run.tool.result_is_dataset());
  if (!piped_) piped_ = piped(run.tool);
  const bool names = look_like_names(*piped_);
  visits.add_read("-", number, of, [&]() -> Dataset {
    try {
      return of > 1 ? run.tool.read(*piped_, "-") : run.tool.read(std::move(*std::exchange(piped_, {})), "-");
    } catch (const DataError& error) {
      if (!names) throw;
      throw DataError(error.name, std::string(error.what()) + ". For a list of files say --files-from -");
    }
  });
}

void EnsembleInput::visit_all(const Run& run) {
  resolve(run.tool);
  Visits visits(run);
  for (std::size_t k = 0; k < files.size(); ++k)
    if (files[k] == "-")
      visit_standard_input(visits, k + 1, files.size());
    else
      visits.add(files[k], k + 1, files.size());
  visits.finish();
  run.tool.about("");
}

void EnsembleGrid::add(const Tool& tool, const Grid& grid, const std::string& file, const std::string& unit) {
  in_turn([this, &tool, grid, file, unit] { compare(tool, grid, file, unit); });
}

void EnsembleGrid::compare(const Tool& tool, const Grid& grid, const std::string& file,
                           const std::string& unit) {
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
