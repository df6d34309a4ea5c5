/// What asperity-contact presses together: the gap of two surfaces, and what is known of it beforehand.
#pragma once

#include <functional>
#include <optional>

#include "contact/doubts.hpp"
#include "contact/ratios.hpp"
#include "dataset/dataset.hpp"
#include "stats/hybrid/slopes.hpp"
#include "tools/cli/shared_fields.hpp"
#include "tools/contact/options.hpp"

namespace asperity::cli {

struct ContactScene {
  Dataset data;  ///< to be amended; its grid is the contact's
  Grid grid;
  Field gap;                                ///< undeformed [m]; of several ranks, the rows that this one has
  SlopeGrowth growth = {};                  ///< of the gap; γ is NaN where it is that of smooth bodies
  std::array<Seam, 2> seams = {};           ///< of the gap, along the axes where it is periodic
  GapRoughness roughness = {};              ///< of the gap, for --add contact_ratios
  Index refinement = 1;                     ///< cells along a side for each given one, by --accuracy
  std::optional<SharedFields> fields = {};  ///< that record() has put into the dataset

  /// Calls write() on the first rank.
  void written(const std::function<void()>& write) const { fields->first_writes(write); }
};

/// Of a dataset with the first body, unless it is smooth. Throws ParameterError when the requested boundary
/// does not go with it, DataError when the counter body, which is read here, lies on another grid. Of several
/// ranks only the first measures the whole gap, because it warns and writes.
ContactScene scene_of(const Tool& tool, const ContactOptions& options, Dataset data);

/// Of a gap on these cells, which is measured too.
ContactScene scene_with(const ContactOptions& options, Dataset data, const Grid& grid, Field gap);
/// Whether a contact of so many cells fits into --memory.
bool fits(const Tool& tool, Shape shape);

/// Whether the grid resolves the surfaces, and whether periodic ones continue at their edges.
std::vector<Doubt> doubts(const ContactScene& scene);

}  // namespace asperity::cli
