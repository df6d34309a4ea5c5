/// A contact in its dataset: attributes and fields, a row for each load of a sweep, and the way back.
#pragma once

#include "contact/grid_error.hpp"
#include "stats/hybrid/slopes.hpp"
#include "tools/cli/table.hpp"
#include "tools/contact/press.hpp"

namespace asperity::cli {

/// The effective parameters, the result and its fields, in place of any former ones.
void record(ContactScene& scene, const ContactOptions& options, const Contact& contact,
            const GridFigures& grid, const Flow* flow = nullptr);

/// Of flat bodies: the load over the nominal area, that of the grid [Pa].
inline double mean_pressure(const Grid& grid, const Contact& contact) {
  return contact.load / (grid.size_x() * grid.size_y());
}

/// NAME_error of each quantity that is recorded.
void record(Attributes& attributes, const GridErrors& errors);

/// Adds the row of a load to the table of a sweep, whose columns come with the first.
void add_load(Table& table, const ContactScene& scene, const ContactOptions& options, const Contact& contact,
              const GridFigures& grid, const Flow* flow = nullptr);

/// What is needed to solve a contact again on coarser cells, from its dataset.
struct RecordedContact {
  Grid grid;
  Field gap;  ///< undeformed [m]
  Contact contact;
  ContactParameters parameters;
  Bodies bodies;  ///< their radii
  double modulus = 0;
  SlopeGrowth growth;
  std::string unknown;  ///< why it cannot be solved again; empty where it can

  bool at_limit() const { return contact.plastic_area > 0; }
};

/// Of the fields and attributes that asperity-contact writes, as long as they agree: a contact that was
/// cropped or changed since is `unknown`, and so is one that did not converge, or that the grid does not
/// resolve.
RecordedContact recorded_contact(const Dataset& data, int threads);

CoarserContacts coarser_contacts(const RecordedContact& recorded);

}  // namespace asperity::cli
