/// What asperity-contact leaves of a solution: attributes and fields of a dataset, or a row of a table.
#pragma once

#include "cli/table.hpp"
#include "contact_scene.hpp"

namespace asperity::cli {

/// The effective parameters, the result and its fields, in place of any former ones.
void record(ContactScene& scene, const ContactOptions& options, const Contact& contact);

/// A row a load; the stiffness needs them all.
class LoadTable {
 public:
  void add(const Contact& contact);
  Table table() const;

 private:
  struct Row {
    double load, approach, area, plastic_area, mean_gap, max_pressure, residual, convolutions, converged;
  };
  std::vector<Row> rows_;
};

}  // namespace asperity::cli
