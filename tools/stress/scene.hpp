/// The loaded body of asperity-stress: what was read, and the options in SI.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "dataset/dataset.hpp"
#include "plastic/residual_stress.hpp"
#include "stress/layers.hpp"
#include "tools/stress/options.hpp"

namespace asperity::cli {

struct StressScene {
  Dataset data;  ///< to be amended
  LoadedBody body;
  std::vector<double> depths;  ///< [m]; none: no layers are requested
  std::optional<Plane> plane;  ///< of a section
  double least = 0;            ///< stresses of smaller modulus are left out [Pa]
  DepthResolution resolution = DepthResolution::adapted;
  std::shared_ptr<const ResidualStress> residual = {};  ///< that flow has left (tools/contact/plasticity.hpp)

  /// Of whole layers, or of the section, with the residual stress.
  std::unique_ptr<StressSolver> solver(const LoadedBody& of, const std::optional<Plane>& section,
                                       int threads) const;
  /// [Pa], a third of the contact's limit pressure; infinite where it has none.
  double yield_stress() const;
};

/// A depth as it is typed, "2px" (of the shorter side of a cell) or "10um" [m]. Throws ParameterError(option)
/// unless it is at most `deepest`.
double depth_on(const Grid& grid, const std::string& option, const std::string& text, double deepest);

/// The coordinate of a plane [m].
double place_of(const Plane& plane, const Grid& grid);

/// Throws ParameterError where the options contradict the dataset. A section through the maximum is not set
/// yet. Of several ranks each has some rows of the pressure, unless the grid is small.
StressScene scene_of(const StressOptions& options, Dataset data, const Ranks& ranks = alone());
/// The same of the only surface.
StressScene read_scene(const Tool& tool, StressOptions& options);

/// Sets the plane of a section; `maximum` is x and y of the largest von Mises stress, where the section runs
/// through it.
void cut(StressScene& scene, const std::string& section, std::array<double, 2> maximum);

/// The effective parameters, as attributes.
void record_parameters(StressScene& scene);

/// Whether a cell of the contact is at its limit pressure.
bool at_limit_pressure(const Dataset& contact, const LoadedBody& body);

/// Whether stresses at this depth rest on single cells: it is less than the accurate depth, and the pressure
/// not uniform.
bool is_shallow(const LoadedBody& body, double depth);

/// Warns of layers that are.
void warn_of_shallow_layers(const Tool& tool, const StressScene& scene);

/// Warns where this largest von Mises stress [Pa] exceeds the yield stress of a contact with a limit
/// pressure.
void warn_of_yield(const Tool& tool, const StressScene& scene, double von_mises);

}  // namespace asperity::cli
