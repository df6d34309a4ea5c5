#include "tools/contact/several.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "dataset/layout.hpp"
#include "tools/cli/ensemble_rows.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/turns.hpp"
#include "tools/contact/record.hpp"

namespace asperity::cli {
namespace {

// Visits the scenes of all surfaces, and tells of those that fail.
class Scenes {
 public:
  using Solve = std::function<void(ContactScene& scene, const EnsembleMember& of)>;  ///< without its data
  using Failed = std::function<void(const std::string& name)>;

  Scenes(Tool& tool, ContactOptions& options) : tool_(tool), options_(options) {}

  /// The worst exit code of those that failed.
  int for_each(const Solve& solve, const Failed& failed) {
    auto fail = [&](const std::string& name, const std::string& why, int code) {
      tool_.warn(why);
      in_turn([this, &failed, name, code] {
        code_ = std::max(code_, code);
        failed(name);
      });
    };
    options_.surfaces.for_each(
        tool_,
        [&](EnsembleMember&& member) {
          tool_.detail(member.name);
          grids_.add(tool_, grid_of(member.data), member.name);
          try {
            ContactScene scene = scene_of(tool_, options_, std::move(member.data));
            warn(doubts(scene));
            warn(doubts(scene.grid, options_.bodies));
            solve(scene, member);
          } catch (const DataError& error) {
            fail(member.name, tool_.in_file(error), bad_data);
          } catch (const ParameterError& error) {
            fail(member.name, "`" + error.name + "`: " + error.what(), usage_error);
          }
        },
        [&](const std::string& name, const std::string& why) { fail(name, why, bad_data); });
    return code_;
  }

 private:
  void warn(const std::vector<Doubt>& doubts) const {
    for (const Doubt& doubt : doubts) tool_.warn(doubt.words);
  }

  Tool& tool_;
  ContactOptions& options_;
  EnsembleGrid grids_{"the mean over contacts"};
  int code_ = done;
};

double& number_in(Cell& cell) { return std::get<double>(cell); }

// What has not converged is unknown.
void blank_unconverged(Table& table) {
  const auto converged = static_cast<std::size_t>(
      std::ranges::find(table.columns, "converged", &Column::name) - table.columns.begin());
  for (auto& row : table.rows)
    if (number_in(row[converged]) == 0)
      for (std::size_t c = 0; c < row.size(); ++c)
        if (table.columns[c].name != "load") row[c] = NAN;
}

EnsembleTable::Content content_of(const Table& sweep) {
  const std::set<std::string> apart{"load", "approach", "residual", "convolutions", "converged"};
  EnsembleTable::Content out{.keys = {"load"}, .value = "approach", .error = "approach_standard_error"};
  for (const Column& c : sweep.columns)
    if (!apart.contains(c.name)) (c.name.ends_with("_error") ? out.means : out.others).push_back(c.name);
  return out;
}

}  // namespace

int press_several(Tool& tool, ContactOptions& options) {
  EnsembleRows rows(
      {.prefix = "contact_", .without = {"hertz_*"}, .achieved = {"residual", "convolutions", "converged"}});
  Influences influences(options);
  int code = done;
  const auto solve = [&](ContactScene& scene, const EnsembleMember& of) {
    const Inventory before(scene.data);
    const Pressed pressed = influences.with_one([&](Influence& own) { return press(options, scene, own); });
    record(scene, options, pressed.contact, pressed.figures);
    in_turn([&, name = of.name, results = scene.data.attributes, converged = pressed.contact.converged] {
      rows.add(name, results, converged);
    });
    for (const Doubt& doubt : pressed.doubts) tool.warn(doubt.words);
    in_turn([&code, own = told_exit(tool, options, pressed.contact, "")] { code = std::max(code, own); });
    if (options.each.empty()) return;
    if (of.number == 1) before.tell(tool, scene.data, "pressure");
    tool.write(scene.data, numbered("each", options.each, static_cast<std::int64_t>(of.number)));
  };
  const int failed =
      Scenes(tool, options).for_each(solve, [&](const std::string& name) { rows.add_failed(name); });
  print(tool, rows.table());
  return std::max(code, failed);
}

int sweep_several(Tool& tool, ContactOptions& options, const Sweep& sweep) {
  std::optional<EnsembleTable> mean;
  Influences influences(options);
  int code = done;
  const auto solve = [&](ContactScene& scene, const EnsembleMember& of) {
    int own = done;
    Table loads = influences.with_one(
        [&](Influence& influence) { return sweep(scene, influence.on(scene.grid), of.name + ": ", own); });
    blank_unconverged(loads);
    in_turn([&mean, &code, loads = std::move(loads), name = of.name, own] {
      code = std::max(code, own);
      if (!mean) mean.emplace(content_of(loads));
      mean->add(loads, name);
    });
  };
  const int failed = Scenes(tool, options).for_each(solve, [](const std::string&) {});
  if (mean) print(tool, mean->table());
  return std::max(code, failed);
}

}  // namespace asperity::cli
