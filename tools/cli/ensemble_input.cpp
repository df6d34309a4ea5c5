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
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "dataset/unread.hpp"
#include "formats/format.hpp"
#include "formats/text_numbers.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/surface_words.hpp"

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

void EnsembleInput::claim(Tool& tool, const std::string& option,
                          const std::vector<std::string>& outputs) const {
  for (const std::string& output : outputs) tool.writes(option, output);
  if (files.size() > 1)
    for (const std::string& file : files) tool.reads(file);
}

Dataset EnsembleInput::only(const Tool& tool) {
  Dataset out;
  for_each(
      tool, [](EnsembleMember&& member) { return std::move(member.data); },
      [&](Dataset&& data, const std::string&) { out = std::move(data); });
  return out;
}

// The surfaces as they come, on threads of their own where that pays.
class EnsembleInput::Visits {
 public:
  using Read = std::function<Dataset()>;

  const Tool& tool;

  Visits(const Tool& by, const Several& several, const Visit& visit)
      : tool(by), several_(several), visit_(visit), progress_(by) {}

  /// A file; `one` has no data yet.
  void add(EnsembleMember one) {
    const Read read = [this, name = one.name] { return tool.read(name); };
    std::error_code none;
    if (work_ && std::filesystem::is_regular_file(one.name, none))
      return work_->add([this, one = std::move(one), read]() mutable -> Action {
        begin(one);
        return opened(one, read) ? worked_on(std::move(one)) : [] {};
      });
    finish();
    begin(one);
    add_read(one, read);
  }
  /// Reads a surface now; the first decides how many are worked on at once.
  void add_read(EnsembleMember one, const Read& read) {
    if (!opened(one, read)) return;
    if (!work_) work_.emplace(one.alone() ? 1 : datasets_at_once(tool, shape_of(one.data)));
    work_->add([this, one = std::move(one), taken = tool.take_warnings()]() mutable {
      tool.go_on_with(std::move(taken));
      return worked_on(std::move(one));
    });
  }
  void begin(const EnsembleMember& one) {
    if (!one.alone()) {
      tool.about(one.name);
      in_order([this, done = static_cast<double>(one.number - 1), of = static_cast<double>(one.of)] {
        progress_.count(done, of, "surfaces");
      });
    }
    tool.reads(one.name, one.alone() && tool.result_is_dataset());
  }
  /// Until the results of all so far are taken; the worst exit code.
  int finish() {
    if (work_) work_->finish();
    return worst_;
  }

 private:
  static Shape shape_of(const Dataset& data) {
    auto points = [&](std::string_view axis) {
      const Variable* const found = data.find(axis);
      return found == nullptr ? Index{0} : static_cast<Index>(count(*found));
    };
    return {points("x"), points("y")};
  }
  bool others_go_on(const EnsembleMember& after) const {
    return !after.alone() && several_.go_on != Several::GoOn::never;
  }
  // False of one that cannot be read, if the others go on.
  bool opened(EnsembleMember& one, const Read& read) try {
    one.data = read();
    return true;
  } catch (const DataError& error) {
    if (!others_go_on(one)) throw;
    in_order(failed(one.name, tool.in_file(error), bad_data));
    return false;
  }
  // A large one among small ones has all threads, in its order.
  Action worked_on(EnsembleMember&& one) {
    if (!works_alone() || !is_worth_all_threads(shape_of(one.data))) return result_of(std::move(one));
    return [this, one = std::move(one), taken = tool.take_warnings()]() mutable {
      tool.go_on_with(std::move(taken));
      result_of(std::move(one))();
    };
  }
  Action result_of(EnsembleMember&& one) {
    if (!one.alone()) tool.detail(one.name);
    check_likeness(one);
    const std::string name = one.name;
    const bool go_on = others_go_on(one);
    try {
      return [this, take = visit_(std::move(one))] { worst_ = std::max(worst_, take()); };
    } catch (const DataError& error) {
      if (!go_on) throw;
      return failed(name, tool.in_file(error), bad_data);
    } catch (const ParameterError& error) {
      if (!go_on || several_.go_on != Several::GoOn::after_any_error) throw;
      return failed(name, "`" + error.name + "`: " + error.what(), usage_error);
    }
  }
  Action failed(const std::string& name, const std::string& why, int code) {
    tool.warn(why);
    return [this, name, code] {
      worst_ = std::max(worst_, code);
      several_.failed(name);
    };
  }

