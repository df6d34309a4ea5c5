/// The parameters of a surface with their standard errors and intervals.
///
///     const Dataset data = decode_netcdf(bytes);  // of surface.nc
///     const Surface surface{grid_of(data), field_of(data, "heights", Missing::not_a_number)};
///     for (const Parameter& p : measure(surface, {.groups = {Group::height, Group::hybrid}}))
///       std::cout << p.name << " = " << p.value << " +- " << p.standard_error << " " << p.unit << "\n";
///
/// The headers of stats/height, spatial, spectrum, hybrid and profile define the parameters. Errors allow for
/// the correlation of the heights (stats/uncertainty); where too few are independent, none is told, and `why`
/// says so. Missing points, NaN, are left out. A Sample in strips has all groups but the spatial one.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"
#include "stats/measure/surface.hpp"
#include "stats/spectrum/spectrum.hpp"

namespace asperity {

enum class Group { height, quantiles, gaussianity, material, hybrid, spatial, profiles };

struct Direction {
  double angle;      ///< from +x towards +y [rad]
  std::string text;  ///< as it is called: "30deg"
};

struct MeasureOptions {
  std::set<Group> groups{Group::height};
  Preparation preparation = {};
  std::vector<double> quantiles = {};               ///< shares of the surface that lie below
  std::array<double, 2> material_ratios{0.1, 0.8};  ///< p, q, the bounds of the core
  double sal_level = 0.2;                           ///< of ρ, to which Sal and Str are measured
  std::optional<Direction> direction = {};          ///< spectral moments along it too
  Axis1D profiles = Axis1D::x;                      ///< along which profiles are taken
  int threads = 1;
};

/// Of a surface as it was read, only the groups asked for.
Parameters measure(const Surface& surface, const MeasureOptions& options = {});
/// One group of a prepared surface. Hybrid parameters have no values, and the reason in their place, where
/// the field is no length or too small; the other groups throw DataError.
Parameters measure(const Sample& sample, Group group, const MeasureOptions& options);

/// Why none of the parameters has a value; "" when one has.
std::string missing(const Parameters& parameters);

}  // namespace asperity
