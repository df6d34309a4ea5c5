/// The parts of a report as HTML; "" where the dataset has nothing for one. Numbers of tables are <data>
/// elements with their exact value in SI.
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

/// What a reader must know before believing a number: solvers that did not converge, a target changed.
std::string warnings(const Dataset& data);

/// The pictures that the dataset has something for, fields as PNG, curves as SVG, and why others are not
/// drawn. `variable` takes the place of heights.
std::string pictures(const plot::Cases& dataset, const std::string& variable);

/// Value, standard error and 95 % interval, a row a quantity.
std::string measurements(const Parameters& rows);
/// What the contact came to, beside smooth bodies where Hertz has a closed form.
std::string contact_results(const Dataset& data);
/// Variables with their dimensions, units and meaning.
std::string contents(const Dataset& data);

/// Label and value of the attributes of this role and stage: kernel, generate, contact, stress.
std::string facts(const Dataset& data, Role role, std::string_view stage);
/// The global attributes that are none of these, but for the history and source.
std::string other_attributes(const Dataset& data);
/// The lines of the history, the last run first.
std::string history(const std::string& text);

}  // namespace asperity::report
