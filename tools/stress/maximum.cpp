#include "tools/stress/maximum.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stress/maximum_error.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {
namespace {

// A criterion as --of names it, the attribute of its maximum, and in a message.
struct CriterionWords {
  Criterion criterion;
  const char* of;
  Quantity<StressMaximum> maximum;
  const char* text;
};

constexpr CriterionWords criteria[] = {
    {Criterion::von_mises, "von_mises", {"stress_max_von_mises", &StressMaximum::value}, "von Mises stress"},
    {Criterion::max_shear, "max_shear", {"stress_max_shear", &StressMaximum::value}, "shear stress"},
    {Criterion::principal, "principal", {"stress_max_principal", &StressMaximum::value}, "principal stress"}};

constexpr Quantity<StressMaximum> place_quantities[] = {{"stress_max_x", &StressMaximum::x},
                                                        {"stress_max_y", &StressMaximum::y},
                                                        {"stress_max_depth", &StressMaximum::depth}};

const CriterionWords& criterion_words(Criterion of) {
  return *std::ranges::find(criteria, of, &CriterionWords::criterion);
}

// The middles of the layers that have flown, where the stress is known best, and on to three times their
// depth.
std::vector<double> depths_with_flow(const StressScene& scene, const StressSearch& search) {
  constexpr double ratio = 1.25, further = 3;
  std::vector<double> out = scene.residual->depths();
  for (const double deepest = further * out.back(); out.back() < deepest;) out.push_back(ratio * out.back());
  std::erase_if(out, [&](double z) { return z < search.below; });
  if (out.empty() || search.below > 0) out.insert(out.begin(), search.below);
  return out;
}

// `layers`: those of a dataset follow.
StressMaximum search_layers(const Tool& tool, const StressScene& scene, const LoadedBody& body,
                            const StressSearch& search) {
  const bool layers = !scene.depths.empty();
  Progress progress(tool, layers ? 0.5 : 1);
  StepTable probes(tool,
                   {"layer", "depth [um]", fmt::format("greatest {} [MPa]", criterion_words(search.of).of)});
  const auto volume = scene.solver(body, std::nullopt, tool.thread_count());
  const auto tell = [&](const StressProbe& p) {
    progress.count(static_cast<double>(p.done), static_cast<double>(p.expected), "layers searched");
    probes.row({std::to_string(p.done), fmt::format("{:.6g}", p.depth * 1e6),
                fmt::format("{:.6g}", p.value * 1e-6)});
  };
  if (!scene.residual) return maximum_stress(*volume, search, tell);
  const auto layers_searched = maximum_by_depth(*volume, search.of, depths_with_flow(scene, search), tell);
  StressMaximum top = *std::ranges::max_element(layers_searched, {}, &StressMaximum::value);
  top.layers = std::ssize(layers_searched);
  return top;
}

// `missing`: edge_error, 0 where no edge counts, NaN where it is not known.
void warn_if_shallow(const Tool& tool, const LoadedBody& body, const StressSearch& search,
                     const StressMaximum& top, double missing) {
  const bool shallow = is_shallow(body, top.depth);
  if (!shallow && missing == 0) return;
  std::string line =
      fmt::format("the largest {} lies {:.4g} um deep", criterion_words(search.of).text, top.depth * 1e6);
  if (shallow)
    line +=
        fmt::format(", less than the {:.4g} um of stress_accurate_depth", accurate_depth(body.grid) * 1e6);
  if (std::isnan(missing))
    line +=
        ": at an edge of a contact at its limit pressure it may be larger, by how much is not known; refine "
        "the grid, or search below the edge, --below 2px";
  else if (missing > 0)
    line += fmt::format(
        ": at an edge of a smooth contact with this largest pressure it is up to {:.4g} MPa "
        "more, of which a finer grid shows more only as the root of its cell; refine the grid, "
        "or search below the edge, --below 2px",
        missing * 1e-6);
  else
    line += fmt::format(
        ": it rests on single cells and may be off by {:.0f} % of the largest pressure; refine "
        "the grid",
        100 * shallow_error(body.poisson, body.friction));
  tool.warn(line);
}

// A maximum in the outermost cells has no parabola through it and stays at their centres.
bool at_end(double place, double first, double last) {
  return first != last && (place == first || place == last);
}

void warn_if_at_edge(const Tool& tool, const Grid& grid, const StressMaximum& maximum, const char* what) {
  const auto [nx, ny] = grid.shape;
  const bool in_x = !grid.periodic.x && at_end(maximum.x, grid.x(0), grid.x(nx - 1)),
             in_y = !grid.periodic.y && at_end(maximum.y, grid.y(0), grid.y(ny - 1));
  if (!in_x && !in_y) return;
  tool.warn(
      fmt::format("the largest {} lies at the edge of the domain, at ({:.4g}, {:.4g}) um, and may be "
                  "larger beyond it; choose a larger domain",
                  what, maximum.x * 1e6, maximum.y * 1e6));
}

StressMaximum found_maximum(const Tool& tool, StressScene& scene, const StressSearch& search,
                            const LoadedBody& body) {
  const auto& [criterion, of, quantity, what] = criterion_words(search.of);
  const StressMaximum top = search_layers(tool, scene, body, search);
  Attributes& a = scene.data.attributes;
  record(a, quantity, top);
  record(a, place_quantities, top);
  if (search.below > 0) a.set("stress_max_below", search.below);
  tool.detail(fmt::format("largest {} {:.6g} MPa, {:.6g} um deep, from {}", what, top.value * 1e-6,
                          top.depth * 1e6, counted(top.layers, "layer")));
  if (top.value == 0) return top;
  if (search.below > 0 && top.depth == search.below)
    tool.note(fmt::format("the largest {} lies at the depth of --below; above it, it is larger", what));
  const double missing = search.below > 0 || scene.residual
                             ? 0
                             : edge_error(top, search.of, body, at_limit_pressure(scene.data, body));
  if (missing > 0) a.set(error_name(quantity.name.text), missing);
  warn_if_shallow(tool, body, search, top, missing);
  warn_if_at_edge(tool, body.grid, top, what);
  return top;
}

}  // namespace

