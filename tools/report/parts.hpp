/// The parts of a report as HTML; "" if the dataset has no content for one. Numbers in tables are <data>
/// elements with the exact SI value.
#pragma once

#include <string>
#include <string_view>

#include "dataset/catalogue.hpp"
#include "stats/measure/parameter.hpp"
#include "tools/cli/readable.hpp"
#include "tools/report/page.hpp"

namespace asperity::report {

using cli::digits_of;
using cli::Measurement;
using cli::readable;

/// "386 ± 17 nm"
std::string value_text(const Parameter& row);
/// A number of SI with the error of the grid, or without where it has none.
std::string value_text(double value, double error, const std::string& unit);

/// Whether the largest pressure is the limit itself, which has no error of the grid.
bool at_limit(const Attributes& a);

/// What every tool warned of, and what attributes tell where a dataset lacks the words: solvers that have not
/// converged, changed targets, stress above yield, layers that the grid does not resolve. `own`: of the
/// measurements on the page.
std::string warnings(const Dataset& data, const std::vector<std::string>& own);

/// All pictures that the dataset allows, and the reasons why others are missing. Those of the field stand in
/// for the live field without a script and on paper.
struct Figures {
  std::string field, surface, flow, stress;
};
Figures figures(const Content& content);

/// Value, standard error and 95 % interval, one row per quantity.
std::string measurements(const Parameters& rows);
/// Results of the contact, and those of smooth bodies if Hertz theory applies.
std::string contact_results(const Dataset& data);
/// What --add told beyond: the ratios, energies and patches of the contact; and what flow has left.
std::string contact_figures(const Dataset& data);
/// Variables with their dimensions, units and meaning.
std::string contents(const Dataset& data);

/// Label and value of the attributes with this role and stage: kernel, generate, filter, contact, stress.
std::string facts(const Dataset& data, Role role, std::string_view stage);
/// All other global attributes except history and source.
std::string other_attributes(const Dataset& data);
/// The lines of the history, the last run first.
std::string history(const std::string& text);

}  // namespace asperity::report
