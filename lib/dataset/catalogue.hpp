/// The table of results that the tools write into a dataset, with their variables and global attributes.
///
/// A result is computed by one run. It depends on the results that it was computed from:
///
///     kernel ← heights ← contact ← residual, stress          acf, psd ← the field that was measured
///
/// Other names belong to the user. A tool that writes a new attribute adds it here: its unit in tables and
/// its label in the report follow. An AttributeName that is not here does not compile.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace asperity {

/// Whether a name of the table is this one; it may end in *, which matches any rest.
constexpr bool fits(std::string_view pattern, std::string_view name) {
  return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
}

struct KnownResult {
  std::string_view name, rests_on;  ///< its name, and the results it depends on, separated by blanks
  std::string_view prefix;          ///< of its attributes
  std::string_view variables;       ///< its own, separated by blanks
};

/// The role of a number: parameter, result, accuracy reached by a solver, or not part of a report.
enum class Role { parameter, result, achieved, other };

struct KnownAttribute {
  std::string_view name;
  Role role;
  /// SI; "sample": cells of x and y, "yes": 0 or 1, "height": m, or 1 for unit heights; "" for text.
  std::string_view unit;
  std::string_view label;  ///< in words
  bool open = false;       ///< may be infinite, or NaN: unknown

  /// Of a column of numbers: that of "yes" is a share.
  constexpr std::string_view column_unit() const { return unit == "yes" ? "1" : unit; }
};

