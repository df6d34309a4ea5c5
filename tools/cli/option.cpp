#include "tools/cli/option.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "core/error.hpp"

namespace asperity::cli {

void refuse_empty(const std::string& key) {
  throw ParameterError(key, "is empty: give it a value or leave it out");
}

Option Option::required() const { return Option(option_->required()); }
Option Option::needs(Option other) const { return Option(option_->needs(other.option_)); }
Option Option::excludes(Option other) const { return Option(option_->excludes(other.option_)); }
Option Option::without_default() const { return Option(option_->default_str("")); }
Option Option::only_on_demand() const { return Option(option_->configurable(false)); }

Option Option::refusing_empty() const {
  return Option(option_->check([key = key()](const std::string& value) {
    if (value.empty()) refuse_empty(key);
    return std::string();
  }));
}

std::vector<std::string> Option::names() const {
  std::vector<std::string> out;
  for (const std::string& name : option_->get_snames()) out.push_back("-" + name);
  for (const std::string& name : option_->get_lnames()) out.push_back("--" + name);
  return out;
}

std::string Option::key() const { return option_->get_single_name(); }
std::string Option::group() const { return option_->get_group(); }
std::string Option::kind() const { return option_->get_type_name(); }
std::string Option::text() const { return option_->get_description(); }
std::string Option::shown_default() const { return option_->get_default_str(); }
bool Option::is_flag() const { return option_->get_expected_min() == 0; }
bool Option::is_positional() const { return option_->get_positional(); }
bool Option::is_required() const { return option_->get_required(); }
bool Option::is_list() const { return option_->get_items_expected_max() > 1; }
bool Option::in_config() const { return option_->get_configurable(); }
bool Option::given() const { return option_->count() > 0; }
std::vector<std::string> Option::values() const { return option_->results(); }
bool Option::flag_value() const { return option_->as<bool>(); }

std::vector<OptionGroup> by_group(const std::vector<Option>& options) {
  std::vector<OptionGroup> out;
  for (const Option& option : options) {
    auto group = std::ranges::find(out, option.group(), &OptionGroup::heading);
    if (group == out.end()) group = out.insert(out.end(), {option.group(), {}});
    group->options.push_back(option);
  }
  return out;
}

}  // namespace asperity::cli
