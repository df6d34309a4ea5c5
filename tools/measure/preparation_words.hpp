/// The form and the filters of a preparation as they are typed: "plane", "3", "sphere"; "0.8mm",
/// "0.8mm,robust".
#pragma once

#include <string>
#include <string_view>

#include "core/words.hpp"
#include "dataset/dataset.hpp"
#include "stats/filter/preparation.hpp"
#include "stats/measure/surface.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

inline constexpr const char* form_kind = "FORM";
inline constexpr const char* cutoff_kind = "LENGTH[,FILTER]";
/// What the two options take, for their help.
extern const std::string form_words, filter_words;

/// A length as messages name it: "0.8 mm".
inline std::string metres(double length) { return format_quantity(length, "m"); }

/// Throw ParameterError(option, …).
Form parse_form(const std::string& option, const std::string& text);
Cutoff parse_cutoff(const std::string& option, const std::string& text);

/// The degree of the form that asperity-filter removed from the map of a dataset; 0: none.
int removed_degree(const Dataset& data, std::string_view variable);
/// The share of its points that asperity-filter has filled.
double filled_share(const Dataset& data, std::string_view variable);
/// The share of Sq that its alignment of scan lines took of the surface.
double aligned_share(const Dataset& data, std::string_view variable);
/// Sets the three for a map.
void set_preparation(Dataset& data, int degree, double filled, double aligned);

/// Throws UsageError(option, …) for a cut-off beyond the longer side of the field, where a filter separates
/// nothing.
void check_cutoff(const std::string& option, const Cutoff& cutoff, const Grid& grid);
/// Throws DataError(variable, …) for a sphere, a cylinder or a ball where values are no lengths.
void check_lengths(const Surface& surface, const std::string& what);
/// Warns where one side of the field is shorter than the cut-off.
void warn_of_cutoff(const Tool& tool, const Cutoff& cutoff, const Grid& grid);

}  // namespace asperity::cli
