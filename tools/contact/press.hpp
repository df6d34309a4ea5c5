/// A contact from its scene: solved once, or on finer cells until the errors of the grid are small enough.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "contact/doubts.hpp"
#include "contact/elastic_operator.hpp"
#include "contact/grid_error.hpp"
#include "tools/contact/scene.hpp"

namespace asperity::cli {

/// Influence coefficients and plans, made once for all surfaces of one grid. No contact depends on those
/// before it.
class Influence {
 public:
  explicit Influence(const ContactOptions& options) : options_(options) {}
  ElasticOperator& on(const Grid& grid);
  /// Spent on them since the last call.
  double further_seconds();

 private:
  const ContactOptions& options_;
  Grid grid_ = {};
  std::unique_ptr<ElasticOperator> made_ = {};
  double reported_ = 0;
};

/// As many of them as there are contacts at once.
class Influences {
 public:
  explicit Influences(const ContactOptions& options) : options_(options) {}
  /// What use(influence) returns, with one that nobody else uses meanwhile; one that fails is not used again.
  template <class Use>
  auto with_one(const Use& use) {
    std::unique_ptr<Influence> one = taken();
    auto out = use(*one);
    put_back(std::move(one));
    return out;
  }

 private:
  std::unique_ptr<Influence> taken();
  void put_back(std::unique_ptr<Influence> one);

  const ContactOptions& options_;
  std::mutex mutex_ = {};
  std::vector<std::unique_ptr<Influence>> free_ = {};
};

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
/// Why a contact has no errors.
std::vector<Doubt> doubts(const GridFigures& figures);

struct Pressed {
  Contact contact;
  GridFigures figures;
  std::vector<Doubt> doubts;
  std::optional<Flow> flow = {};  ///< below the surface, where that was asked for
};

/// A path of loads from nothing.
std::shared_ptr<PlasticContact> plastic_path(const ContactOptions& options, const ContactScene& scene,
                                             ElasticOperator& influence);
/// The contact at the end of a path, with the stiffness of unloading where that is asked for.
Contact contact_of(const ContactOptions& options, const ContactScene& scene, ElasticOperator& influence,
                   const Flow& flow);
/// Where flow leaves the model.
std::vector<Doubt> doubts(const Flow& flow, const Grid& grid);

/// Solves the scene, whose gap it takes unless errors of the grid were asked for.
Pressed press(const ContactOptions& options, ContactScene& scene, Influence& influence);

struct Accurate {
  Pressed pressed;
  std::string unreached;  ///< why --accuracy is not reached; empty where it is
};

/// Presses the scene on its own cells, then on 2, 4, 8 and 16 times as many along each side, of the surface
/// refined by its own band limit, and leaves the last of these scenes.
Accurate press_accurately(const Tool& tool, const ContactOptions& options, ContactScene& scene,
                          Influence& influence);

/// Why a contact, or a stiffness that was asked for, has not converged; "" of one that has.
std::string unconverged(const ContactOptions& options, const Contact& contact);

}  // namespace asperity::cli
