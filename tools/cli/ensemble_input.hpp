/// The surfaces that a tool works on one by one: files or patterns on the command line, those of a list, or a
/// dataset on standard input.
///
///     surfaces.for_each(
///         tool, [&](EnsembleMember&& member) { return measured(tool, member.data); },  // on its own thread
///         [&](Parameters&& found, const std::string& name) { mean.add(found); });      // in input order
///
/// Bytes are data: only --files-from takes them for names. Whoever names a list names its files, so that an
/// error may quote them. A pattern that matches nothing, a file that cannot be opened, and a file that is
/// given twice are refused before the work: the same surface is no further sample.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/field.hpp"
#include "tools/cli/ordered_work.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// One of the surfaces.
struct EnsembleMember {
  Dataset data;
  std::string name;
  std::size_t number = 1, of = 1;  ///< which one, and how many there are

  bool alone() const { return of == 1; }
};

/// What holds where there are several surfaces.
struct Several {
  /// Whose unit all must have, and their grids the same spacing, on which slopes, curvatures, peaks and
  /// correlation lengths depend. Surfaces of different sizes estimate the same quantities with different
  /// errors: they give one warning. A profile and a map, measured from different means, are refused.
  std::string variable = {};
  /// What becomes of different sizes, for the warning; and of different spacings: none refuses them.
  std::string of_sizes =
      "extremes, correlation lengths and all errors depend on the size, and each surface counts alike";
  std::string of_spacings = {};
  /// "the mean at each lag": what needs surfaces of one grid, and refuses others.
  std::string on_one_grid = {};

  /// After which errors of one surface the others go on: its file or data, or also an option that does not
  /// fit it. The error becomes a warning, `failed(name)` takes the place of a result.
  enum class GoOn { never, after_bad_data, after_any_error } go_on = GoOn::never;
  std::function<void(const std::string& name)> failed = [](const std::string&) {};
};

class EnsembleInput {
 public:
  std::vector<std::string> files;

  /// INPUT, any number of them, --files-from, and the options of Tool::input_format().
  struct Declared {
    Option input, list;
  };
  Declared declare(Tool& tool);

  bool takes_standard_input() const;
  /// How many surfaces there are; `files` are their names from now on. Reads the list, if there is one.
  /// Several ranks share one surface, from a file.
  std::size_t resolve(const Tool& tool);
  /// Before the work: these files are written. Throws UsageError(option, …) where one is written twice, or is
  /// one of several surfaces; one that is alone is compared when it is read.
  void claim(Tool& tool, const std::string& option, const std::vector<std::string>& outputs) const;

  /// The surface, where there is one.
  Dataset only(const Tool& tool);

  /// Calls work(member) for each surface, and take(result, name) with what it returns: in the order of the
  /// input, on this thread. Of small surfaces several are worked on at once. What work() says and writes
  /// appears in order, too (cli/ordered_work.hpp); what comes from a pipe is read in order. Of a surface that
  /// is alone, --output may take the place, as of Tool::read(). --verbose names each of several. After
  /// resolve(), several surfaces can be visited again.
  ///
  /// Returns the worst exit code: of those that failed, and of what take() returns, if it returns one. Throws
  /// DataError(file, …) where the surfaces do not go together, with both grids or units.
  template <class Work, class Take>
  int for_each(const Tool& tool, const Work& work, const Take& take, const Several& several = {}) {
    return visit_all(tool, several, [&](EnsembleMember&& member) {
      const std::string name = member.name;
      using Result = std::invoke_result_t<Work, EnsembleMember&&>;
      const auto result = std::make_shared<Result>(work(std::move(member)));
      return [&take, name, result]() -> int {
        if constexpr (std::is_same_v<std::invoke_result_t<Take, Result&&, const std::string&>, int>)
          return take(std::move(*result), name);
        else
          return take(std::move(*result), name), done;
      };
    });
  }

 private:
  class Visits;
  using Visit = std::function<std::function<int()>(EnsembleMember&&)>;
  int visit_all(const Tool& tool, const Several& several, const Visit& visit);
  void visit_standard_input(Visits& visits, const EnsembleMember& one);

  std::string list_ = {};
  bool resolved_ = false;
  std::optional<Bytes> piped_ = {};  ///< the dataset on standard input
};

}  // namespace asperity::cli
