/// Many values in one option: a list "A,B,C", or a range "FROM:TO:COUNT".
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace asperity::cli {

/// "a,b,,c" at ',' is a, b, an empty word and c; an empty text is one empty word.
std::vector<std::string> split(const std::string& text, char separator);

enum class Steps { uniform, geometric };

/// The most values of a range: a layer or a contact each.
inline constexpr int most_values = 100'000;

/// The values of a list, or COUNT ≥ 2 values FROM … TO, at equal steps or at equal ratios: as `steps` says, unless
/// a fourth word does, "FROM:TO:COUNT:geometric". `value` reads one of them. Throws ParameterError(option, …) unless
/// they increase, or for a COUNT out of bounds.
std::vector<double> parse_series(const std::string& option, const std::string& text, Steps steps,
                                 const std::function<double(const std::string&)>& value);

}  // namespace asperity::cli
