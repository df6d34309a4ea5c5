#include "tools/filter/chain.hpp"

#include <algorithm>
#include <functional>

#include "core/error.hpp"
#include "tools/measure/preparation_words.hpp"

namespace asperity::cli {
namespace {

const std::vector<StepKind>& kinds() {
  static const std::vector<StepKind> all = [] {
    std::vector<StepKind> out = form_steps();
    for (const auto& more : {point_steps(), grid_steps()}) out.insert(out.end(), more.begin(), more.end());
    return out;
  }();
  return all;
}

// An S-filter at or beyond an L-filter of the same chain leaves nothing, whichever is first.
void check_cutoffs(const std::vector<Tool::Step>& steps) {
  for (const auto& [option, value] : steps)
    for (const auto& [other, its] : steps)
      if (option == "lambda-s" && other == "lambda-c" &&
          parse_cutoff(option, value).wavelength >= parse_cutoff(other, its).wavelength)
        throw UsageError("lambda-s", value + " is not below --lambda-c " + its + ": no wave passes both");
}

void add_line(const Tool& tool, std::vector<std::string>& lines, const std::string& step,
              const std::string& words) {
  lines.push_back(std::to_string(lines.size() + 1) + ". " + step + ": " + words);
  tool.detail(lines.back());
}

}  // namespace

void Chain::declare(Tool& tool) {
  for (const StepKind& kind : kinds())
    tool.step("--" + std::string(kind.option), kind.kind, kind.text, kind.group);
  tool.steps_in_a_text("Steps");
}

Chain::Chain(const Tool& tool) {
  const std::vector<Tool::Step> steps = tool.steps();
  if (steps.empty()) throw UsageError("steps", "are missing: give one or more, such as --remove-form plane");
  for (const auto& [option, value] : steps) {
    const StepKind& kind = *std::ranges::find(kinds(), option, &StepKind::option);
    links_.push_back({option, value, kind.act(value)});
  }
  check_cutoffs(steps);
}

Chain::Ran Chain::operator()(const Tool& tool, Surface& surface) const {
  Ran out;
  for (const Link& link : links_) try {
      const auto [words, told, doubt] = link.act(tool, surface);
      add_line(tool, out.lines, link.words(), words);
      if (told && !tool.verbose()) tool.note(link.words() + ": " + words);
      if (!doubt.empty()) tool.warn(link.words() + ": " + doubt), out.converged = false;
    } catch (const ParameterError& error) {
      throw ParameterError(link.option, error.what());
    }
  return out;
}

}  // namespace asperity::cli
