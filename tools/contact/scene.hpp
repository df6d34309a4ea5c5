/// What asperity-contact presses together, and what it leaves of a solution: attributes and fields, or a row.
#pragma once

#include <functional>
#include <optional>

#include "contact/ratios.hpp"
#include "dataset/dataset.hpp"
#include "stats/hybrid/slopes.hpp"
#include "tools/cli/shared_fields.hpp"
#include "tools/cli/table.hpp"
#include "tools/contact/options.hpp"

namespace asperity::cli {

struct ContactScene {
  Dataset data;  ///< to be amended; its grid is the contact's
  Grid grid;
  Field gap;                                ///< undeformed [m]; of several ranks, the rows that this one has
  SlopeGrowth growth = {};                  ///< of the gap; γ is NaN where it is that of smooth bodies
  std::array<Seam, 2> seams = {};           ///< of the gap, along the axes where it is periodic
  GapRoughness roughness = {};              ///< of the gap, for --add contact_ratios
  std::optional<SharedFields> fields = {};  ///< that record() has put into the dataset

  /// What write() makes of the dataset, on the first rank.
  void written(const std::function<void()>& write) const { fields->first_writes(write); }
};

/// Of a dataset with the first body, unless it is smooth. Throws ParameterError when the requested boundary
/// does not go with it, DataError when the counter body, which is read here, lies on another grid. Of several
/// ranks the first alone learns what the whole gap tells, for it speaks and writes.
ContactScene scene_of(const Tool& tool, const ContactOptions& options, Dataset data);

/// Of a gap on these cells, with what its roughness tells.
ContactScene scene_with(const ContactOptions& options, Dataset data, const Grid& grid, Field gap);
/// Whether a contact of so many cells fits into --memory.
bool fits(const Tool& tool, Shape shape);

struct GridFigures;

/// The effective parameters, the result and its fields, in place of any former ones.
void record(ContactScene& scene, const ContactOptions& options, const Contact& contact,
            const GridFigures& grid);

/// Adds the row of a load to the table of a sweep, whose columns come with the first.
void add_load(Table& table, const ContactScene& scene, const ContactOptions& options, const Contact& contact,
              const GridFigures& grid);

}  // namespace asperity::cli
