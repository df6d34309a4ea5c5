#include "tools/stress/quantity.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stress/octahedral.hpp"
#include "stress/principal.hpp"
#include "stress/tresca.hpp"
#include "stress/von_mises.hpp"
#include "tools/cli/series.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {
namespace {

using stress::Component;

template <Component c>
void copy(const StressRow& stress, Index count, double* const* out) {
  std::copy_n(stress[c], count, out[0]);
}

template <Component c>
StressQuantity component() {
  const std::string name(stress::names[c]);
  return {
      name, stress::Set().set(c), {{"stress_" + name, "stress " + name + ", positive in tension"}}, copy<c>};
}

StressQuantity principal() {
  StressQuantity out{"principal", stress::all, {}, principal_stress};
  for (int k = 1; k <= 3; ++k)
    out.outputs.push_back(
        {fmt::format("stress_{}", k), fmt::format("principal stress {}, positive in tension", k)});
  return out;
}

StressQuantity directions() {
  StressQuantity out{"principal_directions", stress::all, {}, principal_directions};
  for (int k = 1; k <= 3; ++k)
    for (char axis : {'x', 'y', 'z'})
      out.outputs.push_back(
          {fmt::format("direction_{}_{}", k, axis),
           fmt::format("{} component of the unit vector along principal stress {}", axis, k), "1"});
  return out;
}

std::vector<StressQuantity> make() {
  return {
      {"von_mises",
       stress::all,
       {{"von_mises", "von Mises equivalent stress"}},
       [](const StressRow& stress, Index count, double* const* out) { von_mises(stress, count, out[0]); }},
      {"tresca",
       stress::all,
       {{"max_shear", "largest shear stress"}},
       [](const StressRow& stress, Index count, double* const* out) {
         max_shear_stress(stress, count, out[0]);
       }},
      {"octahedral",
       stress::all,
       {{"octahedral_shear", "octahedral shear stress"}},
       [](const StressRow& stress, Index count, double* const* out) {
         octahedral_shear(stress, count, out[0]);
       }},
      principal(),
      directions(),
      component<stress::xx>(),
      component<stress::yy>(),
      component<stress::zz>(),
      component<stress::xy>(),
      component<stress::xz>(),
      component<stress::yz>()};
}

// All are the stresses; the nine directions would be half of what is written.
bool asked(const std::vector<std::string>& words, const StressQuantity& q) {
  const bool stress = std::ranges::all_of(q.outputs, [](const auto& o) { return o.units == "Pa"; });
  return std::ranges::any_of(words,
                             [&](const std::string& w) { return w == q.word || (w == "all" && stress); });
}

}  // namespace

const std::vector<StressQuantity>& stress_quantities() {
  static const std::vector<StressQuantity> list = make();
  return list;
}

std::string stress_words() {
  std::string out;
  for (const StressQuantity& q : stress_quantities()) out += (out.empty() ? "" : ", ") + q.word;
  return out;
}

StressSelection::StressSelection(const std::string& list) {
  const std::vector<std::string> words = split(list, ',');
  for (const std::string& word : words)
    if (word != "all" &&
        std::ranges::find(stress_quantities(), word, &StressQuantity::word) == stress_quantities().end())
      throw UsageError("components", "'" + word + "' is none of " + stress_words() + ", all");
  for (const StressQuantity& q : stress_quantities())
    if (asked(words, q)) chosen_.push_back(&q);
}

stress::Set StressSelection::needs() const {
  stress::Set out;
  for (const StressQuantity* q : chosen_) out |= q->needs;
  return out;
}

std::vector<StressQuantity::Output> StressSelection::outputs() const {
  std::vector<StressQuantity::Output> out;
  for (const StressQuantity* q : chosen_) out.insert(out.end(), q->outputs.begin(), q->outputs.end());
  return out;
}

void StressSelection::compute(const StressRow& stress, Index count, double* const* out) const {
  for (const StressQuantity* q : chosen_) {
    q->compute(stress, count, out);
    out += q->outputs.size();
  }
}

}  // namespace asperity::cli
