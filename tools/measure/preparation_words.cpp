#include "tools/measure/preparation_words.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"

namespace asperity::cli {
namespace {

constexpr std::pair<const char*, Cutoff::Filter> filters[] = {{"gaussian", Cutoff::Filter::gaussian},
                                                              {"robust", Cutoff::Filter::robust},
                                                              {"spline", Cutoff::Filter::spline}};

constexpr std::string_view degree_attribute = "filter_form_degree", filled_attribute = "filter_filled_share",
                           aligned_attribute = "filter_aligned_share";

double of_map(const Dataset& data, std::string_view variable, std::string_view attribute) {
  return variable == "heights" || variable == "values" ? data.attributes.number(attribute, 0) : 0;
}

bool longer(const Cutoff& cutoff, double side) { return cutoff.wavelength > side * (1 + 1e-12); }

}  // namespace

const std::string form_words =
    "mean, plane, the degree of a polynomial, 0 to 20, sphere or cylinder of the radius that fits best";
const std::string filter_words =
    "FILTER: gaussian (ISO 16610-61), robust (Gaussian that ignores what sticks out, ISO 16610-71) or spline "
    "(ISO 16610-62); 0.8mm,robust. Default: gaussian";

Form parse_form(const std::string& option, const std::string& text) {
  if (text == "sphere") return {Form::Kind::sphere};
  if (text == "cylinder") return {Form::Kind::cylinder};
  if (text == "mean" || text == "plane") return {.degree = text == "plane"};
  const auto degree = to_number<int>(text);
  if (!degree) refuse(option, text, "is not mean, plane, a degree from 0 to 20, sphere or cylinder");
  if (*degree < 0 || *degree > largest_form_degree)
    refuse(option, text, "is not a degree from 0 to " + std::to_string(largest_form_degree));
  return {.degree = *degree};
}

Cutoff parse_cutoff(const std::string& option, const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  Cutoff out{parse_quantity(option, text.substr(0, comma), "m")};
  if (comma == text.size()) return out;
  const std::string word = text.substr(comma + 1);
  const auto* found = std::ranges::find(filters, word, [](const auto& f) { return std::string(f.first); });
  if (found == std::end(filters)) refuse(option, word, "is none of gaussian|robust|spline");
  out.filter = found->second;
  return out;
}

int removed_degree(const Dataset& data, std::string_view variable) {
  const double degree = of_map(data, variable, degree_attribute);
  return degree >= 0 && degree <= largest_form_degree ? static_cast<int>(degree) : 0;
}

double filled_share(const Dataset& data, std::string_view variable) {
  return std::clamp(of_map(data, variable, filled_attribute), 0.0, 1.0);
}

double aligned_share(const Dataset& data, std::string_view variable) {
  return std::clamp(of_map(data, variable, aligned_attribute), 0.0, 1.0);
}

void set_preparation(Dataset& data, int degree, double filled, double aligned) {
  for (const auto& [name, value] : {std::pair(degree_attribute, double(degree)),
                                    {filled_attribute, filled},
                                    {aligned_attribute, aligned}}) {
    data.attributes.erase(name);
    if (value > 0) data.attributes.set(name, value);
  }
}

void check_cutoff(const std::string& option, const Cutoff& cutoff, const Grid& grid) {
  const auto [nx, ny] = grid.shape;
  const double side = std::max(nx > 1 || ny == 1 ? grid.size_x() : 0, ny > 1 || nx == 1 ? grid.size_y() : 0);
  if (longer(cutoff, side))
    throw UsageError(option, metres(cutoff.wavelength) + " is longer than the field, " + metres(side) +
                                 ": it holds no such waves; leave the filter out");
}

void check_lengths(const Surface& surface, const std::string& what) {
  if (surface.units != "m")
    throw DataError(surface.variable,
                    "is in '" + surface.units + "', not a length: " + what + " has no meaning here");
}

void warn_of_cutoff(const Tool& tool, const Cutoff& cutoff, const Grid& grid) {
  for (const auto& [axis, size, points] :
       {std::tuple{"x", grid.size_x(), grid.shape.nx}, {"y", grid.size_y(), grid.shape.ny}})
    if (points > 1 && longer(cutoff, size))
      tool.warn("the cut-off, " + metres(cutoff.wavelength) + ", is longer than the field in " + axis + ", " +
                metres(size) + ": in that direction it separates little more than the mean");
}

}  // namespace asperity::cli
