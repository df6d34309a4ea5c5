#include "tools/report/facts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "tools/report/readable.hpp"

namespace asperity::report {
namespace {

using enum Role;

struct Entry {
  const char* attribute;
  Role role;
  const char* unit;  ///< SI; "sample" counts cells of x and of y, "yes" is 0 or 1
  const char* label;
};

constexpr Entry entries[] = {
    {"kernel_target", parameter, "", "autocorrelation asked for"},
    {"kernel_length", parameter, "sample", "correlation length along x, y"},
    {"kernel_level", parameter, "1", "level that it is the length to"},
    {"kernel_angle", parameter, "rad", "turned by"},
    {"kernel_smoothness", parameter, "1", "smoothness ν"},
    {"kernel_exponent", parameter, "1", "exponent"},
    {"kernel_hurst", parameter, "1", "Hurst exponent"},
    {"kernel_wavelength", parameter, "sample", "wavelength"},
    {"kernel_rms", parameter, "height", "rms height"},
    {"kernel_heights", parameter, "", "distribution of heights"},
    {"kernel_skewness", parameter, "1", "skewness asked for"},
    {"kernel_kurtosis", parameter, "1", "kurtosis asked for"},
    {"kernel_lags", parameter, "sample", "reach of the kernel along x, y"},
    {"kernel_period", parameter, "sample", "period of the surfaces that it is for, along x, y"},
    {"kernel_formulation", parameter, "", "formulation"},
    {"kernel_method", parameter, "", "method"},
    {"kernel_tolerance", parameter, "1", "tolerance of the residual"},
    {"kernel_acf_tolerance", parameter, "1", "tolerance of the autocorrelation"},
    {"kernel_converged", achieved, "yes", "converged"},
    {"kernel_reason", achieved, "", "ended because"},
    {"kernel_answer", achieved, "", "answer"},
    {"kernel_residual", achieved, "1", "residual"},
    {"kernel_error", achieved, "1", "largest error of the autocorrelation"},
    {"kernel_change", achieved, "1", "change of the target"},
    {"kernel_tail", achieved, "1", "autocorrelation beyond the kernel"},
    {"kernel_feasibility", achieved, "1", "least spectral density of the target over its largest"},
    {"kernel_hermite_tail", achieved, "1", "error of the translation"},
    {"kernel_newton_iterations", achieved, "1", "Newton steps"},
    {"kernel_residuals", achieved, "1", "residuals evaluated"},
    {"kernel_jacobian_products", achieved, "1", "products with the Jacobian"},
    {"kernel_solver", achieved, "", "solver"},
    {"kernel_seconds", achieved, "s", "time"},
    {"generate_rms", parameter, "m", "rms height of the ensemble"},
    {"generate_exact_rq", parameter, "yes", "rescaled to this rms exactly"},
    {"generate_seed", parameter, "1", "seed"},
    {"generate_stream", parameter, "1", "stream of random numbers"},
    {"generate_surface", parameter, "1", "member of the ensemble"},
    {"generate_rng", parameter, "", "random numbers"},
    {"generate_heights", parameter, "", "heights"},
    {"generate_method", parameter, "", "summation"},
    {"generate_skewness_expected", achieved, "1", "skewness expected"},
    {"generate_kurtosis_expected", achieved, "1", "kurtosis expected"},
    {"generate_acf_error_expected", achieved, "1", "error of the autocorrelation expected"},
    {"generate_seconds", achieved, "s", "time"},
    {"contact_load", result, "N", "load"},
    {"contact_approach", result, "m", "approach"},
    {"contact_max_pressure", result, "Pa", "largest pressure"},
    {"contact_area", result, "m2", "real contact area"},
    {"contact_plastic_area", result, "m2", "area at the limit pressure"},
    {"contact_mean_gap", result, "m", "mean gap"},
    {"contact_stiffness", result, "N/m", "stiffness"},
    {"contact_hertz_pressure", result, "Pa", "largest pressure, smooth (Hertz)"},
    {"contact_hertz_radius_x", result, "m", "contact half-axis along x, smooth (Hertz)"},
    {"contact_hertz_radius_y", result, "m", "contact half-axis along y, smooth (Hertz)"},
    {"contact_hertz_approach", result, "m", "approach, smooth (Hertz)"},
    {"contact_radius_x", parameter, "m", "radii along x of the bodies"},
    {"contact_radius_y", parameter, "m", "radii along y of the bodies"},
    {"contact_young", parameter, "Pa", "Young's moduli"},
    {"contact_poisson", parameter, "1", "Poisson's ratios"},
    {"contact_composite_modulus", parameter, "Pa", "composite modulus"},
    {"contact_boundary", parameter, "", "boundary"},
    {"contact_variable", parameter, "", "surface that is pressed"},
    {"contact_counter", parameter, "", "second body"},
    {"contact_limit_pressure", parameter, "Pa", "limit pressure"},
    {"contact_tolerance", parameter, "1", "tolerance of the residual"},
    {"contact_converged", achieved, "yes", "converged"},
    {"contact_residual", achieved, "1", "residual"},
    {"contact_stiffness_residual", achieved, "1", "residual of the stiffness"},
    {"contact_stiffness_converged", achieved, "yes", "stiffness converged"},
    {"contact_load_error", achieved, "1", "relative error of the load"},
    {"contact_convolutions", achieved, "1", "convolutions of the full size"},
    {"contact_preconditionings", achieved, "1", "preconditionings"},
    {"contact_levels", achieved, "1", "grids"},
    {"contact_setup_seconds", achieved, "s", "time of preparation"},
    {"contact_seconds", achieved, "s", "time of solution"},
    {"stress_max_von_mises", result, "Pa", "largest von Mises stress"},
    {"stress_max_x", result, "m", "it lies at x"},
    {"stress_max_y", result, "m", "at y"},
    {"stress_max_depth", result, "m", "at the depth"},
    {"stress_poisson", parameter, "1", "Poisson's ratio of the body"},
    {"stress_friction", parameter, "1", "coefficient of friction"},
    {"stress_friction_angle", parameter, "rad", "direction of friction"},
    {"stress_resolution", parameter, "", "resolution"},
    {"stress_above", parameter, "1", "least stress kept, share of the largest"},
    {"stress_section_x", parameter, "m", "section at x"},
    {"stress_section_y", parameter, "m", "section at y"},
    {"stress_accurate_depth", achieved, "m", "accurate from this depth on"},
    {"stress_seconds", achieved, "s", "time"}};

// Of both bodies; one number where they agree.
std::string numbers_text(const std::vector<double>& values, const std::string& unit) {
  std::vector<std::string> words;
  for (const double v : values) words.push_back(readable(v, unit));
  const bool alike = std::ranges::adjacent_find(words, std::ranges::not_equal_to()) == words.end();
  return words.empty() ? "–" : alike ? words.front() : fmt::format("{}", fmt::join(words, ", "));
}

// Of x, and of y; in metres too where the samples have a grid.
std::string samples_text(const Dataset& data, const std::vector<double>& values) {
  std::vector<std::string> counts, lengths;
  for (const double v : values) counts.push_back(digits_of(v));
  const std::string samples = fmt::format("{} samples", fmt::join(counts, " × "));
  if (!data.find("x") || !data.find("y")) return samples;
  const Grid grid = grid_of(data);
  for (const double v : values) lengths.push_back(readable(v * (lengths.empty() ? grid.dx : grid.dy), "m"));
  return fmt::format("{} ({})", samples, fmt::join(lengths, " × "));
}

std::string text_of(const Dataset& data, const Values& values, std::string unit) {
  const auto* words = std::get_if<std::string>(&values);
  if (words) return *words;
  if (unit == "sample") return samples_text(data, numbers(values));
  if (unit == "yes") return count(values) > 0 && numbers(values)[0] != 0 ? "yes" : "no";
  if (unit == "height") {
    const Variable* target = data.find("acf_target");
    unit = target && target->attributes.text("units") == "m2" ? "m" : "1";
  }
  return numbers_text(numbers(values), unit);
}

std::string stage_of(const std::string& attribute) { return attribute.substr(0, attribute.find('_')); }

}  // namespace

std::vector<Fact> facts_of(const Dataset& data) {
  std::vector<Fact> out;
  for (const Entry& e : entries)
    if (const Values* values = data.attributes.find(e.attribute))
      out.push_back({e.role, stage_of(e.attribute), e.attribute, e.label, text_of(data, *values, e.unit)});
  return out;
}

std::vector<Fact> other_attributes(const Dataset& data) {
  std::vector<Fact> out;
  for (const Attribute& a : data.attributes) {
    const bool told = std::ranges::any_of(entries, [&](const Entry& e) { return a.name == e.attribute; });
    if (!told && a.name != "history" && a.name != "source")
      out.push_back({parameter, "", a.name, a.name, text_of(a.values)});
  }
  return out;
}

std::vector<std::string> warnings_of(const Dataset& data) {
  std::vector<std::string> out;
  const Attributes& a = data.attributes;
  const auto number = [&](const char* name) { return readable(a.number(name, NAN), "1"); };
  if (a.number("kernel_converged", 1) == 0)
    out.push_back(
        fmt::format("The kernel did not converge ({}): residual {}, tolerance {}. Surfaces drawn from it do "
                    "not have the autocorrelation asked for.",
                    a.text("kernel_reason"), number("kernel_residual"), number("kernel_tolerance")));
  if (a.number("contact_converged", 1) == 0)
    out.push_back(
        fmt::format("The contact did not converge: residual {}, tolerance {}. Pressure, area and all that "
                    "rests on them are not a solution.",
                    number("contact_residual"), number("contact_tolerance")));
  const std::string answer = a.text("kernel_answer");
  if ((answer == "nearest" || answer == "least-squares") && a.number("kernel_change", 0) > 1e-6)
    out.push_back(
        fmt::format("No kernel of this reach has the autocorrelation asked for; it was changed by up to {} "
                    "of the variance.",
                    number("kernel_change")));
  return out;
}

std::string text_of(const Values& values) {
  if (const auto* words = std::get_if<std::string>(&values)) return *words;
  constexpr std::size_t most = 12;
  std::vector<std::string> words;
  for (const double v : numbers(values)) {
    if (words.size() == most) {
      words.push_back(fmt::format("… ({} values)", count(values)));
      break;
    }
    words.push_back(cli::shortest(v));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace asperity::report
