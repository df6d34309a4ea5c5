/// What asperity-contact presses together, and what it leaves of a solution: attributes and fields, or a row.
#pragma once

#include "contact/ratios.hpp"
#include "dataset/dataset.hpp"
#include "stats/hybrid/slope_growth.hpp"
#include "tools/cli/table.hpp"
#include "tools/contact/options.hpp"

namespace asperity::cli {

struct ContactScene {
  Dataset data;  ///< to be amended; its grid is the contact's
  Grid grid;
  Field gap;                    ///< undeformed [m]
  SlopeGrowth growth = {};      ///< of the gap; γ is NaN where it is that of smooth bodies
  GapRoughness roughness = {};  ///< of the gap, for --add contact_ratios
};

/// Reads the surfaces, if there are any. Throws ParameterError when the requested boundary does not
/// go with them, DataError when the counter body lies on another grid.
ContactScene read_scene(const Tool& tool, const ContactOptions& options);

struct GridFigures;

/// The effective parameters, the result and its fields, in place of any former ones.
void record(ContactScene& scene, const ContactOptions& options, const Contact& contact,
            const GridFigures& grid);

/// Adds the row of a load to the table of a sweep, whose columns come with the first.
void add_load(Table& table, const ContactScene& scene, const ContactOptions& options, const Contact& contact,
              const GridFigures& grid);

}  // namespace asperity::cli
