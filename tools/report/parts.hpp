/// The parts of a report as HTML; "" if the dataset has no content for one. Numbers in tables are <data>
/// elements with the exact SI value.
#pragma once

#include <string>
#include <string_view>

#include "dataset/catalogue.hpp"
#include "stats/measure/parameter.hpp"
#include "tools/cli/readable.hpp"
#include "tools/plot/figure.hpp"

namespace asperity::report {

using cli::digits_of;
using cli::Measurement;
using cli::readable;

/// Warnings about solvers that did not converge and changed targets.
std::string warnings(const Dataset& data);

/// All pictures that the dataset allows, fields as PNG, curves as SVG, and the reasons why others are
/// missing. `variable` replaces heights.
std::string pictures(const plot::Cases& dataset, const std::string& variable);

/// Value, standard error and 95 % interval, one row per quantity.
std::string measurements(const Parameters& rows);
/// Results of the contact, and those of smooth bodies if Hertz theory applies.
std::string contact_results(const Dataset& data);
/// What --add told beyond: the ratios, energies and patches of the contact.
std::string contact_figures(const Dataset& data);
/// Variables with their dimensions, units and meaning.
std::string contents(const Dataset& data);

/// Label and value of the attributes with this role and stage: kernel, generate, contact, stress.
std::string facts(const Dataset& data, Role role, std::string_view stage);
/// All other global attributes except history and source.
std::string other_attributes(const Dataset& data);
/// The lines of the history, the last run first.
std::string history(const std::string& text);

}  // namespace asperity::report
