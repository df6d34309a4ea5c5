#include "tools/measure/stats_options.hpp"

#include <algorithm>

#include "core/words.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {
namespace {

constexpr std::pair<const char*, Group> group_names[] = {{"height", Group::height},
                                                         {"gaussianity", Group::gaussianity},
                                                         {"material", Group::material},
                                                         {"hybrid", Group::hybrid},
                                                         {"spatial", Group::spatial}};

std::vector<double> shares(const std::string& list) {
  std::vector<double> out;
  for (const std::string& word : split(list, ',')) {
    const auto value = to_number<double>(word);
    if (!value || !(*value >= 0 && *value <= 1))
      throw UsageError("quantiles", "value \"" + word + "\" is not a number from 0 to 1");
    if (std::ranges::find(out, *value) != out.end())
      throw UsageError("quantiles", "value \"" + word + "\" is given twice");
    out.push_back(*value);
  }
  return out;
}

}  // namespace

void StatsOptions::declare(Tool& tool) {
  field.declare(tool);
  tool.text(
      "--parameters", groups, "GROUP,...",
      "height (Sa, Sq, Ssk, Sku, Sp, Sv, Sz and effective sample sizes), gaussianity (the tests of "
      "Jarque-Bera, Kolmogorov-Smirnov, Anderson-Darling and Pearson, with p-values that allow for the "
      "correlation and naive ones that do not), material (Sk, Spk, Svk, Smr1, Smr2, Vmp, Vmc, Vvc, Vvv), "
      "hybrid (Sdq, Sdr, spectral moments, summits), spatial (Sal, Str, Std, ellipticity), or all; only what "
      "is asked for is computed",
      "Parameters");
  tool.choice(
      "--profile", profile, {"x", "y"},
      "Profile parameters of ISO 21920-2 in place of these, Pa, Pq, Psk, Pku, Pp, Pv, Pz, Pt, Pdq, PSm, or "
      "Ra and so on after --lambda-c, averaged over all profiles along x or y; each with its spread over "
      "them",
      "Parameters");
  tool.text("--quantiles", quantiles, "P,...",
            "Heights below which these shares of the surface lie, 0.5 the median", "Parameters");
  tool.quantities("--material-ratio", measured.material_ratios, "1",
                  "Shares p,q that bound the core in Vmp, Vmc, Vvc, Vvv, and of Smc_p, Smc_q", "Parameters");
  tool.number("--sal-level", measured.sal_level, "Level of R / R(0,0) to which Sal and Str are measured",
              "Parameters");
  tool.memory(
      "Largest memory for the field. A file of more than an eighth of it is read in strips, above any "
      "--remove-form, for all but spatial and the filters, which need the whole field and are refused if the bound "
      "was given. The order of the heights takes 25 MB more. Errors then rest on the correlation within the "
      "strips, where the dataset carries none");
  tool.text("--direction", direction, "ANGLE",
            "Spectral moments in this direction too, from +x towards +y: 30deg", "Parameters");
}

MeasureOptions StatsOptions::checked(const Tool& tool) const {
  MeasureOptions out = measured;
  out.groups = asked_groups();
  out.preparation = field.preparation();
  out.profiles = profile == "y" ? Axis1D::y : Axis1D::x;
  out.threads = tool.thread_count();
  check_belonging(tool, out.groups);
  if (!direction.empty()) out.direction = {parse_angle("direction", direction), direction};
  if (!profile.empty()) {
    out.groups = {Group::profiles};
  } else if (!quantiles.empty()) {
    out.quantiles = shares(quantiles);
    out.groups.insert(Group::quantiles);
  }
  return out;
}

std::set<Group> StatsOptions::asked_groups() const {
  std::set<Group> out;
  const std::vector<std::string> words = split(groups, ',');
  for (const std::string& word : words) {
    const auto named = [&](const auto& group) { return word == group.first || word == "all"; };
    if (std::ranges::none_of(group_names, named))
      throw UsageError("parameters",
                       "value \"" + word + "\" is not height, gaussianity, material, hybrid, spatial or all");
    if (std::ranges::count(words, word) > 1)
      throw UsageError("parameters", "value \"" + word + "\" is given twice");
    for (const auto& [name, group] : group_names)
      if (word == name || word == "all") out.insert(group);
  }
  return out;
}

void StatsOptions::check_belonging(const Tool& tool, const std::set<Group>& asked) const {
  for (const char* areal : {"parameters", "quantiles", "material-ratio", "sal-level", "direction"})
    if (!profile.empty() && tool.given(std::string("--") + areal))
      throw UsageError(areal, "is of the surface, and does not go together with --profile");
  for (const auto& [option, group, name] : {std::tuple{"material-ratio", Group::material, "material"},
                                            {"sal-level", Group::spatial, "spatial"},
                                            {"direction", Group::hybrid, "hybrid"}})
    if (tool.given(std::string("--") + option) && !asked.contains(group))
      throw UsageError(option, std::string("belongs to --parameters ") + name + ", which is not asked for");
}

}  // namespace asperity::cli
