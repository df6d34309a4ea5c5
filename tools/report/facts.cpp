#include "tools/report/facts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "tools/report/readable.hpp"

namespace asperity::report {
namespace {

// Of both bodies; one number where they agree.
std::string numbers_text(const std::vector<double>& values, const std::string& unit) {
  std::vector<std::string> words;
  for (const double v : values) words.push_back(readable(v, unit));
  const bool alike = std::ranges::adjacent_find(words, std::ranges::not_equal_to()) == words.end();
  return words.empty() ? "–" : alike ? words.front() : fmt::format("{}", fmt::join(words, ", "));
}

// Of x, and of y; in metres too where the samples have a grid.
std::string samples_text(const Dataset& data, const std::vector<double>& values) {
  std::vector<std::string> counts, lengths;
  for (const double v : values) counts.push_back(digits_of(v));
  const std::string samples = fmt::format("{} samples", fmt::join(counts, " × "));
  if (!data.find("x") || !data.find("y")) return samples;
  const Grid grid = grid_of(data);
  for (const double v : values) lengths.push_back(readable(v * (lengths.empty() ? grid.dx : grid.dy), "m"));
  return fmt::format("{} ({})", samples, fmt::join(lengths, " × "));
}

std::string text_of(const Dataset& data, const Values& values, std::string unit) {
  const auto* words = std::get_if<std::string>(&values);
  if (words) return *words;
  if (unit == "sample") return samples_text(data, numbers(values));
  if (unit == "yes") return count(values) > 0 && numbers(values)[0] != 0 ? "yes" : "no";
  if (unit == "height") {
    const Variable* target = data.find("acf_target");
    unit = target && target->attributes.text("units") == "m2" ? "m" : "1";
  }
  return numbers_text(numbers(values), unit);
}

std::string stage_of(const std::string& attribute) { return attribute.substr(0, attribute.find('_')); }

}  // namespace

std::vector<Fact> facts_of(const Dataset& data) {
  std::vector<Fact> out;
  for (const KnownAttribute& known : known_attributes())
    if (const Values* values = data.attributes.find(known.name); values && known.role != Role::other) {
      const std::string name(known.name), unit(known.unit);
      out.push_back(
          {known.role, stage_of(name), name, std::string(known.label), text_of(data, *values, unit)});
    }
  return out;
}

std::vector<Fact> other_attributes(const Dataset& data) {
  std::vector<Fact> out;
  for (const Attribute& a : data.attributes) {
    const KnownAttribute* known = known_attribute(a.name);
    const bool told = known && known->role != Role::other;
    if (!told && a.name != "history" && a.name != "source")
      out.push_back({Role::parameter, "", a.name, a.name, text_of(a.values)});
  }
  return out;
}

std::vector<std::string> warnings_of(const Dataset& data) {
  std::vector<std::string> out;
  const Attributes& a = data.attributes;
  const auto number = [&](const char* name) { return readable(a.number(name, NAN), "1"); };
  if (a.number("kernel_converged", 1) == 0)
    out.push_back(
        fmt::format("The kernel did not converge ({}): residual {}, tolerance {}. Surfaces drawn from it do "
                    "not have the autocorrelation asked for.",
                    a.text("kernel_reason"), number("kernel_residual"), number("kernel_tolerance")));
  if (a.number("contact_converged", 1) == 0)
    out.push_back(
        fmt::format("The contact did not converge: residual {}, tolerance {}. Pressure, area and all that "
                    "rests on them are not a solution.",
                    number("contact_residual"), number("contact_tolerance")));
  const std::string answer = a.text("kernel_answer");
  if ((answer == "nearest" || answer == "least-squares") && a.number("kernel_change", 0) > 1e-6)
    out.push_back(
        fmt::format("No kernel of this reach has the autocorrelation asked for; it was changed by up to {} "
                    "of the variance.",
                    number("kernel_change")));
  return out;
}

std::string text_of(const Values& values) {
  if (const auto* words = std::get_if<std::string>(&values)) return *words;
  constexpr std::size_t most = 12;
  std::vector<std::string> words;
  for (const double v : numbers(values)) {
    if (words.size() == most) {
      words.push_back(fmt::format("… ({} values)", count(values)));
      break;
    }
    words.push_back(cli::shortest(v));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace asperity::report
