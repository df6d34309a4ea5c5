#include "tools/measure/stats_options.hpp"

#include <algorithm>
#include <cmath>

#include "core/words.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {
namespace {

constexpr std::pair<const char*, Group> group_names[] = {
    {"height", Group::height}, {"gaussianity", Group::gaussianity}, {"material", Group::material},
    {"hybrid", Group::hybrid}, {"spatial", Group::spatial},         {"feature", Group::feature}};

std::vector<double> shares(const std::string& list) {
  std::vector<double> out;
  for (const std::string& word : split(list, ',')) {
    const auto value = to_number<double>(word);
    if (!value || !(*value >= 0 && *value <= 1))
      throw UsageError("quantiles", "'" + word + "' is not a number from 0 to 1");
    if (std::ranges::find(out, *value) != out.end())
      throw UsageError("quantiles", "'" + word + "' is given twice");
    out.push_back(*value);
  }
  return out;
}

void profile_option(Tool& tool, std::string& profile) {
  tool.choice(
      "--profile", profile, {"x", "y"},
      "Profile parameters (ISO 21920-2) along x or y instead: the mean over all profiles, and the spread. "
      "Pa, "
      "Pq, Psk, Pku, Pp, Pv, Pz, Pt, Pdq, PSm, Pc; Pk, Ppk, Pvk, Pmr1, Pmr2, Ppkx, Pvkx, Pak1, Pak2; Pmc_p, "
      "Pmc_q, Pdc at the ratios of --material-ratio; P5p, P5v, P10z, of peaks and pits pruned at 5 % of Pz. "
      "With --lambda-c Ra and so on; the standard has Rk to Rak2 behind its robust filter, 0.8mm,robust",
      "Parameters");
}

void comparison_option(Tool& tool, bool& compare) {
  tool.flag("--compare", compare,
            "Compare the first INPUT with the others. A row for each parameter: value and standard error of "
            "both, their difference z in these errors, its p-value, and \"differs\" where p is at most 0.01, "
            "shared among the rows. Of several others the mean counts, with its error by their spread, which "
            "is also the error of a first one as large as they. Without an error the verdict is "
            "\"unknown\". Surfaces that depend on each other, as before and after a filter, have most of the "
            "errors in common: what differs does so all the more, and \"agrees\" tells little",
            "Parameters");
}

void noise_option(Tool& tool, std::string& noise) {
  tool.text(
      "--noise", noise, "SQ",
      "Rms noise of the instrument, 2nm: adds rows NAME_without_noise of Sq, m0, Sdq, and of m2 and m4, "
      "with their errors. It is white, independent from point to point; --compare tells that of two maps of "
      "one place",
      "Parameters");
}

}  // namespace

void pruning_option(Tool& tool, std::string& pruning, const std::string& group) {
  tool.text(
      "--pruning", pruning, "HEIGHT|SHARE%",
      "Least height of a hill above its saddle, and of a dale below, for features: 20nm, or 5% of Sz. Errors "
      "need a height, for Sz grows with the field",
      group);
}

Pruning parse_pruning(const std::string& text) {
  if (!text.ends_with('%')) return {parse_quantity("pruning", text, "m"), false};
  const auto percent = to_number<double>(std::string_view(text).substr(0, text.size() - 1));
  if (!percent) refuse("pruning", text, "is no share: write 5%, or a height such as 20nm");
  return {*percent / 100, true};
}