namespace catalogue {

using enum Role;

inline constexpr KnownResult results[] = {
    {"kernel", "", "kernel_", "kernel acf_target acf_achieved kernel_quantiles"},
    {"heights", "kernel", "generate_", "heights values mask noise"},
    {"filter", "heights", "filter_", ""},
    {"acf", "heights", "acf_", "acf acf_error structure_function acf_quantiles"},
    {"psd", "heights", "psd_", "psd psd_error"},
    {"contact", "heights", "contact_",
     "pressure gap contact displacement displacement_plastic label patch_area layer plastic_strain*"},
    {"residual", "heights contact", "", "heights_residual"},
    {"stress", "contact", "stress_",
     "von_mises max_shear octahedral_shear stress_1 stress_2 stress_3 stress_xx stress_yy stress_zz "
     "stress_xy "
     "stress_xz stress_yz direction_1_* direction_2_* direction_3_* section_x section_y"}};

inline constexpr KnownAttribute attributes[] = {
    {"kernel_target", parameter, "", "target autocorrelation"},
    {"kernel_length", parameter, "sample", "correlation length along x, y"},
    {"kernel_level", parameter, "1", "level at the correlation length"},
    {"kernel_angle", parameter, "rad", "rotation angle"},
    {"kernel_smoothness", parameter, "1", "smoothness ν"},
    {"kernel_exponent", parameter, "1", "exponent"},
    {"kernel_hurst", parameter, "1", "Hurst exponent"},
    {"kernel_wavelength", parameter, "sample", "wavelength"},
    {"kernel_cutoff", parameter, "sample", "shortest wavelength"},
    {"kernel_rolloff", parameter, "sample", "wavelength above which the spectrum is flat, along x, y"},
    {"kernel_rms", parameter, "height", "rms height"},
    {"kernel_rms_slope", parameter, "1", "rms slope by differences of neighbouring heights"},
    {"kernel_heights", parameter, "", "distribution of heights"},
    {"kernel_skewness", parameter, "1", "target skewness"},
    {"kernel_kurtosis", parameter, "1", "target kurtosis"},
    {"kernel_lags", parameter, "sample", "extent of the kernel along x, y"},
    {"kernel_period", parameter, "sample", "period of the surfaces along x, y"},
    {"kernel_corner", parameter, "sample", "largest surface that is a corner of that period along x, y"},
    {"kernel_formulation", parameter, "", "formulation"},
    {"kernel_method", parameter, "", "method"},
    {"kernel_tolerance", parameter, "1", "tolerance of the residual"},
    {"kernel_acf_tolerance", parameter, "1", "tolerance of the autocorrelation"},
    {"kernel_converged", achieved, "yes", "converged"},
    {"kernel_reason", achieved, "", "reason for the end of iteration"},
    {"kernel_answer", achieved, "", "answer"},
    {"kernel_residual", achieved, "1", "residual"},
    {"kernel_error", achieved, "1", "largest error of the autocorrelation"},
    {"kernel_change", achieved, "1", "change of the target"},
    {"kernel_tail", achieved, "1", "autocorrelation beyond the kernel"},
    {"kernel_feasibility", achieved, "1", "smallest over largest spectral density of the target"},
    {"kernel_hermite_tail", achieved, "1", "error of the translation"},
    {"kernel_newton_iterations", achieved, "1", "Newton steps"},
    {"kernel_residuals", achieved, "1", "evaluations of the residual"},
    {"kernel_jacobian_products", achieved, "1", "products with the Jacobian"},
    {"kernel_solver", achieved, "", "solver"},
    {"kernel_seconds", achieved, "s", "time"},
    {"kernel_least_acf", other, "1", "smallest autocorrelation possible with these heights"},
    {"kernel_mirrored_error", other, "1", "largest error over mirrored lags"},
    {"kernel_preconditionings", other, "1", "preconditionings"},
    {"kernel_warnings", other, "", "warnings, a line each"},
    {"generate_rms", parameter, "m", "rms height of the ensemble"},
    {"generate_exact_rq", parameter, "yes", "rescaled to exactly this rms height"},
    {"generate_seed", parameter, "1", "seed"},
    {"generate_stream", parameter, "1", "stream of random numbers"},
    {"generate_surface", parameter, "1", "number in the ensemble"},
    {"generate_rng", parameter, "", "random number generator"},
    {"generate_heights", parameter, "", "heights"},
    {"generate_method", parameter, "", "summation"},
    {"generate_skewness_expected", achieved, "1", "expected skewness"},
    {"generate_kurtosis_expected", achieved, "1", "expected kurtosis"},
    {"generate_acf_error_expected", achieved, "1", "expected error of the autocorrelation", true},
    {"generate_seconds", achieved, "s", "time"},
    {"generate_warnings", other, "", "warnings, a line each"},
    {"filter_form_degree", parameter, "1", "degree of the form that was removed"},
    {"filter_filled_share", parameter, "1", "share of the points that were filled"},
    {"filter_aligned_share", parameter, "1", "share of Sq that aligning scan lines took"},
    {"filter_warnings", other, "", "warnings, a line each"},
    {"acf_variable", other, "", "measured field"},
    {"acf_surfaces", other, "1", "surfaces in the mean"},
    {"acf_taper", other, "", "window of the tapered field"},
    {"acf_marginal", other, "", "distribution of heights that twins are drawn with"},
    {"acf_variance", other, "m2", "variance"},
    {"acf_skewness", other, "1", "skewness", true},
    {"acf_kurtosis", other, "1", "kurtosis", true},
    {"acf_length_*", other, "m", "correlation length", true},
    {"acf_gamma_*", other, "1", "length in x over length in y", true},
    {"acf_ellipticity_*", other, "1", "long over short axis of the contour, and direction of the long axis",
     true},
    {"acf_target_*", other, "", "the same for the target", true},
    {"acf_warnings", other, "", "warnings, a line each"},
    {"psd_degrees_of_freedom", other, "1", "degrees of freedom of chi-squared of a single wave number"},
    {"psd_relative_error", other, "1", "standard error of a single wave number over psd"},
    {"psd_variable", other, "", "measured field"},
    {"psd_surfaces", other, "1", "surfaces in the mean"},
    {"psd_window", other, "", "window"},
    {"psd_warnings", other, "", "warnings, a line each"},
    {"contact_load", result, "N", "load"},
    {"contact_mean_pressure", result, "Pa", "mean pressure over the nominal area"},
    {"contact_approach", result, "m", "approach"},
    {"contact_max_pressure", result, "Pa", "maximum pressure"},
    {"contact_area", result, "m2", "real contact area"},
    {"contact_area_corrected", result, "m2", "real contact area, corrected for its outline"},
    {"contact_perimeter", result, "m", "perimeter of the cells in contact"},
    {"contact_plastic_area", result, "m2", "area at the limit pressure"},
    {"contact_mean_gap", result, "m", "mean gap"},
    {"contact_stiffness", result, "N/m", "stiffness", true},
    {"contact_area_share", result, "1", "contact area over nominal area"},
    {"contact_reduced_pressure", result, "1", "mean pressure over E* times rms slope"},
    {"contact_kappa", result, "1", "area share over reduced pressure"},
    {"contact_reduced_gap", result, "1", "mean gap over rms height"},
    {"contact_sphere_roughness", result, "1", "roughness of the sphere, σR/a0²"},
    {"contact_plasticity_index", result, "1", "plasticity index"},
    {"contact_nayak_alpha", result, "1", "bandwidth parameter of the rough gap"},
    {"contact_rms_slope", result, "1", "rms slope of the rough gap"},
    {"contact_rms_height", result, "m", "rms height of the rough gap"},
    {"contact_elastic_energy", result, "J", "elastic energy"},
    {"contact_plastic_work", result, "J", "work of plastic flattening"},
    {"contact_dent", result, "m", "dent of each body by plastic flow"},
    {"contact_plastic_volume", result, "m3", "volume that has flown, of each body"},
    {"contact_max_plastic_strain", result, "1", "largest equivalent plastic strain of each body"},
    {"contact_dissipated_energy", result, "J", "energy dissipated by plastic flow"},
    {"contact_stored_energy", result, "J", "energy of the residual stress"},
    {"contact_patches", result, "1", "patches of contact"},
    {"contact_largest_patch", result, "m2", "area of the largest patch"},
    {"contact_percolates_x", result, "yes", "a patch percolates along x"},
    {"contact_percolates_y", result, "yes", "a patch percolates along y"},
    {"contact_hertz_pressure", result, "Pa", "maximum pressure, smooth (Hertz)"},
    {"contact_hertz_radius_x", result, "m", "contact half-axis along x, smooth (Hertz)"},
    {"contact_hertz_radius_y", result, "m", "contact half-axis along y, smooth (Hertz)"},
    {"contact_hertz_half_width", result, "m", "half the width of the contact, smooth (Hertz)"},
    {"contact_hertz_approach", result, "m", "approach, smooth (Hertz)"},
    {"contact_flattening_load", parameter, "N", "greater load that flattened the surface before"},
    {"contact_radius_x", parameter, "m", "radii along x of the bodies", true},
    {"contact_radius_y", parameter, "m", "radii along y of the bodies", true},
    {"contact_young", parameter, "Pa", "Young's moduli", true},
    {"contact_poisson", parameter, "1", "Poisson's ratios"},
    {"contact_composite_modulus", parameter, "Pa", "composite modulus"},
    {"contact_boundary", parameter, "", "boundary"},
    {"contact_approach_datum", parameter, "m", "distance from a line load that the approach counts from"},
    {"contact_prescribed", parameter, "", "prescribed"},
    {"contact_variable", parameter, "", "rough surface"},
    {"contact_counter", parameter, "", "second body"},
    {"contact_limit_pressure", parameter, "Pa", "limit pressure", true},
    {"contact_plasticity", parameter, "", "how the bodies yield"},
    {"contact_yield", parameter, "Pa", "yield stress of each body", true},
    {"contact_hardening", parameter, "", "hardening"},
    {"contact_layer_edges", parameter, "m", "bounds of the layers that may flow"},
    {"contact_increments", achieved, "1", "increments of the load"},
    {"contact_increment_error", achieved, "1", "relative error that the increments leave"},
    {"contact_evaluations", achieved, "1", "evaluations of the flow"},
    {"contact_plastic_residual", achieved, "1", "residual of the flow, of the yield strain"},
    {"contact_tolerance", parameter, "1", "tolerance of the residual"},
    {"contact_converged", achieved, "yes", "converged"},
    {"contact_residual", achieved, "1", "residual"},
    {"contact_stiffness_residual", achieved, "1", "residual of the stiffness", true},
    {"contact_stiffness_converged", achieved, "yes", "stiffness converged"},
    {"contact_load_residual", achieved, "1", "relative error of the load"},
    {"contact_slope_growth", achieved, "1",
     "gain of the squared slope by halved cells, over the halving before", true},
    {"contact_load_error", result, "N", "error of the grid: load"},
    {"contact_approach_error", result, "m", "error of the grid: approach"},
    {"contact_max_pressure_error", result, "Pa", "error of the grid: maximum pressure"},
    {"contact_area_error", result, "m2", "error of the grid: real contact area"},
    {"contact_area_corrected_error", result, "m2", "error of the grid: corrected area"},
    {"contact_plastic_area_error", result, "m2", "error of the grid: area at the limit pressure"},
    {"contact_mean_gap_error", result, "m", "error of the grid: mean gap"},
    {"contact_stiffness_error", result, "N/m", "error of the grid: stiffness"},
    {"contact_area_share_error", result, "1", "error of the grid: contact area over nominal area"},
    {"contact_reduced_pressure_error", result, "1",
     "error of the grid: mean pressure over E* times rms slope"},
    {"contact_kappa_error", result, "1", "error of the grid: area share over reduced pressure"},
    {"contact_reduced_gap_error", result, "1", "error of the grid: mean gap over rms height"},
    {"contact_rms_slope_error", result, "1", "error of the grid: rms slope of the rough gap"},
    {"contact_elastic_energy_error", result, "J", "error of the grid: elastic energy"},
    {"contact_plastic_work_error", result, "J", "error of the grid: work of plastic flattening"},
    {"contact_accuracy", parameter, "1", "largest error of the grid that was asked for"},
    {"contact_refinement", achieved, "1", "cells a side in place of each given one"},
    {"contact_grid_errors_seconds", achieved, "s", "time for errors of the grid"},
    {"contact_convolutions", achieved, "1", "convolutions of full size"},
    {"contact_preconditionings", achieved, "1", "preconditionings"},
    {"contact_levels", achieved, "1", "grid levels"},
    {"contact_setup_seconds", achieved, "s", "setup time"},
    {"contact_seconds", achieved, "s", "solution time"},
    {"contact_radius", other, "m", "radius of the body"},
    {"contact_hertz_radius", other, "m", "contact radius, smooth (Hertz)"},
    {"contact_warnings", other, "", "warnings, a line each"},
    {"stress_max_von_mises", result, "Pa", "largest von Mises stress"},
    {"stress_max_shear", result, "Pa", "largest shear stress"},
    {"stress_max_principal", result, "Pa", "largest principal stress"},
    {"stress_max_von_mises_error", result, "Pa", "error of the grid: largest von Mises stress"},
    {"stress_max_shear_error", result, "Pa", "error of the grid: largest shear stress"},
    {"stress_max_principal_error", result, "Pa", "error of the grid: largest principal stress"},
    {"stress_max_x", result, "m", "x of the largest stress"},
    {"stress_max_y", result, "m", "y of the largest stress"},
    {"stress_max_depth", result, "m", "depth of the largest stress"},
    {"stress_max_depth_error", achieved, "m", "error of the grid: depth of the largest stress"},
    {"stress_max_below", parameter, "m", "search from this depth on"},
    {"stress_poisson", parameter, "1", "Poisson's ratio of the body"},
    {"stress_friction", parameter, "1", "coefficient of friction"},
    {"stress_friction_angle", parameter, "rad", "direction of friction"},
    {"stress_resolution", parameter, "", "resolution"},
    {"stress_above", parameter, "Pa", "smallest stress kept"},
    {"stress_section_x", parameter, "m", "section at x"},
    {"stress_section_y", parameter, "m", "section at y"},
    {"stress_accurate_depth", achieved, "m", "smallest accurate depth"},
    {"stress_seconds", achieved, "s", "time"},
    {"stress_warnings", other, "", "warnings, a line each"}};

}  // namespace catalogue

