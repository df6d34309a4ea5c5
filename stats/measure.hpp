/// The parameters of a surface with their standard errors and intervals.
///
///     const Dataset data = decode_netcdf(bytes);  // of surface.nc
///     const Surface surface{grid_of(data), field_of(data, "heights", Missing::not_a_number)};
///     for (const Parameter& p : measure(surface, {.groups = {Group::height, Group::hybrid}}))
///       std::cout << p.name << " = " << p.value << " +- " << p.standard_error << " " << p.unit << "\n";
///
/// The headers of stats/height, spatial, spectrum, hybrid and profile define the parameters. Errors allow for
/// the correlation of the heights (stats/uncertainty). If too few heights are independent, no errors are
/// given, and `why` says so. Missing points (NaN) are left out.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "stats/feature/features.hpp"
#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"
#include "stats/measure/surface.hpp"
#include "stats/spectrum/spectrum.hpp"

namespace asperity {

enum class Group { height, quantiles, gaussianity, material, hybrid, spatial, profiles, feature };

struct Direction {
  double angle;      ///< from +x towards +y [rad]
  std::string text;  ///< as given: "30deg"
};

struct MaterialHeight {
  double value;      ///< above the mean, in the unit of the field
  std::string text;  ///< as given: "0.5um"
};

struct MeasureOptions {
  std::set<Group> groups{Group::height};
  Preparation preparation = {};
  std::vector<double> quantiles = {};                 ///< shares of the surface below the heights
  std::array<double, 2> material_ratios{0.1, 0.8};    ///< p, q, the bounds of the core
  std::vector<MaterialHeight> material_heights = {};  ///< c of Smr(c)
  double sal_level = 0.2;                             ///< of ρ, for Sal and Str
  std::optional<Direction> direction = {};            ///< for further spectral moments
  Pruning pruning = {};                               ///< of hills and dales
  Axis1D profiles = Axis1D::x;                        ///< axis of the profiles
  int threads = 1;
};

/// The requested groups of parameters, of a surface as read.
Parameters measure(const Surface& surface, const MeasureOptions& options = {});
/// One group of a prepared surface. If the field is not a length or is too small, hybrid parameters are NaN
/// with the reason in `why`; the other groups throw DataError.
Parameters measure(const Sample& sample, Group group, const MeasureOptions& options);
/// The symbols of ISO 25178-2 in the tables of a group of heights, the material ratio or slopes: "Sa, Sq, …".
std::string symbols(Group group);
/// White noise of this rms height in place of the heights of a flat surface.
Sample stand_in(Surface flat, double rms = 1);
/// Of a FlatSurface: the limits for heights c w, c → 0, w the stand-in's. A parameter that grows with c is 0;
/// others, and those of summits, of which there is none, have no value, but for the mean and the numbers of
/// points and profiles.
Parameters measure_flat(const Surface& flat, Group group, const MeasureOptions& options);

/// What heights in steps do to hybrid parameters, and what to do about it; "" below a hundredth.
std::string doubt_of_steps(const Sample& sample);
/// Why all parameters lack a value; "" if one has a value.
std::string missing(const Parameters& parameters);

}  // namespace asperity