void StatsOptions::declare(Tool& tool) {
  field.declare(tool);
  std::vector<std::string> words{"all"};
  for (const auto& [name, group] : group_names) words.emplace_back(name);
  tool.words(
      "--parameters", groups, words,
      "Groups of parameters to print, or all. height: " + symbols(Group::height) +
          " and effective sample sizes; gaussianity: the tests of Jarque-Bera, Kolmogorov-Smirnov, "
          "Anderson-Darling and Pearson, with p-values that allow for the correlation of the heights, and "
          "naive ones; material: " +
          symbols(Group::material) + "; hybrid: " + symbols(Group::hybrid) +
          ", spectral moments, summits, of a single row or column spectral moments and peaks; spatial: Sal, "
          "Str, Std, ellipticity; feature: " +
          symbols(Group::feature) +
          ", of hills and dales; areas and volumes of closed ones, beyond the "
          "median",
      "Parameters");
  profile_option(tool, profile);
  tool.text("--quantiles", quantiles, "P,...",
            "Heights below which these shares of the surface lie; 0.5: the median", "Parameters");
  tool.quantities(
      "--material-ratio", measured.material_ratios, "1",
      "Material ratios p,q that bound the core; for Vmp, Vmc, Vvc, Vvv, Smc_p, Smc_q and Sdc. With p = q Vmp "
      "and Vvv are Vm(p) and Vv(p)",
      "Parameters");
  tool.text("--material-height", material_heights, "C,...",
            "Heights above the mean, or that of each profile, at which Smr(c) is printed: 0.5um,-1um",
            "Parameters");
  pruning_option(tool, pruning, "Parameters");
  tool.number("--sal-level", measured.sal_level, "Level of R / R(0,0) that defines Sal and Str",
              "Parameters");
  tool.choice(
      "--errors", errors, {"theory", "none"},
      "Standard errors and intervals, or none. theory: formulas where the correlation is known, else the "
      "field's own long waves",
      "Parameters");
  direction_option(tool, direction, "Parameters");
  noise_option(tool, noise);
  comparison_option(tool, compare);
}

MeasureOptions StatsOptions::checked(const Tool& tool) const {
  MeasureOptions out = measured;
  out.groups = asked_groups();
  out.preparation = field.asked;
  out.profiles = profile == "y" ? Axis1D::y : Axis1D::x;
  out.threads = tool.thread_count();
  check_belonging(tool, out.groups);
  if (compare && errors == "none") throw UsageError("compare", "needs errors; --errors none gives none");
  out.pruning = parse_pruning(pruning);
  if (!direction.empty()) out.direction = {parse_angle("direction", direction), direction};
  if (!profile.empty()) {
    out.groups = {Group::profiles};
  } else if (!quantiles.empty()) {
    out.quantiles = shares(quantiles);
    out.groups.insert(Group::quantiles);
  }
  return out;
}

std::vector<MaterialHeight> StatsOptions::heights_in(const std::string& unit) const {
  std::vector<MaterialHeight> out;
  if (material_heights.empty()) return out;
  for (const std::string& word : split(material_heights, ',')) {
    if (std::ranges::find(out, word, &MaterialHeight::text) != out.end())
      refuse("material-height", word, "is given twice");
    out.push_back({parse_quantity("material-height", word, unit), word});
    if (!std::isfinite(out.back().value)) refuse("material-height", word, "is no height");
  }
  return out;
}

std::set<Group> StatsOptions::asked_groups() const {
  std::set<Group> out;
  for (const std::string& word : groups)
    for (const auto& [name, group] : group_names)
      if (word == name || word == "all") out.insert(group);
  return out;
}

void StatsOptions::check_belonging(const Tool& tool, const std::set<Group>& asked) const {
  for (const char* areal : {"parameters", "quantiles", "sal-level", "pruning", "direction", "noise"})
    if (!profile.empty() && tool.given(std::string("--") + areal))
      throw UsageError(areal, "cannot be combined with --profile");
  for (const auto& [option, group, name] : {std::tuple{"material-ratio", Group::material, "material"},
                                            {"material-height", Group::material, "material"},
                                            {"sal-level", Group::spatial, "spatial"},
                                            {"pruning", Group::feature, "feature"},
                                            {"direction", Group::hybrid, "hybrid"}})
    if (tool.given(std::string("--") + option) && !asked.contains(group) && profile.empty())
      throw UsageError(option, std::string("needs --parameters ") + name +
                                   (group == Group::material ? " or --profile" : ""));
  if (noise.empty()) return;
  if (!asked.contains(Group::height) && !asked.contains(Group::hybrid))
    throw UsageError("noise", "needs --parameters height or --parameters hybrid");
  if (tool.given("--lambda-s"))
    throw UsageError("noise", "is that of single points, but --lambda-s smooths them: leave one of them out");
}

}  // namespace asperity::cli
