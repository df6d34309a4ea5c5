// Where the value of an option comes from: the command line, the environment, a file of options.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>

#include <CLI/CLI.hpp>

#include "tools/cli/record.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {
namespace {

std::string environment_name(const std::string& option) {
  std::string out = "ASPERITY_";
  for (char c : option)
    out += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

// Whether the arguments name the option, as "--size 3mm", "--size=3mm", "-o x" or "-ox".
bool have(const std::vector<std::string>& arguments, const Option& option) {
  const std::vector<std::string> names = option.names();
  return std::ranges::any_of(arguments, [&](const std::string& a) {
    return std::ranges::any_of(names, [&](const std::string& name) {
      return name.starts_with("--") ? a == name || a.starts_with(name + "=") : a.starts_with(name);
    });
  });
}

}  // namespace

std::vector<Option> Tool::options() const {
  std::vector<Option> out;
  for (CLI::Option* option : app_->get_options({})) out.emplace_back(option);
  return out;
}

std::optional<Option> Tool::find(const std::string& name) const {
  CLI::Option* option = app_->get_option_no_throw(name);
  return option == nullptr ? std::nullopt : std::optional(Option(option));
}

bool Tool::given(const std::string& name) const {
  const std::optional<Option> option = find(name);
  return option && option->given();
}

// The arguments that variables stand for, where none on the command line is for the same option.
std::vector<std::string> Tool::environment() const {
  std::vector<std::string> out;
  for (const Option& option : options()) {
    const std::string key = option.key();
    const bool settable = !option.is_positional() && (option.in_config() || key == "config");
    if (!settable || have(arguments_, option)) continue;
    if (const char* value = std::getenv(environment_name(key).c_str()))
      out.push_back("--" + key + "=" + value);
  }
  return out;
}

void Tool::parse(int argc, char** argv) {
  add_common();
  app_->footer(footer());
  arguments_.assign(argv + 1, argv + argc);
  command_line_ = name_;
  for (const std::string& a : arguments_) command_line_ += " " + shell_word(a);
  environment_ = environment();
  for (const Option& option : options())
    if (!option.is_flag() && option != may_be_empty_) option.refusing_empty();
  std::vector<std::string> all = with_empty_values(environment_);
  std::ranges::copy(with_empty_values(arguments_), std::back_inserter(all));
  std::ranges::reverse(all);
  app_->parse(std::move(all));
}

// "--counter=" as two arguments, for CLI11 would take the next one for its value. What follows "--" are no options.
std::vector<std::string> Tool::with_empty_values(const std::vector<std::string>& arguments) const {
  std::vector<std::string> out;
  const auto end = std::ranges::find(arguments, "--");
  for (auto a = arguments.begin(); a != end; ++a) {
    const bool empty = a->starts_with("--") && a->find('=') == a->size() - 1;
    const std::string name = a->substr(0, a->size() - empty);
    const std::optional<Option> option = empty ? find(name) : std::nullopt;
    if (option && option->is_flag()) refuse_empty(name.substr(2));
    out.push_back(option ? name : *a);
    if (option) out.emplace_back();
  }
  out.insert(out.end(), end, arguments.end());
  return out;
}

std::string Tool::config_file() const {
  const CLI::Option* config = app_->get_config_ptr();
  return config == nullptr || config->count() == 0 ? "" : config->results().front();
}

// Where the value of an option came from, as its user would look for it.
std::string Tool::origin(const std::string& key) const {
  const std::optional<Option> option = find("--" + key);
  if (!option && std::getenv(key.c_str()) != nullptr) return key;  // no option's variable
  if (!option) return (find(key) ? "" : "--") + key;
  if (have(arguments_, *option)) return "--" + key;
  if (have(environment_, *option)) return environment_name(key);
  return config_file().empty() || !option->given() ? "--" + key : config_file() + ": " + key;
}

}  // namespace asperity::cli