  struct Like {
    Grid grid;
    std::string file, unit;
  };
  void check_likeness(const EnsembleMember& one) {
    const std::string& variable = several_.variable;
    if (variable.empty() && several_.on_one_grid.empty()) return;
    Like own{grid_of(one.data), one.name, ""};
    if (!variable.empty()) own.unit = si_unit_of(one.data.at(variable));
    in_order([this, own = std::move(own)] { compare_with_first(own); });
  }
  void compare_with_first(const Like& one) {
    if (!first_) first_ = one;
    if (one.unit != first_->unit)
      throw DataError(one.file, "its unit, " + one.unit + ", differs from that of " + first_->file + ", " +
                                    first_->unit + ": quantities of different kinds cannot be averaged");
    const std::string both = "its grid, " + described(one.grid) + ", differs from that of " + first_->file +
                             ", " + described(first_->grid);
    if (!several_.variable.empty() && is_profile(one.grid) != is_profile(first_->grid))
      throw DataError(one.file, both +
                                    ": heights of a profile and of a map are measured from different "
                                    "means; measure them separately");
    if (!same_spacing(one.grid, first_->grid)) {
      if (!several_.of_spacings.empty()) return warn(one, both + ": " + several_.of_spacings);
      throw DataError(
          one.file,
          both +
              ": parameters depend on the spacing and cannot be averaged or compared; measure the surfaces "
              "separately, or thin the finer one (asperity-filter --decimate)");
    }
    if (same_grid(one.grid, first_->grid)) return;
    if (!several_.on_one_grid.empty())
      throw DataError(one.file, both + ": " + several_.on_one_grid + " needs surfaces of one grid");
    warn(one, both + ": " + several_.of_sizes);
  }
  void warn(const Like& one, const std::string& why) {
    if (!std::exchange(warned_, true)) tool.warn(one.file + ": " + why);
  }
  static bool is_profile(const Grid& grid) { return std::min(grid.shape.nx, grid.shape.ny) == 1; }

  const Several& several_;
  const Visit& visit_;
  std::optional<Like> first_ = {};
  bool warned_ = false;  ///< of another grid
  Progress progress_;
  int worst_ = done;
  std::optional<OrderedWork> work_ = {};  ///< from the first surface on
};

// The bytes are kept for another visit.
void EnsembleInput::visit_standard_input(Visits& visits, const EnsembleMember& one) {
  const Tool& tool = visits.tool;
  visits.finish();
  visits.begin(one);
  if (!piped_) piped_ = piped(tool);
  const bool names = look_like_names(*piped_);
  visits.add_read(one, [&, alone = one.alone()]() -> Dataset {
    try {
      return alone ? tool.read(std::move(*std::exchange(piped_, {})), "-") : tool.read(*piped_, "-");
    } catch (const DataError& error) {
      if (!names) throw;
      throw DataError(error.name, std::string(error.what()) + ". For a list of files say --files-from -");
    }
  });
}

int EnsembleInput::visit_all(const Tool& tool, const Several& several, const Visit& visit) {
  resolve(tool);
  Visits visits(tool, several, visit);
  std::size_t number = 0;
  for (const std::string& name : files) {
    const EnsembleMember one{{}, name, ++number, files.size()};
    name == "-" ? visit_standard_input(visits, one) : visits.add(one);
  }
  const int worst = visits.finish();
  tool.about("");
  return worst;
}

}  // namespace asperity::cli
