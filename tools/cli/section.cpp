#include "tools/cli/section.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {

bool through_maximum(const std::string& section) { return section == "x=max" || section == "y=max"; }

CellRow section_row(const Grid& grid, const std::string& section,
                    const std::function<double(bool along_x)>& maximum) {
  if (!section.starts_with("x=") && !section.starts_with("y="))
    refuse("section", section, "is not of the form y=0, x=0.2mm or y=max");
  const bool along_x = section[0] == 'y';
  const double size = along_x ? grid.size_y() : grid.size_x(), spacing = along_x ? grid.dy : grid.dx;
  const std::string place = section.substr(2);
  const double wanted = place == "0"     ? 0
                        : place == "max" ? maximum(along_x)
                                         : parse_length("section", place).metres(spacing);
  if (!(std::abs(wanted) <= 0.5 * size))
    refuse("section", section, "lies outside: the surface reaches to ±" + format_quantity(0.5 * size, "m"));
  const auto nearest = static_cast<Index>(std::floor((wanted + 0.5 * size) / spacing));
  return {along_x, std::clamp<Index>(nearest, 0, (along_x ? grid.shape.ny : grid.shape.nx) - 1)};
}

StressBound::StressBound(const std::string& text) {
  const auto [number, rest, found, in_range] = leading_number<double>(text);
  of_ = rest == "p0" ? Of::hertz : rest == "pmax" ? Of::largest : Of::itself;
  if (found && rest.empty())
    refuse("above", text,
           "has no unit: write 0.1p0 (of the Hertz pressure), 0.1pmax (of the largest contact pressure) or "
           "100MPa");
  value_ = of_ == Of::itself ? parse_quantity("above", text, "Pa") : number;
  if (!(value_ > 0 && std::isfinite(value_))) refuse("above", text, "is not above 0");
}

double StressBound::in(const Dataset& data, const std::function<double()>& largest_pressure) const {
  if (of_ == Of::itself) return value_;
  if (of_ == Of::largest) return value_ * largest_pressure();
  const double hertz = data.attributes.number("contact_hertz_pressure", -1);
  if (!(hertz > 0))
    throw DataError("contact_hertz_pressure",
                    "is missing, as of bodies without radii; give the bound in pmax or MPa");
  return value_ * hertz;
}

std::string StressBound::label() const {
  if (of_ == Of::itself) return format_quantity(value_, "Pa");
  return shortest(value_) + (of_ == Of::hertz ? " p₀" : " pmax");
}

}  // namespace asperity::cli
