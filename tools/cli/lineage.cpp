#include "tools/cli/lineage.hpp"

#include <algorithm>
#include <iterator>

namespace asperity::cli {
namespace {

using Names = std::vector<std::string>;

// A tool that writes a new name adds it here: a test looks for it in the sources and in what they write.
constexpr Result table[] = {
    {"kernel", "", "kernel acf_target acf_achieved kernel_quantiles",
     "kernel_target kernel_length kernel_level kernel_angle kernel_smoothness kernel_exponent kernel_hurst "
     "kernel_wavelength kernel_rms kernel_period kernel_heights kernel_skewness kernel_kurtosis "
     "kernel_least_acf "
     "kernel_hermite_tail kernel_formulation kernel_method kernel_solver kernel_lags kernel_tolerance "
     "kernel_acf_tolerance kernel_answer kernel_residual kernel_change kernel_error kernel_mirrored_error "
     "kernel_tail kernel_feasibility kernel_newton_iterations kernel_residuals kernel_jacobian_products "
     "kernel_preconditionings kernel_seconds kernel_converged kernel_reason"},
    {"heights", "kernel", "heights values mask noise",
     "generate_seed generate_stream generate_surface generate_rng generate_rms generate_exact_rq "
     "generate_method generate_seconds generate_heights generate_skewness_expected "
     "generate_kurtosis_expected generate_acf_error_expected"},
    {"acf", "heights", "acf structure_function acf_quantiles",
     "acf_variable acf_variance acf_skewness acf_kurtosis acf_length_* acf_gamma_* acf_ellipticity_* "
     "acf_target_*"},
    {"psd", "heights", "psd", "psd_variable psd_window"},
    {"contact", "heights", "pressure gap contact displacement displacement_plastic",
     "contact_variable contact_counter contact_radius contact_radius_x contact_radius_y contact_young "
     "contact_poisson contact_composite_modulus contact_boundary contact_limit_pressure contact_tolerance "
     "contact_load contact_approach contact_max_pressure contact_area contact_plastic_area "
     "contact_mean_gap contact_stiffness contact_stiffness_residual contact_stiffness_converged "
     "contact_residual contact_load_error contact_converged contact_convolutions "
     "contact_preconditionings contact_levels contact_setup_seconds contact_seconds contact_hertz_*"},
    {"residual", "heights contact", "heights_residual", ""},
    {"stress", "contact",
     "von_mises max_shear octahedral_shear stress_1 stress_2 stress_3 stress_xx stress_yy stress_zz "
     "stress_xy stress_xz stress_yz direction_1_* direction_2_* direction_3_* section_x section_y",
     "stress_poisson stress_resolution stress_accurate_depth stress_friction stress_friction_angle "
     "stress_above stress_section_x stress_section_y stress_max_von_mises stress_max_x stress_max_y "
     "stress_max_depth stress_seconds"}};

// The words of a list.
std::vector<std::string_view> words_of(std::string_view list) {
  std::vector<std::string_view> out;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    if (end > 0) out.push_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return out;
}

// The result that a variable or an attribute belongs to; null of a user's own.
const Result* owner_of(std::string_view name) {
  const auto found = std::ranges::find_if(
      table, [&](const Result& r) { return lists(r.variables, name) || lists(r.attributes, name); });
  return found == std::end(table) ? nullptr : found;
}

// Where it says that it was computed from another field than the heights, on that one.
bool rests_on(const Dataset& data, const Result& result, const std::vector<const Result*>& gone) {
  const std::string from = data.attributes.text(std::string(result.name) + "_variable");
  return std::ranges::any_of(words_of(result.rests_on), [&](std::string_view base) {
    const Result* other = owner_of(base == "heights" && !from.empty() ? std::string_view(from) : base);
    return std::ranges::find(gone, other) != gone.end();
  });
}

std::vector<const Result*> stale(const Dataset& data, std::string_view replaced, std::string_view input) {
  const Result* const kept = owner_of(input);
  std::vector<const Result*> gone{std::ranges::find(table, replaced, &Result::name)};
  for (std::size_t before = 0; before != gone.size();) {
    before = gone.size();
    for (const Result& r : table)
      if (&r != kept && std::ranges::find(gone, &r) == gone.end() && rests_on(data, r, gone))
        gone.push_back(&r);
  }
  return gone;
}

bool is_coordinate(const Variable& v) { return v.dimensions == Names{v.name}; }

// Erases variables, and the dimensions with their coordinates that are left bare by it.
template <class Predicate>
void erase_variables(Dataset& data, Predicate gone) {
  Names bare;
  for (const Variable& v : data.variables)
    if (gone(v)) bare.insert(bare.end(), v.dimensions.begin(), v.dimensions.end());
  std::erase_if(data.variables, gone);
  std::erase_if(bare, [&](const std::string& dimension) {
    return dimension == "x" || dimension == "y" ||
           std::ranges::any_of(data.variables, [&](const Variable& v) {
             return !is_coordinate(v) && std::ranges::find(v.dimensions, dimension) != v.dimensions.end();
           });
  });
  const auto is_bare = [&](const auto& item) { return std::ranges::find(bare, item.name) != bare.end(); };
  std::erase_if(data.variables, is_bare);
  std::erase_if(data.dimensions, is_bare);
}

// "heights_residual, stress (von_mises and 20 more)": many of one result stand together.
std::string in_short(const Names& names) {
  constexpr std::ptrdiff_t few = 2;
  std::string line;
  std::vector<const Result*> told;
  for (const std::string& name : names) {
    const Result* const result = owner_of(name);
    if (result && std::ranges::find(told, result) != told.end()) continue;
    const auto all = result ? std::ranges::count(names, result, owner_of) : 1;
    line += line.empty() ? "" : ", ";
    if (all <= few) {
      line += name;
      continue;
    }
    told.push_back(result);
    line += std::string(result->name) + " (" + name + " and " + std::to_string(all - 1) + " more)";
  }
  return line;
}

}  // namespace

std::span<const Result> results() { return table; }

bool lists(std::string_view list, std::string_view name) {
  return std::ranges::any_of(words_of(list), [&](std::string_view word) {
    return word.ends_with('*') ? name.starts_with(word.substr(0, word.size() - 1)) : name == word;
  });
}

void drop_results(Dataset& data, std::string_view result, std::string_view input) {
  const std::vector<const Result*> gone = stale(data, result, input);
  const auto any = [&](std::string_view Result::*list, std::string_view name) {
    return std::ranges::any_of(gone, [&](const Result* r) { return lists(r->*list, name); });
  };
  erase_variables(data,
                  [&](const Variable& v) { return v.name != input && any(&Result::variables, v.name); });
  Names attributes;
  for (const Attribute& a : data.attributes)
    if (any(&Result::attributes, a.name)) attributes.push_back(a.name);
  for (const std::string& name : attributes) data.attributes.erase(name);
}

void drop_surface(Dataset& data, std::string_view result) {
  drop_results(data, result);
  erase_variables(data, [](const Variable& v) {
    return !is_coordinate(v) &&
           std::ranges::any_of(v.dimensions, [](const std::string& d) { return d == "x" || d == "y"; });
  });
}

Inventory::Inventory(const Dataset& data) {
  for (const Variable& v : data.variables)
    if (!is_coordinate(v)) names_.push_back(v.name);
  for (const Attribute& a : data.attributes) names_.push_back(a.name);
}

std::vector<std::string> Inventory::missing_in(const Dataset& now) const {
  Names out;
  for (const std::string& name : names_)
    if (!now.has(name) && !now.attributes.find(name)) out.push_back(name);
  return out;
}

void Inventory::tell(const Tool& tool, const Dataset& now, const std::string& replaced,
                     std::string_view coming) const {
  Names gone = missing_in(now);
  std::erase_if(gone, [&](const std::string& name) { return lists(coming, name); });
  if (!gone.empty()) tool.note("dropped what does not belong to the new " + replaced + ": " + in_short(gone));
}

}  // namespace asperity::cli