constexpr std::span<const KnownResult> known_results() { return catalogue::results; }
/// In the order of the tools, and for each tool in the order of interest.
constexpr std::span<const KnownAttribute> known_attributes() { return catalogue::attributes; }

/// Null for a name of the user.
constexpr const KnownAttribute* known_attribute(std::string_view name) {
  const auto found = std::ranges::find_if(catalogue::attributes,
                                          [&](const KnownAttribute& a) { return fits(a.name, name); });
  return found == std::end(catalogue::attributes) ? nullptr : found;
}

void name_is_not_in_the_catalogue();  // never defined: the compiler's message

/// The name of an attribute in the table; any other does not compile.
struct AttributeName {
  std::string_view text;

  consteval AttributeName(const char* name) : text(name) {
    if (known_attribute(text) == nullptr) name_is_not_in_the_catalogue();
  }
  const KnownAttribute& known() const { return *known_attribute(text); }
};

/// The result that a variable or an attribute belongs to; null for a name of the user.
const KnownResult* result_of_variable(std::string_view name);
const KnownResult* result_of_attribute(std::string_view name);
/// The same for a variable or an attribute.
const KnownResult* result_of(std::string_view name);
/// The unit that a variable of this name must have, up to a factor; "": any.
std::string_view unit_needed(std::string_view variable);

}  // namespace asperity
