/// How far a grid resolves a contact: the growth of the slope, the corrected area, the errors of the figures.
#pragma once

#include "contact/doubts.hpp"
#include "contact/elastic_operator.hpp"
#include "contact/grid_error.hpp"
#include "contact/outline.hpp"
#include "tools/contact/scene.hpp"

namespace asperity::cli {

/// What the grid makes of one contact.
struct GridFigures {
  double perimeter = 0, area_corrected = 0;  ///< [m], [m²]
  GridErrors errors = {};                    ///< those of areas; the others with --add grid_errors
  std::string unknown = {};                  ///< why errors that were asked for are not known
  double seconds = 0;                        ///< of the coarser contacts
};

/// Solves the coarser contacts if they were asked for.
GridFigures grid_figures(const ContactOptions& options, const ContactScene& scene, ElasticOperator& influence,
                         const Contact& contact);

void record(Attributes& attributes, const GridErrors& errors);
void record(Attributes& attributes, const SlopeGrowth& growth, const GridFigures& figures);

/// Whether the grid resolves the surfaces, and whether periodic ones continue at their edges.
std::vector<Doubt> doubts(const ContactScene& scene);
/// Why a contact has no errors.
std::vector<Doubt> doubts(const GridFigures& figures);

}  // namespace asperity::cli