std::string attribute_of(Criterion of) { return std::string(criterion_words(of).maximum.name.text); }

StressSearch search_of(const StressOptions& options, const Grid& grid) {
  StressSearch search;
  search.of = std::ranges::find(criteria, options.of, &CriterionWords::of)->criterion;
  if (!options.below.empty()) search.below = depth_on(grid, "below", options.below, StressSearch::deepest);
  return search;
}

StressMaximum find_maximum(const Tool& tool, StressScene& scene, const StressSearch& search) {
  std::vector<StressMaximum> top;
  if (const Ranks& ranks = *scene.body.ranks; ranks.count() == 1) {
    top = {found_maximum(tool, scene, search, scene.body)};
  } else {
    const LoadedBody whole = scene.body.on_the_first();
    if (ranks.rank() == 0) top = {found_maximum(tool, scene, search, whole)};
    top = gathered(ranks, top);
  }
  return top.front();
}

Table maxima_of(const Tool& tool, const StressOptions& options, const StressScene& scene) {
  const StressSearch search = search_of(options, scene.body.grid);
  const auto& [criterion, of, quantity, what] = criterion_words(search.of);
  Progress progress(tool);
  const auto maxima = maximum_by_depth(*scene.solver(scene.body, std::nullopt, tool.thread_count()),
                                       search.of, scene.depths, [&](const StressProbe& p) {
                                         progress.count(static_cast<double>(p.done),
                                                        static_cast<double>(p.expected), "layers");
                                       });
  Table table{{{"depth", "m"}, {of, "Pa"}, {"x", "m"}, {"y", "m"}}, {}};
  for (const StressMaximum& m : maxima) table.rows.push_back({m.depth, m.value, m.x, m.y});
  warn_of_shallow_layers(tool, scene);
  const StressMaximum& top = *std::ranges::max_element(maxima, {}, &StressMaximum::value);
  if (top.value == 0) return table;
  warn_if_at_edge(tool, scene.body.grid, top, what);
  if (search.of == Criterion::von_mises) warn_of_yield(tool, scene, top.value);
  return table;
}

// ---- errors of the grid ----

RecordedContact loading_contact(const Dataset& data, int threads) {
  RecordedContact out = recorded_contact(data, threads);
  const bool solvable = out.unknown.empty() || out.growth.resolved() == Resolved::no;
  if (!solvable) throw UsageError("add", "grid_errors solves the contact again: " + out.unknown);
  return out;
}

StressMaximum maximum_error(const LoadedBody& body, DepthResolution resolution,
                            const CoarserContacts& coarser, const StressSearch& search,
                            const StressMaximum& maximum, bool at_limit_pressure, int threads) {
  auto on = [&](std::size_t level) {
    const LoadedBody below{coarser.grid[level], coarser.contact[level].pressure, body.poisson, body.friction};
    return maximum_stress(StressSolver(below, threads, resolution), search);
  };
  return maximum_error(body, {maximum, on(0), on(1)}, search, at_limit_pressure);
}

void record(Attributes& a, Criterion of, const StressMaximum& error) {
  if (std::isnan(error.value)) return;
  record_error(a, criterion_words(of).maximum, error);
  record_error(a, place_quantities[2], error);
}

void record_grid_errors(const Tool& tool, StressScene& scene, const RecordedContact& loading,
                        const StressSearch& search, const StressMaximum& maximum) {
  const CoarserContacts coarser = coarser_contacts(loading);
  if (!coarser.unknown.empty()) {
    tool.warn("the error of the largest stress is not known: " + coarser.unknown);
    return;
  }
  record(scene.data.attributes, search.of,
         maximum_error(scene.body, scene.resolution, coarser, search, maximum, loading.at_limit(),
                       tool.thread_count()));
}

}  // namespace asperity::cli
