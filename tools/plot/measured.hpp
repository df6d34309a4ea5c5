/// A field as asperity-stats, -pdf and -psd measure it unless they are told otherwise: from its mean, with
/// errors by the correlation that it was drawn with, else by its own. What a figure shows are their numbers.
#pragma once

#include "stats/measure.hpp"
#include "stats/measure/sample.hpp"
#include "tools/plot/source.hpp"

namespace asperity::plot {

Sample measured(const Case& c, const std::string& variable);
/// The same of a whole field; throws DataError for a pressure and a gap, which a part of the cells has.
Sample measured_whole(const Case& c, const std::string& variable);

/// "386 ± 17 nm", as asperity-stats prints it; and "Sq = 386 ± 17 nm, Ssk = 0.02 ± 0.13" of these symbols.
std::string in_words(const Parameter& parameter);
std::string in_words(const Parameters& all, std::initializer_list<const char*> symbols);

/// What is drawn, as its axis says: "height above the mean"; and as the legend does: "heights", or "values".
std::string above_mean(const Quantity& quantity);
std::string in_plural(const Quantity& quantity);

}  // namespace asperity::plot
