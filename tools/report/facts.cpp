#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/ranges.h>

#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "tools/report/html.hpp"
#include "tools/report/parts.hpp"

namespace asperity::report {
namespace {

constexpr std::size_t most_values = 12;

// The numbers of both bodies; a single number if they agree. Of a longer list its ends.
std::string numbers_text(const std::vector<double>& values, const std::string& unit) {
  std::vector<std::string> words;
  for (const double v : values) words.push_back(readable(v, unit));
  if (words.size() > most_values)
    return fmt::format("{} to {} ({} values)", words.front(), words.back(), words.size());
  const bool alike = std::ranges::adjacent_find(words, std::ranges::not_equal_to()) == words.end();
  return words.empty() ? "–" : alike ? words.front() : fmt::format("{}", fmt::join(words, ", "));
}

// In samples of x and y, and in metres if the dataset has a grid.
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

std::string text_of(const Values& values) {
  if (const auto* words = std::get_if<std::string>(&values)) return *words;
  std::vector<std::string> words;
  for (const double v : numbers(values)) {
    if (words.size() == most_values) {
      words.push_back(fmt::format("… ({} values)", count(values)));
      break;
    }
    words.push_back(shortest(v));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

// The line of an attribute in a list.
std::string line(std::string_view name, std::string_view label, const std::string& text) {
  constexpr std::size_t unbroken = 24;  // bytes that stand on one line
  return fmt::format("<div title=\"{}\"><dt>{}</dt><dd{}>{}</dd></div>\n", escaped(name), escaped(label),
                     text.size() <= unbroken ? " class=\"short\"" : "", escaped(text));
}

constexpr std::string_view of_error = "_error", of_warnings = "_warnings";

// The error of a figure that is there too stands beside it; a kernel that is wider is one all the same.
bool told_beside(const Dataset& data, std::string_view name) {
  const Attributes& a = data.attributes;
  return (name.ends_with(of_error) && a.find(name.substr(0, name.size() - of_error.size()))) ||
         name.ends_with(of_warnings) || (name == "kernel_reason" && a.text("kernel_answer") == "wider");
}

// What a kernel converged to where that is not what was asked for.
std::string answer_of(const Attributes& a) {
  const std::string answer = a.text("kernel_answer");
  return answer == "nearest" ? ", to the closest autocorrelation found, not to the one asked for"
         : answer == "wider" ? ", with a kernel wider than the lags asked for"
                             : "";
}

std::string text_of(const Dataset& data, const KnownAttribute& known, const Values& values) {
  const std::string unit(known.unit);
  const double error = data.attributes.number(std::string(known.name).append(of_error), NAN);
  if (error > 0 && count(values) == 1) return value_text(numbers(values)[0], error, unit);
  const std::string text = text_of(data, values, unit);
  return known.name == "kernel_converged" && text == "yes" ? text + answer_of(data.attributes) : text;
}

}  // namespace

std::string value_text(const Parameter& row) {
  const Measurement m = readable(row);
  return m.value + (m.error.empty() ? "" : " ± " + m.error) + (m.unit.empty() ? "" : "\u00A0" + m.unit);
}

std::string value_text(double value, double error, const std::string& unit) {
  return value_text(Parameter{"", value, unit, error > 0 ? error : unknown, ""});
}

std::string facts(const Dataset& data, Role role, std::string_view stage) {
  std::string lines;
  for (const KnownAttribute& known : known_attributes())
    if (const Values* values = data.attributes.find(known.name);
        values && known.role == role && known.name.substr(0, known.name.find('_')) == stage &&
        !told_beside(data, known.name))
      lines += line(known.name, known.label, text_of(data, known, *values));
  return element("dl", lines, "facts");
}

std::string contact_figures(const Dataset& data) {
  std::string lines;
  const KnownAttribute *known = known_attribute("contact_area_share"),
                       *last = known_attribute("contact_percolates_y");
  for (; known <= last; ++known)
    if (const Values* values = data.attributes.find(known->name))
      lines += line(known->name, known->label, text_of(data, *known, *values));
  return element("dl", lines, "facts");
}

std::string other_attributes(const Dataset& data) {
  std::string lines;
  for (const Attribute& a : data.attributes) {
    const KnownAttribute* known = known_attribute(a.name);
    const bool told = known && known->role != Role::other;
    if (!told && a.name != "history" && a.name != "source" && !a.name.ends_with(of_warnings))
      lines += line(a.name, a.name, text_of(a.values));
  }
  return element("dl", lines, "facts");
}

std::string history(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> runs;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (line.starts_with("  ") && !runs.empty()) {  // a step of the run above
      runs.back() += "<br>" + escaped(line.substr(2));
      continue;
    }
    const auto colon = line.find(": ");
    const bool timed = colon != line.npos && line.find(' ') > colon;
    const std::string when = timed ? fmt::format("<time>{}</time>", escaped(line.substr(0, colon))) : "";
    runs.push_back(when + fmt::format("<code>{}</code>", escaped(timed ? line.substr(colon + 2) : line)));
  }
  std::string out;
  for (const std::string& run : runs) out += element("li", run);
  return element("ol", out, "history");
}

}  // namespace asperity::report
