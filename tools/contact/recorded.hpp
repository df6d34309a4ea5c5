/// A contact as its dataset tells of it: what is needed to solve it again on coarser cells.
#pragma once

#include "contact/grid_error.hpp"
#include "dataset/dataset.hpp"
#include "stats/hybrid/slopes.hpp"

namespace asperity::cli {

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
