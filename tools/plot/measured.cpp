#include "tools/plot/measured.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "tools/cli/readable.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/measure/height_tables.hpp"

namespace asperity::plot {

Sample measured(const Case& c, const std::string& variable) {
  if (c.sample && c.sample->surface().variable == variable) return *c.sample;
  cli::FieldOptions as_usual;
  as_usual.variable = variable;
  Surface surface = as_usual.without_heights(c.data);
  surface.heights = field_of(c.data, variable, Missing::not_a_number);
  return Sample(prepared(std::move(surface), as_usual.asked));
}

Sample measured_whole(const Case& c, const std::string& variable) {
  if (const auto part = cli::counted_cells(c.data, variable))
    throw DataError(variable, "only the cells that are " + part->which + " have one: draw --kind pdf");
  return measured(c, variable);
}

std::string in_words(const Parameter& parameter) {
  const cli::Measurement of = cli::readable(parameter);
  return of.value + (of.error.empty() ? "" : " ± " + of.error) + (of.unit.empty() ? "" : " " + of.unit);
}

std::string in_words(const Parameters& all, std::initializer_list<const char*> symbols) {
  std::string out;
  for (const char* symbol : symbols)
    if (const auto row = std::ranges::find(all, symbol, &Parameter::name); row != all.end())
      out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", symbol, in_words(*row));
  return out;
}

std::string above_mean(const Quantity& quantity) { return quantity.name + " above the mean"; }

std::string in_plural(const Quantity& quantity) { return quantity.name == "height" ? "heights" : "values"; }

}  // namespace asperity::plot
