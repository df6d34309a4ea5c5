#include "tools/stress/quantity.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/cli/tool.hpp"

namespace asperity::cli {
namespace {

StressQuantity equivalent(StressOutput output, void (*along_row)(const StressRow&, std::span<double>),
                          double of_mises = 0) {
  return {output.name,
          stress::all,
          {output},
          [along_row](const StressRow& s, RowOutputs out) { along_row(s, out[0]); },
          of_mises};
}

StressQuantity component(stress::Component c) {
  const std::string name(stress::names[c]);
  return {name,
          stress::Set().set(c),
          {{"stress_" + name, "stress " + name + ", positive in tension"}},
          [c](const StressRow& s, RowOutputs out) { std::ranges::copy(s[c], out[0].begin()); }};
}

std::vector<StressQuantity> make_quantities() {
  std::vector<StressOutput> principal, directions;
  for (int k = 1; k <= 3; ++k) {
    principal.push_back(
        {fmt::format("stress_{}", k), fmt::format("principal stress {}, positive in tension", k)});
    for (char axis : {'x', 'y', 'z'})
      directions.push_back({fmt::format("direction_{}_{}", k, axis),
                            fmt::format("{} component of the unit vector along principal stress {}", axis, k),
                            "1"});
  }
  std::vector<StressQuantity> list{equivalent({"von_mises", "von Mises equivalent stress"}, von_mises, 1),
                                   equivalent({"max_shear", "largest shear stress"}, max_shear_stress),
                                   equivalent({"octahedral_shear", "octahedral shear stress"},
                                              octahedral_shear, octahedral_over_von_mises),
                                   {"principal", stress::all, principal,
                                    [](const StressRow& s, RowOutputs out) { principal_stress(s, out); }},
                                   {"principal_directions", stress::all, directions, principal_directions}};
  for (stress::Component c : stress::components) list.push_back(component(c));
  return list;
}

const std::vector<StressQuantity>& quantities() {
  static const std::vector<StressQuantity> list = make_quantities();
  return list;
}

// All are the stresses; the nine directions would be half of what is written.
bool asked(const std::vector<std::string>& words, const StressQuantity& q) {
  return std::ranges::count(words, q.word) > 0 ||
         (std::ranges::count(words, "all") > 0 && std::ranges::all_of(q.outputs, &StressOutput::is_stress));
}

}  // namespace

std::string stress_words() {
  std::string out;
  for (const StressQuantity& q : quantities()) out += (out.empty() ? "" : ", ") + q.word;
  return out;
}

StressSelection::StressSelection(const std::string& list) {
  const std::vector<std::string> words = split(list, ',');
  for (const std::string& word : words)
    if (word != "all" && std::ranges::count(quantities(), word, &StressQuantity::word) == 0)
      throw UsageError("components", "'" + word + "' is none of " + stress_words() + ", all");
  for (const StressQuantity& q : quantities()) {
    if (!asked(words, q)) continue;
    chosen_.push_back(&q);
    needs_ |= q.needs;
    outputs_.insert(outputs_.end(), q.outputs.begin(), q.outputs.end());
  }
}

void StressSelection::compute(const StressRow& stress, RowOutputs out) const {
  for (const StressQuantity* q : chosen_) {
    q->compute(stress, out.first(q->outputs.size()));
    out = out.subspan(q->outputs.size());
  }
}

// ---- rows of layers ----

LayerRows::LayerRows(const StressSelection& selection, const StressSolver& solver)
    : selection_(selection), solver_(solver), layers_(size(solver.threads())) {
  for (std::size_t first = 0; const StressQuantity* q : selection.chosen()) {
    placed_.push_back({q, first});
    first += q->outputs.size();
    mises_ = mises_ || q->of_mises != 0;
    together_ = together_ || (q->needs == stress::all && (q->of_mises == 0 || !solver.by_component()));
  }
}

void LayerRows::compute(Index l, double z, StressSolver::Workspace& work, const Take& take,
                        const BehindRows& after) {
  if (together_)
    at_once(z, work, take, after);
  else
    one_by_one(z, work, layers_[size(l) % layers_.size()], take, after);
}

void LayerRows::at_once(double z, StressSolver::Workspace& work, const Take& take,
                        const BehindRows& after) const {
  const std::size_t outputs = selection_.outputs().size(), points = size(solver_.shape().ny);
  auto row = [&](Index i, const StressRow& stress) {
    std::vector<double> values(outputs * points);
    std::vector<std::span<double>> out;
    for (std::size_t k = 0; k < outputs; ++k) out.push_back(std::span(values).subspan(k * points, points));
    selection_.compute(stress, out);
    for (std::size_t k = 0; k < outputs; ++k) take(k, i, out[k]);
  };
  solver_.layer(z, selection_.needs(), work, row, after);
}

void LayerRows::one_by_one(double z, StressSolver::Workspace& work, std::optional<MisesLayer>& mises,
                           const Take& take, const BehindRows& after) const {
  const Extent own = solver_.rows();
  if (mises_ && !mises) mises.emplace(Shape{own.count, solver_.shape().ny});
  for (stress::Component c : stress::components) {
    const auto only = stress::Set().set(c);
    if ((selection_.needs() & only).none()) continue;
    auto take_row = [&](Index i, const StressRow& row) {
      std::vector<double> values(row[c].begin(), row[c].end());
      for (const auto& [quantity, first] : placed_)
        if (quantity->needs == only) take(first, i, values);
      if (mises) mises->add(c, i - own.first, row[c]);
      if (!mises || c != stress::yz) return;
      for (const auto& [quantity, first] : placed_) {
        if (quantity->of_mises == 0) continue;
        mises->row(i - own.first, quantity->of_mises, values);
        take(first, i, values);
      }
    };
    solver_.layer(z, only, work, take_row, after);
  }
}

}  // namespace asperity::cli
