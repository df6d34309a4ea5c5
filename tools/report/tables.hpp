/// Tables of a report as HTML. Every number is in a <data> element that carries its exact value in SI.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "tools/cli/table.hpp"
#include "tools/report/facts.hpp"

namespace asperity::report {

/// Value, standard error and 95 % interval, a row a quantity.
std::string measurements(const std::vector<cli::Quantities::Row>& rows);
/// What the contact came to, beside smooth bodies where Hertz has a closed form; "" where there was none.
std::string contact_results(const Dataset& data);
/// Label and value of the facts of this role and stage; "" where there are none.
std::string facts(const std::vector<Fact>& facts, Role role, const std::string& stage);
/// Variables with their dimensions, units and meaning.
std::string contents(const Dataset& data);
/// The lines of the history, the last run first.
std::string history(const std::string& text);

}  // namespace asperity::report
