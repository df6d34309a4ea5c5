/// Plastic flow below the contact: its options, the path of loads, and how it stands in a dataset.
///
/// Variables, on the layers that flow and the whole grid, zero beside them:
///     plastic_strain(layer, x, y)         equivalent plastic strain of the first body that flows
///     plastic_strain_xx … _yz             its tensor, z into the body
/// and plastic_strain_counter… of the second body if that flows and is of another material. layer(layer) is
/// the middle depth of each layer, contact_layer_edges their bounds.
#pragma once

#include <functional>
#include <memory>

#include "dataset/dataset.hpp"
#include "plastic/plastic_contact.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct PlasticOptions {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string model = "cut";
  std::array<double, 2> yield{none, none};  ///< [Pa]
  int increments = 0;                       ///< 0: by an estimate of their error
  bool unload = false;
  PlasticParameters parameters;  ///< with `progress`

  bool flows() const { return model == "j2"; }
  const std::string& hardening() const { return hardening_; }  ///< as it was given
  /// With the bounds of layers on this grid.
  PlasticParameters on(const Grid& grid) const;
  void declare(Tool& tool);
  /// After parsing; throws ParameterError when options do not go together or are out of bounds.
  void check(const Tool& tool);

 private:
  void check_model(const Tool& tool) const;

  std::string hardening_ = "perfect", depths_;
};

/// Where a path of loads has led.
struct Flow {
  std::shared_ptr<PlasticContact> path;
  int increments = 0;  ///< from nothing to the load
  double increment_error =
      NAN;  ///< that they leave, of the greatest pressure, the approach or load, and the dent
  double greatest_load = 0;    ///< [N]
  int former_evaluations = 0;  ///< with fewer increments

  /// The contact at its end.
  Contact contact() const;
};

/// Presses on a fresh path, with as many increments as were asked for, or 8, 16 or 32 until half of them
/// differs by less than 1 %; and unloads, where that was asked for.
Flow press_with_flow(const PlasticOptions& options, const PlasticTarget& target,
                     const std::function<std::shared_ptr<PlasticContact>()>& make);
/// To the next of several loads [N], the greatest of which is given.
void go_on(Flow& flow, const PlasticOptions& options, double load, double greatest);

/// Attributes, and variables unless they are of a table.
void record_flow(Attributes& a, const PlasticOptions& options, const Flow& flow);
void record_strain(Dataset& data, const Grid& grid, const Flow& flow);

}  // namespace asperity::cli
