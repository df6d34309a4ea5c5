#include "tools/plot/source.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::plot {
namespace {

struct Span {
  Index first, count;
};

// The cells whose centres lie in a range.
template <class Position>
Span cells_within(Range range, Index n, Position position, const char* option) {
  Index first = 0, last = n - 1;
  while (first < n && position(first) < range.low) ++first;
  while (last >= 0 && position(last) > range.high) --last;
  if (first > last)
    throw ParameterError(option, fmt::format("no point lies in it; they reach from {} to {}",
                                             cli::format_quantity(position(0), "m"),
                                             cli::format_quantity(position(n - 1), "m")));
  return {first, last - first + 1};
}

// A place as typed, or where the dataset says that the von Mises stress is largest.
double place_of(const Dataset& data, const std::string& text, bool along_x) {
  if (text == "0") return 0;
  if (text != "max") return cli::parse_quantity("section", text, "m");
  const char* attribute = along_x ? "stress_max_y" : "stress_max_x";
  const double place = data.attributes.number(attribute, std::nan(""));
  if (std::isnan(place)) throw DataError(attribute, "the dataset does not have this attribute");
  return place;
}

double mean_of(const Field& values) {
  const auto finite = values.isFinite();
  return finite.select(values, 0.0).sum() / static_cast<double>(finite.count());
}

}  // namespace

Quantity quantity_of(const Variable& variable) {
  const std::string& name = variable.name;
  const std::string unit = si_unit_of(variable), words = variable.attributes.text("long_name");
  if (name == "heights") return {"height", unit, true};
  if (name == "noise") return {"noise", unit, true};
  if (name == "pressure" || name == "gap" || name == "displacement") return {name, unit, false};
  if (name == "von_mises") return {"von Mises", unit, false};
  if (name.starts_with("stress_")) return {"stress σ" + name.substr(7), unit, true};
  return {words.empty() ? name : words, unit,
          range_of(Eigen::Map<const Field>(present_numbers(variable).data(), 1,
                                           static_cast<Index>(count(variable.values))))
                  .low < 0};
}

Patch patch_of(const Dataset& data, const std::string& variable, const Request& request) {
  const Grid grid = grid_of(data);
  const Field all = field_of(data, variable, Missing::not_a_number);
  const Span i = cells_within(
      request.x, grid.shape.nx, [&](Index k) { return grid.x(k); }, "x-range");
  const Span j = cells_within(
      request.y, grid.shape.ny, [&](Index k) { return grid.y(k); }, "y-range");
  const Range x{grid.x(i.first) - 0.5 * grid.dx, grid.x(i.first + i.count - 1) + 0.5 * grid.dx},
      y{grid.y(j.first) - 0.5 * grid.dy, grid.y(j.first + j.count - 1) + 0.5 * grid.dy};
  Patch patch{all.block(i.first, j.first, i.count, j.count), x, y};
  if (!patch.values.isFinite().any()) throw DataError(variable, "none of its points is a number");
  return patch;
}

std::vector<Patch> patches_of(const Cases& cases, const std::string& variable, const Request& request) {
  std::vector<Patch> out;
  for (const Case& c : cases) out.push_back(patch_of(c.data, variable, request));
  return out;
}

Range range_of(const std::vector<Patch>& patches) {
  Range out{unlimited, -unlimited};
  for (const Patch& p : patches) out = united(out, range_of(p.values));
  return out;
}

Lattice lattice_of(const Patch& patch, const Unit& x, const Unit& y) {
  return {patch.x_at(0) / x.factor, patch.y_at(0) / y.factor, patch.dx() / x.factor, patch.dy() / y.factor};
}

double reach(const Patch& patch) { return std::max(patch.x.magnitude(), patch.y.magnitude()); }

std::string Section::label() const {
  const Unit unit = unit_for(std::abs(place), "m");
  return fmt::format("{} = {} {}", along_x ? "y" : "x", brief(place / unit.factor), unit.name);
}

Section section_of(const Dataset& data, const std::string& text) {
  if (!text.starts_with("x=") && !text.starts_with("y="))
    throw ParameterError("section", "'" + text + "' is not of the form y=0, x=0.2mm or y=max");
  const Grid grid = grid_of(data);
  const bool along_x = text[0] == 'y';
  const double wanted = place_of(data, text.substr(2), along_x), spacing = along_x ? grid.dy : grid.dx,
               size = along_x ? grid.size_y() : grid.size_x();
  if (!(std::abs(wanted) <= 0.5 * size))
    throw ParameterError("section", "'" + text + "' lies outside: the surface reaches to ±" +
                                        cli::format_quantity(0.5 * size, "m"));
  const Index n = along_x ? grid.shape.ny : grid.shape.nx;
  const auto nearest = static_cast<Index>(std::floor((wanted + 0.5 * size) / spacing));
  const Index index = std::clamp<Index>(nearest, 0, n - 1);
  return {along_x, along_x ? grid.y(index) : grid.x(index), index};
}

Range value_range(const Request& request, const std::string& unit, Range otherwise) {
  if (request.range.empty()) return otherwise;
  const bool pure = unit.empty() || unit == "1";
  const auto [low, high] =
      pure ? cli::parse_numbers("range", request.range) : cli::parse_quantities("range", request.range, unit);
  if (!(low < high)) throw ParameterError("range", "'" + request.range + "' does not rise");
  if (!(drawable({low, high}) == Range{low, high}))
    throw ParameterError("range",
                         "'" + request.range + "' is too narrow: doubles hardly tell its ends apart");
  return {low, high};
}

Colours field_colours(const std::vector<Patch>& patches, const Quantity& quantity, const Request& request) {
  const Range range = range_of(patches);
  if (!request.range.empty())
    return {value_range(request, quantity.unit, range),
            quantity.signed_value ? Palette::diverging : Palette::sequential};
  if (!quantity.signed_value) return one_sided(range);
  double mean = 0;
  for (const Patch& p : patches) mean += mean_of(p.values) / static_cast<double>(patches.size());
  return about(quantity.name == "height" ? mean : 0.0, range);
}

}  // namespace asperity::plot
