// Form and waves.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "tools/filter/step.hpp"
#include "tools/measure/preparation_words.hpp"

namespace asperity::cli {
namespace {

// "a dome of radius 5mm; ", of what is no polynomial.
std::string words_of(const WithoutForm& found, Form::Kind kind) {
  if (kind == Form::Kind::polynomial) return "";
  std::string out = (found.radius > 0 ? "a dome" : "a bowl") + std::string(" of radius ") +
                    figure(std::abs(found.radius), "m");
  if (kind == Form::Kind::cylinder)
    out += ", axis at " + in_digits(found.axis * 180 / std::numbers::pi, 4) + "deg";
  return out + "; ";
}

Act without_form(const std::string& value) {
  return [form = parse_form("remove-form", value)](const Tool& tool, Surface& surface) -> Account {
    if (form.kind != Form::Kind::polynomial) check_lengths(surface, "the radius of a form");
    WithoutForm found = asperity::without_form(surface.heights, surface.grid, form, tool.thread_count());
    const Field former = std::exchange(surface.heights, std::move(found.heights));
    surface.degree = std::max(surface.degree, form.modes());
    const Removal removal(former, surface.heights);
    std::string words = words_of(found, form.kind) + removal.words(surface.units);
    const Index lost = missing_in(surface.heights) - missing_in(former);
    if (lost > 0) words += "; " + share_of(lost, former.size()) + " lie beyond it and are missing now";
    const bool poor = form.kind != Form::Kind::polynomial && !removal.most();
    if (poor) words += "; no more was removed than is left: --crop the map to the " + form.words();
    return {words, poor || lost > 0};
  };
}

// The waves on one side of the cut-off stay.
template <bool longer_stay>
Account filtered(const std::string& option, const Cutoff& cutoff, const Tool& tool, Surface& surface) try {
  check_cutoff(option, cutoff, surface.grid);
  warn_of_cutoff(tool, cutoff, surface.grid);
  MeanSurface waves = mean_surface(surface.heights, surface.grid, cutoff, tool.thread_count());
  if (!longer_stay) surface.degree = degree_behind(surface.degree, surface.grid, cutoff);
  if (!longer_stay) waves.surface = surface.heights - waves.surface;
  const Field former = std::exchange(surface.heights, std::move(waves.surface));
  return {removed(former, surface.heights, surface.units), false, waves.doubt};
} catch (const ParameterError& error) {
  throw ParameterError(option, error.what());
}

Act short_waves_removed(const std::string& value) {
  return [cutoff = parse_cutoff("lambda-s", value)](const Tool& tool, Surface& surface) {
    return filtered<true>("lambda-s", cutoff, tool, surface);
  };
}

Act long_waves_removed(const std::string& value) {
  return [cutoff = parse_cutoff("lambda-c", value)](const Tool& tool, Surface& surface) {
    return filtered<false>("lambda-c", cutoff, tool, surface);
  };
}

}  // namespace

std::vector<StepKind> form_steps() {
  const char* group = "Form and waves";
  return {
      {"remove-form", form_kind, "Subtract a form: " + form_words, group, without_form},
      {"lambda-s", cutoff_kind, "Keep the waves longer than this, by the S-filter. " + filter_words, group,
       short_waves_removed},
      {"lambda-c", cutoff_kind, "Keep the waves shorter than this, by the L-filter. FILTER as of --lambda-s",
       group, long_waves_removed}};
}

}  // namespace asperity::cli
