/// The surfaces that a tool reads one by one: files or patterns on the command line, those of a list, or a
/// dataset on standard input.
///
/// Bytes are data: only --files-from takes them for names. Whoever names a list names its files, so that an
/// error may quote them. A pattern that matches nothing, a file that cannot be opened, and a file that is
/// given twice are refused before the work: the same surface is no further sample.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// One of the surfaces.
struct EnsembleMember {
  Dataset data;
  std::string name;
  std::size_t number = 1, of = 1;  ///< which one, and how many there are

  bool alone() const { return of == 1; }
};

struct EnsembleInput {
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

  /// The surface, where there is one.
  Dataset only(const Tool& tool);

  using Visit = std::function<void(EnsembleMember&&)>;
  using Failed = std::function<void(const std::string& name, const std::string& why)>;

  /// Calls visit(member) for each surface. Of small ones several are visited at once: whatever they share,
  /// they leave to their turn (cli/turns.hpp). What comes from a pipe is read in its turn. Of a surface that
  /// is alone, --output may take the place, as of Tool::read(). After resolve(), several surfaces can be
  /// visited again.
  void for_each(const Tool& tool, const Visit& visit) { visit_all({tool, visit, {}}); }
  /// The same; where there are several, one that cannot be read is told to `failed`, in its turn, and the
  /// others go on.
  void for_each(const Tool& tool, const Visit& visit, const Failed& failed) {
    visit_all({tool, visit, failed});
  }

 private:
  class Visits;
  struct Run {
    const Tool& tool;
    const Visit& visit;
    Failed failed;  ///< empty: an error ends the run
  };
  void visit_all(const Run& run);
  void visit_standard_input(Visits& visits, std::size_t number, std::size_t of);

  std::string list_ = {};
  bool resolved_ = false;
  std::optional<Bytes> piped_ = {};  ///< the dataset on standard input
};

/// Checks that a mean over the surfaces is meaningful. Slopes, curvatures, peaks and correlation lengths
/// depend on the spacing: surfaces of different spacings are refused, and so are fields of different units.
/// Surfaces of different sizes estimate the same quantities with different errors: one warning, or an error
/// where something needs surfaces of one grid.
class EnsembleGrid {
 public:
  /// `alike`, "the test": what needs them; "": nothing does.
  explicit EnsembleGrid(std::string alike = "") : alike_(std::move(alike)) {}
  /// The grid of the next surface, and the unit of its field; throws DataError(file, …) with both grids or
  /// units if it does not fit the first; in turn.
  void add(const Tool& tool, const Grid& grid, const std::string& file, const std::string& unit = "m");

 private:
  void compare(const Tool& tool, const Grid& grid, const std::string& file, const std::string& unit);

  std::string alike_;
  std::optional<Grid> first_;
  std::string file_, unit_;
  bool warned_ = false;
};

}  // namespace asperity::cli
