#include "tools/cli/series.hpp"

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {
namespace {

Index number_of_values(const std::string& option, const std::string& text) {
  const Bounds bounds(std::numeric_limits<Index>::min(), most_values, "as many as a series may have");
  const Index number = parse_count(option, text, bounds);
  if (number < 2) throw ParameterError(option, "'" + text + "' is no number of values from 2 on");
  return number;
}

Steps parse_steps(const std::string& option, const std::string& text) {
  if (text == "uniform") return Steps::uniform;
  if (text == "geometric") return Steps::geometric;
  throw ParameterError(option, "'" + text + "' is none of uniform, geometric");
}

std::vector<double> spaced(double from, double to, Index count, Steps steps) {
  std::vector<double> out;
  for (Index i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    out.push_back(steps == Steps::geometric ? from * std::pow(to / from, t) : from + (to - from) * t);
  }
  out.back() = to;
  return out;
}

}  // namespace

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> out;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(separator, begin);
    out.push_back(text.substr(begin, end - begin));
  }
  return out;
}

std::vector<double> parse_series(const std::string& option, const std::string& text, Steps steps,
                                 const std::function<double(const std::string&)>& value) {
  std::vector<double> values;
  const std::vector<std::string> range = split(text, ':');
  if (range.size() == 1) {
    for (const std::string& word : split(text, ',')) values.push_back(value(word));
  } else {
    if (range.size() != 3 && range.size() != 4)
      throw ParameterError(option, "'" + text + "' is not of the form FROM:TO:COUNT");
    if (range.size() == 4) steps = parse_steps(option, range[3]);
    const double from = value(range[0]);
    if (steps == Steps::geometric && !(from > 0))
      throw ParameterError(option, "equal ratios cannot start from '" + range[0] + "'");
    values = spaced(from, value(range[1]), number_of_values(option, range[2]), steps);
  }
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(values[i] > values[i - 1])) throw ParameterError(option, "'" + text + "' does not increase");
  return values;
}

}  // namespace asperity::cli
