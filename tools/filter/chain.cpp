#include "tools/filter/chain.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "tools/measure/preparation_words.hpp"

namespace asperity::cli {
namespace {

const std::vector<StepKind>& kinds() {
  static const std::vector<StepKind> all = [] {
    std::vector<StepKind> out = value_steps();
    std::ranges::move(grid_steps(), std::back_inserter(out));
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

Chain::Result Chain::operator()(const Tool& tool, Surface& surface) const {
  Result out;
  for (const Link& link : links_) try {
      const auto [words, notable, doubt] = link.act(tool, surface);
      add_line(tool, out.lines, link.words(), words);
      if (notable && !tool.verbose()) tool.note(link.words() + ": " + words);
      if (!doubt.empty()) tool.warn(link.words() + ": " + doubt), out.converged = false;
    } catch (const ParameterError& error) {
      throw ParameterError(link.option, error.what());
    }
  return out;
}

// ---- figures of a report ----

// About its mean, so that an offset costs no digits.
Spread::Spread(const Field& z) {
  if (z.isNaN().all()) return;
  mean = asperity::mean(z);
  const ValidSum squares = sum_of_valid((z - mean).square());
  rms = std::sqrt(squares.sum / squares.count);
}

std::string Removal::words(const std::string& units) const {
  const auto [mean, rms] = gone;
  const std::string rest = figure(left.rms, units) + " rms is left";
  if (rms + std::abs(mean) <= 1e-12 * (left.rms + std::abs(left.mean)))
    return "removed nothing but round-off; " + rest;
  return fmt::format("removed {} rms about a mean of {}; {}", figure(rms, units),
                     figure(std::abs(mean) > 1e-9 * rms ? mean : 0, units), rest);
}

std::string removed(const Field& before, const Field& after, const std::string& units) {
  return Removal(before, after).words(units);
}

std::string share_of(Index points, Index all) {
  const double percent = 100 * static_cast<double>(points) / static_cast<double>(all);
  return std::to_string(points) + " of " + counted(all, "point") +
         (points > 0 ? " (" + in_digits(percent, 2) + " %)" : "");
}

Index missing_in(const Field& z) { return has_missing(z) ? z.isNaN().count() : 0; }

}  // namespace asperity::cli
